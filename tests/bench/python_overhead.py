#!/usr/bin/env python3
"""What a step costs through Python, beside the same step in C++.

Both see the same boxes in the same step, one right after the other and in turns first, so that they meet the same
machine. An overhead is the median of the ratios of such two steps, so that interruptions do not count. The clock is
one that is read without a system call: a system call takes longer than the call that is measured.

overhead   of kerf.BroadPhase.step over the step in C++, timed there; the pairs are dropped before the next step
kept       the same, with the pairs still there during the next step: then the array keeps the memory
call       of a bare call of the step in C++ from Python over itself: what Python's interpreter costs alone

Prints a table; --json FILE writes the figures.

usage: PYTHONPATH=build/release/python:build/release/tests/python tests/bench/python_overhead.py [--objects N...]
           [--steps N] [--json FILE]
"""

import argparse
import itertools
import json
import sys
import time

import kerf_steps
import numpy as np

import kerf


def crowd(objects, dimension, steps, share):
    """Boxes of side 1 in a cube with about four pairs each, a share of which moves a little in each step."""
    rng = np.random.default_rng(1)
    side = (objects / 0.9) ** (1 / dimension)
    low = rng.random((objects, dimension)) * side
    speed = rng.normal(0, 0.02, (objects, dimension)) * (rng.random((objects, 1)) < share)
    size = 0.4 + 0.6 * rng.random((objects, dimension))
    for step in range(steps):
        corner = low + step * speed
        yield np.stack([corner, corner + size], axis=1)


def timed(function):
    """What it returns, and the nanoseconds that it took."""
    start = time.perf_counter_ns()
    result = function()
    return result, time.perf_counter_ns() - start


def steps_of_both(objects, dimension, dtype, share, steps, keep):
    """Nanoseconds of each step in C++, of its call from Python, and of the module's step; and the number of pairs."""
    native = (kerf_steps.Steps2D if dimension == 2 else kerf_steps.Steps3D)(1)
    native_step = native.step if dtype == np.float32 else native.step_of_doubles
    phase = kerf.BroadPhase(dimension)
    times, pairs = [], None
    for k, given in enumerate(crowd(objects, dimension, steps, share)):
        boxes = np.ascontiguousarray(given, dtype)
        if k == 0:
            phase.insert(boxes)
            native.insert(phase.boxes)
            phase.step()
            continue
        pairs = pairs if keep else None
        for turn in ("python", "c++") if k % 2 else ("c++", "python"):
            if turn == "c++":
                inner, outer = timed(lambda: native_step(boxes))
            else:
                pairs, through = timed(lambda: phase.step(boxes))
        assert len(pairs) == native.pairs()
        times.append((inner, outer, through))
    return np.array(times[len(times) // 5 :], float), len(pairs)


def measure(objects, dimension, dtype, share, steps):
    """One row of the table."""
    kept, _ = steps_of_both(objects, dimension, dtype, share, steps, keep=True)
    times, pairs = steps_of_both(objects, dimension, dtype, share, steps, keep=False)
    return {
        "objects": objects,
        "dimension": dimension,
        "dtype": np.dtype(dtype).name,
        "moving": share,
        "pairs": pairs,
        "cpp_ms": float(np.median(times[:, 0])) * 1e-6,
        "python_ms": float(np.median(times[:, 2])) * 1e-6,
        "overhead": float(np.median(times[:, 2] / times[:, 0])) - 1,
        "kept": float(np.median(kept[:, 2] / kept[:, 0])) - 1,
        "call": float(np.median(times[:, 1] / times[:, 0])) - 1,
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--steps", type=int, default=200)
    parser.add_argument("--objects", type=int, nargs="+", default=[1000, 4000, 16000, 64000])
    parser.add_argument("--json")
    options = parser.parse_args()
    rows = []
    heads = f"{'objects':>8}     {'dtype':8} {'moving':>6} {'pairs':>7} {'C++ ms':>8} {'Python ms':>9}"
    print(heads + f" {'overhead':>8} {'kept':>8} {'call':>8}")
    for objects, dimension, dtype, share in itertools.product(
        options.objects, (2, 3), (np.float32, np.float64), (1.0, 0.1)
    ):
        row = measure(objects, dimension, dtype, share, options.steps)
        rows.append(row)
        print(
            f"{objects:8} {dimension}D  {row['dtype']:8} {share:6.0%} {row['pairs']:7} {row['cpp_ms']:8.3f} "
            f"{row['python_ms']:9.3f} {row['overhead']:8.1%} {row['kept']:8.1%} {row['call']:8.1%}",
            flush=True,
        )
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump({"version": kerf.__version__, "python": sys.version.split()[0], "rows": rows}, file, indent=1)


if __name__ == "__main__":
    main()
