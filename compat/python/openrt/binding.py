# SPDX-License-Identifier: MIT
"""The C library: finds it, and makes its errors exceptions.

`raw` has every function of the C interface under its name, and every RT_ constant:

    from openrt import raw
    raw.rtTranslatef(0, 0, -5)

Arguments that are pointers take None, cffi pointers, bytes for `void` and numpy arrays whose
elements are of the pointer's type, writable ones where it is not const; a `const char *` takes a
str. An array is not copied: it must live as long as the C function says that its memory must.
"""
from __future__ import annotations

import ctypes.util
import os
import pathlib
import threading
import typing

import cffi
import numpy

from ._declarations import CDEF, TOKENS, VERSION, WRITTEN

ffi = cffi.FFI()
ffi.cdef(CDEF)


class Error(RuntimeError):
    """What a call recorded. `code` is the token, such as raw.RT_INVALID_VALUE."""

    def __init__(self, code: int, function: str, text: str) -> None:
        super().__init__(code, function, text)
        self.code = code
        self.function = function

    def __str__(self) -> str:
        return f"{self.function}: {self.args[2]}"


def _open():
    """OPENRT_LIBRARY, else the library beside this package, else the system's."""
    named = os.environ.get("OPENRT_LIBRARY")
    if named:
        return ffi.dlopen(named)
    beside = pathlib.Path(__file__).with_name("libOpenRT.so.0")
    found = str(beside) if beside.exists() else "libOpenRT.so.0"
    try:
        return ffi.dlopen(found)
    except OSError as reason:
        other = ctypes.util.find_library("OpenRT")
        if other:
            return ffi.dlopen(other)
        raise OSError(f"{reason}; set OPENRT_LIBRARY to the path of libOpenRT.so") from None


_library = _open()


class _Pending(threading.local):
    """What the calls of this thread since the last look recorded."""

    def __init__(self):
        self.errors = []


_pending = _Pending()


@ffi.callback("void(RTenum, const char *, const char *, void *)")
def _on_error(code, function, text, _user):
    _pending.errors.append(Error(code, ffi.string(function).decode(), ffi.string(text).decode()))


def _raise_pending():
    if not _pending.errors:
        return
    first = _pending.errors[0]
    _pending.errors.clear()
    _library.rtGetError()
    raise first


#: Calls that mean something on a thread without a context; others do nothing there.
_WITHOUT_CONTEXT = {
    "rtInit", "rtExit", "rtCreateContext", "rtMakeCurrent", "rtDestroyContext",
    "rtGetCurrentContext", "rtGetError", "rtGetErrorText", "rtWaitFrame", "rtFrameStatus",
    "rtFrameProgress", "rtCancelFrame", "rtReleaseScene", "rtIntersect", "rtIntersectStream",
    "rtOccluded", "rtOccludedStream"}
_UTILITIES_WITHOUT_CONTEXT = {
    "rtuErrorString", "rtuGetString", "rtuCheckExtension", "rtuProject", "rtuUnProject",
    "rtuUnProject4", "rtuPickRay", "rtuScaleImage", "rtuNewQuadric", "rtuDeleteQuadric",
    "rtuQuadricDrawStyle", "rtuQuadricNormals", "rtuQuadricOrientation", "rtuQuadricTexture",
    "rtuQuadricCallback", "rtuNewTess", "rtuDeleteTess", "rtuTessCallback", "rtuTessProperty",
    "rtuGetTessProperty", "rtuTessNormal", "rtuTessBeginPolygon", "rtuTessBeginContour",
    "rtuTessVertex", "rtuTessEndContour", "rtuTessEndPolygon", "rtuBeginPolygon",
    "rtuNextContour", "rtuEndPolygon"}


def listen() -> None:
    """Makes the errors of the context current on this thread exceptions; init() does so."""
    raw.rtErrorCallback(_on_error, None)


_ELEMENTS = {"float": numpy.float32, "double": numpy.float64, "unsigned char": numpy.uint8,
             "signed char": numpy.int8, "short": numpy.int16, "unsigned short": numpy.uint16,
             "int": numpy.int32, "unsigned int": numpy.uint32, "int64_t": numpy.int64,
             "uint64_t": numpy.uint64}


def _pointer(kind, value, name, is_written):
    """An argument for a parameter that is a pointer."""
    if value is None:
        return ffi.NULL
    is_array = isinstance(value, numpy.ndarray)
    if is_written and (isinstance(value, (bytes, str)) or is_array and not value.flags.writeable):
        raise ValueError(f"{name}: what the call writes to is read-only")
    if isinstance(value, str):
        return value.encode()
    if not is_array:
        return value
    if not value.flags.c_contiguous:
        raise ValueError(f"{name}: the array is not contiguous")
    item = kind.item
    if item.kind == "void":
        return ffi.from_buffer(value)
    element = _ELEMENTS.get(item.cname)
    if element is None or value.dtype != element:
        raise TypeError(f"{name}: elements are {value.dtype}, not {item.cname}")
    return ffi.cast(kind, ffi.from_buffer(value))


def _wrapped(name):
    function = getattr(_library, name)
    kind = ffi.typeof(function)
    pointers = [i for i, argument in enumerate(kind.args) if argument.kind == "pointer"]
    written = WRITTEN.get(name, ())
    needs_context = name not in _WITHOUT_CONTEXT | _UTILITIES_WITHOUT_CONTEXT
    current = _library.rtGetCurrentContext

    def call(*arguments):
        if needs_context and not current():
            raise Error(TOKENS["RT_INVALID_OPERATION"], name,
                        "no context is current on this thread; init() makes one")
        if pointers:
            arguments = list(arguments)
            for i in pointers:
                if i < len(arguments):
                    arguments[i] = _pointer(kind.args[i], arguments[i], name, i in written)
        result = function(*arguments)
        _raise_pending()
        return result

    call.__name__ = call.__qualname__ = name
    call.__doc__ = ffi.getctype(kind, name)
    return call


class _Raw:
    """Functions and constants of the C interface."""

    def __getattr__(self, name: str) -> typing.Any:
        if name in TOKENS:
            value = TOKENS[name]
        elif name.startswith("rt"):
            try:
                value = _wrapped(name)
            except AttributeError:
                raise AttributeError(f"the library has no function {name}") from None
        else:
            raise AttributeError(name)
        setattr(self, name, value)
        return value

    def __dir__(self) -> list[str]:
        return sorted([*TOKENS, *(name for name in dir(_library) if name.startswith("rt"))])


raw = _Raw()


def text(name: str) -> str:
    """What rtGetString says of the library; also on a thread without a context."""
    made = None if raw.rtGetCurrentContext() else raw.rtCreateContext()
    if made:
        raw.rtMakeCurrent(made)
    try:
        return ffi.string(ffi.cast("const char *", raw.rtGetString(TOKENS[name]))).decode()
    finally:
        raw.rtDestroyContext(made)


def _require_own_version():
    version = text("RT_VERSION").split()[-1]
    if version != VERSION:
        raise ImportError(f"the module openrt is of {VERSION}, libOpenRT of {version}: "
                          "both are to be of one release")


_require_own_version()
