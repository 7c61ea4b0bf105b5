# SPDX-License-Identifier: MIT
"""Start, end and facts of the library."""
from __future__ import annotations

import operator

from . import frames
from .binding import _library, ffi, listen, raw, text


def init(threads: int | None = None, isa: str | None = None) -> None:
    """Starts with a fresh context, current on this thread. A second call ends the first one's.

    threads: how many render, 0 to 1024; 0 = all cores; None: as many as the environment variable
    OPENRT_THREADS says, or all cores. isa: "generic", "sse4", "avx2", "avx512" or "neon", for the
    whole process; None: as before, at first the best that this machine has.
    """
    if threads is not None:
        threads = operator.index(threads)
        if not 0 <= threads <= 1024:
            raise ValueError(f"threads are 0 to 1024, not {threads}")
    if isa is not None and isa not in (names := text("RT_ISA_NAMES").split()):
        raise ValueError(f"isa is among {names} here, not {isa!r}")
    arguments = [b"python"]
    if isa is not None:
        arguments += [b"--rt-isa", isa.encode()]
    kept = [ffi.new("char[]", argument) for argument in arguments]
    argv = ffi.new("char *[]", kept + [ffi.NULL])
    _library.rtInit(ffi.new("int *", len(kept)), argv)
    listen()
    if threads is not None:
        raw.rtThreads(threads)


def exit() -> None:
    """Waits for frames in flight and frees everything."""
    _library.rtExit()
    frames.let_go()


def version() -> str:
    """Of the library, as "0.1.0"; `openrt.__version__`, of the module, is the same."""
    return text("RT_VERSION").split()[-1]


def instruction_set() -> str:
    """The one that the kernels use."""
    return text("RT_ISA")


def statistics() -> dict[str, int]:
    """Facts of the last frame and of memory, as a dictionary: triangles, bytes, rays ..."""
    prefix = "RT_STAT_"
    names = [name for name in dir(raw) if name.startswith(prefix)]
    value = ffi.new("RTint64 *")
    result = {}
    for name in names:
        raw.rtGetInteger64v(getattr(raw, name), value)
        result[name[len(prefix):].lower()] = value[0]
    return result
