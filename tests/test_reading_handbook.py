r"""Identities as handbooks list them, each for itself: the true ones follow, and no misprint does.

The mark ``|>`` stands before an equation that follows.
"""

import pytest
from cases import for_each
from textbooks import follow, plain, with_misprint

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")
COMPLEX = r"""For all $z \in \mathbb{C}$ |>\[ e^{z + 2 \pi i} = e^z \] |>\[ e^{i z} = \cos z + i \sin z \] |>\[ \cos z =
\frac{e^{i z} + e^{-i z}}{2} \] |>\[ \sin(i z) = i \sinh z. \]"""
WHOLE = r"""Let $n \in \mathbb{Z}$. |>\[ \sin(x + n \pi) = (-1)^n \sin x \] |>\[ \cos(n \pi) = (-1)^n \] |>\[
\cos(2 n \pi - x) = \cos x. \]"""
SLOPES = r"""The derivatives are |>\[ \frac{d}{dx} \tanh x = 1 - \tanh^2 x \] |>\[ \frac{d}{dx} \arcsin x =
\frac{1}{\sqrt{1 - x^2}} \] |>\[ \frac{d}{dx} x^a = a x^{a-1} \] |>\[ \frac{d}{dx} x^x = x^x (1 + \ln x) \]
|>\[ \frac{d}{dx} 2^x = 2^x \ln 2 \] |>\[ \frac{d}{dx} \cot x = -\csc^2 x \] |>\[
\frac{d}{dx} \operatorname{artanh} x = \frac{1}{1 - x^2}. \]"""
FACTORIALS = r"""For whole numbers |>\[ (n + 1)! = (n + 1) \, n! \] |>\[ \binom{n}{k} = \frac{n!}{k! \, (n - k)!} \]
|>\[ \binom{n}{k} = \binom{n}{n - k} \] |>\[ \binom{n + 1}{k + 1} = \binom{n}{k} + \binom{n}{k + 1} \] |>\[ k
\binom{n}{k} = n \binom{n - 1}{k - 1} \] |>\[ \sum_{k=0}^n \binom{n}{k} = 2^n \] |>\[ \sum_{k=0}^n \binom{n}{k} x^k
y^{n - k} = (x + y)^n. \]"""
GAMMA = r"""The gamma function has |>\[ \Gamma(z + 1) = z \Gamma(z) \] |>\[ \Gamma(n + 1) = n! \] |>\[
\Gamma\left(\tfrac12\right) = \sqrt{\pi} \] |>\[ \Gamma(z + 2) = z (z + 1) \Gamma(z). \]"""
EULER = r"""\[ \Gamma(x) = \int_0^\infty t^{x-1} e^{-t} dt \] This extends $\Gamma$ to all numbers. |>\[ \Gamma(x + 1) =
x \Gamma(x) \] |>\[ \Gamma(n + 1) = n! \] |>\[ \Gamma\left(\tfrac32\right) = \frac{\sqrt\pi}{2} \] The beta function is
\[ B(x, y) = \frac{\Gamma(x) \Gamma(y)}{\Gamma(x + y)}. \] It has |>\[ B(x + 1, y) = \frac{x}{x + y} B(x, y) \] |>\[
B(x, 1) = \frac1x. \]"""
SUMS = r"""The sums are |>\[ \sum_{k=1}^n k^2 = \frac{n (n + 1) (2 n + 1)}{6} \] |>\[ \sum_{k=0}^n x^k =
\frac{x^{n + 1} - 1}{x - 1} \] |>\[ \sum_{k=1}^n \frac{1}{k (k + 1)} = \frac{n}{n + 1} \] |>\[ \prod_{k=1}^n k = n! \]
|>\[ \sum_{k=1}^n k \, k! = (n + 1)! - 1 \] |>\[ \sum_{k=1}^n \cos(k x) = \frac{\sin\frac{n x}{2} \cos\frac{(n + 1)
x}{2}}{\sin\frac{x}{2}} \] |>\[ \sum_{k=0}^n (-1)^k = \frac{1 + (-1)^n}{2}. \]"""
TEXTS = {
    "complex": COMPLEX,
    "whole": WHOLE,
    "slopes": SLOPES,
    "factorials": FACTORIALS,
    "gamma": GAMMA,
    "euler": EULER,
    "sums": SUMS,
}
MISPRINTS = [
    ("complex", r"e^{z + 2 \pi i}", r"e^{z + \pi i}"),
    ("complex", r"= i \sinh z", r"= -i \sinh z"),
    ("complex", r"= \cos z + i", r"= \cos z - i"),
    ("whole", r"= (-1)^n \sin x", r"= (-1)^{n+1} \sin x"),
    ("whole", r"\cos(n \pi) = (-1)^n", r"\cos(n \pi) = 1"),
    ("whole", r"\cos(2 n \pi - x) = \cos x", r"\cos(n \pi - x) = \cos x"),
    ("slopes", r"\frac{1}{\sqrt{1 - x^2}}", r"\frac{1}{\sqrt{1 + x^2}}"),
    ("slopes", r"= -\csc^2 x", r"= \csc^2 x"),
    ("slopes", r"= a x^{a-1}", r"= a x^{a}"),
    ("factorials", r"= (n + 1) \, n!", r"= n \, n!"),
    ("factorials", r"+ \binom{n}{k + 1}", r"+ \binom{n}{k - 1}"),
    ("factorials", r"= n \binom{n - 1}{k - 1}", r"= n \binom{n - 1}{k}"),
    ("factorials", r"= (x + y)^n", r"= (x - y)^n"),
    ("factorials", r"= 2^n", r"= 2^n - 1"),
    ("gamma", r"z (z + 1) \Gamma(z)", r"z (z - 1) \Gamma(z)"),
    ("gamma", r"\Gamma(n + 1) = n!", r"\Gamma(n) = n!"),
    ("euler", r"\frac{x}{x + y} B(x, y)", r"\frac{y}{x + y} B(x, y)"),
    ("euler", r"B(x, 1) = \frac1x", r"B(x, 1) = \frac2x"),
    ("sums", r"(2 n + 1)}{6}", r"(2 n - 1)}{6}"),
    ("sums", r"\frac{x^{n + 1} - 1}", r"\frac{x^n - 1}"),
    ("sums", r"= (n + 1)! - 1", r"= (n + 1)! + 1"),
    ("sums", r"\frac{1 + (-1)^n}{2}", r"\frac{1 - (-1)^n}{2}"),
]
ENEMIES = [
    r"Let $z \in \mathbb{C}$. \[ \ln(z^2) = 2 \ln z \]",
    r"Let $z \in \mathbb{C}$. \[ \sqrt{z^2} = z \]",
    r"Let $z, w \in \mathbb{C}$. \[ \sqrt{z} \sqrt{w} = \sqrt{z w} \]",
    r"Let $z \in \mathbb{C}$. \[ \ln e^z = z \]",
    r"Let $z \in \mathbb{C}$. \[ \arcsin(\sin z) = z \]",
    r"The index $n$ is that of refraction. \[ \cos(n \pi) = (-1)^n \]",
    r"Let $n$ be real. \[ \sin(n \pi) = 0 \]",
    r"Let $n \in \mathbb{Z}$. \[ \sin(n \pi / 2) = 0 \]",
    r"Let $n \in \mathbb{Z}$. \[ (-1)^{n/2} = 1 \]",
    r"Let $n \in \mathbb{Z}$ and $m = n/2$. \[ m = n/2 \] \[ \cos(2 \pi m) = 1 \]",
    r"The strength of the vortex is $\Gamma$. \[ \Gamma(z + 1) = z \Gamma(z) \]",
    r"\[ n!! = n \, (n - 1)! \]",
    r"\[ \binom{-n}{k} = \binom{-n}{-n - k} \]",
    r"\[ \sum_{k=0}^n \binom{n}{k} x_k^k = (1 + x_k)^n \]",
    r"\[ x = k + 1 \] \[ \sum_{k=0}^n \binom{n}{k} x^k = (1 + x)^n \]",
    r"\[ \sum_{k=1}^n \binom{n}{k} = 2^n \]",
    r"\[ \sum_{k=0}^n (-1)^k \binom{n}{k} = 0 \]",
    r"\[ \sum_{k=1}^n a_k = n a_k \]",
    r"\[ \sum_{k=1}^n k = \frac{n (n + 1)}{2} + \sin(\pi n) \tan(\pi n / 2) \]",
    r"\[ \sum_{k=1}^n \frac{1}{(k - 3) (k - 4)} = \frac{n}{3 (3 - n)} \]",
    r"\[ c = n^2 \] \[ \sum_{k=1}^n c = c n \] \[ \sum_{k=1}^n 2 k = c \]",
    r"\[ \sum_{k=1}^n k = \frac{k (k + 1)}{2} \]",
    r"\[ c - k = 1 \] \[ \sum_{k=1}^n c = n c \]",
    r"\[ c_0 - c_1 = k \] \[ \sum_{k=1}^n c_0 = n c_0 \]",
    r"\[ \binom{999999999}{3} = 999999999! \]",
    r"\[ \frac{d}{dx} |x| = 1 \]",
    r"\[ \frac{d}{dx} x^x = x x^{x-1} \]",
    r"\[ y = x^x \] \[ \frac{dy}{dx} = x x^{x-1} \]",
    r"\[ a = 2 x \] \[ \frac{d}{dx} x^a = a x^{a-1} \]",
    r"\[ \frac{d}{dx} (-1)^x = 0 \]",
    r"\[ \frac{d}{dx} 2^x = 0 \]",
    r"The logarithm has base ten. \[ \frac{d}{dx} \log x = \frac{1}{x} \]",
    r"\[ \binom{n}{n + 1} = 0 \]",
    r"The number $n$ is not an integer. \[ \cos(2 n \pi) = 1 \]",
    r"The phase $n$ is an integer multiple of $1/2$. \[ \cos(2 n \pi) = 1 \]",
    r"Let $s$ be a half integer. \[ \cos(2 \pi s) = 1 \]",
    r"For non-integer $s$, \[ \cos(2 \pi s) = 1 \]",
    r"The quotient of two integers $q$. \[ \cos(2 \pi q) = 1 \]",
    r"The ratio $q$ is never an integer. \[ \cos(2 \pi q) = 1 \]",
    r"The ratio $q$ is close to an integer. \[ \cos(2 \pi q) = 1 \]",
    r"If $q$ is an integer, the wave closes. If it is not, \[ \cos(2 \pi q) = 1 \]",
    r"The mean is $\sum_{k=1}^n a_k$. The wave number $k$ is real. \[ \cos(2 \pi k) = 1 \]",
    r"The mean is \[ m = \sum_{i=1}^n a_i \] The unit normal is $n$. \[ \sin(\pi n) = 0 \]",
    r"\[ m = \sum_{t=0}^T a_t \] \[ x = \cos(2\pi t) \] Hence \[ x = 1 \]",
    r"Let $n \in \mathbb{Z}/5\mathbb{Z}$. \[ \cos(\pi n) = (-1)^n \]",
    r"Let $n \in \mathbb{Z}[\sqrt 2]$. \[ \cos(\pi n) = (-1)^n \]",
    r"Let $n \in \mathbb{Z}_p$. \[ \cos(\pi n) = (-1)^n \]",
    r"Let $n \in \mathbb{N}$. The same letter denotes a real number below. \[ \cos(2 \pi n) = 1 \]",
    r"Unless $n \in \mathbb{Z}$, \[ \cos(2 \pi n) = 1 \]",
    r"We do not assume $n \in \mathbb{Z}$. \[ \cos(2 \pi n) = 1 \]",
    r"\section{A} Let $x \in \mathbb{N}$. \section{B} Let $x \in \mathbb{R}$. \[ \cos(2 \pi x) = 1 \]",
    r"\section{A} Let $x \in \mathbb{N}$. \section{B} The depth is $x$. \[ \cos(2 \pi x) = 1 \]",
    r"\[ e = k \] \[ \sum_{k=1}^n e = n e \]",
    r"The weight $e$ depends on $k$. \[ \sum_{k=1}^n e k = e n (n+1)/2 \]",
    r"The policy is $\pi$, which depends on $k$. \[ \sum_{k=1}^n \pi k = \pi n (n+1)/2 \]",
    r"The circulation is $\Gamma$. Unlike the gamma function, \[ \Gamma(z+1) = z\Gamma(z) \]",
    r"The gamma function is rare. The circulation $\Gamma(r)$ depends on $r$. \[ \Gamma(r+1) = r \Gamma(r) \]",
    r"The $q$-gamma function: \[ \Gamma(z+1) = z \Gamma(z) \]",
    r"The $p$-adic gamma function: \[ \Gamma(z+1) = z \Gamma(z) \]",
    r"\[ \Gamma(x) = \int_0^\infty t^x e^{-t} dt \] Hence \[ \Gamma(x + 1) = x \Gamma(x) \]",
    r"The gamma function is not meant. \[ \Gamma(x+1) = x \Gamma(x) \]",
    r"\[ \frac{d}{dx} \operatorname{sign} x = 0 \]",
]


def readings(text):
    return read_document(document_of(plain(text)))


@pytest.mark.parametrize("name", TEXTS)
def test_what_a_handbook_lists_follows(name):
    found = [each.verdict for each in readings(TEXTS[name])]
    assert [each == "follows" for each in found] == follow(TEXTS[name]), found


@pytest.mark.parametrize(("name", "printed", "wrong"), MISPRINTS)
def test_no_misprint_of_a_handbook_follows(name, printed, wrong):
    text, place = with_misprint(TEXTS[name], printed, wrong)
    assert readings(text)[place].verdict != "follows"


@for_each("latex", ENEMIES)
def test_what_only_looks_so_does_not_follow(latex):
    assert readings(latex)[-1].verdict != "follows", latex


@for_each(
    "latex, hypothesis",
    [
        (r"Let $n \in \mathbb{Z}$. \[ \cos(n \pi) = (-1)^n \]", "n is a whole number"),
        (r"Let $n \in \mathbb{Z}$. \[ \int_0^\pi \cos(n x) dx = 0 \]", "n"),
        (r"\[ \sum_{k=2}^n k = \frac{(n - 1) (n + 2)}{2} \]", "n is a whole number >= 2"),
        (r"\[ \binom{n}{k} = \binom{n}{n - k} \]", "1/factorial(n)"),
        (r"\[ \sum_{k=1}^n \frac{k - 3}{k - 3} = n \]", "n - 2, also for each smaller n"),
        (r"The gamma function: \[ \Gamma(z + 1) = z \Gamma(z) \]", "z"),
    ],
)
def test_hypotheses_say_for_what_numbers_an_identity_holds(latex, hypothesis):
    assert hypothesis in readings(latex)[-1].links[0].hypotheses
