"""Queries of kerf.BroadPhase in batches, against brute force in numpy."""

import numpy as np
import pytest
from conftest import random_boxes

import kerf


def overlapping(queries, boxes):
    """Rows of (query, id), from the definition."""
    a, b = queries[:, None].astype(float), boxes[None].astype(float)
    return np.argwhere(((a[:, :, 0] <= b[:, :, 1]) & (b[:, :, 0] <= a[:, :, 1])).all(axis=2))


def distances(points, boxes):
    low, high = boxes[None, :, 0].astype(float), boxes[None, :, 1].astype(float)
    p = points[:, None].astype(float)
    return np.sqrt((np.maximum(0, np.maximum(low - p, p - high)) ** 2).sum(axis=2))


def entries(rays, boxes):
    """Where each ray enters each box, infinity where it does not: slabs in float64."""
    origin, way = (rays[:, None, k].astype(float) for k in (0, 1))
    with np.errstate(all="ignore"):
        ends = [(boxes[None, :, k].astype(float) - origin) / way for k in (0, 1)]
    low, high = np.fmin(*ends).max(axis=2), np.fmax(*ends).min(axis=2)
    return np.where((low <= high) & (high >= 0), np.maximum(low, 0), np.inf)


@pytest.fixture(params=[2, 3])
def world(request):
    dimension = request.param
    boxes = random_boxes(500, dimension, size=0.2)
    phase = kerf.BroadPhase(dimension, threads=2)
    phase.insert(boxes)
    return dimension, boxes, phase


def test_boxes_and_points(world):
    dimension, boxes, phase = world
    queries = random_boxes(200, dimension, seed=9, size=0.3)
    found = phase.query_boxes(queries)
    assert found.dtype == np.uint32 and (found == overlapping(queries, boxes)).all()
    points = queries[:, 0]
    assert (phase.query_points(points) == overlapping(np.stack([points, points], 1), boxes)).all()
    corner = boxes[7, 1]
    assert [0, 7] in phase.query_points([corner]).tolist()


def test_spheres_and_nearest(world):
    dimension, boxes, phase = world
    points = random_boxes(100, dimension, seed=4)[:, 0]
    exact = distances(points, boxes)
    radii = np.random.default_rng(1).random(100).astype(np.float32) * np.float32(0.2)
    assert (phase.query_spheres(points, radii) == np.argwhere(exact <= radii[:, None].astype(float))).all()
    assert (phase.query_spheres(points, 0.1) == np.argwhere(exact <= np.float32(0.1))).all()
    ids, found = phase.query_nearest(points, 5)
    order = np.argsort(exact, axis=1, kind="stable")[:, :5]
    assert (ids == order).all() and np.allclose(found, np.take_along_axis(exact, order, 1))
    ids, found = phase.query_nearest(points, 600, max_distance=0.1)
    assert ids.shape == (100, 600) and ((ids >= 0).sum(axis=1) == (exact <= np.float32(0.1)).sum(axis=1)).all()
    assert np.isinf(found[ids == -1]).all()
    assert phase.query_nearest(points)[0].shape == (100, 1)


def test_rays_segments_and_sweeps(world):
    dimension, boxes, phase = world
    rng = np.random.default_rng(8)
    rays = rng.normal(0.5, 0.7, (150, 2, dimension)).astype(np.float32)
    exact = entries(rays, boxes)
    ids, t = phase.query_rays(rays)
    first = exact.min(axis=1)
    assert ((ids == -1) == np.isinf(first)).all() and np.isinf(t[ids == -1]).all()
    hit = ids >= 0
    assert hit.any() and not hit.all() and np.allclose(t[hit], first[hit], atol=1e-5)
    assert np.allclose(exact[hit, ids[hit]], first[hit], atol=1e-5)
    rows, t = phase.query_rays(rays, all=True)
    assert sorted(map(tuple, rows.tolist())) == [tuple(row) for row in np.argwhere(np.isfinite(exact)).tolist()]
    assert (np.diff(t)[np.diff(rows[:, 0].astype(int)) == 0] >= 0).all()
    near, _ = phase.query_rays(rays, all=True, max_t=0.25)
    assert len(near) == (exact <= 0.25).sum()
    ends = np.stack([rays[:, 0], rays[:, 0] + rays[:, 1]], 1)
    assert len(phase.query_segments(ends, all=True)[0]) == pytest.approx((exact <= 1).sum(), abs=2)
    moving = random_boxes(50, dimension, seed=2)
    rows, _ = phase.query_sweeps(moving, np.zeros((50, dimension)), all=True)
    assert sorted(map(tuple, rows.tolist())) == [tuple(row) for row in overlapping(moving, boxes).tolist()]
    ids, t = phase.query_sweeps(moving + np.float32(10), np.full((50, dimension), -20.0))
    assert ((t > 0) & (t < 1))[ids >= 0].all() and (ids >= 0).any()


def test_queries_see_the_boxes_as_they_were_given_last(world):
    dimension, boxes, phase = world
    query = boxes[3:4] + np.float32(100)
    assert len(phase.query_boxes(query)) == 0
    phase.move(query, [3])
    assert phase.query_boxes(query).tolist() == [[0, 3]]
    phase.step()
    assert phase.query_boxes(query).tolist() == [[0, 3]]
    phase.remove([3])
    assert len(phase.query_boxes(query)) == 0
    phase.insert(query)
    assert phase.query_boxes(query).tolist() == [[0, 3]]


def test_nothing_is_fine(world):
    dimension, _, phase = world
    assert phase.query_boxes([]).shape == (0, 2) and phase.query_points([]).shape == (0, 2)
    assert phase.query_nearest([], 3)[0].shape == (0, 3)
    assert phase.query_rays(np.empty((0, 2, dimension)))[0].shape == (0,)
    assert phase.query_nearest(np.zeros((2, dimension)), 0)[0].shape == (2, 0)
    empty = kerf.BroadPhase(dimension)
    assert len(empty.query_boxes(np.zeros((1, 2, dimension)))) == 0
    assert empty.query_rays(np.ones((1, 2, dimension)))[0].tolist() == [-1]
    assert empty.query_nearest(np.zeros((1, dimension)), 2)[0].tolist() == [[-1, -1]]


def test_more_than_all_takes_no_memory_without_end(world):
    dimension, boxes, phase = world
    point = np.zeros((1, dimension))
    for k in (2**31, 2**40, 2**63, 2**64 - 1):
        with pytest.raises(ValueError, match=f"k: {k} for each of 1 point is far beyond the {len(boxes)} objects"):
            phase.query_nearest(point, k)
    with pytest.raises(ValueError, match="for each of 1000 points"):
        phase.query_nearest(np.zeros((1000, dimension)), 100_000)
    assert phase.query_nearest(point, 100_000)[0].shape == (1, 100_000)


def test_what_cannot_be_asked_is_refused_by_its_row(world):
    dimension, _, phase = world
    points = np.zeros((4, dimension))
    points[2] = np.nan
    with pytest.raises(ValueError, match="points: row 2"):
        phase.query_nearest(points)
    with pytest.raises(ValueError, match="centers, radii: row 1"):
        phase.query_spheres(np.zeros((2, dimension)), [1, -1])
    for radius in ("3", True, 3 + 4j, None):
        with pytest.raises(ValueError, match="radii: the dtype is .*; give float32, float64 or whole numbers"):
            phase.query_spheres(np.zeros((2, dimension)), radius)
    with pytest.raises(ValueError, match="radii: there are 3 for 2 centers"):
        phase.query_spheres(np.zeros((2, dimension)), [1, 1, 1])
    with pytest.raises(ValueError, match=r"rays: the shape is \(4, .\), but must be \(n, 2, .\)"):
        phase.query_rays(np.zeros((4, dimension)))
    with pytest.raises(ValueError, match="points: the dtype"):
        phase.query_points(np.zeros((4, dimension), complex))
    with pytest.raises(ValueError, match="ways: there are 1 for 2 boxes"):
        phase.query_sweeps(random_boxes(2, dimension), np.zeros((1, dimension)))


def test_a_length_below_zero_is_none_however_small():
    phase = kerf.BroadPhase(2)
    phase.insert([[[0, 0], [1, 1]]])
    with pytest.raises(ValueError, match="rays: row 0"):
        phase.query_rays([[[0, 0], [1, 1]]], max_t=-1e-50)
    with pytest.raises(ValueError, match="points: row 0"):
        phase.query_nearest([[0, 0]], max_distance=-1e-50)
    for radii in (-1e-50, [-1e-50]):
        with pytest.raises(ValueError, match="centers, radii: row 0"):
            phase.query_spheres([[0, 0]], radii)


@pytest.mark.parametrize("error", [KeyboardInterrupt, MemoryError, RuntimeError])
def test_what_an_array_raises_when_it_is_read_is_raised(error):
    class Unreadable:
        def __array__(self, *_, **__):
            raise error

    with pytest.raises(error):
        kerf.BroadPhase(2).query_points(Unreadable())


def test_radii_are_read_once():
    """What is an array of another shape each time."""

    class Fickle:
        asked = 0

        def __array__(self, dtype=None, copy=None):
            self.asked += 1
            return np.array(1.0, np.float32) if self.asked == 1 else np.zeros(0, np.float32)

    phase = kerf.BroadPhase(2)
    phase.insert(np.array([[[0, 0], [1, 1]]], np.float32))
    fickle = Fickle()
    assert phase.query_spheres(np.zeros((1, 2), np.float32), fickle).tolist() == [[0, 0]]
    assert fickle.asked == 1
