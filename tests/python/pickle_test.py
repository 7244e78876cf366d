"""What cannot be pickled or copied says so, and what to do instead; the interpreter goes on."""

import copy
import pickle

import numpy as np
import pytest

import kerf


class OwnWorld(kerf.World):
    pass


def of_every_class(run):
    boxes = np.zeros((2, 2, 2), np.float32)
    yield kerf.World(2), "save"
    yield OwnWorld(3), "save"
    yield kerf.BroadPhase(2), "insert its boxes"
    yield run, "its path"
    yield run.why(0, 1, 60), "its values"
    yield run.verify(), "its values"
    yield run.compare(run), "its values"
    yield kerf.check(lambda rows: [], boxes, raises=False), "its values"


def test_what_cannot_be_pickled_or_copied_says_what_to_do(run):
    for instance, instead in of_every_class(run):
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            with pytest.raises(TypeError, match=f"cannot pickle or copy a kerf.*{instead}"):
                pickle.dumps(instance, protocol)
        for copied in (copy.copy, copy.deepcopy):
            with pytest.raises(TypeError, match="cannot pickle or copy a kerf"):
                copied(instance)
