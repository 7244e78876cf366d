#!/usr/bin/env python3
"""What a step costs through Python, beside the same step in C++.

Both see the same boxes in the same step, one right after the other and in turns first, so that they meet the same
machine. Times are processor time of the thread; the overhead is the median of the ratios of such two steps. The pairs
of a step are looked at and dropped, or, in the last column, kept during the next step: then the array keeps the memory.
Prints a table; --json FILE writes the figures.

usage: PYTHONPATH=build/release/python:build/release/tests/python tests/bench/python_overhead.py [--objects N...] [--json FILE]
"""

import argparse
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


def measure(objects, dimension, dtype, share, threads, steps, keep):
    """The figures of one row, in milliseconds; `keep`: the pairs of a step are there during the next one."""
    native = (kerf_steps.Steps2D if dimension == 2 else kerf_steps.Steps3D)(threads)
    phase = kerf.BroadPhase(dimension, threads=threads)
    native_step = native.step if dtype == np.float32 else native.step_of_doubles
    times, pairs = [], None
    for k, given in enumerate(crowd(objects, dimension, steps, share)):
        boxes = np.ascontiguousarray(given, dtype)
        if k == 0:
            phase.insert(boxes)
            native.insert(phase.boxes)
            phase.step()
            continue
        both = {}
        pairs = pairs if keep else None
        for turn in ("python", "c++") if k % 2 else ("c++", "python"):
            if turn == "c++":
                both[turn] = native_step(boxes)
            else:
                start = time.thread_time_ns()
                pairs = phase.step(boxes)
                both[turn] = time.thread_time_ns() - start
        assert len(pairs) == native.pairs()
        times.append((both["c++"], both["python"]))
    warm = np.array(times[len(times) // 5 :], float)
    return {
        "objects": objects,
        "dimension": dimension,
        "dtype": np.dtype(dtype).name,
        "moving": share,
        "threads": threads,
        "pairs": len(pairs),
        "cpp_ms": float(np.median(warm[:, 0])) * 1e-6,
        "python_ms": float(np.median(warm[:, 1])) * 1e-6,
        "overhead": float(np.median(warm[:, 1] / warm[:, 0])) - 1,
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--steps", type=int, default=200)
    parser.add_argument("--objects", type=int, nargs="+", default=[1000, 4000, 16000, 64000])
    parser.add_argument("--json")
    options = parser.parse_args()
    rows = []
    print(f"{'objects':>8}     {'dtype':8} {'moving':>6} {'pairs':>7} {'C++ ms':>8} {'Python ms':>9} {'overhead':>8} {'kept':>8}")
    for objects in options.objects:
        for dimension in (2, 3):
            for dtype in (np.float32, np.float64):
                for share in (1.0, 0.1):
                    row = measure(objects, dimension, dtype, share, 1, options.steps, keep=False)
                    kept = measure(objects, dimension, dtype, share, 1, options.steps, keep=True)
                    row["overhead_kept"] = kept["overhead"]
                    rows.append(row)
                    print(
                        f"{objects:8} {dimension}D  {row['dtype']:8} {share:6.0%} {row['pairs']:7} {row['cpp_ms']:8.3f} "
                        f"{row['python_ms']:9.3f} {row['overhead']:8.1%} {row['overhead_kept']:8.1%}",
                        flush=True,
                    )
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump({"version": kerf.__version__, "python": sys.version.split()[0], "rows": rows}, file, indent=1)


if __name__ == "__main__":
    main()
