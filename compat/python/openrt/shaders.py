# SPDX-License-Identifier: MIT
"""Shaders by name, their parameters as attributes."""
from __future__ import annotations

import contextlib

import numpy
from numpy.typing import ArrayLike

from .binding import Error, raw


@contextlib.contextmanager
def kept_binding():
    """Afterwards the shader, or class without one, is bound that is bound now."""
    shader, shader_class = numpy.zeros(1, numpy.int32), numpy.zeros(1, numpy.int32)
    raw.rtGetIntegerv(raw.RT_SHADER_BINDING, shader)
    raw.rtGetIntegerv(raw.RT_SHADER_CLASS_BINDING, shader_class)
    try:
        yield
    finally:
        if shader[0]:
            raw.rtBindShader(int(shader[0]))
        else:
            raw.rtBindShaderClass(int(shader_class[0]))


class Shader:
    """A shader of a class: built in ("Phong", "Glass", "PointLight" ...) or of a shader library.

        red = Shader("Phong", diffuse=(0.8, 0.1, 0.1))
        red.set(shininess=40.0)

    Values are numbers, sequences of 2, 3, 4 or 16 numbers, 4x4 matrices and str.
    """

    id: int

    def __init__(self, class_name: str, library: str | None = None,
                 **parameters: ArrayLike) -> None:
        with kept_binding():
            self._class = raw.rtGenNewShaderClass(class_name, library)
            self.id = raw.rtGenNewShader()
        try:
            self.set(**parameters)
        except BaseException:
            self.remove()
            raise

    def __reduce__(self):
        raise TypeError("a Shader belongs to its context and can not be copied")

    def bind(self) -> None:
        """Geometry from here on uses it."""
        raw.rtBindShader(self.id)

    def set(self, **parameters: ArrayLike) -> None:
        """Sets parameters by name; which names there are, docs/builtin-shaders.md says."""
        with kept_binding():
            self.bind()
            for name, value in parameters.items():
                _set(raw.rtParameterHandle(name), value)

    def use(self) -> None:
        """Makes a light part of the next frame."""
        raw.rtUseLight(self.id)

    def use_as_camera(self) -> None:
        """Takes the picture of the next frame, in the place of camera()."""
        raw.rtUseCamera(self.id)

    def use_as_environment(self) -> None:
        """Surrounds the next frame: what rays see that meet nothing."""
        raw.rtUseEnvironmentShader(self.id)

    def use_as_rendering_object(self) -> None:
        """Makes pixels of rays in the next frame."""
        raw.rtUseRenderingObject(self.id)

    def remove(self) -> None:
        """Forgets the id; objects and frames that use the shader keep it."""
        raw.rtRemoveShader(self.id)


_FLOATS = {1: "rtParameter1fv", 2: "rtParameter2fv", 3: "rtParameter3fv", 4: "rtParameter4fv",
           16: "rtParameter16fv"}
_INTEGERS = {1: "rtParameter1i", 2: "rtParameter2i", 3: "rtParameter3i"}


def _set(handle, value):
    if isinstance(value, str):
        raw.rtParameterString(handle, value)
        return
    array = numpy.asarray(value)
    if array.size not in _FLOATS or array.dtype.kind not in "biuf":
        raise ValueError("a parameter has 1, 2, 3, 4 or 16 numbers")
    if array.dtype.kind != "f" and array.size in _INTEGERS:
        try:
            getattr(raw, _INTEGERS[array.size])(handle, *map(int, array.ravel()))
            return
        except Error as error:  # whole numbers for a parameter of floats
            if error.code != raw.RT_INVALID_OPERATION:
                raise
    if array.shape == (4, 4):
        array = array.T
    numbers = numpy.ascontiguousarray(array, numpy.float32).ravel()
    getattr(raw, _FLOATS[array.size])(handle, numbers)
