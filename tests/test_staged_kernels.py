"""Kernels with stages and several results, from their declaration to the verified function."""

import ast
import inspect
import math
import signal
from collections import Counter
from fractions import Fraction
from itertools import count

import mpmath
import numpy as np
import pytest
import sympy
from hypothesis import assume, example, given
from hypothesis import strategies as st

import algebroproj
from algebroproj_sym import Section
from algebroproj_sym.declaring import arctan2, cos_sin, let, null_vector, solution
from algebroproj_sym.expressions import Matrix, entries, over, vector
from algebroproj_sym.generating.backends.numpy import render
from algebroproj_sym.generating.backends.numpy.printer import LINE, statements
from algebroproj_sym.generating.choosing import lower
from algebroproj_sym.generating.lowering import LoweringError
from algebroproj_sym.generating.program import Call, Program, Step, run
from algebroproj_sym.generating.runtime import systems
from algebroproj_sym.generating.samples import stratified
from algebroproj_sym.generating.writing import NOTICE, PACKAGE, write
from algebroproj_sym.proving import ENGINES
from algebroproj_sym.study.arithmetics import double_double, float64_balls, mpmath_digits
from algebroproj_sym.study.precision import apply, lift, nearest
from algebroproj_sym.verifying.accuracy import measured
from algebroproj_sym.verifying.oracle import oracle
from algebroproj_sym.verifying.proof_of_source import in_general, source_is_proved
from algebroproj_sym.verifying.shipped import call, function_of, load_package
from algebroproj_sym.verifying.verification import silent_factors, verify

p0, p1, q0, q1, angle = sympy.symbols("p0 p1 q0 q1 angle")
a00, a01, a10, a11, b0, b1 = sympy.symbols("a00 a01 a10 a11 b0 b1")
r0, r1, r2, s0, s1, s2 = sympy.symbols("r0 r1 r2 s0 s1 s2")
c, s, u, v, dx, dy, n0, n1, n2 = sympy.symbols("c s u v dx dy n0 n1 n2")
x, y, z = sympy.symbols("x y z")

silently = pytest.mark.filterwarnings("ignore::RuntimeWarning")
every_engine = pytest.mark.parametrize("engine", ENGINES)


def kernel(name, arguments, derived, through, **options):
    decimals = (f"{place % 7 + 1}.25" if place % 3 else f"-{place % 5 + 1}.5" for place in count(1))

    def example(value):
        if not isinstance(value, sympy.MatrixBase):
            return next(decimals)
        if value.cols == 1:
            return [next(decimals) for _ in value]
        return [[next(decimals) for _ in range(value.cols)] for _ in range(value.rows)]

    return Section("demo", "1", "Demonstration").kernel(
        name,
        "A function.",
        arguments=arguments,
        derived=derived,
        through=through,
        claims=["1.1"],
        example={key: example(value) for key, value in arguments.items()},
        describe=dict.fromkeys(arguments, "Some numbers."),
        **options,
    )


def of_xy(derived, through, **options):
    return kernel("demo.f", {"x": x, "y": y}, derived, through, **options)


TURN = kernel(
    "plane.turn",
    {"p": vector(p0, p1), "angle": angle},
    vector(c * p0 - s * p1, s * p0 + c * p1),
    [cos_sin(c, s, angle)],
)
MEET = kernel(
    "plane.meet",
    {"a": Matrix([[a00, a01], [a10, a11]]), "b": vector(b0, b1)},
    {"point": vector(u, v), "product": u * v},
    [solution([u, v], Matrix([[a00, a01], [a10, a11]]), vector(b0, b1))],
    normwise=True,
)
HEADING = kernel(
    "plane.heading",
    {"p": vector(p0, p1), "q": vector(q0, q1)},
    {"heading": angle, "squared": dx**2 + dy**2},
    [let({dx: q0 - p0, dy: q1 - p1}), arctan2(angle, dy, dx)],
)
NORMAL = kernel(
    "space.normal",
    {"r": vector(r0, r1, r2), "s": vector(s0, s1, s2)},
    vector(n0, n1, n2),
    [null_vector([n0, n1, n2], Matrix([[r0, r1, r2], [s0, s1, s2]]))],
    normwise=True,
)
AREA = kernel("space.area", {"p": vector(p0, p1)}, {"area": p0 * p1, "perimeter": 2 * p0 + 2 * p1}, [])
NAMED = kernel("names.ratio", {"x": x, "y": y}, over(u * x, v), [let({u: x + y, v: x - y})])
KERNELS = {k.qualified_name: k for k in (TURN, MEET, HEADING, NORMAL, AREA, NAMED)}
LOWERED = {name: lower(k) for name, k in KERNELS.items()}
STAGED = {name: k for name, k in KERNELS.items() if k.stages}
every_kernel = pytest.mark.parametrize("declared", KERNELS.values(), ids=KERNELS)
every_staged_kernel = pytest.mark.parametrize("declared", STAGED.values(), ids=STAGED)


def shipped(folder, *kernels, changes=()):
    """Return a freshly generated package, loaded, with some changes to its text."""
    files = render([lower(k) for k in kernels])
    for name, old, new in changes:
        assert old in files[name], files[name]
        files[name] = files[name].replace(old, new)
    write(files, folder / PACKAGE)
    return load_package(folder)


@pytest.fixture(scope="module")
def package(tmp_path_factory):
    return shipped(tmp_path_factory.mktemp("package"), *KERNELS.values())


@pytest.fixture(scope="module")
def files():
    return render(LOWERED.values())


def cramer(rows):
    """Solve two linear equations exactly, or over any other field."""
    (a, b, e), (c, d, f) = rows
    return (e * d - b * f) / (a * d - b * c), (a * f - e * c) / (a * d - b * c)


def cross(rows):
    """Return the vector that is perpendicular to two, scaled so that its largest component is 1."""
    (a, b, c), (d, e, f) = rows
    product = (b * f - c * e, c * d - a * f, a * e - b * d)
    largest = max(product, key=abs)
    return tuple(component / largest for component in product)


def exactly(call, rows):
    """Interpret calls by closed forms on fractions; a cosine and a sine are those of twice the arc tangent."""
    if call.primitive == "let":
        return rows[0]
    if call.primitive == "cos_sin":
        t = Fraction(rows[0][0])
        return (1 - t**2) / (1 + t**2), 2 * t / (1 + t**2)
    if call.primitive == "arctan2":
        ((b, a),) = rows
        return (Fraction(b) / a,)
    return cramer(rows) if call.primitive == "solve" else cross(rows)


# Programs


def test_a_call_gives_names_to_the_results_of_its_rows():
    steps = (
        Step("t0", "+", ("x", 1)),
        Call(("u", "v"), "solve", (("x", 2, "t0"), ("t0", "x", 3))),
        Step("t1", "-", ("u", "v")),
    )
    seen = []

    def interpretation(call, rows):
        seen.append((call.primitive, rows))
        return 10, 4

    assert run(Program(("x",), steps, ("t1", "v", 7)), {"x": 5}, interpretation) == (6, 4, 7)
    assert seen == [("solve", ((5, 2, 6), (6, 5, 3)))]


def test_a_program_with_calls_needs_an_interpretation():
    program = Program(("x",), (Call(("c", "s"), "cos_sin", (("x",),)),), ("c",))
    with pytest.raises(TypeError, match="expected an interpretation of cos_sin, got none"):
        run(program, {"x": 1.0})


@pytest.mark.parametrize("results", [(), (1,), (1, 2, 3)])
def test_an_interpretation_gives_as_many_results_as_there_are_names(results):
    program = Program(("x",), (Call(("c", "s"), "cos_sin", (("x",),)),), ("c",))
    with pytest.raises(ValueError, match="zip"):
        run(program, {"x": 1.0}, lambda call, rows: results)


def test_names_cost_nothing_and_other_calls_count_as_operations():
    assert LOWERED["plane.turn"].plain.operations() == {"cos_sin": 1, "*": 4, "+": 1, "-": 1}
    assert LOWERED["plane.heading"].plain.operations() == {"arctan2": 1, "*": 2, "+": 1, "-": 2}
    assert LOWERED["plane.meet"].plain.operations() == {"solve": 1, "*": 1}
    assert LOWERED["space.normal"].plain.operations() == {"null_vector": 1}


fractions = st.fractions(-6, 6, max_denominator=5)


def value_at(expression, point):
    """Return the exact value of an expression; raise ZeroDivisionError where it has none."""
    value = expression.xreplace({s: sympy.Rational(str(v)) for s, v in point.items()}).doit()
    if not value.is_Rational:
        raise ZeroDivisionError
    return Fraction(int(value.p), int(value.q))


@every_staged_kernel
@given(data=st.data())
def test_a_program_is_exact_at_rational_points(declared, data):
    point = {symbol: data.draw(fractions, symbol.name) for symbol in declared.symbols}
    inputs = {symbol.name: value for symbol, value in point.items()}
    program = LOWERED[declared.qualified_name].plain
    try:
        for stage in declared.stages:
            rows = [tuple(value_at(entry, point) for entry in stage.derived.row(i)) for i in range(stage.derived.rows)]
            point |= dict(zip(stage.results, exactly(Call((), stage.primitive, ()), rows), strict=True))
        expected = [value_at(entry, point) for entry in entries(declared.derived)]
    except ZeroDivisionError:
        with pytest.raises(ZeroDivisionError):
            run(program, inputs, exactly)
    else:
        assert list(run(program, inputs, exactly)) == expected


monomials = st.builds(
    lambda *n: sympy.Mul(*(t**k for t, k in zip((x, y, u, c, s), n, strict=True))), *[st.integers(0, 2)] * 5
)
polynomials = st.lists(st.tuples(st.integers(-4, 4), monomials), min_size=1, max_size=4).map(
    lambda terms: sympy.Add(*(k * m for k, m in terms))
)


@example(sympy.S.Zero, sympy.S.Zero, c * y, (Fraction(0), Fraction(1, 3)))
@given(polynomials, polynomials, polynomials, st.tuples(fractions, fractions))
def test_a_chain_of_stages_is_computed_link_by_link(first, second, last, point):
    first = first.xreplace({u: x, c: y, s: x})
    second = second.xreplace({c: u, s: x})
    program = lower(of_xy(vector(last, u), [let({u: first}), cos_sin(c, s, second)])).plain
    at = dict(zip((x, y), point, strict=True))
    at[u] = value_at(first, at)
    at[c], at[s] = exactly(Call((), "cos_sin", ()), ((value_at(second, at),),))
    assert run(program, dict(zip("xy", point, strict=True)), exactly) == (value_at(last, at), at[u])


@pytest.mark.parametrize("number", [0, 3])
def test_a_link_that_is_a_number_is_computed_with(number, tmp_path):
    declared = of_xy(vector(s + 1, u), [let({u: sympy.Integer(number)}), cos_sin(c, s, u**2 * x)])
    function = shipped(tmp_path, declared).demo.f
    assert function(0.0, 1.0).tolist() == [1.0, number]
    assert function(2.0, 1.0)[0] == pytest.approx(1 + math.sin(2 * number**2), rel=1e-15)


def test_a_link_that_no_result_uses_stays():
    program = lower(of_xy(vector(x, y), [let({u: sympy.Integer(0)}), cos_sin(c, s, u)])).plain
    assert [step.primitive for step in program.steps] == ["let", "cos_sin"]


@given(polynomials, polynomials, polynomials)
def test_every_name_is_assigned_once_and_before_its_use(first, second, last):
    through = [let({u: first.xreplace({u: x, c: y, s: x})}), cos_sin(c, s, second.xreplace({c: u, s: x}))]
    program = lower(of_xy(vector(last, first.xreplace({c: x})), through)).plain
    known = set(program.inputs)
    for step in program.steps:
        names = step.names if isinstance(step, Call) else (step.name,)
        assert known.isdisjoint(names)
        assert all(type(operand) is int or operand in known for operand in step.operands)
        known.update(names)
    assert all(type(output) is int or output in known for output in program.outputs)


def test_stages_and_results_share_what_they_have_in_common():
    through = [cos_sin(c, s, x + y), let({u: c * (x + y)})]
    program = lower(of_xy(vector(u, s * (x + y) ** 2, x + y), through)).plain
    assert program.operations() == {"+": 1, "*": 3, "cos_sin": 1}


def test_sums_that_stages_have_in_common_are_summed_once():
    program = lower(of_xy(vector(u, v), [let({u: x + y + 1, v: x * y + x + y})])).plain
    assert program.operations() == {"+": 3, "*": 1}


# Lowering


def two_forms(primitive, right):
    """Return a kernel with one stage, whose form is right, or differs from what is derived in one sign."""
    sign = 1 if right else -1
    derived = over(x**2 - y**2, x + y)
    form = x - sign * y
    if primitive == "let":
        return of_xy(u * x, [let({u: derived, v: y}, form={u: form, v: y})])
    if primitive == "solve":
        system = Matrix([[x, y], [1, derived]])
        return of_xy(u, [solution([u, v], system, vector(x, 1), form=Matrix([[x, y, x], [1, form, 1]]))])
    matrix = Matrix([[x, y, 1], [derived, 1, y]])
    return of_xy(vector(u, v, z), [null_vector([u, v, z], matrix, form=Matrix([[x, y, 1], [form, 1, y]]))])


@pytest.mark.parametrize("primitive", ["let", "solve", "null_vector"])
def test_a_wrong_form_of_what_a_stage_is_given_is_refused(primitive):
    assert lower(two_forms(primitive, right=True)).hypotheses == (x + y,)
    with pytest.raises(LoweringError, match=r"^kernel demo\.f, form: entry \d differs from the derivation"):
        lower(two_forms(primitive, right=False))


@pytest.mark.parametrize("place", range(6))
def test_every_entry_of_a_system_is_compared(place):
    form = [x, y, x, 1, x - y, y]
    derived = Matrix([[x, y], [1, x - y]])
    lower(of_xy(u, [solution([u, v], derived, vector(x, y), form=Matrix(2, 3, form))]))
    form[place] = form[place] + x
    with pytest.raises(LoweringError, match=f"entry {place} differs"):
        lower(of_xy(u, [solution([u, v], derived, vector(x, y), form=Matrix(2, 3, form))]))


@pytest.mark.parametrize(
    ("derived", "form"),
    [
        (c, s),
        (c, -c),
        (c * x - s * y, c * x + s * y),
        (vector(c, s), vector(s, c)),
        (c**2 + s**2, sympy.Integer(1)),
        (over(s, c), over(c, s)),
        ({"first": c, "second": s}, {"first": c, "second": c}),
    ],
    ids=str,
)
def test_a_wrong_form_of_a_result_is_refused(derived, form):
    with pytest.raises(LoweringError, match=r"^kernel demo\.f, form: entry \d differs from the derivation"):
        lower(of_xy(derived, [cos_sin(c, s, x)], form=form))


def test_a_form_that_is_equal_for_any_cosine_and_sine_is_accepted():
    derived = {"first": (c + s) ** 2, "second": over(c * s, c)}
    form = {"first": c * (c + 2 * s) + s**2, "second": s}
    lowered = lower(of_xy(derived, [cos_sin(c, s, x)], form=form))
    assert run(lowered.plain, {"x": 1, "y": 2}, lambda call, rows: (Fraction(3), Fraction(5))) == (64, 5)
    assert (lowered.hypotheses, lowered.input_hypotheses) == ((c,), ())


def test_unknowns_are_told_apart():
    system = (Matrix([[x, y], [y, x + 1]]), vector(1, x))
    with pytest.raises(LoweringError):
        lower(of_xy(vector(u, v), [solution([u, v], *system)], form=vector(v, u)))


def test_a_divisor_that_the_form_of_a_stage_hides_is_guarded():
    hidden = of_xy({"first": u, "second": v}, [let({u: over(x * y, x), v: y}, form={u: y, v: y})])
    lowered = lower(hidden)
    assert (lowered.guarded, lowered.hypotheses, lowered.input_hypotheses) == ((x,), (x,), (x,))
    assert run(lowered.plain, {"x": Fraction(2), "y": Fraction(3)}, exactly) == (3, 3)
    with pytest.raises(ZeroDivisionError):
        run(lowered.plain, {"x": Fraction(0), "y": Fraction(3)}, exactly)
    with np.errstate(all="ignore"):
        assert not np.isfinite(run(lowered.plain, {"x": np.float64(0), "y": np.float64(3)}, exactly)).any()


def test_hypotheses_on_the_inputs_are_told_from_those_on_the_way():
    lowered = lower(of_xy(over(1, c) + over(1, u) + over(1, x), [let({u: x + y}), cos_sin(c, s, over(x, y))]))
    assert set(lowered.hypotheses) == {c, u, x, y}
    assert set(lowered.input_hypotheses) == {x, y}


def test_the_determinants_are_those_of_systems_that_the_inputs_decide():
    through = [
        let({z: x * y}),
        solution([u, v], Matrix([[x, y], [y, 2 * x]]), vector(1, 2)),
        solution([c, s], Matrix([[z, y], [y, 2 * x]]), vector(1, 2)),
    ]
    (determinant,) = lower(of_xy(u + c, through)).determinants
    assert sympy.expand(determinant - (2 * x**2 - y**2)) == 0


def test_a_constant_fraction_is_no_operand():
    with pytest.raises(LoweringError, match=r"demo\.f, form: expected no constant fraction"):
        lower(of_xy(x * u, [let({u: sympy.Rational(1, 2)})]))


# Source

INPUTS = ("x", "y", "z")
ARITY = {"let": (1, 2), "cos_sin": (1, 2), "arctan2": (1, 1), "solve": (2, 2), "null_vector": (2, 3)}


@st.composite
def programs(draw):
    """Any straight-line program with calls."""
    names, steps = list(INPUTS), []
    for place in range(draw(st.integers(0, 8))):
        recent = st.sampled_from(names[-3:]) | st.sampled_from(names)
        primitive = draw(st.sampled_from([None, None, *ARITY]))
        if primitive is None:
            operator = draw(st.sampled_from("+-*/"))
            steps.append(Step(f"t{place}", operator, (draw(recent), draw(recent | st.integers(-3, 3)))))
            names.append(f"t{place}")
            continue
        height, count = ARITY[primitive]
        width = {"let": 2, "cos_sin": 1, "arctan2": 2}.get(primitive, 3)
        operands = recent | st.integers(-3, 3)
        rows = draw(st.tuples(*[st.tuples(*[operands] * width)] * height))
        steps.append(Call(tuple(f"c{place}_{k}" for k in range(count)), primitive, rows))
        names.extend(steps[-1].names)
    outputs = draw(st.lists(st.sampled_from(names[-4:]) | st.integers(-3, 3), min_size=1, max_size=3))
    return Program(INPUTS, tuple(steps), tuple(outputs))


def body(program):
    """Return the statements as a tree: assignments, and a tuple that is returned."""
    (function,) = ast.parse("\n    ".join(["def body():", *statements(program)])).body
    return function.body


def pretended(call, rows):
    """Interpret a call by numbers that depend on every operand and its place."""
    if call.primitive == "let":
        return rows[0]
    weighted = sum((3 * i + j + 1) * np.float64(entry) for i, row in enumerate(rows) for j, entry in enumerate(row))
    return tuple(weighted + 0.5 * place for place in range(len(call.names)))


def pretended_functions():
    def function(primitive):
        height, count = ARITY[primitive]
        names = ("",) * count

        def called(*operands):
            rows = operands if height > 1 else (operands,)
            results = pretended(Call(names, primitive, ()), rows)
            return results if count > 1 else results[0]

        return called

    return {primitive: function(primitive) for primitive in ARITY if primitive != "let"}


def bits(value):
    return value if isinstance(value, int) else np.float64(value).tobytes()


@silently
@given(programs(), st.tuples(*[st.floats(-1e3, 1e3).map(np.float64)] * 3))
def test_printed_calls_give_the_bits_of_the_program(program, values):
    inputs = dict(zip(INPUTS, values, strict=True))
    namespace = pretended_functions()
    exec("\n    ".join([f"def body({', '.join(inputs)}):", *statements(program)]), namespace)
    assert list(map(bits, namespace["body"](*inputs.values()))) == list(map(bits, run(program, inputs, pretended)))


@given(programs())
def test_every_call_is_printed_once_in_order(program):
    found = [node.func.id for node in ast.walk(ast.Module(body(program), [])) if isinstance(node, ast.Call)]
    assert found == [step.primitive for step in program.steps if isinstance(step, Call) and step.primitive != "let"]


@given(programs())
def test_every_result_of_a_call_is_assigned_once_under_its_name(program):
    targets = Counter(
        node.id
        for statement in body(program)[:-1]
        for node in ast.walk(statement.targets[0])
        if isinstance(node, ast.Name)
    )
    assert set(targets.values()) <= {1}
    assert {name for step in program.steps if isinstance(step, Call) for name in step.names} <= set(targets)


def test_short_calls_stand_in_a_line_and_systems_in_a_line_for_each_row():
    steps = (
        Call(("u", "v"), "let", (("x", -1),)),
        Call(("c", "s"), "cos_sin", (("u",),)),
        Step("t0", "*", ("c", "x")),
        Call(("w",), "arctan2", (("s", "t0"),)),
        Call(("m", "n"), "solve", (("c", "s", 1), (0, "w", -2))),
    )
    assert statements(Program(("x",), steps, ("m", "n"))) == [
        "u = x",
        "v = -1",
        "c, s = cos_sin(u)",
        "w = arctan2(s, c * x)",
        "m, n = solve(",
        "    [c, s, 1],",
        "    [0, w, -2],",
        ")",
        "return m, n",
    ]


@every_kernel
def test_lines_of_staged_kernels_stay_readable(declared):
    lowered = lower(declared)
    assert max(map(len, statements(lowered.plain))) <= 2 * LINE


# The package


def functions_of(text):
    return {node.name: node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef)}


def imports_of(text):
    found = [node for node in ast.parse(text).body if isinstance(node, ast.ImportFrom) and node.level == 1]
    return {node.module: [alias.name for alias in node.names] for node in found}


def docstring_of(declared, files):
    return ast.get_docstring(functions_of(files[f"{declared.module}.py"])[declared.name])


def test_a_module_imports_the_primitive_functions_that_it_calls_and_no_others(files):
    homes = {"_runtime.arctan2": ["arctan2"], "_runtime.cos_sin": ["cos_sin"], "_runtime.systems": ["solve"]}
    assert homes.items() <= imports_of(files["plane.py"]).items()
    assert imports_of(files["space.py"])["_runtime.systems"] == ["null_vector"]
    assert homes.keys().isdisjoint(imports_of(files["names.py"]))
    assert homes.keys().isdisjoint(imports_of(render([lower(AREA)])["space.py"]))


def test_the_primitive_functions_travel_with_the_package_under_the_notice(files):
    source = inspect.getsource(systems)
    assert NOTICE not in source
    assert files["_runtime/systems.py"].replace(f"\n\n{NOTICE}", "", 1) == source
    assert NOTICE in ast.get_docstring(ast.parse(files["_runtime/systems.py"]))


def test_a_package_has_the_modules_that_it_imports_and_no_others():
    without, with_angles = (render([lower(kernel)]) for kernel in (AREA, TURN))
    runtimes = [{name for name in files if name.startswith("_runtime/")} for files in (without, with_angles)]
    assert runtimes[1] - runtimes[0] == {"_runtime/cos_sin.py"}
    assert "_runtime/systems.py" not in with_angles
    for files, own in zip((without, with_angles), runtimes, strict=True):
        imported = {f"_runtime/{module}.py" for name in own for module in imports_of(files[name])}
        assert imported <= own


@every_kernel
def test_several_results_are_documented_by_name_and_shape(declared, files):
    section = docstring_of(declared, files).partition("Returns\n-------\n")[2].partition("\n\nRaises")[0]
    documented = [line for line in section.splitlines() if not line.startswith(" ")]
    shapes = [f"ndarray, shape ({', '.join(['...', *map(str, result.shape)])})" for result in declared.results]
    names = [f"{result.name} : " if len(declared.results) > 1 else "" for result in declared.results]
    assert documented == [name + shape for name, shape in zip(names, shapes, strict=True)]


def test_the_formula_shows_the_stages_before_the_results(files):
    def formula(declared):
        notes = docstring_of(declared, files).partition("Formula::\n\n")[2]
        return [line.strip() for line in notes.partition("\n\n")[0].splitlines()]

    assert formula(TURN)[0] == "c, s = cos_sin(angle)"
    assert formula(MEET)[:3] == ["u, v = solve of", "a00, a01, b0", "a10, a11, b1"]
    assert formula(NORMAL)[:3] == ["n0, n1, n2 = null_vector of", "r0, r1, r2", "s0, s1, s2"]
    heading = formula(HEADING)
    assert [sympy.sympify(line.partition(" = ")[2]) for line in heading[:2]] == [q0 - p0, q1 - p1]
    assert [line.partition(" = ")[0] for line in heading] == ["dx", "dy", "angle", "heading", "squared"]
    assert heading[2] == "angle = arctan2(dy, dx)"


# The functions

CORES = {name: [argument.shape for argument in k.arguments] for name, k in KERNELS.items()}


def drawn(declared, *batches, dtype=np.float64):
    """Return arguments in general position."""
    generator = np.random.default_rng(11)
    cores = CORES[declared.qualified_name]
    shapes = [batch + core for batch, core in zip(batches or [()] * len(cores), cores, strict=True)]
    return [generator.uniform(0.5, 2, shape).astype(dtype) for shape in shapes]


def as_tuple(results):
    return results if isinstance(results, tuple) else (results,)


REAL = [np.float32, np.float64, np.longdouble]


@every_kernel
@pytest.mark.parametrize("dtype", [*REAL, np.complex64, np.complex128])
def test_the_dtype_is_preserved_and_its_precision_used(declared, dtype, package):
    if declared is HEADING and dtype not in REAL:
        with pytest.raises(TypeError):
            function_of(declared, package)(*drawn(declared, dtype=dtype))
        return
    function = function_of(declared, package)
    single = drawn(declared, *[(5,)] * len(declared.arguments), dtype=np.float32)
    results = as_tuple(function(*(a.astype(dtype) for a in single)))
    expected = as_tuple(function(*(a.astype(np.longdouble) for a in single)))
    assert {result.dtype for result in results} == {np.dtype(dtype)}
    for result, exact in zip(results, expected, strict=True):
        np.testing.assert_allclose(result, exact, rtol=200 * np.finfo(dtype).eps, atol=200 * np.finfo(dtype).eps)


@given(st.lists(st.tuples(*[fractions] * 6), min_size=1, max_size=3))
def test_fractions_give_the_exact_intersection(package, members):
    assume(all(a * d != b * c for a, b, c, d, _, _ in members))
    matrices = np.array([[[a, b], [c, d]] for a, b, c, d, _, _ in members], dtype=object)
    sides = np.array([[e, f] for *_, e, f in members], dtype=object)
    points, products = package.plane.meet(matrices, sides)
    expected = [cramer(((a, b, e), (c, d, f))) for a, b, c, d, e, f in members]
    assert [tuple(point) for point in points.tolist()] == expected
    assert products.tolist() == [first * second for first, second in expected]


@given(st.tuples(*[fractions] * 6))
def test_fractions_give_the_exact_normal(package, values):
    rows = values[:3], values[3:]
    product = (
        rows[0][1] * rows[1][2] - rows[0][2] * rows[1][1],
        rows[0][2] * rows[1][0] - rows[0][0] * rows[1][2],
        rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0],
    )
    arguments = [np.array(row, dtype=object) for row in rows]
    if not any(product):
        with pytest.raises(ZeroDivisionError):
            package.space.normal(*arguments)
        return
    normal = package.space.normal(*arguments).tolist()
    assert all(isinstance(component, Fraction) for component in normal)
    assert max(map(abs, normal)) == 1
    assert 1 in normal
    assert all(normal[i] * product[j] == normal[j] * product[i] for i in range(3) for j in range(i))


def test_a_turn_and_a_heading_are_each_other_s_inverse(package):
    angles = np.linspace(-3, 3, 13)
    for length in (0.1, 7.0):
        turned = package.plane.turn([length, 0.0], angles)
        found, squared = package.plane.heading([0.0, 0.0], turned)
        np.testing.assert_allclose(found, angles, atol=1e-15)
        np.testing.assert_allclose(squared, length**2, rtol=1e-15)


# The oracle


def digits_apart(value, exact):
    """Return the relative difference to an exact fraction, far beyond the digits of floats."""
    with mpmath.workdps(70):
        truth = mpmath.mpf(exact.numerator) / exact.denominator
        return abs(value - truth) / abs(truth) if truth else abs(value)


floats = st.floats(-1e3, 1e3).filter(lambda value: abs(value) > 1e-3)
FIFTY_DIGITS = mpmath.mpf(10) ** -50


@given(st.tuples(*[floats] * 6))
def test_the_oracle_solves_to_fifty_digits(values):
    exact = [Fraction(value) for value in values]
    a, b, c, d, e, f = exact
    assume(a * d != b * c)
    unknowns = cramer(((a, b, e), (c, d, f)))
    assume(all(unknowns))
    truth = oracle(MEET)(dict(zip(("a00", "a01", "a10", "a11", "b0", "b1"), values, strict=True)))
    for value, expected in zip(truth.values, (*unknowns, unknowns[0] * unknowns[1]), strict=True):
        assert digits_apart(value, expected) < FIFTY_DIGITS


@given(st.tuples(*[floats] * 6))
def test_the_oracle_spans_null_spaces_to_fifty_digits(values):
    rows = [tuple(map(Fraction, values[:3])), tuple(map(Fraction, values[3:]))]
    names = [symbol.name for symbol in NORMAL.symbols]
    try:
        expected = cross(rows)
    except ZeroDivisionError:
        return
    sizes = sorted(map(abs, expected))
    assume(all(expected))
    assume(sizes[2] != sizes[1])
    truth = oracle(NORMAL)(dict(zip(names, values, strict=True)))
    assert all(digits_apart(value, exact) < FIFTY_DIGITS for value, exact in zip(truth.values, expected, strict=True))


@pytest.mark.parametrize("rows", [((3.0, 2.0, 0.0), (0.0, 0.0, 1.0)), ((1.0, 2.0, 3.0), (1.0, 1.0, 1.0))])
def test_the_oracle_finds_null_vectors_of_small_integers(rows):
    truth = oracle(NORMAL)(dict(zip([s.name for s in NORMAL.symbols], rows[0] + rows[1], strict=True)))
    residuals = [sum(a * n for a, n in zip(row, truth.values, strict=True)) for row in rows]
    assert max(map(abs, residuals)) < FIFTY_DIGITS
    assert max(truth.values, key=abs) == 1


@given(floats, floats, floats)
def test_the_oracle_turns_by_cosine_and_sine(first, second, turned_by):
    truth = oracle(TURN)({"p0": first, "p1": second, "angle": turned_by})
    with mpmath.workdps(100):
        cosine, sine = mpmath.cos(turned_by), mpmath.sin(turned_by)
        expected = (cosine * first - sine * second, sine * first + cosine * second)
        for value, exact in zip(truth.values, expected, strict=True):
            assert abs(value - exact) <= FIFTY_DIGITS * abs(exact)


@given(st.tuples(*[floats] * 4))
def test_the_oracle_knows_headings_in_all_quadrants(values):
    names = ("p0", "p1", "q0", "q1")
    truth = oracle(HEADING)(dict(zip(names, values, strict=True)))
    with mpmath.workdps(100):
        x_difference, y_difference = (mpmath.mpf(values[k + 2]) - mpmath.mpf(values[k]) for k in (0, 1))
        assert abs(truth.values[0] - mpmath.atan2(y_difference, x_difference)) <= FIFTY_DIGITS
        assert abs(truth.values[1] - x_difference**2 - y_difference**2) <= FIFTY_DIGITS * truth.values[1]


def test_sensitivities_reach_through_the_stages():
    truth = oracle(TURN)({"p0": 3.0, "p1": -2.0, "angle": 0.7})
    cosine, sine = np.cos(0.7), np.sin(0.7)
    first = 3 * cosine + 2 * sine + 0.7 * abs(-sine * 3 + cosine * 2)
    second = 3 * sine + 2 * cosine + 0.7 * abs(cosine * 3 + sine * 2)
    assert [float(value) for value in truth.sensitivities] == pytest.approx([first, second])


def test_a_singular_system_has_no_truth():
    with pytest.raises(ZeroDivisionError):
        oracle(MEET)({"a00": 1.0, "a01": 2.0, "a10": 2.0, "a11": 4.0, "b0": 1.0, "b1": 1.0})


# Proving the source


@every_engine
@every_kernel
def test_every_function_is_proved(declared, engine, package):
    assert in_general(declared, engine).is_met_by(function_of(declared, package))


def test_proving_leaves_the_functions_as_they_were(package):
    before = package.plane.solve, package.plane.cos_sin
    source_is_proved(MEET, package)
    assert (package.plane.solve, package.plane.cos_sin) == before
    np.testing.assert_allclose(package.plane.meet([[2.0, 1], [1, -1]], [5.0, 1])[0], [2, 1], rtol=1e-15)


PLANTED = {
    "cosine and sine exchanged": (TURN, "c, s = cos_sin(", "s, c = cos_sin("),
    "wrong sense of the turn": (TURN, "cos_sin(wide(angle))", "cos_sin(wide(-angle))"),
    "wrong sign of a product": (TURN, "c * p0 - wide(p1) * s", "c * p0 + wide(p1) * s"),
    "unknowns exchanged": (MEET, "u, v = solve(", "v, u = solve("),
    "matrix transposed": (MEET, "[a00, a01, b0],\n        [a10, ", "[a00, a10, b0],\n        [a01, "),
    "wrong sign in a system": (MEET, "[a10, a11, b1]", "[a10, -a11, b1]"),
    "wrong sign of a right side": (MEET, "a01, b0]", "a01, -b0]"),
    "wrong result": (MEET, "u * v", "u * u"),
    "results exchanged": (MEET, "return u, v", "return v, v"),
    "y and x exchanged": (HEADING, "arctan2(dy, dx)", "arctan2(dx, dy)"),
    "opposite direction": (HEADING, "dx = q0 - p0", "dx = p0 - q0"),
    "another coordinate": (HEADING, "dy = q1 - p1", "dy = q1 - p0"),
    "named value changed": (NAMED, "u = x + y", "u = x - y"),
    "equation changed": (NORMAL, "[s0, s1, s2]", "[s0, s1, -s2]"),
    "equation repeated": (NORMAL, "[s0, s1, s2]", "[r0, r1, r2]"),
    "components exchanged": (NORMAL, "n0, n1, n2 = null_vector(", "n1, n0, n2 = null_vector("),
    "no call at all": (MEET, "u, v = solve(", "u, v = (lambda first, second: (first[2], second[2]))("),
}


@pytest.mark.sampled(3)
@pytest.mark.parametrize("mistake", PLANTED)
def test_a_planted_mistake_is_not_proved_and_samples_find_it(mistake, tmp_path):
    declared, old, new = PLANTED[mistake]
    package = shipped(tmp_path, declared, changes=[(f"{declared.module}.py", old, new)])
    assert not source_is_proved(declared, package)
    low = LOWERED[declared.qualified_name]
    assert not measured(low, function_of(declared, package), stratified(low, 6)).within_bound


def test_a_mistake_within_one_of_several_stages_is_not_proved(tmp_path):
    system = solution([u, v], Matrix([[z, 1], [c, s]]), vector(x, y))
    declared = of_xy(vector(u * c, v * s), [let({z: x - y}), cos_sin(c, s, z), system])
    assert source_is_proved(declared, shipped(tmp_path / "right", declared))
    for place, (old, new) in enumerate(
        [
            ("z = wide(x) - y", "z = wide(y) - x"),
            ("= cos_sin(z)\n    c", "= cos_sin(wide(x))\n    c"),
            ("u, v = solve", "v, u = solve"),
            ("[z, 1, x]", "[z, 1, y]"),
            ("[t3, t4, y]", "[t4, t3, y]"),
        ]
    ):
        package = shipped(tmp_path / str(place), declared, changes=[("demo.py", old, new)])
        assert not source_is_proved(declared, package), (old, new)


def test_a_constant_system_is_solved(tmp_path):
    declared = of_xy(u * x, [solution([u, v], Matrix([[3, 1], [1, 2]]), vector(1, 1))])
    assert shipped(tmp_path, declared).demo.f(1.0, 2.0) == pytest.approx(0.2)


SYSTEM = solution([u, v], Matrix([[x, y], [y + 1, x]]), vector(1, 2 * x))
SOLVING = of_xy(vector(u, v), [SYSTEM])
TURNING = of_xy(c, [cos_sin(c, s, x)])
OTHERWISE_CALLED = {
    "another primitive function": (
        of_xy(vector(u, v, n0, n1, n2), [SYSTEM, null_vector([n0, n1, n2], Matrix([[x, y, 1], [y, x, 2]]))]),
        [("v = solve(", "v = third("), ("n2 = null_vector(", "n2 = solve("), ("v = third(", "v = null_vector(")],
    ),
    "rows grouped in another way": (
        SOLVING,
        [
            (
                "        [x, y, 1],\n        [wide(y) + 1, x, 2 * wide(x)],",
                "        [x, y], [1, wide(y) + 1], [x, 2 * wide(x)],",
            )
        ],
    ),
    "a call too many": (TURNING, [("    return (c,)", "    c, s = cos_sin(c)\n    return (c,)")]),
    "no primitive function": (
        TURNING,
        [("from ._runtime.cos_sin import cos_sin\n", ""), ("c, s = cos_sin(x)", "c, s = x, y")],
    ),
}


@pytest.mark.parametrize(("declared", "changes"), OTHERWISE_CALLED.values(), ids=OTHERWISE_CALLED)
def test_what_is_called_otherwise_is_not_proved(declared, changes, tmp_path):
    changed = [("demo.py", old, new) for old, new in changes]
    assert not source_is_proved(declared, shipped(tmp_path, declared, changes=changed))


# Samples and all together


def test_samples_come_near_singular_systems():
    samples = stratified(LOWERED["plane.meet"], 28)
    near = [sample.values for sample in samples if sample.stratum == "near a singular system"]
    assert len(near) == 28
    determinants = [
        abs(float(Fraction(v["a00"]) * Fraction(v["a11"]) - Fraction(v["a01"]) * Fraction(v["a10"]))) for v in near
    ]
    assert min(determinants) < 1e-11
    assert max(determinants) > 1e-2
    assert {sample.stratum for sample in samples} == {"ordinary", "badly scaled", "near a singular system"}


@pytest.fixture
def _ending():
    """Stop a test that does not end."""

    def stop(*_):
        raise TimeoutError("does not end")

    before = signal.signal(signal.SIGALRM, stop)
    signal.alarm(15)
    yield
    signal.alarm(0)
    signal.signal(signal.SIGALRM, before)


@pytest.mark.usefixtures("_ending")
@pytest.mark.parametrize(
    "matrix",
    [[[x, -y], [y, x]], [[1, x], [0, 1]], [[x, y], [x, y]], [[over(1, x), y], [y, x]]],
    ids=["not affine in any variable", "constant determinant", "always singular", "with a division"],
)
def test_samples_near_a_singular_system_end(matrix):
    lowered = lower(of_xy(vector(u, v), [solution([u, v], Matrix(matrix), vector(1, y))]))
    assert len(stratified(lowered, 3)) >= 6


@pytest.mark.usefixtures("_ending")
def test_samples_near_a_hypothesis_that_is_not_affine_end():
    assert len(stratified(lower(of_xy(over(1, x**2 + y**2), [])), 3)) >= 6


def test_samples_come_near_hypotheses_on_the_inputs_only():
    lowered = lower(of_xy(over(c, x) + over(1, c), [cos_sin(c, s, y)]))
    assert {sample.stratum for sample in stratified(lowered, 3)} == {"ordinary", "badly scaled", "near x"}


def test_a_singularity_that_a_staged_function_skips_is_silent(tmp_path):
    declared = of_xy(vector(u, c), [let({u: over(x * y, x)}, form={u: y}), cos_sin(c, s, y)])
    lowered = lower(declared)
    assert lowered.guarded == (x,)
    assert silent_factors(lowered, shipped(tmp_path / "right", declared)) == ()
    unguarded = shipped(tmp_path / "wrong", declared, changes=[("demo.py", "0 / x", "0 * x")])
    assert silent_factors(lowered, unguarded) == (x,)


@every_kernel
def test_every_function_is_verified(declared, package):
    verification = verify(LOWERED[declared.qualified_name], package, size=10)
    assert verification.source_proved
    assert verification.silent == ()
    assert verification.accuracy.within_bound
    assert verification.passed


def test_near_singular_systems_are_part_of_the_verification(package):
    low = LOWERED["plane.meet"]
    found = measured(low, function_of(low.kernel, package), stratified(low, 14))
    strata = {stratum.name: stratum.samples for stratum in found.strata}
    assert strata == {"ordinary": 14, "badly scaled": 14, "near a singular system": 14}


@every_kernel
def test_results_of_one_call_are_joined_in_order(declared, package):
    values = {symbol.name: np.array([0.5 + k, 1.25 - k]) for k, symbol in enumerate(declared.symbols)}
    joined = call(function_of(declared, package), declared, values)
    assert joined.shape == (2, sum(int(np.prod(result.shape)) for result in declared.results))
    truth = oracle(declared)({name: float(value[1]) for name, value in values.items()})
    np.testing.assert_allclose(joined[1], [float(value) for value in truth.values], rtol=1e-12, atol=1e-14)


@pytest.fixture(scope="module")
def others(tmp_path_factory):
    """Return a package of another name, which has a runtime of its own."""
    folder = tmp_path_factory.mktemp("others")
    write(render([LOWERED[name] for name in KERNELS]), folder / "others")
    return load_package(folder, "others")


@every_kernel
@pytest.mark.parametrize("wrapper", ["dd", "bounds", "plain", "hypotheses"])
def test_functions_of_a_package_of_another_name_are_taken(declared, wrapper, others):
    """Each package wraps functions of the other as the other does itself, to the last bit."""
    function = function_of(declared, others)
    arguments = [np.asarray(declared.example[argument.name], dtype=float) for argument in declared.arguments]
    wrapped = getattr(algebroproj, wrapper)(function)(*arguments)
    assert_same_numbers(wrapped, getattr(others, wrapper)(function)(*arguments))


@pytest.mark.parametrize("wrapper", ["dd", "bounds"])
def test_a_plain_function_of_a_package_of_another_name_stays_plain(wrapper, others):
    function = others.plain(function_of(MEET, others))
    arguments = [np.array([[1.0, 0.3], [0.7, 0.1]]), np.array([0.1, 1.7])]
    wrapped = getattr(algebroproj, wrapper)(function)(*arguments)
    assert_same_numbers(wrapped, getattr(others, wrapper)(function)(*arguments))


def test_a_function_of_another_package_is_not_taken_for_a_compiled_one_of_the_same_name(tmp_path):
    """The function ``optics.scale`` of the other package is not the one that is compiled here."""
    write(render([lower(kernel("optics.scale", {"x": x, "y": y}, x + 7 * y, []))]), tmp_path / "others")
    scale = load_package(tmp_path, "others").optics.scale
    assert algebroproj.plain(scale)(1.0, 2.0) == 15.0


@every_kernel
def test_the_studies_take_functions_of_a_package_of_another_name(declared, others):
    function = function_of(declared, others)
    arguments = [np.asarray(declared.example[argument.name], dtype=float) for argument in declared.arguments]
    expected = function(*arguments)
    for arithmetic in (double_double(), float64_balls(), mpmath_digits(30)):
        found = apply(arithmetic, function, *(lift(arithmetic, argument) for argument in arguments))
        pairs = zip(as_tuple(found), as_tuple(expected), strict=True)
        for numbers, value in pairs:
            np.testing.assert_allclose(np.asarray(nearest(arithmetic, numbers).hi, dtype=float), value, rtol=1e-12)


def assert_same_numbers(found, expected):
    if isinstance(expected, dict):
        assert found.keys() == expected.keys()
        found, expected = tuple(found.values()), tuple(expected.values())
    for left, right in zip(as_tuple(found), as_tuple(expected), strict=True):
        if isinstance(right, tuple):
            assert_same_numbers(left, right)
        elif hasattr(right, "hi"):
            assert_same_numbers((left.hi, left.lo), (right.hi, right.lo))
        else:
            np.testing.assert_array_equal(left, right)
