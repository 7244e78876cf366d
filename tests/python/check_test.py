"""kerf.check: faults of every kind are found and made small, and nothing right is accused."""

import itertools
import os
import pathlib
import random

import numpy as np
import pytest
from conftest import brute_force, random_boxes

import kerf

SOURCE = pathlib.Path(os.environ["KERF_SOURCE_DIR"])


def right(boxes):
    return sorted(brute_force(boxes))


def in_float32_order(boxes):
    """A sweep along x, right in any precision."""
    order = np.argsort(boxes[:, 0, 0], kind="stable")
    found, active = [], []
    for i in order:
        active = [k for k in active if boxes[k, 1, 0] >= boxes[i, 0, 0]]
        found += [(i, k) for k in active if (boxes[i, 0] <= boxes[k, 1]).all() and (boxes[k, 0] <= boxes[i, 1]).all()]
        active.append(i)
    return np.array(found, int).reshape(-1, 2)


def hard_boxes(dimension, dtype, seed):
    """Boxes that touch, that are points, that are equal, that lie an ulp apart."""
    rng = np.random.default_rng(seed)
    low = rng.integers(0, 6, (60, dimension)).astype(dtype)
    high = low + rng.integers(0, 3, (60, dimension)).astype(dtype)
    shift = rng.integers(0, 3, (60, 1)) == 0
    low = np.where(shift, np.nextafter(low, dtype(-np.inf)), low)
    high = np.where(shift, np.nextafter(high, dtype(np.inf)), high)
    return np.stack([low, high], 1)


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("function", [right, in_float32_order, lambda boxes: set(right(boxes))])
def test_what_is_right_is_never_accused(dimension, dtype, function):
    for seed in range(20):
        boxes = hard_boxes(dimension, dtype, seed)
        assert kerf.check(function, boxes) is None
        shuffled = lambda b: random.Random(seed).sample([p[::-1] for p in function(b)], len(function(b)))
        if function is right:
            assert kerf.check(shuffled, boxes) is None


def test_the_answer_is_that_of_the_precision_given():
    """The second box begins an ulp of float64 after the first one ends: in float32 they touch."""
    boxes = np.array([[[0, 0], [1, 1]], [[np.nextafter(1.0, 2), 0], [2, 1]]])
    assert kerf.check(lambda boxes: [], boxes) is None
    assert kerf.check(lambda boxes: [], boxes.astype(np.float32)).missed.tolist() == [[0, 1]]
    seen = []
    kerf.check(lambda boxes: seen.append(boxes.dtype) or [], boxes.astype(">f8")[::-1])
    assert seen == [np.dtype(float)]


@pytest.mark.parametrize("given", ["f2", "f4", "f8", ">f4", ">f8", "i1", "u1", "i4", "i8", ">i2"])
def test_boxes_reach_the_function_in_the_type_that_the_page_says(given):
    """The page said that the type is the one given; only float32 and float64 keep theirs."""
    wide = np.dtype(np.float32 if np.dtype(given).newbyteorder("=") == np.float32 else np.float64)
    seen = []
    boxes = np.asfortranarray(in_a_row(3).astype(given))
    assert kerf.check(lambda b: seen.append((b.dtype, b.flags.c_contiguous)) or right(b), boxes) is None
    assert seen == [(wide, True)]
    page = (SOURCE / "docs/PYTHON.md").read_text(encoding="utf-8")
    for text in (page, " ".join(kerf.check.__doc__.split())):
        assert "float32 stays float32" in text and "in the type given" not in text and "as they are given" not in text


def test_infinite_boxes_are_judged():
    inf = np.inf
    boxes = np.array([[[-inf, 0], [inf, 1]], [[3e300, 0], [inf, 1]], [[inf, 0], [inf, 1]], [[1, 0], [3, 1]]])
    assert kerf.check(right, boxes) is None
    with np.errstate(over="ignore"):
        assert kerf.check(right, boxes.astype(np.float32)) is None


@pytest.mark.parametrize(
    "touching, closed_is_right, open_is_right", [("pair", True, False), ("none", False, True), ("either", True, True)]
)
def test_the_rule_for_touching_boxes_can_be_chosen(touching, closed_is_right, open_is_right):
    def strict(boxes):
        return [
            (i, k)
            for i, k in itertools.combinations(range(len(boxes)), 2)
            if (boxes[i, 0] < boxes[k, 1]).all() and (boxes[k, 0] < boxes[i, 1]).all()
        ]

    boxes = hard_boxes(2, np.float32, 1)
    assert (kerf.check(right, boxes, touching=touching) is None) == closed_is_right
    assert (kerf.check(strict, boxes, touching=touching) is None) == open_is_right
    assert kerf.check(lambda boxes: [], boxes, touching=touching) is not None
    everything = lambda boxes: list(itertools.combinations(range(len(boxes)), 2))
    assert kerf.check(everything, boxes, touching=touching) is not None


def test_a_missed_pair_is_made_small():
    def forgets_large_ones(boxes):
        return [(i, k) for i, k in right(boxes) if boxes[i, 1, 0] - boxes[i, 0, 0] < 0.29]

    boxes = random_boxes(400, 2, size=0.3)
    failure = kerf.check(forgets_large_ones, boxes)
    assert len(failure.rows) == 2 and failure.missed.tolist() == [[0, 1]] and failure.repeats
    assert len(failure.invented) == 0 and len(failure.doubled) == 0
    assert (failure.boxes == boxes[failure.rows]).all() and failure.boxes.dtype == np.float32
    assert failure.counts[0] > 1 and failure.counts[1:] == (0, 0)
    assert "missed (0, 1)" in str(failure) and failure.calls > 5


def test_invented_and_doubled_pairs_are_made_small():
    boxes = random_boxes(100, 3, size=0.3)
    failure = kerf.check(lambda boxes: right(boxes) + right(boxes)[:1], boxes)
    assert failure.doubled.tolist() == [[0, 1]] and len(failure.rows) == 2
    failure = kerf.check(lambda boxes: right(boxes) + [(k, i) for i, k in right(boxes)], boxes)
    assert failure.doubled.tolist() == [[0, 1]]
    far = boxes * np.float32(1000)
    failure = kerf.check(lambda boxes: list(itertools.combinations(range(len(boxes)), 2)), far)
    assert failure.invented.tolist() == [[0, 1]] and len(failure.rows) == 2
    for wrong in [(0, 0), (0, 10**6), (-1, 0), (0, 2**40)]:
        failure = kerf.check(lambda boxes: right(boxes) + [wrong], boxes)
        assert failure.invented.tolist() == [list(wrong)] and len(failure.rows) <= 1


def test_a_fault_that_needs_many_boxes_keeps_them():
    crowded = lambda boxes: right(boxes)[:3]
    failure = kerf.check(crowded, np.tile(np.array([[[0.0, 0], [1, 1]]]), (50, 1, 1)))
    assert len(failure.rows) == 4 and len(failure.missed) == 3


def test_the_step_that_fails_is_found():
    steps = np.stack([random_boxes(60, 2, seed, size=0.2) for seed in range(6)])
    slow = lambda boxes: [] if (boxes[:1] == steps[4, :1]).all() else right(boxes)
    failure = kerf.check(slow, steps)
    assert failure.step == 4 and failure.steps == [4]
    assert (failure.boxes == steps[4][failure.rows]).all()
    ragged = [steps[0], steps[1, :10], steps[2, :0], steps[4]]
    assert kerf.check(right, ragged) is None
    assert kerf.check(slow, ragged).step == 3


def test_what_remembers_is_made_anew_for_each_trial():
    """Forgets one step's pairs when the boxes move backwards."""

    def make():
        before = []

        def function(boxes):
            backwards = bool(before) and len(boxes) > 0 and boxes[0, 0, 0] < before[-1]
            if len(boxes):
                before.append(boxes[0, 0, 0])
            return [] if backwards else right(boxes)

        return function

    still = random_boxes(30, 2, size=0.3)
    steps = np.stack([still + np.float32(shift) for shift in [0, 1, 2, 3, 2.5, 4]])
    failure = kerf.check(make, steps, stateful=True)
    assert failure.step == 4 and len(failure.steps) == 2 and failure.steps[-1] == 4
    assert 2 <= len(failure.rows) <= 3 and len(failure.scene) == 2
    assert kerf.check(lambda: right, steps, stateful=True) is None


def test_a_function_that_is_not_the_same_each_time_is_said_so():
    calls = []

    def wrong_once(boxes):
        calls.append(1)
        return [] if len(calls) == 1 else right(boxes)

    failure = kerf.check(wrong_once, random_boxes(30, 2, size=0.3))
    assert not failure.repeats and len(failure.rows) == 30 and "not deterministic" in str(failure)


def test_what_it_raises_is_raised():
    def broken(boxes):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        kerf.check(broken, random_boxes(5, 2))
    calls = []

    def interrupted(boxes):
        calls.append(1)
        if len(calls) == 5:
            raise KeyboardInterrupt
        return []

    with pytest.raises(KeyboardInterrupt):
        kerf.check(interrupted, random_boxes(50, 2, size=0.3))


def test_small_scenes_that_it_cannot_take_are_no_failures():
    def few_are_too_few(boxes):
        if len(boxes) < 7:
            raise IndexError
        return []

    failure = kerf.check(few_are_too_few, random_boxes(60, 2, size=0.5))
    assert len(failure.rows) == 7


def test_what_happened_without_one_of_the_boxes_is_said():
    """It was said that the function was right where it had raised or returned nonsense."""

    def picky(boxes):
        if len(boxes) == 6:
            raise IndexError("six")
        return [] if len(boxes) > 6 else 3.5

    failure = kerf.check(picky, np.tile(in_a_row(1), (20, 1, 1)))
    assert len(failure.rows) == 7 and failure.repeats and failure.raised == ["IndexError: six"]
    assert "returned the right pairs, or none:\n  IndexError: six\n" in str(failure)
    nonsense = kerf.check(lambda boxes: [] if len(boxes) > 6 else 3.5, np.tile(in_a_row(1), (20, 1, 1)))
    assert len(nonsense.raised) == 1 and "the function returned 3.5" in nonsense.raised[0]
    plain = kerf.check(lambda boxes: [], random_boxes(60, 2, size=0.5))
    assert plain.raised == [] and "or none" not in str(plain)
    assert kerf.check(picky, np.tile(in_a_row(1), (20, 1, 1)), shrink=False).raised == []
    for text in (kerf.check.__doc__, (SOURCE / "docs/PYTHON.md").read_text(encoding="utf-8")):
        assert "is right, raises, or returns no pairs" in " ".join(text.split())


def test_steps_left_out_may_raise_too():
    def make():
        seen = []

        def function(boxes):
            seen.append(len(boxes))
            if len(seen) == 1 and len(boxes) == 0:
                raise ValueError
            if len(seen) == 2:
                return []
            if boxes[0, 0, 0] == 1:
                raise RuntimeError("no first step")
            return right(boxes)

        return function

    steps = np.stack([in_a_row(3), in_a_row(3) + 1])
    failure = kerf.check(make, steps, stateful=True)
    assert failure.steps == [0, 1] and len(failure.rows) == 2 and failure.raised == ["RuntimeError: no first step"]


@pytest.mark.parametrize("good", [1, 3])
def test_what_raises_when_it_is_tried_again_is_no_right_answer(good):
    """It was called right; when the smallest scene was tried last, its exception left the check, and the finding
    with it."""
    calls = []

    def flaky(boxes):
        calls.append(1)
        if len(calls) > good:
            raise OSError("connection lost")
        return []

    boxes = in_a_row(2)
    failure = kerf.check(flaky, boxes)
    assert failure.counts == (1, 0, 0) and failure.missed.tolist() == [[0, 1]] and (failure.boxes == boxes).all()
    assert not failure.repeats and failure.raised == ["OSError: connection lost"]
    assert "gave no pairs (OSError: connection lost)" in str(failure) and "right" not in str(failure)


def test_a_function_cannot_change_the_boxes():
    boxes = random_boxes(30, 2, size=0.3)
    was = boxes.copy()

    def vandal(b):
        found = right(b)
        b[:] = 0
        return found[1:]

    assert len(kerf.check(vandal, boxes).rows) == 2
    assert (boxes == was).all()


def test_a_failure_can_be_raised():
    with pytest.raises(kerf.CheckFailed, match="1 pair missed, 0 invented, 0 doubled") as raised:
        kerf.check(lambda boxes: [], [[[0, 0], [1, 1]], [[1, 1], [2, 2]]], raises=True)
    assert raised.value.failure.missed.tolist() == [[0, 1]]
    assert isinstance(raised.value, AssertionError)
    assert kerf.check(right, random_boxes(5, 2), raises=True) is None


def test_shrinking_can_be_left_out():
    failure = kerf.check(lambda boxes: [], random_boxes(50, 2, size=0.3), shrink=False)
    assert len(failure.rows) == 50 and failure.calls <= 3


def test_nothing_is_right():
    for empty in [np.empty((0, 2, 3)), np.empty((4, 0, 2, 2)), [np.empty((0, 2, 2))]]:
        assert kerf.check(right, empty) is None
    for no_step in [np.empty((0, 5, 2, 2)), [], ()]:
        with pytest.raises(ValueError, match="boxes: there is no step"):
            kerf.check(right, no_step)
    with pytest.raises(ValueError, match=r"\(7, 4\), but must be \(n, 2, 2\) or \(n, 2, 3\).*reshape\(-1, 2, 2\)"):
        kerf.check(right, np.zeros((7, 4)))
    assert kerf.check(lambda boxes: np.empty((0, 2)), random_boxes(1, 2)) is None


@pytest.mark.parametrize("returned", [None, 3, [[1, 2, 3]], [[0.5, 1.0]], ["ab"], np.ones((2, 3), int), np.ones((2, 0))])
def test_what_is_no_list_of_pairs_is_refused(returned):
    with pytest.raises(ValueError):
        kerf.check(lambda boxes: returned, random_boxes(5, 2))


def test_numbers_beyond_those_of_int64_are_refused():
    """2^64 - 1 was reported as row -1."""
    pairs = np.array([[0, 2**64 - 1]], np.uint64)
    with pytest.raises(ValueError, match=r"the function returned a whole number beyond 2\^63"):
        kerf.check(lambda boxes: pairs, random_boxes(5, 2))
    with pytest.raises(ValueError, match=r"pairs: this is a whole number beyond 2\^63"):
        kerf.render(random_boxes(5, 2), pairs=pairs)


def in_a_row(count):
    """Boxes of which each touches its neighbours alone."""
    low = np.arange(count)[:, None] * [1.0, 0.0]
    return np.stack([low, low + 1], 1)


def test_a_mask_of_returned_pairs_is_refused():
    """It was not heeded: a masked pair counted as reported, which accused what is right and approved what is not."""
    boxes = in_a_row(3)
    pairs = np.ma.masked_array([[0, 1], [1, 2], [0, 2]], mask=[[0, 0], [0, 0], [1, 1]])
    missing = np.ma.masked_array([[0, 1], [1, 2]], mask=[[0, 0], [1, 1]])
    for masked in (pairs, missing, list(pairs), tuple(missing), iter(pairs)):
        with pytest.raises(ValueError, match="masked array|tuple of arrays"):
            kerf.check(lambda b: masked, boxes)
    unmasked = np.ma.masked_array([[0, 1], [1, 2]], mask=False)
    assert kerf.check(lambda b: unmasked, boxes) is None
    assert kerf.check(lambda b: list(unmasked), boxes) is None


@pytest.mark.parametrize("count", range(7))
def test_index_arrays_are_refused_however_many_there_are(count):
    """Two pairs as np.nonzero returns them were taken for (i0, i1) and (j0, j1)."""
    i, j = np.arange(count - 1), np.arange(1, count)
    for columns in ((i, j), (i.astype(np.uint8), j.astype(np.uint8)), tuple(np.argwhere(np.eye(count))[1:].T)):
        with pytest.raises(ValueError, match=r"np.argwhere.*axis=1"):
            kerf.check(lambda boxes: columns, in_a_row(count))
    if count == 3:
        return  # (0, 1) and (1, 2) are the same read along rows and along columns
    for columns in ([i, j], (i.tolist(), j.tolist()), np.stack([i, j]), [i.tolist(), j.tolist()]):
        with pytest.raises(ValueError, match=r"np.argwhere.*axis=1"):
            kerf.check(lambda boxes: columns, in_a_row(count))


@pytest.mark.parametrize("count", range(1, 7))
def test_pairs_may_come_in_any_iterable(count):
    pairs = np.stack([np.arange(count - 1), np.arange(1, count)], axis=1)
    tuples = [tuple(pair) for pair in pairs.tolist()]
    numpy_tuples = [tuple(pair) for pair in pairs]
    for form in (tuples, tuple(tuples), set(tuples), dict.fromkeys(tuples), numpy_tuples, tuple(numpy_tuples)):
        assert kerf.check(lambda boxes: form, in_a_row(count)) is None
    arrays = (pairs, pairs.T.copy().T, pairs.astype(">u2"), memoryview(pairs))
    for form in (*arrays, list(pairs), pairs.tolist(), tuple(pairs.tolist())):
        assert kerf.check(lambda boxes: form, in_a_row(count)) is None
    assert kerf.check(lambda boxes: zip(*pairs.T), in_a_row(count)) is None
    assert kerf.check(lambda boxes: (pair for pair in pairs), in_a_row(count)) is None


def test_two_wrong_pairs_are_a_failure_though_their_columns_are_right():
    boxes = np.array([[[0, 0], [1, 1]], [[1, 0], [2, 1]], [[5, 0], [6, 1]], [[6, 0], [7, 1]]])
    assert kerf.check(lambda b: [(0, 2), (1, 3)], boxes) is not None
    with pytest.raises(ValueError, match="their columns are the right pairs"):
        kerf.check(lambda b: np.array([[0, 2], [1, 3]]), boxes)


def test_what_is_no_box_is_refused_by_step_and_row():
    steps = np.stack([random_boxes(5, 2)] * 3)
    steps[1, 3, 0, 0] = np.nan
    with pytest.raises(ValueError, match="boxes: step 1: row 3 has a NaN"):
        kerf.check(right, steps)
    with pytest.raises(ValueError, match="none of 'pair'"):
        kerf.check(right, steps[0], touching="maybe")
