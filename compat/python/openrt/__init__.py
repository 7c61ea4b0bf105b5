# SPDX-License-Identifier: MIT
"""Ray tracing in the manner of OpenGL.

    import openrt
    openrt.init()
    openrt.camera(eye=(0, 0, 4), target=(0, 0, 0))
    openrt.instance(openrt.mesh([[-1, -1, 0], [1, -1, 0], [0, 1, 0]], colors=numpy.eye(3)))
    picture = openrt.render(openrt.FrameBuffer(640, 640)).picture()

Everything of the C interface is in openrt.raw. An error is an openrt.Error.
"""
from .context import exit, init, instruction_set, statistics, version
from .frames import FrameBuffer, QueuedFrame, queue, render
from .geometry import camera, instance, matrix, mesh
from .binding import VERSION as __version__
from .binding import Error, ffi, listen, raw
from .queries import MISS, CompiledScene, Hits
from .shaders import Shader

__all__ = ["CompiledScene", "Error", "FrameBuffer", "Hits", "MISS", "QueuedFrame", "Shader",
           "camera", "exit", "ffi", "init", "instance", "instruction_set", "listen", "matrix",
           "mesh", "queue", "raw", "render", "statistics", "version"]
