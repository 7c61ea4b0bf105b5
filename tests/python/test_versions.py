# SPDX-License-Identifier: MIT
"""The module is of one release with the library, or is not imported."""
import pathlib
import re
import shutil
import subprocess
import sys

import openrt


def imported(folder, version):
    """What an interpreter says that imports the module as one of this version."""
    package = folder / "openrt"
    shutil.copytree(pathlib.Path(openrt.__file__).parent, package)
    made = package / "_declarations.py"
    made.write_text(re.sub(r"^VERSION = .*$", f"VERSION = {version!r}", made.read_text(),
                           flags=re.M))
    return subprocess.run([sys.executable, "-c", "import openrt; print(openrt.__version__)"],
                          cwd=folder, capture_output=True, text=True, check=False)


def test_that_of_the_library():
    assert openrt.__version__ == openrt.version()


def test_own_version_is_imported(tmp_path):
    result = imported(tmp_path, openrt.__version__)
    assert (result.returncode, result.stdout) == (0, f"{openrt.__version__}\n"), result.stderr


def test_another_version_is_refused(tmp_path):
    result = imported(tmp_path, "0.0.9")
    assert result.returncode != 0
    assert f"ImportError: the module openrt is of 0.0.9, libOpenRT of {openrt.version()}" in \
        result.stderr
