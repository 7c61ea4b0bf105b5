#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A set-uid program takes nothing from the environment of who calls it; an ordinary one does.
Skipped (exit status 77) where this user, or the file system, can not make such programs.

usage: set_uid_test.py PROGRAM
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ANOTHER = 65534  # nobody
SKIPPED = 77


def run(program, folder):
    """(what it told, the names of the files that the library wrote)"""
    log, trace = folder / "log", folder / "trace"
    for path in (log, trace):
        path.unlink(missing_ok=True)
    wanted = {"OPENRT_ISA": "generic", "OPENRT_THREADS": "7", "OPENRT_LOG": str(log),
              "OPENRT_SHADER_PATH": str(folder), "OPENRT_TRACE": str(trace)}
    result = subprocess.run([program], env=wanted, capture_output=True, text=True, check=True)
    told = dict(line.split(": ", 1) for line in result.stdout.splitlines())
    return told, {path.name for path in (log, trace) if path.exists()}


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        folder.chmod(0o777)
        program = folder / "environment"
        shutil.copy(sys.argv[1], program)
        told, files = run(program, folder)
        assert told["secure"] == "0" and told["isa"] == "generic", told
        assert told["threads"] == "7" and str(folder) in told["folders"], told
        assert files == {"log", "trace"}, files
        try:
            os.chown(program, ANOTHER, -1)
            program.chmod(0o4755)
        except PermissionError:
            print("skipped: another user's programs can not be made here")
            return SKIPPED
        told, files = run(program, folder)
        if told["secure"] == "0":
            print("skipped: set-uid has no effect here")
            return SKIPPED
        print(told, files)
        assert told["threads"] == str(len(os.sched_getaffinity(0))), told
        assert str(folder) not in told["folders"], told
        assert not files, files
        normal = subprocess.run([sys.argv[1]], env={}, capture_output=True, text=True, check=True)
        assert f"isa: {told['isa']}\n" in normal.stdout, (told, normal.stdout)
    return 0


if __name__ == "__main__":
    sys.exit(main())
