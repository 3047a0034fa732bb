"""Statements made to be decided wrongly: side conditions at their boundary, branches, poles, what is nowhere defined.

A line is a statement and what is assumed.  Which are true is known from how they were made.
"""

import json
import re

import pytest

from algebroproj_sym.proving.reals import decided
from algebroproj_sym.replaying.reals import require_real

TRUE = """
sqrt(3 + 2*sqrt(2)) = 1 + sqrt(2)
sqrt(3 - 2*sqrt(2)) = sqrt(2) - 1
sqrt(x + 2*sqrt(x - 1)) = 1 + sqrt(x - 1)
sqrt(x - 2*sqrt(x - 1)) = 1 - sqrt(x - 1) | 1 <= x <= 2
sqrt(x - 2*sqrt(x - 1)) = abs(1 - sqrt(x - 1))
sqrt(x/y) = sqrt(x)/sqrt(y)
sqrt(x*y) = sqrt(abs(x))*sqrt(y)
sqrt(x^6) = x^3 | x >= 0
atan2(y, x) = pi/2 - atan(x/y) | y > 0
atan2(0, x) = pi | x <= 0
atan2(0, x) = 0 | x >= 0
atan2(-y, x) = -atan2(y, x) | y != 0
atan2(y, -x) = pi - atan2(y, x) | y >= 0
atan2(k*y, k*x) = atan2(y, x) | k >= 0
atan2(sin(t), cos(t)) = t | -pi < t <= pi
diff(abs(x), x) = x/abs(x)
diff(x*abs(x), x) = 2*abs(x)
diff(abs(x^2 - 1), x) = 2*x | x > 1
diff(abs(sin(x)), x) = cos(x) | 0 < x < pi
diff(log(abs(x)), x) = 1/x
integrate(1/x, (x, 1, t)) = log(t) | t > 0
integrate(1/(2 + cos(x)), (x, 0, 2*pi)) = 2*pi/sqrt(3)
integrate(tan(x), (x, 0, t)) = -log(cos(t)) | 0 <= t < pi/2
taylor(abs(a + x), x, 1) = a + x | a > 0
taylor(sqrt(a^2 + x), x, 1) = a + x/(2*a) | a > 0
taylor(atan2(x, 1), x, 1) = x
tan(A/2) = sin(A)/(1 + cos(A))
tan(A/2) = (1 - cos(A))/sin(A)
sin(A/2) = sqrt((1 - cos(A))/2) | 0 <= A <= 2*pi
cos(A/2) = sqrt((1 + cos(A))/2) | -pi <= A <= pi
tan(A/2) = sqrt((1 - cos(A))/(1 + cos(A))) | 0 <= A < pi
1 + cos(A) >= 0
log(x) < x - 1 | x > 0 | x != 1
sin(x)/x > cos(x) | 0 < x < pi
(sin(x)/x)^3 > cos(x) | 0 < x < pi/2
cosh(x) < (sinh(x)/x)^3 | x > 0
cosh(x) <= exp(x^2/2)
log(x) <= (x - 1)/sqrt(x) | x >= 1
sqrt((a - x)^2 + (b - y)^2) <= sqrt(a^2 + b^2) + sqrt(x^2 + y^2)
x*cos(x) < sin(x) | 0 < x < pi
exp(-x/(1 - x)) < 1 - x | 0 < x < 1
a*(a - b)*(a - c) + b*(b - c)*(b - a) + c*(c - a)*(c - b) >= 0 | a >= 0 | b >= 0 | c >= 0
a/(b + c) + b/(c + a) + c/(a + b) >= 3/2 | a > 0 | b > 0 | c > 0
abs(tanh(x)) < 1
""".strip().splitlines()

NOT_FOUND = {"integrate(1/(2 + cos(x)), (x, 0, 2*pi)) = 2*pi/sqrt(3)"}
"""Of which the usual antiderivative jumps."""

FALSE = """
sqrt(3 - 2*sqrt(2)) = 1 - sqrt(2)
sqrt(x - 2*sqrt(x - 1)) = 1 - sqrt(x - 1)
sqrt(x - 2*sqrt(x - 1)) = 1 - sqrt(x - 1) | 1 <= x <= 21/10
sqrt((x - 1)^2) = x - 1 | x >= 9/10
sqrt(x^2*y) = x*sqrt(y)
sqrt(x^6) = x^3 | x > -1/20
sqrt(2 + sqrt(3)) = (sqrt(6) - sqrt(2))/2
atan2(y, x) = atan(y/x) | x != 0
atan2(y, x) = pi/2 - atan(x/y) | y != 0
atan2(0, x) = pi | x <= 1
atan2(0, x) = 0 | x != 0
atan2(-y, x) = -atan2(y, x)
atan2(-y, x) = -atan2(y, x) | x >= -1
atan2(y, -x) = pi - atan2(y, x) | y >= -1
atan2(k*y, k*x) = atan2(y, x) | k >= -1
atan2(sin(t), cos(t)) = t | -pi <= t <= pi
atan2(sin(t), cos(t)) = t | -pi < t <= 4
diff(abs(x), x) = 1 | x > -1
diff(abs(x^2 - 1), x) = 2*x | x > 0
diff(sqrt(x^2), x) = 1
diff(abs(sin(x)), x) = cos(x) | 0 < x < 4
diff(log(abs(x)), x) = 1/abs(x)
integrate(1/x, (x, 1, t)) = log(t^2) | t > 0
integrate(abs(x), (x, -1, 1)) = 0
integrate(1/(2 + cos(x)), (x, 0, 2*pi)) = 0
integrate(1/(1 + sin(x)^2), (x, 0, pi)) = 0
integrate(tan(x), (x, 0, t)) = log(cos(t)) | 0 <= t < pi/2
taylor(sqrt(1 + x), x, 1) = 1 + x
taylor(abs(a + x), x, 1) = a + x | a != 0
taylor(sqrt(a^2 + x), x, 1) = a + x/(2*a) | a != 0
sin(A/2) = sqrt((1 - cos(A))/2) | 0 <= A <= 7
sin(A/2) = sqrt((1 - cos(A))/2) | -1/10 <= A <= pi
cos(A/2) = sqrt((1 + cos(A))/2) | -pi <= A <= 4
tan(A/2) = sqrt((1 - cos(A))/(1 + cos(A))) | -1 < A < pi
cos(A/2) != 0
1 + cos(A) > 0
2*cos(A/2)^2 > 0
sin(x) < x | x >= 0
log(x) < x - 1 | x > 0
x + 1/x >= 2 | x != 0
tan(x) > x | 0 < x < pi
tan(x) > x | 0 <= x < pi/2
sin(x)/x > cos(x) | x > 0
(sin(x)/x)^3 > cos(x) | 0 < x < 7
(sin(x)/x)^3 >= cos(x) | x > 0
(sin(x)/x)^2 + tan(x)/x > 2 | 0 < x < pi
(sin(x)/x)^4 > cos(x) | 0 < x < pi/2
cos(x) <= exp(-x^2/2) | 0 <= x <= 7
cos(x) < exp(-x^2/2) | 0 <= x <= pi/2
cosh(x) < exp(x^2/2)
cosh(x) <= exp(x^2/3)
cosh(x) <= (sinh(x)/x)^2 | x > 0
log(x) <= (x - 1)/sqrt(x) | x > 0
log(x) < (x - 1)/sqrt(x) | x >= 1
log(1 + x) <= x/sqrt(1 + x) | x > -1
2*sin(x) + tan(x) > 3*x | 0 <= x < pi/2
2*sin(x) + tan(x) > 3*x | -1 < x < pi/2
2*sin(x) + tan(x) > 3*x | 0 < x < 3
3*x/(1 + 2*sqrt(1 + x^2)) < atan(x) | x >= 0
3*x/(1 + 2*sqrt(1 + x^2)) < atan(x)
exp(-x/(1 - x)) < 1 - x | 0 <= x < 1
exp(-x/(1 - x)) < 1 - x | 0 < x < 2
sqrt((a + x)^2 + (b + y)^2) < sqrt(a^2 + b^2) + sqrt(x^2 + y^2)
sqrt((a + x)^2 + (b + y)^2) <= sqrt(a^2 + b^2) + x + y
abs(abs(x) - abs(y)) < abs(x - y)
x*cos(x) < sin(x) | 0 < x < 8
x*cos(x) < sin(x) | 0 <= x < pi
a*(a - b)*(a - c) + b*(b - c)*(b - a) + c*(c - a)*(c - b) >= 0 | a >= 0 | b >= 0
a*(a - b)*(a - c) + b*(b - c)*(b - a) + c*(c - a)*(c - b) > 0 | a > 0 | b > 0 | c > 0
a/(b + c) + b/(c + a) + c/(a + b) > 3/2 | a > 0 | b > 0 | c > 0
x^3 + y^3 >= x^2*y + x*y^2 | x >= 0 | y >= -1
abs(tanh(x)) < 99/100
""".strip().splitlines()

NOWHERE = """
integrate(1/x, (x, -1, 1)) = 0
integrate(1/x^2, (x, -1, 1)) = -2
integrate(1/cos(x)^2, (x, 0, pi)) = 0
integrate(tan(x), (x, 0, pi)) = 0
taylor(sqrt(x), x, 1) = 0
taylor(abs(x), x, 1) = x
taylor(1/x, x, 1) = 0
taylor(log(x), x, 1) = x - 1
taylor(x*sqrt(x), x, 1) = 0
taylor(atan2(x, -1), x, 1) = pi - x
taylor(acos(1 - x), x, 1) = 0
atan2(x - x, 0) = 0
sqrt(-1 - x^2) = sqrt(-1 - x^2)
log(-abs(x)) = 0
tan(A/2) = 0 | cos(A/2) = 0
""".strip().splitlines()


def decide(line):
    said, *given = line.split(" | ")
    lhs, relation, rhs = re.split(r" (<=|>=|!=|<|>|=) ", said)
    found = decided(
        {"lhs": lhs, "rhs": rhs, "relation": relation, "assumptions": given, "constraints": [], "nonzero": []}
    )
    if found["verdict"] != "open":
        require_real(json.loads(json.dumps(found)))
    return found["verdict"]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("line", TRUE)
def test_what_is_true_is_proved(line):
    assert decide(line) == ("open" if line in NOT_FOUND else "proved")


@pytest.mark.sampled(3)
@pytest.mark.parametrize("line", FALSE)
def test_what_is_false_is_refuted(line):
    assert decide(line) == "refuted"


@pytest.mark.parametrize("line", NOWHERE)
def test_what_is_nowhere_defined_is_neither_proved_nor_refuted(line):
    assert decide(line) == "open"
