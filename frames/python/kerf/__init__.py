"""Kerf: a broad phase for numpy, and what sees through it. See docs/PYTHON.md."""

import enum
from typing import NamedTuple, Optional

import numpy as np

from kerf._kerf import (
    BroadPhase,
    CheckFailure,
    Comparison,
    PairWhy,
    Recording,
    RecordingError,
    Verdict,
    World,
    __version__,
    check,
    record,
    render,
    scene_boxes,
    scenes,
)


class Moment(NamedTuple):
    """A moment of a recording: right after an event, or the end of a step."""

    step: int
    event: Optional[int]
    """None: the step is over."""


class CheckFailed(AssertionError):
    """Raised by check(..., raises=True); .failure is the kerf.CheckFailure."""

    failure: CheckFailure


class Kind(enum.IntEnum):
    """What an object of a World is: the field 'kind' of World.objects()."""

    fixed = 0
    kinematic = 1
    moving = 2
    sensor = 3


def index_of(handles):
    """The indices of handles of a World, in their shape: uint64, dense, less than World.bound."""
    handles = np.asarray(handles)
    if handles.size and handles.dtype.kind not in "iu":
        raise ValueError(
            f"handles: the dtype is {handles.dtype}, but handles are whole numbers; "
            "numpy makes float64 of uint64 beside int64"
        )
    if handles.size and handles.min() < 0:
        raise ValueError("handles: there is a negative one")
    return handles.astype(np.uint64) & np.uint64(0xFFFFFFF)


class EventKind(enum.IntEnum):
    """What happened: the field 'kind' of Recording.events()."""

    phase = 0
    placed = 1
    scheduled = 2
    acted = 3
    refused = 4
    deferred = 5
    all_placed = 6


class Operator(enum.IntEnum):
    """The field 'op' of Recording.events()."""

    balance = 0
    shift_split = 1
    split = 2
    swap = 3
    merge = 4


class Refusal(enum.IntEnum):
    """Why an operator did not act: the field 'reason' of Recording.events()."""

    dead_node = 0
    not_needed = 1
    no_partitioner = 2
    height = 3
    entries = 4
    list_full = 5
    decided = 6


class Phase(enum.IntEnum):
    """The phase of a step that begins: the field 'phase' of Recording.events()."""

    place = 0
    sort = 1
    schedule = 2
    operate = 3
    sweep = 4


__all__ = [
    "BroadPhase",
    "CheckFailed",
    "CheckFailure",
    "Comparison",
    "EventKind",
    "Kind",
    "Moment",
    "Operator",
    "PairWhy",
    "Phase",
    "Recording",
    "RecordingError",
    "Refusal",
    "Verdict",
    "World",
    "__version__",
    "check",
    "index_of",
    "record",
    "render",
    "scene_boxes",
    "scenes",
]
