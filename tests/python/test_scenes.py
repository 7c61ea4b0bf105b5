# SPDX-License-Identifier: MIT
"""Objects, shaders, frames and errors."""
import math
import os
import subprocess
import sys

import numpy
import openrt
import pytest

TRIANGLE = [[-1, -1, 0], [1, -1, 0], [0, 1, 0]]


def look():
    openrt.camera(eye=(0, 0, 4), target=(0, 0, 0), fovy=60)


def test_picture_is_the_array():
    frame = openrt.FrameBuffer(64, 64, "rgb32f", values=["depth", "object_id", "normal"])
    color = frame.color
    look()
    triangle = openrt.mesh(TRIANGLE, colors=[[0.25, 0.5, 1.0]] * 3)
    openrt.instance(triangle)
    assert openrt.render(frame).color is color
    inside = frame.object_id == triangle
    # A right share of the pixels: the triangle's area in a window of side 8 tan(30 degrees).
    share = 2.0 / (8 * math.tan(math.radians(30))) ** 2
    assert abs(inside.mean() - share) < 0.01
    assert (color[inside] == numpy.float32([0.25, 0.5, 1.0])).all()
    assert (color[~inside] == 0).all() and (frame.depth[~inside] == 1).all()
    assert numpy.allclose(frame.normal[inside], [0, 0, 1])
    # The tip is at the top: the picture turns the rows over.
    assert inside[:32].sum() > inside[32:].sum()
    assert (frame.picture()[0] == color[-1]).all()


def test_colours_are_interpolated():
    frame = openrt.FrameBuffer(65, 65, "rgb32f")
    openrt.camera(eye=(0, -1 / 3, 4), target=(0, -1 / 3, 0))
    openrt.instance(openrt.mesh(TRIANGLE, colors=numpy.eye(3)))
    openrt.render(frame)
    assert numpy.allclose(frame.color[32, 32], 1 / 3, atol=1e-5)


def test_shader_parameters_by_name():
    frame = openrt.FrameBuffer(8, 8, "rgb32f")
    look()
    green = openrt.Shader("ConstantShader", value=(0.0, 0.5, 0.25))
    big = openrt.mesh(numpy.array(TRIANGLE) * 50, shader=green)
    openrt.instance(big)
    assert numpy.allclose(openrt.render(frame).color, [0, 0.5, 0.25])
    green.set(value=(1.0, 0.0, 0.0))
    openrt.instance(big)
    assert numpy.allclose(openrt.render(frame).color, [1, 0, 0])
    blue = openrt.Shader("ConstantShader", value=(0.0, 0.0, 1.0))
    openrt.instance(big, shader=blue)
    assert numpy.allclose(openrt.render(frame).color, [0, 0, 1])
    with pytest.raises(openrt.Error) as info:
        green.set(no_such_parameter=1.0)
    assert info.value.code == openrt.raw.RT_INVALID_VALUE
    with pytest.raises(openrt.Error):
        openrt.Shader("NoSuchClass")
    with pytest.raises(openrt.Error):
        openrt.Shader("ConstantShader", library="/no/such/file.so")


def bound():
    """The shader that is bound, and the class."""
    raw = openrt.raw
    value = numpy.zeros(2, numpy.int32)
    raw.rtGetIntegerv(raw.RT_SHADER_BINDING, value[:1])
    raw.rtGetIntegerv(raw.RT_SHADER_CLASS_BINDING, value[1:])
    return value.tolist()


def test_only_bind_binds_a_shader():
    raw = openrt.raw
    red = openrt.Shader("ConstantShader", value=(1.0, 0.0, 0.0))
    assert bound() == [0, 0]
    red.bind()
    before = bound()
    assert before[0] == red.id
    blue = openrt.Shader("ConstantShader", value=(0.0, 0.0, 1.0))
    openrt.Shader("PointLight").set(radiance=(1.0, 1.0, 1.0))
    openrt.mesh(TRIANGLE, shader=blue)
    for wrong in (lambda: openrt.Shader("NoSuchClass"), lambda: blue.set(no_such_parameter=1.0),
                  lambda: openrt.Shader("Phong", no_such_parameter=1.0),
                  lambda: openrt.mesh(TRIANGLE, shader=openrt.Shader("PointLight"))):
        with pytest.raises(openrt.Error):
            wrong()
    assert bound() == before
    frame = openrt.FrameBuffer(8, 8, "rgb32f")
    look()
    openrt.instance(openrt.mesh(numpy.array(TRIANGLE) * 50))
    assert numpy.allclose(openrt.render(frame).color, [1, 0, 0])
    raw.rtBindShaderClass(before[1])
    blue.set(value=(0.0, 1.0, 0.0))
    assert bound() == [0, before[1]]


def test_frames_in_flight_keep_their_buffers():
    look()
    triangle = openrt.mesh(numpy.array(TRIANGLE) * 50, colors=[[1, 1, 1]] * 3)
    frames = []
    for _ in range(6):
        openrt.instance(triangle)
        frames.append(openrt.queue(openrt.FrameBuffer(128, 128)))
    assert all(frame.wait() for frame in frames)
    assert all(frame.ended and frame.progress == 1.0 for frame in frames)
    assert all((frame.buffer.color == 255).all() for frame in frames)


def test_arrays_of_the_program_do_not_reach_a_mesh():
    raw = openrt.raw
    arrays = (raw.RT_SECONDARY_COLOR_ARRAY, raw.RT_FOG_COORD_ARRAY, raw.RT_TEXTURE_COORD_ARRAY)
    raw.rtClientActiveTexture(raw.RT_TEXTURE1)
    for token in arrays:
        raw.rtEnableClientState(token)
    names = numpy.zeros(2, numpy.uint32)
    raw.rtGenBuffers(2, names)
    bindings = ((raw.RT_ARRAY_BUFFER, raw.RT_ARRAY_BUFFER_BINDING),
                (raw.RT_ELEMENT_ARRAY_BUFFER, raw.RT_ELEMENT_ARRAY_BUFFER_BINDING))
    for (target, _), name in zip(bindings, names):
        raw.rtBindBuffer(target, int(name))
    openrt.mesh(TRIANGLE, colors=numpy.eye(3))
    value = numpy.zeros(1, numpy.int32)
    for (_, binding), name in zip(bindings, names):
        raw.rtGetIntegerv(binding, value)
        assert value == name
    raw.rtGetIntegerv(raw.RT_CLIENT_ACTIVE_TEXTURE, value)
    assert value == raw.RT_TEXTURE1
    assert all(raw.rtIsEnabled(token) for token in arrays)


def test_transform_is_in_mathematical_order():
    frame = openrt.FrameBuffer(32, 32, values=["object_id"])
    look()
    transform = numpy.diag([0.1, 0.1, 0.1, 1.0])
    transform[:3, 3] = (1.5, 0, 0)
    openrt.instance(openrt.mesh(TRIANGLE), transform)
    openrt.render(frame)
    rows, columns = numpy.nonzero(frame.object_id != openrt.MISS)
    assert len(columns) > 0 and columns.min() > 20


def test_errors_are_exceptions_and_change_nothing():
    with pytest.raises(openrt.Error) as info:
        openrt.raw.rtInstantiateObject(12345)
    assert info.value.code == openrt.raw.RT_INVALID_VALUE
    assert info.value.function == "rtInstantiateObject"
    assert openrt.raw.rtGetError() == openrt.raw.RT_NO_ERROR
    with pytest.raises(ValueError):
        openrt.mesh([[0, 0], [1, 1]])
    with pytest.raises(ValueError):
        openrt.mesh(TRIANGLE, [[0, 1, 3]])
    with pytest.raises(ValueError):
        openrt.mesh(TRIANGLE, [[0, 1, -1]])
    with pytest.raises(TypeError):
        openrt.mesh(TRIANGLE, [[0.0, 1.0, 2.0]])
    with pytest.raises(ValueError):
        openrt.mesh(TRIANGLE, normals=[[0, 0, 1]])
    with pytest.raises(ValueError):
        openrt.matrix(numpy.eye(3))
    with pytest.raises(ValueError):
        openrt.FrameBuffer(8, 8, "rgb16")
    with pytest.raises(TypeError):
        openrt.raw.rtLoadMatrixd(numpy.eye(4, dtype=numpy.float32))
    with pytest.raises(AttributeError):
        openrt.raw.rtNoSuchFunction
    look()
    openrt.instance(openrt.mesh(TRIANGLE))
    frame = openrt.render(openrt.FrameBuffer(16, 16, values=["object_id"]))
    assert (frame.object_id != openrt.MISS).any()


def test_strange_vertices_are_dropped_not_fatal():
    frame = openrt.FrameBuffer(16, 16)
    look()
    openrt.instance(openrt.mesh(numpy.full((30, 3), numpy.nan)))
    openrt.instance(openrt.mesh(numpy.empty((0, 3))))
    openrt.render(frame)
    assert (frame.color == 0).all()
    assert openrt.statistics()["dropped_triangles"] == 10


def test_facts():
    assert openrt.version().count(".") == 2
    assert openrt.instruction_set() in ("generic", "sse4", "avx2", "avx512", "neon")
    openrt.init(isa="generic")
    assert openrt.instruction_set() == "generic"


@pytest.mark.parametrize("argument, expected", [("", os.cpu_count() + 1), ("threads=1", 1)])
def test_threads_are_the_environments_where_the_program_says_none(argument, expected):
    program = ("import openrt, pathlib, re\n"
               f"openrt.init({argument})\n"
               "openrt.render(openrt.FrameBuffer(16, 16))\n"
               "names = (p.read_text() for p in pathlib.Path('/proc/self/task').glob('*/comm'))\n"
               "print(sum(bool(re.match(r'openrt-\\d', name)) for name in names))\n")
    result = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True,
                            env={**os.environ, "OPENRT_THREADS": str(os.cpu_count() + 1)},
                            check=True)
    assert int(result.stdout) == expected


def test_facts_without_a_context():
    openrt.exit()
    assert openrt.version() == openrt.__version__
    assert not openrt.raw.rtGetCurrentContext()
