"""The samples of docs/PYTHON.md and README.md run, and give what stands behind '# =>'."""

import ast
import os
import pathlib
import re
import subprocess
import sys

import pytest

import kerf

SOURCE = pathlib.Path(os.environ["KERF_SOURCE_DIR"])
PAGES = {"docs/PYTHON.md": 8, "README.md": 1}


def samples(page):
    text = (SOURCE / page).read_text(encoding="utf-8")
    return re.findall(r"^```python\n(.*?)^```", text, re.DOTALL | re.MULTILINE)


def wrong_values(code, names):
    """Runs a sample; the expressions whose value is another one than the page says."""
    lines, wrong = code.splitlines(), []
    for node in ast.parse(code).body:
        said = re.search(r"#\s*=>\s*(.*)$", lines[node.end_lineno - 1])
        if said and isinstance(node, ast.Expr):
            value = eval(compile(ast.Expression(node.value), "page", "eval"), names)
            if repr(value) != said[1]:
                wrong.append((ast.unparse(node), repr(value), said[1]))
        else:
            exec(compile(ast.Module([node], []), "page", "exec"), names)
    return wrong


@pytest.mark.parametrize("page", PAGES)
def test_samples_run_and_give_what_the_page_says(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names = {}
    assert len(samples(page)) >= PAGES[page]
    assert [wrong for code in samples(page) for wrong in wrong_values(code, names)] == []


def test_another_value_would_be_seen():
    assert wrong_values("x = 2\nx + 1  # => 4\nx  # => 2", {}) == [("x + 1", "3", "4")]


@pytest.mark.parametrize("page", PAGES)
def test_samples_have_the_right_types(page, tmp_path):
    """The page leaves out the types of the one function that it defines."""
    file = tmp_path / "samples.py"
    code, functions = re.subn(
        r"def (\w+)\(boxes\):", r"def \1(boxes: np.ndarray[Any, np.dtype[Any]]) -> Any:", "\n".join(samples(page))
    )
    assert functions == 1
    file.write_text("from typing import Any\n" + code, encoding="utf-8")
    environment = dict(os.environ, MYPYPATH=str(pathlib.Path(kerf.__file__).parent.parent))
    found = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", str(file)],
        cwd=tmp_path, env=environment, capture_output=True, text=True, check=False,
    )
    assert found.returncode == 0, found.stdout
