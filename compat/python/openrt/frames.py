# SPDX-License-Identifier: MIT
"""Pictures as numpy arrays, without a copy."""
from __future__ import annotations

import atexit
import collections.abc
import typing

import numpy

from .binding import _library, raw

_FORMATS = {  # name: (token, element, components)
    "rgb8": ("RT_RGB_8", numpy.uint8, 3),
    "rgba8": ("RT_RGBA_8", numpy.uint8, 4),
    "rgb32f": ("RT_RGB_32F", numpy.float32, 3),
    "rgba32f": ("RT_RGBA_32F", numpy.float32, 4),
}
_VALUES = {  # name: (token, format, element, components)
    "depth": ("RT_DEPTH", "RT_FLOAT", numpy.float32, 1),
    "distance": ("RT_DISTANCE", "RT_FLOAT", numpy.float32, 1),
    "normal": ("RT_NORMAL", "RT_RGB_32F", numpy.float32, 3),
    "object_id": ("RT_OBJECT_ID", "RT_UNSIGNED_INT", numpy.uint32, 1),
    "instance_id": ("RT_INSTANCE_ID", "RT_UNSIGNED_INT", numpy.uint32, 1),
    "primitive_id": ("RT_PRIMITIVE_ID", "RT_UNSIGNED_INT", numpy.uint32, 1),
}


class FrameBuffer:
    """Memory that frames are rendered to.

    color: the picture, (height, width, components), row 0 at the bottom as in OpenGL; picture()
    has the top row first. With `values`, also attributes depth, distance, normal, object_id,
    instance_id, primitive_id: what they hold where nothing is hit, rtSetAuxBuffer says. Write into
    the arrays as you like; they are never exchanged, for the library has their addresses.
    """

    color: numpy.ndarray
    depth: numpy.ndarray
    distance: numpy.ndarray
    normal: numpy.ndarray
    object_id: numpy.ndarray
    instance_id: numpy.ndarray
    primitive_id: numpy.ndarray

    def __init__(self, width: int, height: int, format: str = "rgb8",
                 values: collections.abc.Iterable[str] = ()) -> None:
        if format not in _FORMATS:
            raise ValueError(f"format is one of {', '.join(_FORMATS)}")
        self.width, self.height = width, height
        token, element, components = _FORMATS[format]
        self._format = getattr(raw, token)
        self.color = numpy.zeros((height, width, components), element)
        self.values = tuple(values)
        for name in self.values:
            if name not in _VALUES:
                raise ValueError(f"values are among {', '.join(_VALUES)}")
            _, _, element, components = _VALUES[name]
            shape = (height, width) if components == 1 else (height, width, components)
            setattr(self, name, numpy.zeros(shape, element))

    def __setattr__(self, name: str, value: typing.Any) -> None:
        if name in vars(self):
            raise AttributeError(f"{name} of a FrameBuffer stays what it was made as")
        super().__setattr__(name, value)

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"{name} of a FrameBuffer stays what it was made as")

    def bind(self) -> None:
        """Frames started from now on are written here."""
        raw.rtSetFrameBuffer(self.color.view(numpy.uint8), self.width, self.height, self._format)
        raw.rtFrameBufferStride(0)
        for name, (token, format, _, _) in _VALUES.items():
            array = getattr(self, name) if name in self.values else None
            raw.rtSetAuxBuffer(getattr(raw, token), array, getattr(raw, format))
        _bound.clear()
        _bound.append(self)

    def picture(self) -> numpy.ndarray:
        """The picture with the top row first: a view, not a copy."""
        return self.color[::-1]


_bound: list[FrameBuffer] = []  # keeps the memory that the library was told of
_in_flight: dict[int, FrameBuffer] = {}  # by frame


def let_go() -> None:
    """Forgets the buffers; for when the library writes to none any more."""
    _bound.clear()
    _in_flight.clear()


@atexit.register
def _end():
    """No frame may write to arrays that the interpreter frees."""
    for number in _in_flight:
        _library.rtCancelFrame(number)
    for number in _in_flight:
        _library.rtWaitFrame(number)
    _library.rtDestroyContext(_library.rtGetCurrentContext())


def render(buffer: FrameBuffer) -> FrameBuffer:
    """Renders what was given since the last frame into the buffer, and returns it."""
    buffer.bind()
    raw.rtRender()
    return buffer


class QueuedFrame:
    """A frame under way; see queue()."""

    def __init__(self, number: int, buffer: FrameBuffer) -> None:
        self.number, self.buffer = number, buffer

    def __reduce__(self):
        raise TypeError("a QueuedFrame belongs to its process and can not be copied")

    def wait(self) -> bool:
        """Until it has ended. True: the picture is complete."""
        done = raw.rtWaitFrame(self.number) != 0
        _in_flight.pop(self.number, None)
        return done

    def cancel(self) -> None:
        """Drops what no thread has begun; the frame ends soon."""
        raw.rtCancelFrame(self.number)

    @property
    def progress(self) -> float:
        """0 to 1."""
        return raw.rtFrameProgress(self.number)

    @property
    def ended(self) -> bool:
        """Whether nothing is written to the buffer any more."""
        return _has_ended(self.number)


def _has_ended(number):
    return raw.rtFrameStatus(number) not in (raw.RT_QUEUED, raw.RT_RENDERING)


def queue(buffer: FrameBuffer) -> QueuedFrame:
    """Starts a frame into the buffer and returns at once with a QueuedFrame, unless the queue is
    full (rtFrameDepth). Use one buffer for each frame in flight."""
    for number in [number for number in _in_flight if _has_ended(number)]:
        del _in_flight[number]
    buffer.bind()
    number = raw.rtQueueFrame()
    _in_flight[number] = buffer
    return QueuedFrame(number, buffer)
