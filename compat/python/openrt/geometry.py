# SPDX-License-Identifier: MIT
"""Objects from arrays, instances, the camera."""
from __future__ import annotations

import collections.abc

import numpy
from numpy.typing import ArrayLike

from .binding import raw
from .shaders import Shader, kept_binding

#: Three, of a point or direction.
Numbers = collections.abc.Iterable[float]


def _rows(values, columns, count, name):
    """A contiguous float array of `count` rows."""
    array = numpy.ascontiguousarray(values, numpy.float32)
    if array.ndim != 2 or array.shape[1] not in columns:
        raise ValueError(f"{name} has the shape {array.shape}, not (n, {columns[0]})")
    if count is not None and len(array) != count:
        raise ValueError(f"{name} has {len(array)} rows for {count} vertices")
    return array


def mesh(vertices: ArrayLike, triangles: ArrayLike | None = None, normals: ArrayLike | None = None,
         colors: ArrayLike | None = None, texcoords: ArrayLike | None = None,
         shader: Shader | None = None) -> int:
    """An object; returns its id, for instance().

    vertices:  (n, 3) positions
    triangles: (m, 3) numbers of vertices; None: each three vertices in a row are a triangle
    normals:   (n, 3), colors: (n, 3) or (n, 4) from 0 to 1, texcoords: (n, 2). Where None, the
               instance's current values serve, and normals are the triangles' own.
    shader:    a Shader; None: the one bound now
    """
    vertices = _rows(vertices, (3,), None, "vertices")
    count = len(vertices)
    if triangles is None:
        triangles = numpy.arange(count - count % 3, dtype=numpy.uint32)
    else:
        triangles = numpy.asarray(triangles)
        if triangles.size and not numpy.issubdtype(triangles.dtype, numpy.integer):
            raise TypeError("triangles are numbers of vertices: integers")
        if triangles.size and (triangles.min() < 0 or triangles.max() >= count):
            raise ValueError("a triangle names a vertex that is none")
        if triangles.ndim != 2 or triangles.shape[1] != 3:
            raise ValueError(f"triangles have the shape {triangles.shape}, not (m, 3)")
        triangles = numpy.ascontiguousarray(triangles, numpy.uint32)
    arrays = [(raw.RT_VERTEX_ARRAY, raw.rtVertexPointer, vertices)]
    if colors is not None:
        arrays.append((raw.RT_COLOR_ARRAY, raw.rtColorPointer,
                       _rows(colors, (3, 4), count, "colors")))
    if texcoords is not None:
        arrays.append((raw.RT_TEXTURE_COORD_ARRAY, raw.rtTexCoordPointer,
                       _rows(texcoords, (2,), count, "texcoords")))
    if normals is not None:
        normals = _rows(normals, (3,), count, "normals")

    raw.rtPushClientAttrib(raw.RT_CLIENT_VERTEX_ARRAY_BIT)
    try:
        for target in (raw.RT_ARRAY_BUFFER, raw.RT_ELEMENT_ARRAY_BUFFER):
            raw.rtBindBuffer(target, 0)
        for token in (raw.RT_VERTEX_ARRAY, raw.RT_NORMAL_ARRAY, raw.RT_COLOR_ARRAY,
                      raw.RT_SECONDARY_COLOR_ARRAY, raw.RT_FOG_COORD_ARRAY, raw.RT_INDEX_ARRAY,
                      raw.RT_EDGE_FLAG_ARRAY):
            raw.rtDisableClientState(token)
        for unit in (raw.RT_TEXTURE3, raw.RT_TEXTURE2, raw.RT_TEXTURE1, raw.RT_TEXTURE0):
            raw.rtClientActiveTexture(unit)
            raw.rtDisableClientState(raw.RT_TEXTURE_COORD_ARRAY)
        for token, point, array in arrays:
            raw.rtEnableClientState(token)
            point(array.shape[1], raw.RT_FLOAT, 0, array)
        if normals is not None:
            raw.rtEnableClientState(raw.RT_NORMAL_ARRAY)
            raw.rtNormalPointer(raw.RT_FLOAT, 0, normals)
        with kept_binding():
            if shader is not None:
                shader.bind()
            made = raw.rtNewObject(raw.RT_DEFINE)
            try:
                raw.rtDrawElements(raw.RT_TRIANGLES, triangles.size, raw.RT_UNSIGNED_INT,
                                   triangles)
            finally:
                raw.rtEndObject()
    finally:
        raw.rtPopClientAttrib()
    return made


def matrix(values: ArrayLike) -> numpy.ndarray:
    """A 4x4 matrix in mathematical order as OpenGL lays it out: column by column."""
    array = numpy.asarray(values, numpy.float64)
    if array.shape != (4, 4):
        raise ValueError(f"a matrix has the shape (4, 4), not {array.shape}")
    return numpy.ascontiguousarray(array.T)


def instance(mesh: int, transform: ArrayLike | None = None,
             shader: Shader | None = None) -> None:
    """Places an object in the next frame. transform: 4x4, the translation in the last column;
    None: the current model-view matrix. shader: takes the place of the object's own."""
    raw.rtPushMatrix()
    try:
        if transform is not None:
            raw.rtMultMatrixd(matrix(transform))
        if shader is None:
            raw.rtInstantiateObject(mesh)
        else:
            raw.rtInstantiateObjectShader(mesh, shader.id)
    finally:
        raw.rtPopMatrix()


def camera(eye: Numbers, target: Numbers, up: Numbers = (0, 1, 0), fovy: float = 45.0,
           aspect: float = 1.0, near: float = 0.01, far: float = 10000.0) -> None:
    """Looks from eye to target; fovy: the whole vertical angle in degrees. Call it before the
    frame's first instance: instances are placed in the world that it looks at."""
    raw.rtMatrixMode(raw.RT_PROJECTION)
    raw.rtLoadIdentity()
    raw.rtPerspective(fovy, aspect, near, far)
    raw.rtMatrixMode(raw.RT_MODELVIEW)
    raw.rtLoadIdentity()
    raw.rtLookAt(*eye, *target, *up)
