"""Kerf's answers are the same where a library has made this thread take denormals for zero."""

import numpy as np
import pytest
from conftest import denormals_are_zero

import kerf


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_boxes_a_denormal_apart_are_no_pair_where_denormals_are_zero(dtype):
    tiny = np.finfo(dtype).smallest_subnormal
    boxes = np.array([[[0, 0], [tiny, 1]], [[2 * tiny, 0], [1, 1]], [[tiny, 0], [tiny, 1]]], dtype)
    inverted = boxes.copy()
    inverted[0, 0, 0] = 2 * tiny
    seen = []

    def in_whole_numbers(given):
        seen.append(float(given[1, 0, 0]) > 0)
        return [(0, 2)]

    with denormals_are_zero():
        assert kerf.check(in_whole_numbers, boxes) is None
        with pytest.raises(ValueError, match="row 0 has its lower corner above its upper one"):
            kerf.check(in_whole_numbers, inverted)
    assert seen == [False]  # the function computes as its caller chose


def test_a_broad_phase_of_kerf_is_right_where_denormals_are_zero():
    def pairs_of(boxes):
        phase = kerf.BroadPhase(2)
        phase.insert(boxes)
        phase.step()
        return phase.pairs

    boxes = np.array([[[0, 0], [1e-40, 1]], [[2e-40, 0], [1, 1]]], np.float32)
    with denormals_are_zero():
        assert kerf.check(pairs_of, boxes) is None


def test_a_recording_says_the_same(tmp_path):
    def record(name, gap):
        with kerf.BroadPhase(2, record=tmp_path / name) as phase:
            phase.insert(np.array([[[0, 0], [1e-40, 1]], [[1e-40 + gap, 0], [1, 1]]], np.float32))
            phase.step()
        return kerf.Recording(tmp_path / name)

    apart, touching = record("apart.kerf", 1e-40), record("touching.kerf", 0)
    with denormals_are_zero():
        why = apart.why(0, 1, 1)
        assert not (why.is_pair or why.reported or why.boxes_overlap or len(why.changes))
        assert apart.compare(touching).requests == 1
