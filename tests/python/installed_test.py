"""cmake --install puts the module where an interpreter finds it."""

import os
import pathlib
import site
import subprocess
import sys

import kerf


def test_the_component_is_whole(tmp_path):
    """It is imported from the prefix alone, with its types."""
    build = os.environ["KERF_BUILD_DIR"]
    subprocess.run(["cmake", "--install", build, "--component", "python", "--prefix", tmp_path], check=True)
    (module,) = tmp_path.rglob("kerf/__init__.py")
    installed = sorted(path.name for path in module.parent.iterdir())
    assert installed == sorted(path.name for path in pathlib.Path(kerf.__file__).parent.iterdir() if path.is_file())
    assert {"__init__.pyi", "py.typed"} <= set(installed)
    code = "import kerf; print(kerf.__file__, kerf.__version__, len(kerf.BroadPhase(2)))"
    environment = dict(os.environ, PYTHONPATH=str(module.parent.parent))
    found = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True)
    assert found.stdout.split() == [str(module), kerf.__version__, "0"]


def test_the_folder_is_one_in_which_the_interpreter_looks(tmp_path):
    build = os.environ["KERF_BUILD_DIR"]
    subprocess.run(["cmake", "--install", build, "--component", "python", "--prefix", tmp_path], check=True)
    (module,) = tmp_path.rglob("kerf/__init__.py")
    folder = str(module.parent.parent.relative_to(tmp_path))
    assert any(path.endswith(f"/{folder}") for path in site.getsitepackages()), folder


def test_the_version_is_that_of_the_project():
    source = pathlib.Path(os.environ["KERF_SOURCE_DIR"])
    assert f"project(Kerf VERSION {kerf.__version__} " in (source / "CMakeLists.txt").read_text(encoding="utf-8")
