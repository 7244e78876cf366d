"""kerf.Recording: contents, conditions, reasons, what-if, comparison, smallest runs."""

import os
import pathlib
import shutil
import signal
import subprocess

import numpy as np
import pytest
from conftest import as_set, brute_force

import kerf


def test_contents_are_those_of_the_run(run):
    assert (run.dimension, run.steps, len(run)) == (2, 60, 60)
    assert run.info["scene"] == "pile" and run.info["complete"] and not run.info["imported"]
    assert run.rows["step"].tolist() == list(range(1, 61))
    fixed = run.fixed(60)
    expected = {(a, b) for a, b in brute_force(run.boxes(60)) if not (fixed[a] and fixed[b])}
    assert run.ids(60).tolist() == list(range(len(fixed))) and 0 < fixed.sum() < len(fixed)
    assert as_set(run.pairs(60)) == expected
    assert [len(run.pairs(step)) for step in (3, 60, 17)] == run.rows["pairs"][[2, 59, 16]].tolist()
    assert run.boxes(0).shape == (0, 2, 2)


def test_events_are_a_structured_array(run):
    every = run.events()
    assert every["id"].tolist() == list(range(len(every)))
    assert len(every) == run.rows["events"].sum()
    seven = run.events(7)
    assert (seven["step"] == 7).all() and len(seven) == run.rows["events"][6]
    assert (run.events(7, 9)["step"] == np.repeat([7, 8, 9], run.rows["events"][6:9])).all()
    acted = every[every["kind"] == kerf.EventKind.acted]
    assert len(acted) > 0 and (acted["op"] >= 0).all() and (acted["node"] >= 0).all()
    split = acted[acted["op"] == kerf.Operator.split][0]
    assert run.describe(split["id"]).startswith(f"e{split['id']} step {split['step']} split n{split['node']}")
    placed = every[every["kind"] == kerf.EventKind.placed]
    assert (placed["object"] >= 0).all() and (placed["node"] == -1).all() and np.isnan(placed["old_offset"]).all()
    begun = every[every["kind"] == kerf.EventKind.phase]
    assert (np.bincount(begun["phase"]) == run.steps).all()


def test_enumerations_have_the_order_of_the_core():
    reasons = {
        "dead_node": "the node is dead",
        "not_needed": "no longer needed",
        "no_partitioner": "no good partitioner",
        "height": "the height cap",
        "entries": "the cap on entries",
        "list_full": "the event list is full",
        "decided": "refused by a decision",
    }
    for name, words in kerf._kerf._names.items():
        members = list(getattr(kerf, name))
        assert [member.value for member in members] == list(range(len(words)))
        if name != "Refusal":
            assert [member.name for member in members] == [word.replace("-", "_") for word in words]
    assert [reasons[reason.name] for reason in kerf.Refusal] == kerf._kerf._names["Refusal"]


def test_conditions_find_moments(run):
    first = run.find("op==split && kind==acted")
    assert isinstance(first, kerf.Moment) and first.event is not None
    assert run.find("op==split && kind==acted", before=first) is None
    second = run.find("op==split && kind==acted", after=first)
    assert second > first
    assert run.find("op==split && kind==acted", before=second) == first
    assert run.find_all("op==split && kind==acted", limit=2) == [first, second]
    full = run.find_all("pairs>50")
    assert [moment.step for moment in full] == (np.flatnonzero(run.rows["pairs"] > 50) + 1).tolist()
    assert all(moment.event is None for moment in full)
    assert run.find("pairs>50", after=full[3].step) == full[4]
    assert run.find("pairs>50", after=np.int64(full[3].step)) == full[4]
    for moment in [-1, 2**32, 0.5, "ab", (1, -1)]:
        with pytest.raises(ValueError, match="is neither a step nor a kerf.Moment"):
            run.find("pairs>50", after=moment)
    assert run.find("pairs<0") is None
    with pytest.raises(ValueError, match="pears"):
        run.find("pears>1")
    with pytest.raises(ValueError, match="not both"):
        run.find("pairs>1", after=1, before=2)


def test_values_are_those_of_the_steps(run):
    assert (run.values("pairs") == run.rows["pairs"]).all()
    assert np.allclose(run.values("100*redundancy"), 100 * run.rows["redundancy"])
    assert (run.values("missed") == 0).all()
    with pytest.raises(ValueError, match="single events"):
        run.values("population")


def test_a_pair_has_reasons(run):
    a, b = run.pairs(60)[0].tolist()
    why = run.why(b, a, 60)
    assert why.is_pair and why.reported and why.boxes_overlap and (why.a, why.b) == (a, b)
    assert why.margin <= 0 and why.leaf is not None and why.since is not None
    assert (why.a_box == run.boxes(60)[a]).all()
    assert len(why.changes) % 2 == 1 and why.changes[-1] <= 60
    assert "overlap" in str(why)
    apart = next((i, k) for i in range(50) for k in range(i + 1, 50) if (i, k) not in brute_force(run.boxes(60)))
    why = run.why(*apart, 60)
    assert not why.is_pair and (why.margin > 0 or why.both_fixed)
    assert f"{apart[0]}" in why.text
    moment = run.find("op==split && kind==acted")
    assert "split" in run.why_event(moment.event)
    assert "n0" in run.why_node(0, 60)
    with pytest.raises(ValueError, match="no pair with itself"):
        run.why(3, 3, 60)
    with pytest.raises(kerf.RecordingError, match="no object 99999"):
        run.why(3, 99999, 60)


def test_what_if_the_parameters_were_others(run, tmp_path):
    other = run.what_if(tmp_path / "other.kerf", config={"min_threshold": 64})
    assert other.info["config"]["min_threshold"] == 64 and other.verify()
    difference = run.compare(other)
    assert not difference.same and difference.operators is not None
    assert difference.requests is None and difference.pairs is None
    assert run.compare(run).same
    late = run.what_if(tmp_path / "late.kerf", config="min_threshold=64", first=40)
    assert run.compare(late).events >= 40


def test_what_if_an_operator_were_refused(run, tmp_path):
    event = run.find("op==split && kind==acted").event
    refused = run.what_if(tmp_path / "refused.kerf", refuse=event)
    difference = run.compare(refused)
    assert difference.operators == run.events()[event]["step"] and difference.pairs is None
    taken = run.what_if(tmp_path / "taken.kerf", take=(event, 0))
    assert taken.steps == run.steps
    with pytest.raises(kerf.RecordingError, match="exists"):
        run.what_if(tmp_path / "taken.kerf", take=(event, 0))
    run.what_if(tmp_path / "taken.kerf", take=(event, 0), overwrite=True)
    with pytest.raises(ValueError, match="say what differs"):
        run.what_if(tmp_path / "nothing.kerf")
    with pytest.raises(kerf.RecordingError, match="exists: give another name"):
        run.minimise(lambda other: pytest.fail("it is asked before the name is"), tmp_path / "taken.kerf")
    with pytest.raises(ValueError, match="candidate"):
        run.what_if(tmp_path / "nothing.kerf", take=(event, 9999))
    assert not (tmp_path / "nothing.kerf").exists()


def test_what_holds_by_a_decision_only_is_not_minimised(run, tmp_path):
    refused = run.what_if(tmp_path / "refused.kerf", refuse=run.find("op==split && kind==acted").event)
    with pytest.raises(kerf.RecordingError, match="only because of a decision"):
        refused.minimise(
            lambda run: (run.events(1, run.steps)["reason"] == kerf.Refusal.decided).any(), tmp_path / "small.kerf"
        )
    assert not (tmp_path / "small.kerf").exists()


def test_a_verdict_without_the_oracle_is_asked_for(run):
    with pytest.raises(ValueError, match=f"oracle_every: of {run.steps} steps the oracle was asked in none"):
        run.verify(oracle_every=run.steps + 1)
    assert run.verify(oracle_every=run.steps) and run.verify(oracle_every=0)


def test_the_smallest_run_still_shows_it(run, tmp_path):
    small = run.minimise("op==split && kind==acted", tmp_path / "small.kerf")
    assert small.find("op==split && kind==acted") is not None
    assert small.steps < run.steps and small.rows["objects"][-1] < run.rows["objects"][-1]
    smaller = run.minimise(lambda run: len(run.pairs(run.steps)) > 0, tmp_path / "pair.kerf")
    assert len(smaller.pairs(smaller.steps)) == 1 and smaller.rows["objects"][-1] == 2
    a, b = run.pairs(run.steps)[-1]
    for holds in [f"pair({a},{b})", lambda run: run.find(f"pair({a},{b})") is not None]:
        of_two = run.minimise(holds, tmp_path / "small.kerf", overwrite=True)
        assert set(of_two.ids(of_two.steps)) == {a, b}
    for holds in ["pair(0,99999)", lambda run: run.find("pair(0,99999)")]:
        with pytest.raises(ValueError, match="no object 99999"):
            run.minimise(holds, tmp_path / "none.kerf")
    with pytest.raises(ValueError, match="nothing to minimise"):
        run.minimise("pairs<0", tmp_path / "none.kerf")
    with pytest.raises(ValueError, match="returns False"):
        run.minimise(lambda run: False, tmp_path / "none.kerf")
    with pytest.raises(ZeroDivisionError):
        small.minimise(lambda run: 1 / 0, tmp_path / "none.kerf")
    answers = iter([True])
    with pytest.raises(kerf.RecordingError, match="nothing to minimize"):
        run.minimise(lambda run: next(answers, False), tmp_path / "none.kerf")
    assert {path.name for path in tmp_path.iterdir()} == {"small.kerf", "pair.kerf"}


def test_a_recording_is_verified(run, tmp_path):
    verdict = run.verify()
    assert verdict and verdict.holds and verdict.steps == 60
    assert (verdict.missed, verdict.extra, verdict.twice, verdict.changed) == (0, 0, 0, "")


def test_what_is_no_recording_is_said_so(run, tmp_path):
    for content in [b"", b"no recording", bytes(100000)]:
        path = tmp_path / "file.kerf"
        path.write_bytes(content)
        with pytest.raises(kerf.RecordingError):
            kerf.Recording(path)
    with pytest.raises(kerf.RecordingError):
        kerf.Recording(tmp_path / "missing.kerf")
    assert not (tmp_path / "missing.kerf").exists()


def test_a_file_that_was_damaged_is_said_so(run, tmp_path):
    """Its second half, where blocks are."""
    path = tmp_path / "damaged.kerf"
    content = bytearray(run.path.read_bytes())
    content[len(content) // 2 :] = bytes(len(content) - len(content) // 2)
    path.write_bytes(content)
    with pytest.raises(kerf.RecordingError):
        damaged = kerf.Recording(path)
        damaged.events()


def test_a_file_that_is_cut_while_it_is_open_is_said_so(run, tmp_path):
    path = tmp_path / "stale.kerf"
    shutil.copy(run.path, path)
    stale = kerf.Recording(path)
    with open(path, "r+b") as file:
        file.truncate(8192)
    with pytest.raises(kerf.RecordingError):
        stale.events()


def test_steps_and_events_that_are_not_there(run):
    for ask in [run.pairs, run.boxes, run.ids, run.fixed, run.events]:
        with pytest.raises(kerf.RecordingError, match="ends with step 60, before step 61"):
            ask(61)
    with pytest.raises(kerf.RecordingError):
        run.describe(10**12)
    with pytest.raises(TypeError):
        run.pairs(-1)
    with pytest.raises(kerf.RecordingError, match="no pairs of another engine"):
        run.their_pairs(3)


@pytest.fixture(scope="module")
def long_run(tmp_path_factory):
    """So many steps that `values` goes through them for many times the 50 ms after which it asks for signals again."""
    return kerf.record("pile", tmp_path_factory.mktemp("long") / "long.kerf", steps=40_000, objects=50, grow=10)


def test_a_long_call_can_be_interrupted(long_run):
    """The handler runs within the call: the recording is in use then."""
    within = []

    def handler(number, frame):
        try:
            long_run.pairs(1)
        except RuntimeError:
            within.append(number)
            raise KeyboardInterrupt from None

    before = signal.signal(signal.SIGALRM, handler)
    signal.setitimer(signal.ITIMER_REAL, 0.01, 0.01)
    try:
        with pytest.raises(KeyboardInterrupt):
            long_run.values("missed")
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert within
    assert len(long_run.values("pairs")) == 40_000


def test_what_a_condition_catches_does_not_end_the_search_for_the_smallest_run(tmp_path, long_run):
    """`minimise` and `values` both ask for signals, some 50 ms after they last did: while the condition runs, only
    `values` may."""
    run = kerf.record("pile", tmp_path / "run.kerf", steps=10, objects=20, grow=2)
    caught = []

    def handler(number, frame):
        raise TimeoutError

    def holds(trial):
        try:
            signal.setitimer(signal.ITIMER_REAL, 0.004 * (1 + len(caught)))
            long_run.values("missed")
        except TimeoutError:
            caught.append(trial.steps)
        return True

    before = signal.signal(signal.SIGALRM, handler)
    try:
        assert run.minimise(holds, tmp_path / "small.kerf").steps == 1
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert len(caught) > 3


def test_scenes_of_the_program_are_recorded(tmp_path):
    names = {name: dimension for name, dimension, _ in kerf.scenes()}
    assert names["buckets"] == 3 and names["pile"] == 2
    path = tmp_path / "scene.kerf"
    run = kerf.record("buckets", path, steps=5, objects=30, tree="kerf")
    assert run.dimension == 3 and run.steps == 5
    with pytest.raises(kerf.RecordingError, match="exists"):
        kerf.record("buckets", path, steps=5)
    assert kerf.record("buckets", path, steps=3, objects=30, overwrite=True).steps == 3
    with pytest.raises(ValueError, match="did you mean 'buckets'"):
        kerf.record("bucket", path)
    with pytest.raises(ValueError, match="neither 'kerf'"):
        kerf.record("buckets", tmp_path / "x.kerf", tree="x")
    with pytest.raises(kerf.RecordingError):
        kerf.record("buckets", tmp_path / "none" / "x.kerf", steps=3)
    for record in [lambda: kerf.record("attractors", path, grow=50), lambda: kerf.scene_boxes("attractors", grow=3)]:
        with pytest.raises(ValueError, match="^grow: attractors does not grow"):
            record()
    boxes = kerf.scene_boxes("buckets", steps=5, objects=30, grow=3)
    assert len(boxes) == 5 and boxes[-1].shape[1:] == (2, 3) and boxes[0].dtype == np.float32
    assert [len(step) for step in boxes] == sorted(len(step) for step in boxes)


@pytest.mark.parametrize("scene", ["pile", "buckets"])
def test_a_scene_is_recorded_as_the_program_records_it(scene, tmp_path):
    of_program, of_python = tmp_path / "program.kerf", tmp_path / "python.kerf"
    program = os.environ["KERF_BUILD_DIR"] + "/frames/kerf"
    options = ["--objects", "40", "--grow", "10", "--steps", "20"]
    subprocess.run([program, "record", scene, "-o", of_program, *options], check=True)
    kerf.record(scene, of_python, objects=40, grow=10, steps=20)
    same = subprocess.run([program, "compare", of_program, of_python], capture_output=True, text=True, check=False)
    assert same.returncode == 0, same.stdout


def imported(folder, boxes, *arguments):
    """What the program makes of the boxes of another engine."""
    (folder / "boxes.csv").write_text(boxes, encoding="utf-8")
    program = pathlib.Path(os.environ["KERF_BUILD_DIR"]) / "frames" / "kerf"
    command = [program, "import", "boxes.csv", "-o", "theirs.kerf", *arguments]
    subprocess.run(command, cwd=folder, check=True, capture_output=True)
    return kerf.Recording(folder / "theirs.kerf")


def test_values_are_exact_or_refused(tmp_path):
    """Steps of an import beyond 2^53 were rounded without a word, also where what is asked is small."""
    first = 2**53
    rows = "".join(f"{first + k},7,{k},{k + 1},0,1\n" for k in range(3))
    theirs = imported(tmp_path, "step,object,min_x,max_x,min_y,max_y\n" + rows)
    with pytest.raises(ValueError, match=f"at the end of step 2 of the recording it is {first + 1}, .*subtract"):
        theirs.values("step")
    assert theirs.values(f"step-{first}").tolist() == [0, 1, 2]
    assert theirs.values(f"(step+1)-{first}").tolist() == [1, 2, 3]
    assert theirs.values("step/2").tolist() == [first / 2, first / 2, first / 2 + 1]


def test_pairs_that_touch_only_as_written_are_undecided(tmp_path):
    boxes = "step,object,min_x,max_x,min_y,max_y\n1,0,0.123457,1.23457,0,1\n1,1,1.23457,2.34568,0,1\n"
    (tmp_path / "pairs.csv").write_text("step,a,b\n", encoding="utf-8")
    theirs = imported(tmp_path, boxes, "--pairs", "pairs.csv")
    assert theirs.values("undecided").tolist() == [1] and theirs.values("missed+extra+ignored").tolist() == [0]
    assert theirs.find("undecided>0").step == 1
    why = theirs.why(0, 1, 1)
    assert why.undecided and "may be a pair" in str(why)
