# SPDX-License-Identifier: MIT
"""Programs may be checked against the types of the module's functions."""
import importlib.util
import inspect
import os
import pathlib
import subprocess
import sys

import openrt
import pytest


def functions():
    """(name, function) of what is public, methods and properties too."""
    for name in set(openrt.__all__) - {"ffi", "raw"}:
        thing = getattr(openrt, name)
        if inspect.isfunction(thing):
            yield name, thing
        for part, member in vars(thing).items() if inspect.isclass(thing) else ():
            member = member.fget if isinstance(member, property) else member
            if inspect.isfunction(member) and (part[0] != "_" or part == "__init__"):
                yield f"{name}.{part}", member


def untyped(function):
    signature = inspect.signature(function)
    values = [p.annotation for p in signature.parameters.values() if p.name != "self"]
    return inspect.Signature.empty in [*values, signature.return_annotation]


def test_every_function_has_types():
    found = dict(functions())
    assert {"mesh", "Shader.set", "QueuedFrame.progress", "FrameBuffer.__init__"} <= set(found)
    assert [name for name, function in found.items() if untyped(function)] == []
    assert untyped(lambda x: x)
    assert pathlib.Path(openrt.__file__).with_name("py.typed").exists()


@pytest.mark.skipif(not importlib.util.find_spec("mypy"), reason="no mypy")
def test_mypy(tmp_path):
    program = tmp_path / "program.py"
    lines = ["import openrt", "openrt.init(threads=2)",
             "mesh = openrt.mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], shader=openrt.Shader('Phong'))",
             "openrt.instance(mesh)", "frame = openrt.queue(openrt.FrameBuffer(4, 4))",
             "done: bool = frame.wait()", "openrt.init(threads='two')"]
    program.write_text("\n".join(lines) + "\n")
    result = subprocess.run(
        [sys.executable, "-m", "mypy", "--ignore-missing-imports", str(program),
         "--cache-dir", str(tmp_path)], capture_output=True, text=True, check=False,
        env={**os.environ, "MYPYPATH": os.environ["PYTHONPATH"]})
    errors = [line for line in result.stdout.splitlines() if ": error:" in line]
    assert len(errors) == 1 and 'program.py:7: error: Argument "threads"' in errors[0], result.stdout
