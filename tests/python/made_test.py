"""What __new__ made without __init__ raises: it had memory in it that no constructor had seen."""

import inspect

import pytest

import kerf
from kerf import _kerf

CLASSES = [
    found for _, found in inspect.getmembers(_kerf, inspect.isclass) if found.__base__.__name__ == "pybind11_object"
]
HARMLESS = ["__enter__", "__init__", "__new__", "__reduce__"]
UNMADE = r"__init__\(\) was not called"


class Forgetful(kerf.World):
    def __init__(self):
        pass


def uses_of(found):
    """The class's own members, without those that do not look into an object."""
    return [name for name, _ in inspect.getmembers(found) if name in found.__dict__ and name not in HARMLESS]


def ways_to_use(found, name):
    """Calls of a member with an object, until one has as many arguments as it takes."""
    member = found.__dict__[name]
    if isinstance(member, property):
        return [member.__get__]
    return [lambda unmade, k=k: getattr(found, name)(unmade, *[None] * k) for k in range(5)]


def test_all_classes_are_known():
    assert len(CLASSES) >= 7


@pytest.mark.parametrize("found", CLASSES, ids=lambda found: found.__name__)
def test_an_object_without_contents_raises(found):
    for name in uses_of(found):
        if name.startswith("__") and not callable(found.__dict__[name]):
            continue
        said = []
        for use in ways_to_use(found, name):
            with pytest.raises(TypeError) as raised:
                use(found.__new__(found))
            said.append(str(raised.value))
        assert any("__init__() was not called" in text for text in said), (name, said)
    with pytest.raises(TypeError, match=UNMADE):
        repr(found.__new__(found))


def test_it_cannot_be_an_argument(run):
    with pytest.raises(TypeError, match=UNMADE):
        run.compare(kerf.Recording.__new__(kerf.Recording))


def test_a_subclass_whose_init_forgets_the_base_raises():
    with pytest.raises(TypeError, match="__init__"):
        Forgetful()
    with pytest.raises(TypeError, match="Forgetful.__init__.. was not called"):
        len(Forgetful.__new__(Forgetful))
