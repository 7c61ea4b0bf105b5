# SPDX-License-Identifier: MIT
"""The program of compat/python/README.md, and its command for a build tree."""
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
README = ROOT / "compat/python/README.md"


def test_program(capsys):
    program = re.search(r"^```python\n(.*?)^```", README.read_text(encoding="utf-8"),
                        flags=re.DOTALL | re.MULTILINE).group(1)
    made = {}
    exec(compile(program, str(README), "exec"), made)  # pylint: disable=exec-used
    assert made["picture"].shape[:2] == (640, 640)
    assert made["hits"].t[0] == 4
    assert list(made["hits"].hit) == [True, False]
    assert capsys.readouterr().out.startswith("[")


def test_command_in_a_build_tree(tmp_path):
    command = re.search(r"^PYTHONPATH=.*$", README.read_text(encoding="utf-8"), flags=re.M).group(0)
    (tmp_path / "compat").symlink_to(ROOT / "compat")
    (tmp_path / "build").symlink_to(pathlib.Path(os.environ["PYTHONPATH"]).parent)
    result = subprocess.run(
        ["bash", "-c", f'python3() {{ {sys.executable} "$@"; }}; {command}'], cwd=tmp_path,
        capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stderr
    assert "rays, depth from" in result.stdout
