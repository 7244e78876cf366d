"""The notebooks run, and have the pictures that they should; they are left in build/.../python/notebooks to look at."""

import base64
import io
import os
import pathlib

import matplotlib.image
import nbclient
import nbformat
import numpy as np
import pytest

SOURCE = pathlib.Path(os.environ["KERF_SOURCE_DIR"]) / "docs/notebooks"
OUTPUT = pathlib.Path(os.environ["KERF_BUILD_DIR"]) / "python_notebooks"
PICTURES = {"first_look": 5, "grid_bug": 3}


@pytest.fixture
def own_folders(tmp_path, monkeypatch):
    """Nothing of the user's is read or written."""
    for name in ("HOME", "IPYTHONDIR", "JUPYTER_CONFIG_DIR", "JUPYTER_RUNTIME_DIR", "MPLCONFIGDIR", "TMPDIR"):
        folder = tmp_path / name.lower()
        folder.mkdir()
        monkeypatch.setenv(name, str(folder))
    return tmp_path


def pictures_of(notebook):
    return [
        base64.b64decode(output.data["image/png"])
        for cell in notebook.cells
        for output in cell.get("outputs", [])
        if "image/png" in output.get("data", {})
    ]


def test_each_notebook_is_tried():
    assert sorted(PICTURES) == sorted(file.stem for file in SOURCE.glob("*.ipynb"))


@pytest.mark.parametrize("name", PICTURES)
def test_a_notebook_runs_and_has_its_pictures(name, own_folders):
    notebook = nbformat.read(SOURCE / f"{name}.ipynb", as_version=4)
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3", cwd=str(own_folders)).execute()
    OUTPUT.mkdir(exist_ok=True)
    pictures = pictures_of(notebook)
    assert len(pictures) == PICTURES[name]
    for k, png in enumerate(pictures):
        (OUTPUT / f"{name}_{k}.png").write_bytes(png)
        pixels = matplotlib.image.imread(io.BytesIO(png))
        assert len(np.unique(pixels.reshape(-1, pixels.shape[2]), axis=0)) > 20
    nbformat.write(notebook, OUTPUT / f"{name}.ipynb")


@pytest.mark.parametrize("name", PICTURES)
def test_a_notebook_is_kept_without_results(name):
    notebook = nbformat.read(SOURCE / f"{name}.ipynb", as_version=4)
    assert all(not cell.get("outputs") and cell.get("execution_count") is None for cell in notebook.cells)
