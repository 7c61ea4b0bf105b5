# SPDX-License-Identifier: MIT
"""Start, end and facts of the library."""
from . import frames
from .binding import _library, ffi, listen, raw


def init(threads=0, isa=None):
    """Starts with a fresh context, current on this thread. A second call ends the first one's.

    threads: how many render, 0 = all cores. isa: "generic", "sse4", "avx2", "avx512" or "neon",
    for the whole process; None: as before, at first the best that this machine has.
    """
    arguments = [b"python"]
    if isa is not None:
        arguments += [b"--rt-isa", isa.encode()]
    kept = [ffi.new("char[]", text) for text in arguments]
    argv = ffi.new("char *[]", kept + [ffi.NULL])
    _library.rtInit(ffi.new("int *", len(kept)), argv)
    listen()
    if isa is not None and instruction_set() != isa:
        raise ValueError(f"isa is among {_text(raw.RT_ISA_NAMES).split()} here, not {isa!r}")
    raw.rtThreads(threads)


def exit():
    """Waits for frames in flight and frees everything."""
    _library.rtExit()
    frames.let_go()


def version():
    """Of the library, as "0.1.0"."""
    return _text(raw.RT_VERSION).split()[-1]


def instruction_set():
    """The one that the kernels use."""
    return _text(raw.RT_ISA)


def _text(name):
    return ffi.string(ffi.cast("const char *", raw.rtGetString(name))).decode()


def statistics():
    """Facts of the last frame and of memory, as a dictionary: triangles, bytes, rays ..."""
    prefix = "RT_STAT_"
    names = [name for name in dir(raw) if name.startswith(prefix)]
    value = ffi.new("RTint64 *")
    result = {}
    for name in names:
        raw.rtGetInteger64v(getattr(raw, name), value)
        result[name[len(prefix):].lower()] = value[0]
    return result
