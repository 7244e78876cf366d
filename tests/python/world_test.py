"""kerf.World: handles, kinds, filters, begun and ended pairs, states."""

import numpy as np
import pytest
from conftest import brute_force, random_boxes

import kerf

ONE = np.array([[[0, 0], [1, 1]]], np.float32)


def indices(pairs):
    return set(map(tuple, kerf.index_of(pairs).tolist()))


@pytest.mark.parametrize("dimension", [2, 3])
def test_pairs_are_those_of_brute_force(dimension):
    boxes = random_boxes(300, dimension, size=0.2)
    world = kerf.World(dimension)
    handles = world.insert(boxes)
    assert handles.dtype == np.uint64 and kerf.index_of(handles).tolist() == list(range(300))
    for k in range(5):
        moved = boxes + np.random.default_rng(k).normal(0, 0.02, (300, 1, dimension)).astype(np.float32)
        world.move(handles, moved)
        assert indices(world.step()) == brute_force(moved)
        assert (world.boxes(handles) == moved).all()
    assert (world.handles == handles).all() and len(world) == 300 and world.bound == 300


def test_the_origin_is_shifted():
    boxes = random_boxes(300, 3, size=0.2)
    world = kerf.World(3)
    handles = world.insert(boxes)
    world.step()
    world.shift_origin([100, 0, -50])
    moved = boxes + np.array([100, 0, -50], np.float32)
    assert (world.boxes(handles) == moved).all()
    assert indices(world.step()) == brute_force(moved)
    for by in [[1, 2], [1, 2, np.nan], [1, 2, np.inf], [1, 2, 1e300], 3]:
        with pytest.raises(ValueError, match="by: give a finite number for each of the 3 axes"):
            world.shift_origin(by)
    for by in ["abc", ["x", "y", "z"], [10**400, 0, 0], None]:
        with pytest.raises(ValueError, match="by: the dtype is"):
            world.shift_origin(by)
    assert (world.boxes(handles) == moved).all()


def test_a_shift_beyond_the_range_of_float32_is_refused():
    world = kerf.World(2)
    handles = world.insert(np.concatenate([ONE, ONE + 3]))
    floor = world.insert([[[-np.inf, 0], [np.inf, 1]]])
    world.shift_origin([1000, 0])  # the endless floor comes along
    with pytest.raises(ValueError, match=f"by: the box of handle {floor[0]} would exceed the range of float32"):
        world.shift_origin([1e32, 0])
    assert (world.boxes(handles) == np.concatenate([ONE, ONE + 3]) + np.array([1000, 0], np.float32)).all()


def test_worlds_with_different_tags_refuse_each_others_handles():
    first, second = kerf.World(2), kerf.World(2, tag=255)
    handles = first.insert(ONE), second.insert(ONE)
    assert handles[0] != handles[1] and kerf.index_of(handles[1]) == 0
    for world, handle in [(first, handles[1]), (second, handles[0])]:
        with pytest.raises(ValueError, match="handles: row 0 names no object of this world: .* with another tag"):
            world.remove(handle)
    first.step()
    second.restore(first.save())
    second.remove(handles[0])
    for tag in [-1, 256]:
        with pytest.raises(ValueError, match=f"tag: it is {tag}, but must be from 0 to 255"):
            kerf.World(2, tag=tag)


def test_an_object_that_asks_while_it_is_read_is_refused():
    world = kerf.World(2)
    handles = world.insert(ONE)

    class Asks:
        def __array__(self, *_args, **_names):
            len(world.handles)
            return handles

    with pytest.raises(RuntimeError, match="in use by another thread, or by the call that asked for these numbers"):
        world.boxes(Asks())
    assert len(world.boxes(handles)) == 1


def test_whole_numbers_are_what_has_an_index():
    class Whole:
        def __init__(self, value):
            self.value = value

        def __index__(self):
            if self.value is None:
                raise KeyError("mine")
            return self.value

    world = kerf.World(2)
    most = 2**64 - 1
    handles = world.insert(np.repeat(ONE, 2, 0), kind=Whole(0), group=[Whole(-3), np.int8(4)], user_data=Whole(most))
    rows = world.objects(handles)
    assert rows["kind"].tolist() == [0, 0] and rows["group"].tolist() == [-3, 4]
    assert rows["user_data"].tolist() == [most] * 2
    with pytest.raises(ValueError, match="category: row 0 is .*; it is a whole number from 0 to"):
        world.set(handles, category=Whole(-1))
    with pytest.raises(KeyError, match="mine"):
        world.set(handles, category=Whole(None))


def test_kinds_and_filters_decide_which_pairs_are_reported():
    world = kerf.World(2)
    kinds = ["fixed", "kinematic", "moving", "sensor"]
    one = np.concatenate([world.insert(ONE, kind=kind) for kind in kinds])
    assert world.objects(one)["kind"].tolist() == list(kerf.Kind)
    pairs = world.step()
    assert indices(pairs) == {(0, 2), (1, 2), (0, 3), (1, 3), (2, 3)}
    assert world.of_sensor.tolist() == [3 in pair for pair in kerf.index_of(pairs).tolist()]
    world = kerf.World(2)
    world.insert(np.repeat(ONE, 4, 0), category=[1, 2, 1, 2], mask=[2, 1, 1, 2**64 - 1], group=[0, 0, -3, -3])
    world.step()
    expected = set()
    category, mask, group = [1, 2, 1, 2], [2, 1, 1, 2**64 - 1], [0, 0, -3, -3]
    for a in range(4):
        for b in range(a + 1, 4):
            same = group[a] == group[b] != 0
            if not same and category[a] & mask[b] and category[b] & mask[a]:
                expected.add((a, b))
    assert indices(world.pairs) == expected


def test_kinds_are_a_name_or_a_number_for_each_row():
    world = kerf.World(2)
    handles = world.insert(np.repeat(ONE, 3, 0), kind=["fixed", "moving", kerf.Kind.sensor])
    assert world.objects(handles)["kind"].tolist() == [0, 2, 3]
    world.set(handles, kind=np.array(["kinematic", "sensor", "fixed"]))
    assert world.objects(handles)["kind"].tolist() == [1, 3, 0]
    world.set(handles, kind=np.array([2, 2, 1]))
    assert world.objects(handles)["kind"].tolist() == [2, 2, 1]


def test_what_an_object_is_can_change():
    world = kerf.World(2)
    handles = world.insert(np.repeat(ONE, 3, 0), kind=kerf.Kind.fixed, user_data=[10, 11, 2**64 - 1])
    assert len(world.step()) == 0
    world.set(handles[:1], kind="moving", user_data=7)
    assert indices(world.step()) == {(0, 1), (0, 2)} and indices(world.begun) == {(0, 1), (0, 2)}
    assert world.objects(handles)["user_data"].tolist() == [7, 11, 2**64 - 1]
    world.set(handles, mask=[1, 0, 1])
    world.step()
    assert indices(world.ended) == {(0, 1)}
    world.set(handles, margin=0.5)
    assert (world.objects(handles)["margin"] == np.float32(0.5)).all()


def test_a_handle_names_one_life():
    world = kerf.World(2)
    handles = world.insert(np.repeat(ONE, 2, 0))
    world.step()
    world.remove(handles[:1])
    world.step()
    assert (world.ended[:, 0] == handles[0]).all() and len(world.ended) == 1
    again = world.insert(ONE)
    assert kerf.index_of(again) == kerf.index_of(handles[:1]) and again[0] != handles[0]
    for ask in [world.boxes, world.objects, world.remove, lambda h: world.move(h, ONE), lambda h: world.set(h, kind="fixed")]:
        with pytest.raises(ValueError, match="handles: row 0 names no object of this world"):
            ask(handles[:1])
    with pytest.raises(ValueError, match="row 1 is in an earlier row, too"):
        world.remove([again[0], again[0]])
    assert len(world) == 2


@pytest.mark.parametrize(
    "columns, problem",
    [
        ({"kind": "liquid"}, "kind: 'liquid' is none of"),
        ({"kind": ["fixed", "liquid"]}, "kind: row 1: 'liquid' is none of"),
        ({"kind": ["fixed"]}, r"kind: the shape is \(1,\), but must be \(2,\)"),
        ({"kind": [0, 4]}, "kind: row 1 is 4"),
        ({"category": [1, -1]}, "category: row 1 is -1"),
        ({"mask": [1, 2, 3]}, r"mask: the shape is \(3,\), but must be \(2,\)"),
        ({"group": 2**31}, "group: row 0 is 2147483648"),
        ({"margin": [0, np.nan]}, "margin: row 1 is nan"),
        ({"margin": -1}, "margin: row 0 is -1"),
        ({"margin": -1e-50}, "margin: row 0 is -1e-50"),
        ({"margin": "0.5"}, "margin: row 0 is '0.5'; it is a finite number"),
        ({"margin": [1, None]}, "margin: row 1 is None"),
        ({"margin": [1, 10**400]}, "margin: row 1 is 1000"),
        ({"margin": [1, 1e39]}, r"margin: row 1 is 1e\+39"),
        ({"margin": 1j}, "margin: row 0 is 1j"),
        ({"user_data": 0.5}, "user_data: row 0 is 0.5"),
    ],
)
def test_what_an_object_cannot_be_is_refused_by_its_row(columns, problem):
    world = kerf.World(2)
    with pytest.raises(ValueError, match=problem):
        world.insert(np.repeat(ONE, 2, 0), **columns)
    assert len(world) == 0


def test_a_state_goes_on_as_the_world_that_was_saved():
    boxes = random_boxes(200, 3, size=0.2)
    first, second = kerf.World(3), kerf.World(3)
    handles = first.insert(boxes, margin=0.01)
    with pytest.raises(RuntimeError, match="step first"):
        first.save()
    first.step()
    second.restore(first.save())
    for world in (first, second):
        world.move(handles, boxes + np.float32(0.3))
    assert (first.step() == second.step()).all() and (first.begun == second.begun).all()
    with pytest.raises(ValueError, match="state: "):
        second.restore(b"no state")
    with pytest.raises(ValueError, match="state: "):
        kerf.World(2).restore(first.save())


def test_fat_and_exact_pairs():
    apart = np.array([[[0, 0], [1, 1]], [[1.5, 0], [2, 1]]], np.float32)
    for pairs_of, count in [("fat", 1), ("exact", 0)]:
        world = kerf.World(2, pairs_of=pairs_of)
        world.insert(apart, margin=0.3)
        assert len(world.step()) == count
    with pytest.raises(ValueError, match="neither 'fat' nor 'exact'"):
        kerf.World(2, pairs_of="both")
    for threads in [0, 257]:
        with pytest.raises(ValueError, match="threads: "):
            kerf.World(2, threads=threads)
    assert kerf.World(3).insert([]).shape == (0,)
