"""An adversary finds larger errors than samples do, in the same strata, and what it finds can be measured again."""

from fractions import Fraction

import pytest

import algebroproj
from algebroproj_sym.expressions import evaluate
from algebroproj_sym.generating.samples import Sample, stratified
from algebroproj_sym.verifying.accuracy import measured
from algebroproj_sym.verifying.adversary import CLIMBERS, attack, attack_record
from algebroproj_sym.verifying.shipped import function_of

NAMES = ["projection.mu_from_center", "optics.scale"]


@pytest.mark.parametrize("name", NAMES)
def test_it_climbs(name, lowered):
    low = lowered(name)
    before, after = (attack(low, algebroproj, seconds) for seconds in (0, 0.5))
    samples = stratified(low, CLIMBERS)
    sampled = measured(low, function_of(low.kernel, algebroproj), samples)
    assert before.evaluations == len(samples)
    assert before.accuracy.overall.max_ulp == sampled.overall.max_ulp
    assert after.accuracy.overall.max_ulp > before.accuracy.overall.max_ulp
    assert {stratum.name for stratum in after.accuracy.strata} == {stratum.name for stratum in sampled.strata}


@pytest.mark.parametrize("name", NAMES)
def test_what_it_finds_can_be_measured_again(name, lowered):
    low = lowered(name)
    found = attack(low, algebroproj, 0.2)
    record = attack_record(found)
    worst = Sample("again", {name: float.fromhex(value) for name, value in record["worst"].items()})
    again = measured(low, function_of(low.kernel, algebroproj), [worst])
    assert again.overall.max_ulp == found.accuracy.overall.max_ulp


def test_it_comes_no_nearer_to_a_singularity(lowered):
    """By half at each point that it goes on from, which is one of the samples."""
    low = lowered("projection.mu_from_center")
    point = {s: Fraction(attack(low, algebroproj, 0.2).worst.values[s.name]) for s in low.kernel.symbols}
    starts = [{s: Fraction(sample.values[s.name]) for s in low.kernel.symbols} for sample in stratified(low, CLIMBERS)]
    for factor in low.input_hypotheses:
        least = min(abs(Fraction(evaluate(factor, start)[0])) for start in starts)
        assert abs(Fraction(evaluate(factor, point)[0])) >= least / 2 > 0
