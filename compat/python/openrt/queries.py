# SPDX-License-Identifier: MIT
"""Rays from the application, in arrays."""
from __future__ import annotations

import dataclasses

import numpy
from numpy.typing import ArrayLike

from .binding import Error, ffi, raw

MISS = 0xFFFFFFFF  #: id of a ray that hits nothing


@dataclasses.dataclass(eq=False)
class Hits:
    """An element for each ray. t: in units of the direction's length; a miss has t = tfar, and
    MISS as primitive, object and instance. u, v: weights of the second and third vertex. normal:
    (n, 3), of the triangle, as long as twice its area."""
    t: numpy.ndarray
    u: numpy.ndarray
    v: numpy.ndarray
    primitive: numpy.ndarray
    object: numpy.ndarray
    instance: numpy.ndarray
    normal: numpy.ndarray

    @property
    def hit(self) -> numpy.ndarray:
        """Whether each ray hit anything: n truth values."""
        return self.primitive != MISS


class CompiledScene:
    """What the next frame consists of so far, ready for rays; the frame goes on. Any thread may
    ask, several at once. It is held until close(), which a `with` calls."""

    def __init__(self) -> None:
        self._handle = raw.rtCompileScene()

    def close(self) -> None:
        """Frees it; afterwards nothing can be asked."""
        if self._handle is not None:
            handle, self._handle = self._handle, None
            raw.rtReleaseScene(handle)

    def __enter__(self) -> CompiledScene:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def intersect(self, origins: ArrayLike, directions: ArrayLike, tnear: ArrayLike = 0.0,
                  tfar: ArrayLike = numpy.inf, coherent: bool = False) -> Hits:
        """Nearest hits of n rays. origins: (n, 3), or (3,) for all; directions: (n, 3), of any
        length; tnear, tfar: a number, or n. coherent: neighbours in the arrays are neighbours in
        space, as the pixels of a picture are; it changes the speed only."""
        rays, kept, count = self._stream(origins, directions, tnear, tfar)
        normals = numpy.empty((3, count), numpy.float32)
        hits = Hits(*(numpy.empty(count, numpy.float32) for _ in range(3)),
                    *(numpy.empty(count, numpy.uint32) for _ in range(3)), normals.T)
        hits.primitive[:1], hits.instance[:1] = MISS, 0  # what no ray is answered
        out = ffi.new("RThitstream *")
        for name in ("t", "u", "v"):
            setattr(out, name, ffi.cast("float *", ffi.from_buffer(getattr(hits, name))))
        for name in ("primitive", "object", "instance"):
            setattr(out, name, ffi.cast("RTuint *", ffi.from_buffer(getattr(hits, name))))
        for name, values in zip(("nx", "ny", "nz"), normals):
            setattr(out, name, ffi.cast("float *", ffi.from_buffer(values)))
        raw.rtIntersectStream(self._open(), rays, out, count, _coherence(coherent))
        del kept
        if count and hits.primitive[0] == MISS and hits.instance[0] == 0:
            raise _unanswered("rtIntersectStream")
        return hits

    def occluded(self, origins: ArrayLike, directions: ArrayLike, tnear: ArrayLike = 0.0,
                 tfar: ArrayLike = numpy.inf, coherent: bool = False) -> numpy.ndarray:
        """Whether anything lies in a ray's range: n truth values."""
        rays, kept, count = self._stream(origins, directions, tnear, tfar)
        blocked = numpy.empty(count, numpy.uint8)
        blocked[:1] = 2  # what no ray is answered
        raw.rtOccludedStream(self._open(), rays, blocked, count, _coherence(coherent))
        del kept
        if count and blocked[0] == 2:
            raise _unanswered("rtOccludedStream")
        return blocked.astype(bool)

    def __reduce__(self):
        raise TypeError("a CompiledScene belongs to its process and can not be copied")

    def _open(self):
        if self._handle is None:
            raise ValueError("the scene is closed")
        return self._handle

    @staticmethod
    def _stream(origins, directions, tnear, tfar):
        directions = numpy.asarray(directions, numpy.float32)
        if directions.ndim != 2 or directions.shape[1] != 3:
            raise ValueError(f"directions have the shape {directions.shape}, not (n, 3)")
        count = len(directions)
        origins = numpy.asarray(origins, numpy.float32)
        common = origins.shape == (3,)
        if not common and origins.shape != (count, 3):
            raise ValueError(f"origins have the shape {origins.shape}, not ({count}, 3) or (3,)")
        columns = [*numpy.atleast_2d(origins).T, *directions.T,
                   numpy.broadcast_to(numpy.float32(tnear), count),
                   numpy.broadcast_to(numpy.float32(tfar), count)]
        kept = [numpy.ascontiguousarray(column) for column in columns]
        rays = ffi.new("RTraystream *")
        for name, column in zip(("ox", "oy", "oz", "dx", "dy", "dz", "tnear", "tfar"), kept):
            setattr(rays, name, ffi.cast("const float *", ffi.from_buffer(column)))
        rays.flags = raw.RT_COMMON_ORIGIN if common else 0
        return rays, kept, count


def _unanswered(function):
    """Without a context on the thread nothing records why."""
    return Error(raw.RT_INVALID_OPERATION, function,
                 "no answer on a thread without a context; was the scene freed by exit()?")


def _coherence(coherent):
    return raw.RT_COHERENT if coherent else raw.RT_INCOHERENT
