"""What the module writes: nothing else is lost by it, and nothing of a run is."""

import os
import shutil
import subprocess
import sys
import warnings

import numpy as np
import pytest
from conftest import random_boxes

import kerf


def record_a_step(path, overwrite=False):
    with kerf.BroadPhase(2, record=path, overwrite=overwrite) as phase:
        phase.insert(random_boxes(5, 2))
        phase.step()


WRITERS = {
    "BroadPhase": lambda run, out: record_a_step(out, overwrite=True),
    "record": lambda run, out: kerf.record("pile", out, steps=2, objects=20, overwrite=True),
    "what_if": lambda run, out: run.what_if(out, config="min_threshold=64", overwrite=True),
    "minimise": lambda run, out: run.minimise("pairs>0", out, overwrite=True),
}


@pytest.mark.parametrize("writer", WRITERS.values(), ids=WRITERS.keys())
def test_an_empty_name_is_none(writer, run):
    with pytest.raises(kerf.RecordingError, match="is empty"):
        writer(run, "")


@pytest.mark.parametrize("writer", WRITERS.values(), ids=WRITERS.keys())
def test_nothing_but_a_recording_is_replaced(writer, run, tmp_path):
    (tmp_path / "thesis.txt").write_text("mine")
    (tmp_path / "link").symlink_to("thesis.txt")
    (tmp_path / "nowhere").symlink_to("nothing")
    (tmp_path / "folder").mkdir()
    os.mkfifo(tmp_path / "pipe")
    for name, reason in {
        "thesis.txt": "is no recording",
        "link": "is no recording",
        "nowhere": "link to nothing",
        "folder": "is a folder",
        "pipe": "is no regular file",
    }.items():
        with pytest.raises(kerf.RecordingError, match=reason):
            writer(run, tmp_path / name)
    assert (tmp_path / "thesis.txt").read_text() == "mine" and (tmp_path / "pipe").is_fifo()
    assert sorted(os.listdir(tmp_path)) == ["folder", "link", "nowhere", "pipe", "thesis.txt"]


def test_an_earlier_recording_of_a_tree_is_replaced_only_if_that_is_said(tmp_path):
    path = tmp_path / "a.kerf"
    record_a_step(path)
    before = path.read_bytes()
    with pytest.raises(kerf.RecordingError, match="exists: give another name, or overwrite=True"):
        record_a_step(path)
    assert path.read_bytes() == before
    record_a_step(path, overwrite=True)
    assert kerf.Recording(path).steps == 1


@pytest.mark.parametrize("writer", ["what_if", "minimise"])
def test_what_is_read_is_not_replaced(writer, run, tmp_path):
    path = tmp_path / "a.kerf"
    shutil.copy(kerf.record("pile", tmp_path / "b.kerf", steps=20, objects=30).path, path)
    os.link(path, tmp_path / "other-name.kerf")
    before = path.read_bytes()
    for out in (path, tmp_path / "other-name.kerf"):
        with pytest.raises(kerf.RecordingError, match="which is read"):
            WRITERS[writer](kerf.Recording(path), out)
    assert path.read_bytes() == before


@pytest.mark.parametrize("end", ["", "del phase", "raise SystemExit(3)", "1 / 0"])
def test_a_recording_that_was_not_closed_is_kept(end, tmp_path):
    code = f"""
import kerf
phase = kerf.BroadPhase(2, record="a.kerf")
phase.insert([[[0, 0], [1, 1]]])
for _ in range(30):
    phase.step()
{end}
"""
    subprocess.run([sys.executable, "-c", code], cwd=tmp_path, check=False, capture_output=True)
    assert os.listdir(tmp_path) == ["a.kerf"]
    run = kerf.Recording(tmp_path / "a.kerf")
    assert run.steps == 30 and run.info["complete"] and run.verify()


LAST_REQUESTS = {
    "insert": lambda phase: phase.insert(random_boxes(2, 2)),
    "move": lambda phase: phase.move(random_boxes(2, 2, 1), [0, 1]),
    "remove": lambda phase: phase.remove([0, 1]),
}


@pytest.mark.parametrize("ask", LAST_REQUESTS.values(), ids=LAST_REQUESTS.keys())
@pytest.mark.parametrize("end", ["with", "close", "del"])
def test_requests_after_the_last_step_are_said_to_be_left_out(ask, end, tmp_path):
    """They were left out without a word."""
    phase = kerf.BroadPhase(2, record=tmp_path / "a.kerf")
    phase.insert(random_boxes(5, 2))
    phase.step()
    with pytest.warns(RuntimeWarning, match="2 requests after step 1 will not be in the recording"):
        if end == "with":
            with phase:
                ask(phase)
        else:
            ask(phase)
            phase.close() if end == "close" else None
        del phase
    assert kerf.Recording(tmp_path / "a.kerf").ids(1).tolist() == [0, 1, 2, 3, 4]


def test_a_warning_that_is_an_error_comes_after_the_recording_is_complete(tmp_path):
    phase = kerf.BroadPhase(2, record=tmp_path / "a.kerf")
    phase.step()
    phase.insert(random_boxes(1, 2))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(RuntimeWarning, match="1 request after step 1"):
            phase.close()
    assert kerf.Recording(tmp_path / "a.kerf").info["complete"]


def test_normal_use_of_a_recording_gives_no_warning(tmp_path):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with kerf.BroadPhase(2, record=tmp_path / "a.kerf") as phase:
            ids = phase.insert(random_boxes(5, 2))
            phase.step(random_boxes(5, 2, 1))
            phase.remove(ids[:2])
            phase.step()
            phase.insert(random_boxes(0, 2))
            phase.move(random_boxes(0, 2), [])
            phase.remove([])
            phase.query_points([[0.5, 0.5]])
        phase.close()
        quiet = kerf.BroadPhase(2)
        quiet.insert(random_boxes(5, 2))
        quiet.close()
        del quiet, phase
        kerf.BroadPhase(2, record=tmp_path / "b.kerf").close()


@pytest.mark.parametrize("exists", [False, True])
@pytest.mark.parametrize(
    "call",
    [
        "kerf.record('pile', 'a.kerf', steps=3000, objects=50, overwrite=True)",
        "run.what_if('a.kerf', config='min_threshold=64', overwrite=True)",
        "record_steps()",
    ],
)
def test_a_full_disk_leaves_what_was_recorded(call, exists, tmp_path):
    """A file that may not grow further is as good as a full disk. All that was recorded so far was deleted."""
    if exists:
        record_a_step(tmp_path / "a.kerf")
        before = (tmp_path / "a.kerf").read_bytes()
    code = """
import kerf
import resource
import numpy as np

def record_steps():
    rng = np.random.default_rng(1)
    low = rng.random((200, 1, 2), np.float32)
    with kerf.BroadPhase(2, record="a.kerf", overwrite=True) as phase:
        phase.insert(np.concatenate([low, low + np.float32(0.1)], 1))
        for _ in range(1000):
            low = rng.random((200, 1, 2), np.float32)
            phase.step(np.concatenate([low, low + np.float32(0.1)], 1))
"""
    if call.startswith("run."):
        code += "run = kerf.record('pile', 'in.kerf', steps=3000, objects=50)\n"
    code += f"""
resource.setrlimit(resource.RLIMIT_FSIZE, (500_000, 500_000))
try:
    {call}
except kerf.RecordingError as error:
    print(error)
"""
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True)
    parts = [name for name in os.listdir(tmp_path) if name.endswith(".part")]
    assert len(parts) == 1, done
    kept = kerf.Recording(tmp_path / parts[0])
    assert kept.steps > 0 and kept.verify(5)
    assert f"(steps 1 to {kept.steps}) is in {parts[0]}" in done.stdout
    if exists:
        assert (tmp_path / "a.kerf").read_bytes() == before
    else:
        assert kerf.Recording(tmp_path / "a.kerf").steps == kept.steps


def test_a_call_that_fails_replaces_nothing(tmp_path):
    record_a_step(tmp_path / "a.kerf")
    before = (tmp_path / "a.kerf").read_bytes()
    for name in ("a.kerf", "b.kerf"):
        with pytest.raises(ValueError):
            kerf.BroadPhase(2, record=tmp_path / name, overwrite=True, threads=0)
    assert os.listdir(tmp_path) == ["a.kerf"] and (tmp_path / "a.kerf").read_bytes() == before


def test_names_that_are_none(tmp_path):
    with pytest.raises(TypeError):
        kerf.BroadPhase(2, record=3)
    with pytest.raises(kerf.RecordingError, match="missing-\udcff"):
        kerf.Recording(str(tmp_path / "missing-\udcff.kerf"))


def test_a_verdict_says_whether_brute_force_was_asked(run):
    assert repr(run.verify(0)) == "<kerf.Verdict: 60 steps hold; brute force was asked in none>"
    assert repr(run.verify(25)) == "<kerf.Verdict: 60 steps hold; brute force was asked in 2>"


def test_a_function_that_decides_may_return_what_python_takes_for_true(run, tmp_path):
    small = run.minimise(lambda other: other.find_all("pairs>0"), tmp_path / "small.kerf")
    assert 0 < small.steps < run.steps and small.find("pairs>0")


def test_masked_rows_are_not_taken_for_boxes():
    boxes = np.ma.masked_array(random_boxes(3, 2), mask=False)
    phase = kerf.BroadPhase(2)
    phase.insert(boxes)  # nothing is masked
    boxes[1] = np.ma.masked
    for call in (phase.insert, phase.step, phase.query_boxes):
        for given in (boxes, list(boxes), tuple(boxes)):
            with pytest.raises(ValueError, match="masked array"):
                call(given)
    with pytest.raises(ValueError, match="masked array"):
        phase.remove(np.ma.masked_array([0, 1], mask=[True, False]))
    assert len(phase) == 3


def test_only_handles_have_an_index():
    assert kerf.index_of([]).size == 0
    assert kerf.index_of(np.uint64(2**62 + 5)) == 5
    for wrong in ([1.5], [-1], ["7"], [True], np.array([2**62 + 5], np.float64)):
        with pytest.raises(ValueError, match="handles"):
            kerf.index_of(wrong)


def test_a_recording_that_was_closed_may_be_replaced_at_once(tmp_path):
    """As by a cell of a notebook that runs twice, while its variable is still there."""
    path = tmp_path / "run.kerf"
    for count in (3, 5):
        with kerf.BroadPhase(2, record=path, overwrite=True) as phase:
            phase.insert(random_boxes(count, 2))
            phase.step()
        assert len(kerf.Recording(path).ids(1)) == count == len(phase)
        assert sorted(tmp_path.iterdir()) == [path]
