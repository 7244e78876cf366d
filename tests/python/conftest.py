"""Boxes and recordings that several tests use."""

import contextlib
import ctypes
import itertools
import platform

import numpy as np
import pytest

import kerf


def random_boxes(n, dimension, seed=1, size=0.1, dtype=np.float32):
    """n boxes in the unit cube, (n, 2, d)."""
    rng = np.random.default_rng(seed)
    low = rng.random((n, dimension))
    return np.stack([low, low + size * rng.random((n, dimension))], axis=1).astype(dtype)


def brute_force(boxes):
    """The definition: each against each, closed."""
    return {
        (i, k)
        for i, k in itertools.combinations(range(len(boxes)), 2)
        if (boxes[i, 0] <= boxes[k, 1]).all() and (boxes[k, 0] <= boxes[i, 1]).all()
    }


def as_set(pairs):
    """Pairs as a set, each of which must come once."""
    found = {tuple(pair) for pair in pairs.tolist()}
    assert len(found) == len(pairs)
    return found


@contextlib.contextmanager
def denormals_are_zero():
    """As libraries leave a thread that were compiled for fast mathematics: in operands and in results."""
    if platform.machine() != "x86_64":
        pytest.skip("how floats are computed is set by the control register of x86-64")
    libm = ctypes.CDLL("libm.so.6")
    usual = (ctypes.c_uint32 * 8)()  # fenv_t, of which the last word is MXCSR
    libm.fegetenv(usual)
    changed = (ctypes.c_uint32 * 8)(*usual)
    changed[7] |= 0x8040
    libm.fesetenv(changed)
    try:
        yield
    finally:
        libm.fesetenv(usual)


@pytest.fixture(scope="session")
def run(tmp_path_factory):
    """A recorded scene in 2D: blocks that fall, with events of all kinds that matter."""
    return kerf.record("pile", tmp_path_factory.mktemp("run") / "pile.kerf", steps=60, objects=200, grow=30)
