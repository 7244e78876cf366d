"""kerf.BroadPhase: what goes in, what comes out, and what is refused."""

import re
import subprocess
import sys
import threading
from types import MappingProxyType

import numpy as np
import pytest
from conftest import as_set, brute_force, random_boxes

import kerf


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("tree", ["kerf", "kerf-paper"])
def test_pairs_are_those_of_brute_force_in_each_step(dimension, tree):
    boxes = random_boxes(300, dimension)
    phase = kerf.BroadPhase(dimension, tree=tree)
    assert phase.insert(boxes).tolist() == list(range(300))
    rng = np.random.default_rng(2)
    for _ in range(15):
        boxes = boxes + rng.normal(0, 0.01, (300, 1, dimension)).astype(np.float32)
        pairs = phase.step(boxes)
        assert pairs.dtype == np.uint32 and pairs.shape == (len(pairs), 2)
        assert as_set(pairs) == brute_force(boxes)
    assert (phase.boxes == boxes).all()
    assert phase.steps == 15 and phase.statistics["objects"] == 300


def test_pairs_of_an_earlier_step_stay_as_they_were():
    boxes = random_boxes(200, 3, size=0.3)
    phase = kerf.BroadPhase(3)
    phase.insert(boxes)
    first = phase.step()
    kept, was = first[3:10:2], first.copy()
    for k in range(20):
        phase.step(boxes[::-1] + np.float32(k))
    assert (first == was).all() and (kept == was[3:10:2]).all()
    assert not first.flags.writeable
    assert phase.pairs is phase.pairs


def test_a_part_of_earlier_pairs_is_enough_to_keep_them():
    boxes = random_boxes(200, 3, size=0.3)
    phase = kerf.BroadPhase(3)
    phase.insert(boxes)
    part = phase.step()[3:10:2]
    was = part.copy()
    for k in range(20):
        phase.step(boxes[::-1] + np.float32(k))
    assert (part == was).all()


def test_pairs_are_written_where_they_were_unless_an_array_has_them():
    boxes = random_boxes(200, 3, size=0.3)
    phase = kerf.BroadPhase(3)
    phase.insert(boxes)
    places = {phase.step(boxes).ctypes.data for _ in range(10)}
    assert len(places) == 1
    kept = [phase.step(boxes) for _ in range(10)]
    assert len({pairs.ctypes.data for pairs in kept}) == 10
    expected = as_set(kept[0])
    assert all(as_set(pairs) == expected for pairs in kept)


def test_pairs_outlive_the_broad_phase():
    phase = kerf.BroadPhase(2)
    phase.insert([[[0, 0], [1, 1]], [[1, 1], [2, 2]]])
    pairs = phase.step()
    del phase
    assert pairs.tolist() == [[0, 1]]


def test_touching_boxes_are_a_pair():
    phase = kerf.BroadPhase(2)
    phase.insert([[[0, 0], [1, 1]], [[1, 0], [2, 1]], [[np.nextafter(np.float32(2), np.float32(3)), 0], [3, 1]]])
    assert phase.step().tolist() == [[0, 1]]


@pytest.mark.parametrize(
    "change",
    [
        np.asfortranarray,
        lambda boxes: boxes[::-1][::-1],
        lambda boxes: np.repeat(boxes, 2, axis=0)[::2],
        lambda boxes: boxes.astype(np.float64),
        lambda boxes: boxes.astype(">f4"),
        lambda boxes: boxes.astype(">f8"),
        lambda boxes: boxes.tolist(),
        lambda boxes: np.frombuffer(b"x" + boxes.tobytes(), np.uint8)[1:].view(np.float32).reshape(boxes.shape),
    ],
)
def test_layout_and_type_of_the_array_do_not_matter(change):
    boxes = random_boxes(100, 3, size=0.3)
    phase = kerf.BroadPhase(3)
    phase.insert(change(boxes))
    assert as_set(phase.step()) == brute_force(boxes)
    assert (phase.boxes == boxes).all()


def test_whole_numbers_and_halves_are_exact():
    boxes = np.array([[[0, 0], [3, 3]], [[3, 3], [5, 5]]])
    for dtype in [np.int8, np.int64, np.uint16, np.uint64, np.float16]:
        phase = kerf.BroadPhase(2)
        phase.insert(boxes.astype(dtype))
        assert phase.step().tolist() == [[0, 1]]
        assert (phase.boxes == boxes).all()


def test_float64_is_rounded_outward():
    rng = np.random.default_rng(5)
    low = np.concatenate([rng.normal(0, 1, 3000), rng.normal(0, 1e-44, 500), [0.1, -0.1, 1e-60, -1e-60, 3e38, -1e300]])
    boxes = np.stack([np.stack([low, low], 1), np.stack([low, low + 1e-12], 1)], 1)
    phase = kerf.BroadPhase(2)
    phase.insert(boxes)
    taken = phase.boxes.astype(np.float64)
    largest = float(np.finfo(np.float32).max)
    inner = np.clip(boxes, -largest, largest)
    assert (taken[:, 0] <= inner[:, 0]).all() and (taken[:, 1] >= inner[:, 1]).all()
    tight = phase.boxes
    with np.errstate(over="ignore"):
        above, below = (np.nextafter(tight, np.float32(way)).astype(float) for way in (np.inf, -np.inf))
    changed = taken != inner
    assert changed.any()
    assert (above[:, 0] > inner[:, 0])[changed[:, 0]].all() and (below[:, 1] < inner[:, 1])[changed[:, 1]].all()


def test_no_overlap_of_float64_is_lost():
    """0.1 + 0.2 touches 0.3 only after rounding."""
    boxes = np.array([[[0.0, 0], [0.3, 1]], [[0.1 + 0.2, 0], [1, 1]], [[0.0, 0], [0.1 + 0.2, 1]]])
    phase = kerf.BroadPhase(2)
    phase.insert(boxes)
    assert as_set(phase.step()) >= {(0, 2), (1, 2)}


def test_infinite_bounds_are_taken():
    phase = kerf.BroadPhase(2)
    phase.insert([[[-np.inf, -np.inf], [np.inf, np.inf]], [[1e38, 0], [np.inf, 1]]])
    assert phase.step().tolist() == [[0, 1]]


def test_nothing_is_fine():
    phase = kerf.BroadPhase(3, changes=True)
    for empty in [np.empty((0, 2, 3)), np.empty((0, 2, 3), np.float32), []]:
        assert phase.insert(empty).shape == (0,)
        assert phase.step(empty).shape == (0, 2)
        phase.move(empty, [])
        phase.remove([])
    assert len(phase) == 0 and phase.boxes.shape == (0, 2, 3) and phase.ids.shape == (0,)
    assert phase.begun.shape == (0, 2) and phase.fixed.shape == (0,)


@pytest.mark.parametrize(
    "boxes, problem",
    [
        (np.zeros((4, 3, 2)), r"the shape is \(4, 3, 2\), but must be \(n, 2, 3\)"),
        (np.zeros((4, 6)), r"become that by .reshape\(-1, 2, 3\)"),
        (np.zeros((4, 2, 2)), r"must be \(n, 2, 3\)"),
        (np.float32(3), r"the shape is \(\)"),
        (np.zeros((4, 2, 3), complex), "the dtype is complex128"),
        (np.zeros((4, 2, 3), bool), "the dtype is bool"),
        (np.zeros((4, 2, 3), object), "the dtype is object"),
        (np.zeros((4, 2, 3), np.longdouble), "the dtype is float128"),
        ([["a"]], "the shape is"),
        (np.array([[[0, 0, 0], [1, 1, 1]], [[0, 0, 0], [1, np.nan, 1]]]), "row 1 has a NaN"),
        (np.array([[[0, 0, 0], [1, 1, 1]], [[0, 2, 0], [1, 1, 1]]], np.float32), "row 1 has its lower corner above"),
        (np.array([[[0, 0, 0], [2**53, 1, 1]]]), r"row 0 has a whole number beyond 2\^53"),
        (np.array([[[0, 0, 0], [1, 1, 1 - 1e-12]], [[0, 0, 1], [1, 1, 1 - 1e-12]]]), "row 1 has its lower corner above"),
    ],
)
def test_what_is_no_box_is_refused_by_its_row(boxes, problem):
    phase = kerf.BroadPhase(3)
    phase.insert(random_boxes(4, 3))
    with pytest.raises(ValueError, match="boxes: .*" + problem):
        phase.insert(boxes)
    with pytest.raises(ValueError, match=problem):
        phase.step(boxes)
    assert len(phase) == 4 and phase.steps == 0
    assert (phase.boxes == random_boxes(4, 3)).all()


def test_ids_are_the_smallest_that_are_free():
    phase = kerf.BroadPhase(2)
    phase.insert(random_boxes(5, 2))
    phase.remove([3, 1])
    assert phase.ids.tolist() == [0, 2, 4]
    assert phase.insert(random_boxes(3, 2)).tolist() == [1, 3, 5]
    assert phase.insert(random_boxes(2, 2), ids=[9, 7]).tolist() == [9, 7]
    assert phase.insert(random_boxes(2, 2)).tolist() == [6, 8]


def test_rows_belong_to_ids():
    boxes = random_boxes(40, 2, size=0.5)
    ids = np.random.default_rng(3).permutation(1000)[:40]
    phase = kerf.BroadPhase(2)
    phase.insert(boxes, ids=ids)
    expected = {tuple(sorted((ids[i], ids[k]))) for i, k in brute_force(boxes)}
    assert as_set(phase.step()) == expected
    assert (phase.boxes == boxes[np.argsort(ids)]).all()
    phase.move(boxes[:7] + 10, ids[:7])
    later = boxes.copy()
    later[:7] += 10
    assert as_set(phase.step()) == {tuple(sorted((ids[i], ids[k]))) for i, k in brute_force(later)}


@pytest.mark.parametrize(
    "ids, problem",
    [
        ([5, -1, 6], "row 1 is -1; ids go from 0"),
        ([5, 6, 2**32], "row 2 is 4294967296"),
        ([5, 6, 2**32 - 1], "row 2 is 4294967295"),
        (np.array([5, 6, 2**64 - 1], np.uint64), "row 2 is 18446744073709551615"),
        ([5, 6, 2**31], "memory grows with the highest id"),
        ([5, 0, 6], "row 1 is 0, which is present already"),
        ([5, 6, 5], "row 2 is 5, which an earlier row is"),
        ([5, 6], "there are 2 for 3 boxes"),
        ([5.0, 6.0, 7.0], "the dtype is float64; ids are whole numbers"),
        ([[5, 6, 7]], r"the shape is \(1, 3\)"),
        ([True, False, True], "the dtype is bool"),
    ],
)
def test_ids_that_cannot_be_are_refused_by_their_row(ids, problem):
    phase = kerf.BroadPhase(2)
    phase.insert(random_boxes(1, 2))
    with pytest.raises(ValueError, match="ids: .*" + problem):
        phase.insert(random_boxes(3, 2), ids=ids)
    assert phase.ids.tolist() == [0]


def test_what_is_not_there_cannot_move_or_leave():
    phase = kerf.BroadPhase(2)
    phase.insert(random_boxes(3, 2))
    with pytest.raises(ValueError, match="row 1 is 3, but there is no such object"):
        phase.move(random_boxes(2, 2), [0, 3])
    with pytest.raises(ValueError, match="row 1 is 7, but there is no such object"):
        phase.remove([0, 7])
    with pytest.raises(ValueError, match="row 2 is 1, which an earlier row is"):
        phase.remove([1, 0, 1])
    with pytest.raises(ValueError, match="there are 2 rows for 3 objects"):
        phase.step(random_boxes(2, 2))
    assert phase.ids.tolist() == [0, 1, 2] and phase.steps == 0


def test_two_fixed_objects_are_no_pair():
    phase = kerf.BroadPhase(2)
    phase.insert([[[0, 0], [1, 1]]] * 3, fixed=[True, True, False])
    assert as_set(phase.step()) == {(0, 2), (1, 2)}
    assert phase.fixed.tolist() == [True, True, False]
    phase = kerf.BroadPhase(2)
    phase.insert([[[0, 0], [1, 1]]] * 3, fixed=True)
    assert len(phase.step()) == 0
    with pytest.raises(ValueError, match=r"fixed: the shape is \(2,\), but must be \(3,\)"):
        phase.insert([[[0, 0], [1, 1]]] * 3, fixed=[True, False])
    with pytest.raises(ValueError, match="fixed: the dtype is int64, but must be bool"):
        phase.insert([[[0, 0], [1, 1]]] * 3, fixed=[1, 0, 1])


def test_pairs_begin_and_end():
    phase = kerf.BroadPhase(2, changes=True)
    phase.insert([[[0, 0], [1, 1]], [[5, 0], [6, 1]], [[0, 0], [1, 1]]])
    phase.step()
    assert phase.begun.tolist() == [[0, 2]] and len(phase.ended) == 0
    phase.move([[[5, 0], [6, 1]]], [0])
    phase.step()
    assert phase.begun.tolist() == [[0, 1]] and phase.ended.tolist() == [[0, 2]]
    phase.remove([1])
    phase.step()
    assert len(phase.begun) == 0 and phase.ended.tolist() == [[0, 1]]
    with pytest.raises(RuntimeError, match="changes=True"):
        kerf.BroadPhase(2).begun


def test_threads_change_no_result():
    boxes = random_boxes(3000, 3)
    one, two = kerf.BroadPhase(3), kerf.BroadPhase(3, threads=2)
    for phase in (one, two):
        phase.insert(boxes)
    for k in range(3):
        assert (one.step(boxes + np.float32(k)) == two.step(boxes + np.float32(k))).all()


def test_parameters_are_those_of_the_program():
    assert kerf.BroadPhase(2, tree="kerf-paper").config["max_threshold"] == 128
    assert kerf.BroadPhase(2, config={"max_threshold": 9999, "dense": False}).config["max_threshold"] == 9999
    assert kerf.BroadPhase(2, config="max_threshold=9999,dense=0").config["dense"] == 0
    assert kerf.BroadPhase(2, config=MappingProxyType({"max_threshold": 9999})).config["max_threshold"] == 9999
    for wrong in ["max_treshold=1", "max_threshold=-1", {"max_threshold": "x"}, 3]:
        with pytest.raises(ValueError):
            kerf.BroadPhase(2, config=wrong)
    with pytest.raises(ValueError, match="neither 'kerf' nor 'kerf-paper'"):
        kerf.BroadPhase(2, tree="octree")
    with pytest.raises(ValueError, match="must be 2 or 3"):
        kerf.BroadPhase(4)
    for threads in [0, 257]:
        with pytest.raises(ValueError, match="threads: "):
            kerf.BroadPhase(2, threads=threads)


def test_another_thread_gets_an_error_while_a_step_runs():
    """So Python's lock is free meanwhile, and nothing else touches the tree."""
    boxes = random_boxes(20000, 3, size=0.02)
    phase = kerf.BroadPhase(3)
    phase.insert(boxes)
    refused = threading.Event()

    def steps():
        for _ in range(2000):
            try:
                phase.step(boxes)
            except RuntimeError:
                pass
            if refused.is_set():
                return

    worker = threading.Thread(target=steps)
    worker.start()
    while worker.is_alive() and not refused.is_set():
        try:
            phase.move(boxes)
        except RuntimeError as error:
            assert "this object is in use by another thread" in str(error)
            refused.set()
    worker.join()
    assert refused.is_set()
    reference = kerf.BroadPhase(3, tree="kerf-paper")
    reference.insert(boxes)
    assert as_set(phase.step(boxes)) == as_set(reference.step())


def test_a_run_is_recorded(tmp_path):
    path = tmp_path / "mine.kerf"
    boxes = random_boxes(50, 2, size=0.3)
    with kerf.BroadPhase(2, record=path) as phase:
        phase.insert(boxes)
        pairs = [phase.step(boxes + np.float32(0.01 * k)) for k in range(5)]
        assert not path.exists()
    run = kerf.Recording(path)
    assert run.steps == 5 and run.verify()
    for step in range(5):
        assert as_set(run.pairs(step + 1)) == as_set(pairs[step])
    assert (run.boxes(5) == boxes + np.float32(0.04)).all()
    with pytest.raises(RuntimeError, match="the recording is complete"):
        phase.step()
    assert as_set(phase.pairs) == as_set(pairs[4]), "a step that is refused changes nothing"


def test_a_change_that_memory_left_half_made_is_the_last():
    """In a process of its own, which may have little more memory than it has."""
    code = """
import resource, numpy as np, kerf
phase = kerf.BroadPhase(3)
corner = np.random.default_rng(1).random((1_000_000, 3), np.float32)
boxes = np.stack([corner, corner + np.float32(0.001)], axis=1)
used = int(open('/proc/self/statm').read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (used + (64 << 20),) * 2)
for call in (lambda: phase.insert(boxes), phase.step, phase.step):
    try:
        call()
    except (MemoryError, RuntimeError) as error:
        print(type(error).__name__, str(error)[-21:])
"""
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert re.fullmatch(r"MemoryError .*\n(RuntimeError make a new BroadPhase\n){2}", found), found
