"""Random numbers that are counted: the same for a member wherever and with whomever it is computed."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym.study.sampling import normal, uniform

seeds = st.integers(0, 2**64)


@given(seeds, st.lists(st.integers(0, 10**12), min_size=1, max_size=20), st.integers(1, 9))
def test_a_member_depends_on_its_index_alone(seed, indices, count):
    together = uniform(seed, indices, (count,))
    for place, index in enumerate(indices):
        assert np.array_equal(together[place], uniform(seed, [index], (count,))[0])


@given(seeds, st.integers(1, 50), st.integers(1, 49))
def test_chunks_change_nothing(seed, members, size):
    parts = [normal(seed, range(k, min(k + size, members)), (3,)) for k in range(0, members, size)]
    assert np.array_equal(np.concatenate(parts), normal(seed, range(members), (3,)))


def test_it_is_philox_as_published():
    """Ten rounds of Philox4x64, in integers: what is encrypted is the counter, member after member."""
    seed, stream, member, count = 12345, 3, 10**7, 6
    key = [int(word) for word in np.random.SeedSequence(seed, spawn_key=(stream,)).generate_state(2, np.uint64)]
    words = []
    for step in range(2):
        words += philox((member * 2 + step + 1, 0, 0, 0), key)
    expected = [(word >> 11) / 2**53 for word in words[:count]]
    assert uniform(seed, [member], (count,), stream)[0].tolist() == expected


def philox(counter, key):
    mask = 2**64 - 1
    a, b, c, d = counter
    k0, k1 = key
    for _ in range(10):
        low, high = divmod(0xD2E7470EE14C6C93 * a, 2**64), divmod(0xCA5A826395121157 * c, 2**64)
        a, b, c, d = high[0] ^ b ^ k0, high[1], low[0] ^ d ^ k1, low[1]
        k0, k1 = (k0 + 0x9E3779B97F4A7C15) & mask, (k1 + 0xBB67AE8584CAA73B) & mask
    return [a, b, c, d]


def test_streams_and_seeds_differ_and_neighbours_are_independent():
    first, other_stream, other_seed = (uniform(s, range(4000), (2,), t) for s, t in ((0, 0), (0, 1), (1, 0)))
    for one, other in ((first, other_stream), (first, other_seed), (first[:-1], first[1:])):
        assert abs(np.corrcoef(one[:, 0], other[:, 0])[0, 1]) < 0.06
    assert abs(np.corrcoef(first[:, 0], first[:, 1])[0, 1]) < 0.06


def test_the_distributions_are_those_of_their_names():
    from scipy.stats import kstest

    assert kstest(uniform(5, range(20_000)), "uniform").pvalue > 1e-3
    assert kstest(normal(5, range(20_000)), "norm").pvalue > 1e-3


@pytest.mark.parametrize(
    ("seed", "indices", "stream", "name"),
    [(-1, [0], 0, "seed"), (0, [-1], 0, "indices"), (0, [0], -1, "stream")],
)
def test_negative_numbers_are_refused_by_name(seed, indices, stream, name):
    with pytest.raises(ValueError, match=name):
        uniform(seed, indices, (), stream)


def test_no_member_gives_no_number():
    assert uniform(0, [], (2, 3)).shape == (0, 2, 3)
