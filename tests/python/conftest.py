# SPDX-License-Identifier: MIT
import openrt
import pytest


@pytest.fixture(autouse=True)
def context():
    """Each test has a fresh context of two threads."""
    openrt.init(threads=2)
    yield
    openrt.exit()
