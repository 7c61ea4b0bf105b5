# SPDX-License-Identifier: MIT
"""The program of compat/python/README.md."""
import pathlib
import re

README = pathlib.Path(__file__).resolve().parents[2] / "compat/python/README.md"


def test_program(capsys):
    program = re.search(r"^```python\n(.*?)^```", README.read_text(encoding="utf-8"),
                        flags=re.DOTALL | re.MULTILINE).group(1)
    made = {}
    exec(compile(program, str(README), "exec"), made)  # pylint: disable=exec-used
    assert made["picture"].shape[:2] == (640, 640)
    assert made["hits"].t[0] == 4
    assert list(made["hits"].hit) == [True, False]
    assert capsys.readouterr().out.startswith("[")
