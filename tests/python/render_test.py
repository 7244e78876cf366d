"""kerf.render: what is drawn of what, and what cannot be."""

import numpy as np
import pytest
from conftest import random_boxes

import kerf

SIZE = {"width": 320, "height": 180}


def test_pictures_are_arrays_and_the_same_in_every_run(run):
    picture = kerf.render(run, 60, **SIZE)
    assert picture.shape == (180, 320, 3) and picture.dtype == np.uint8 and picture.flags.c_contiguous
    assert len(np.unique(picture.reshape(-1, 3), axis=0)) > 20
    assert (picture == kerf.render(run, 60, **SIZE)).all()
    assert (picture == kerf.render(run, **SIZE)).all()
    assert (picture != kerf.render(run, 20, **SIZE)).any()


def test_layers_and_camera_change_the_picture(run):
    picture = kerf.render(run, 60, **SIZE)
    bare = kerf.render(run, 60, layers="objects", **SIZE)
    assert (picture != bare).any()
    assert (bare != kerf.render(run, 60, layers="objects", camera="center=0:5,width=5", **SIZE)).any()
    empty = kerf.render(run, 60, layers="none", **SIZE)
    assert (empty == empty[0, 0]).all()


def test_the_moment_of_an_event_is_drawn(run):
    event = run.find("op==split && kind==acted").event
    assert (kerf.render(run, event=event, **SIZE) != kerf.render(run, event=event - 1, **SIZE)).any()
    with pytest.raises(kerf.RecordingError, match="ends before event"):
        kerf.render(run, event=10**12)
    with pytest.raises(ValueError, match="only a recording has events"):
        kerf.render("pile", event=3)


@pytest.mark.parametrize("dimension", [2, 3])
def test_boxes_and_broad_phases_are_drawn(dimension):
    boxes = random_boxes(50, dimension, size=0.2)
    plain = kerf.render(boxes, layers="objects,pairs", **SIZE)
    with_pairs = kerf.render(boxes, pairs=[(0, 1), (2, 3)], layers="objects,pairs", **SIZE)
    assert (plain != with_pairs).any()
    phase = kerf.BroadPhase(dimension)
    phase.insert(boxes)
    phase.step()
    assert (kerf.render(phase, layers="objects", **SIZE) == kerf.render(boxes, layers="objects", **SIZE)).all()
    assert kerf.render(kerf.BroadPhase(dimension), **SIZE).shape == (180, 320, 3)
    assert kerf.render(np.empty((0, 2, dimension)), **SIZE).shape == (180, 320, 3)


def test_a_scene_is_drawn_by_its_name():
    assert (kerf.render("pile", 5, **SIZE) != kerf.render("pile", 40, **SIZE)).any()
    with pytest.raises(ValueError, match="unknown scene"):
        kerf.render("no such scene")


def test_what_cannot_be_drawn_is_said_so(run):
    boxes = random_boxes(5, 2)
    for options, problem in [
        ({"width": 10}, "width: it is 10, but must be 64 to 8192"),
        ({"height": 100000}, "height"),
        ({"layers": "objcts"}, "objcts"),
        ({"camera": "yaw=1"}, "yaw"),
        ({"pairs": [(0, 5)]}, "there is no row 5"),
        ({"pairs": [(1, 1)]}, "with itself"),
        ({"pairs": [(0, 1, 2)]}, r"^pairs: this is an array of shape \(1, 3\)"),
        ({"pairs": 5}, "^pairs: this is 5; pairs are"),
        ({"pairs": np.nonzero(np.eye(3))}, "^pairs: this is a tuple of arrays; pairs are rows"),
        ({"step": 3}, "only a recording or a scene"),
    ]:
        with pytest.raises(ValueError, match=problem):
            kerf.render(boxes, **options)
    with pytest.raises(kerf.RecordingError, match="before step 61"):
        kerf.render(run, 61)
    with pytest.raises(ValueError, match="source"):
        kerf.render(object())
