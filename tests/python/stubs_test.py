"""The types that editors see (__init__.pyi) are those of the module."""

import ast
import inspect
import math
import os
import pathlib
import re
import subprocess
import sys

import pytest

import kerf

FOLDER = pathlib.Path(kerf.__file__).parent
STUB = ast.parse((FOLDER / "__init__.pyi").read_text(encoding="utf-8"))
OWN = [name for name in kerf.__all__ if name != "__version__"]


def declared(body):
    """Names that are declared, with their nodes; of overloaded functions the first one, which has all defaults."""
    return {node.name: node for node in reversed(body) if isinstance(node, (ast.FunctionDef, ast.ClassDef))}


def members(cls):
    """What a class has of its own, without what every object has."""
    ignored = {"__doc__", "__module__", "__weakref__", "__dict__", "__hash__", "__annotations__", "__str__", "__repr__"}
    ignored.add("__reduce__")
    return {name for name in vars(cls) if name not in ignored and not name.startswith("_pybind11")}


def parameters_of_stub(node):
    """[(name, default or None, keyword only)]"""
    args = node.args
    positional = args.args[1:] if args.args and args.args[0].arg == "self" else args.args
    defaults = [None] * (len(positional) - len(args.defaults)) + args.defaults
    found = [(arg.arg, value, False) for arg, value in zip(positional, defaults)]
    found += [(arg.arg, value, True) for arg, value in zip(args.kwonlyargs, args.kw_defaults)]
    return [(name, None if value is None else eval(ast.unparse(value), {"inf": math.inf}), only) for name, value, only in found]


def parameters_of_module(function):
    """The same from the signature that pybind11 puts first into the docstring."""
    first = re.sub(r": [\w.\[\], ]+?(?=( = |, \*|, \w+:|\) ->))", "", function.__doc__.split("\n")[0])
    signature = first[first.index("(") :].rsplit(" ->", 1)[0]
    node = ast.parse(f"def f{signature}: ...").body[0]
    return parameters_of_stub(node)


def functions():
    for name, node in declared(STUB.body).items():
        if name == "index_of":
            continue
        if isinstance(node, ast.FunctionDef):
            yield name, node, getattr(kerf, name)
        elif hasattr(getattr(kerf, name), "_pybind11_conduit_v1_") or "_kerf" in getattr(kerf, name).__module__:
            for member, inner in declared(node.body).items():
                is_property = any(isinstance(d, ast.Name) and d.id == "property" for d in inner.decorator_list)
                if not is_property and not member.startswith("__") or member == "__init__":
                    yield f"{name}.{member}", inner, getattr(getattr(kerf, name), member)


def test_every_name_is_declared_and_every_declared_name_is_there():
    assert sorted(declared(STUB.body)) == sorted(OWN)
    public = {name for name in vars(kerf) if not name.startswith("_")} - {"enum", "np", "NamedTuple", "Optional"}
    assert public == set(OWN)


@pytest.mark.parametrize("name", [name for name in OWN if inspect.isclass(getattr(kerf, name))])
def test_every_member_is_declared(name):
    cls = getattr(kerf, name)
    if "_kerf" not in cls.__module__ or issubclass(cls, Exception):
        return
    stub = declared(STUB.body)[name]
    made_by_others = set() if "__init__" in declared(stub.body) else {"__init__"}
    assert set(declared(stub.body)) == members(cls) - made_by_others
    for member, node in declared(stub.body).items():
        is_property = any(isinstance(d, ast.Name) and d.id == "property" for d in node.decorator_list)
        assert isinstance(vars(cls)[member], property) == is_property, member


@pytest.mark.parametrize("name, node, function", list(functions()), ids=lambda x: x if isinstance(x, str) else "")
def test_parameters_are_declared_with_their_defaults(name, node, function):
    if name in {"CheckFailed.__init__"}:
        return
    found = [p for p in parameters_of_module(function) if p[0] != "self"]
    assert parameters_of_stub(node) == found


@pytest.mark.parametrize("name", OWN)
def test_everything_has_a_docstring(name):
    thing = getattr(kerf, name)
    assert thing.__doc__ and len(thing.__doc__.split()) > 4
    if inspect.isclass(thing) and "_kerf" in thing.__module__ and not issubclass(thing, Exception):
        bare = {"step", "steps", "a", "b", "leaf", "reported", "boxes_overlap", "both_fixed", "text", "b_box"}
        bare |= {"events", "pairs", "extra", "twice"}
        for member in members(thing) - bare:
            if not member.startswith("__"):
                assert len(getattr(thing, member).__doc__.split("\n", 1)[-1].split()) >= 2, member


def test_types_are_found_by_other_programs():
    assert (FOLDER / "py.typed").exists()


def run_mypy(*arguments, cwd):
    environment = dict(os.environ, MYPYPATH=str(FOLDER.parent), MYPY_CACHE_DIR=str(cwd / "cache"))
    return subprocess.run(
        [sys.executable, "-m", *arguments], cwd=cwd, env=environment, capture_output=True, text=True, check=False
    )


def test_mypy_takes_the_stub_and_finds_wrong_calls(tmp_path):
    (tmp_path / "right.py").write_text(
        "import numpy as np\nimport kerf\n\n"
        "phase = kerf.BroadPhase(3, config={'dense': False})\n"
        "ids = phase.insert(np.zeros((1, 2, 3)))\n"
        "count: int = int(ids[0]) + len(phase.step())\n"
    )
    (tmp_path / "wrong.py").write_text("import kerf\n\nkerf.BroadPhase(3, tree='octree').insert()\n")
    right = run_mypy("mypy", "--strict", "right.py", cwd=tmp_path)
    assert right.returncode == 0, right.stdout + right.stderr
    wrong = run_mypy("mypy", "--strict", "wrong.py", cwd=tmp_path)
    assert wrong.returncode == 1 and "octree" in wrong.stdout and "boxes" in wrong.stdout, wrong.stdout + wrong.stderr


def test_stubtest_finds_no_difference(tmp_path):
    """Classes of pybind11 have a metaclass of their own; those that only results have cannot be made."""
    classes = [name for name in OWN if "_kerf" in getattr(getattr(kerf, name), "__module__", "")]
    allowed = [f"kerf.{name}{part}" for name in classes for part in ("", ".__init__")]
    (tmp_path / "allowed").write_text("\n".join(allowed))
    options = ["--ignore-missing-stub", "--concise", "--allowlist", "allowed", "--ignore-unused-allowlist"]
    found = run_mypy("mypy.stubtest", "kerf", *options, cwd=tmp_path)
    assert found.returncode == 0, found.stdout + found.stderr
