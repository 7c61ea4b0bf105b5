# SPDX-License-Identifier: MIT
"""What a program does wrong, or at an odd time, is an exception and never a crash."""
import copy
import pickle
import subprocess
import sys
import threading

import numpy
import openrt
import pytest
from openrt.binding import _library

TRIANGLE = [[-1, -1, 0], [1, -1, 0], [0, 1, 0]]
RTU_TESS_TOLERANCE, RTU_VERSION = 100142, 100800


def on_another_thread(work):
    """What the work gives on a thread of its own, which has no context."""
    results = []
    thread = threading.Thread(target=lambda: results.append(work()))
    thread.start()
    thread.join()
    return results[0]


@pytest.mark.parametrize("call", [
    lambda: openrt.mesh(TRIANGLE), lambda: openrt.instance(1), openrt.CompiledScene,
    lambda: openrt.Shader("Phong"), lambda: openrt.render(openrt.FrameBuffer(4, 4)),
    lambda: openrt.queue(openrt.FrameBuffer(4, 4)), openrt.statistics, openrt.listen,
    lambda: openrt.raw.rtuPerspective(60, 1, 1, 9),
    lambda: openrt.raw.rtuLookAt(0, 0, 4, 0, 0, 0, 0, 1, 0),
    lambda: openrt.raw.rtuCameraFromFov(numpy.eye(4), -1, 1, 1, -1),
    lambda: openrt.raw.rtuSphere(openrt.raw.rtuNewQuadric(), 1, 4, 4),
    openrt.raw.rtuNewNurbsRenderer])
def test_without_a_context_calls_are_errors(call):
    openrt.exit()
    with pytest.raises(openrt.Error, match="no context is current"):
        call()


def test_utilities_that_need_no_context_work_without_one():
    openrt.exit()
    raw = openrt.raw
    assert openrt.ffi.string(raw.rtuGetString(RTU_VERSION)) == b"1.3"
    where = numpy.zeros(3)
    assert raw.rtuProject(0, 0, 0, numpy.eye(4), numpy.eye(4),
                          numpy.array([0, 0, 8, 8], numpy.int32),
                          where[0:1], where[1:2], where[2:3]) == 1
    assert where.tolist() == [4, 4, 0.5]
    tessellator = raw.rtuNewTess()
    raw.rtuTessProperty(tessellator, RTU_TESS_TOLERANCE, 0.25)
    raw.rtuGetTessProperty(tessellator, RTU_TESS_TOLERANCE, where[0:1])
    assert where[0] == 0.25
    raw.rtuDeleteTess(tessellator)
    image, small = numpy.full((2, 4), 7, numpy.uint8), numpy.zeros((1, 4), numpy.uint8)
    assert raw.rtuScaleImage(raw.RT_LUMINANCE, 2, 2, raw.RT_UNSIGNED_BYTE, image, 1, 1,
                             raw.RT_UNSIGNED_BYTE, small) == 0
    assert small[0, 0] == 7


def test_rays_without_an_answer_are_errors():
    openrt.instance(openrt.mesh(TRIANGLE))
    scene = openrt.CompiledScene()
    ray = ((0, 0, 1), [[0, 0, -1]])
    assert on_another_thread(lambda: scene.intersect(*ray).t) == [1]
    assert on_another_thread(lambda: scene.occluded(*ray)) == [True]
    openrt.exit()
    for ask in (scene.intersect, scene.occluded):
        with pytest.raises(openrt.Error, match="exit"):
            ask(*ray)
        ask((0, 0, 1), numpy.empty((0, 3)))


def test_errors_are_those_of_the_thread():
    def fail_unseen():
        context = openrt.raw.rtCreateContext()
        openrt.raw.rtMakeCurrent(context)
        openrt.listen()
        _library.rtInstantiateObject(12345)
        return context

    context = on_another_thread(fail_unseen)
    openrt.raw.rtTranslatef(0, 0, 0)
    openrt.raw.rtDestroyContext(context)


def test_memory_of_frames_is_never_exchanged():
    frame = openrt.FrameBuffer(8, 8, values=["depth"])
    for name, value in (("width", 4000), ("height", 4000), ("color", numpy.zeros(1)),
                        ("depth", numpy.zeros(1)), ("values", ("normal",))):
        with pytest.raises(AttributeError, match=name):
            setattr(frame, name, value)
        with pytest.raises(AttributeError, match=name):
            delattr(frame, name)
    again = pickle.loads(pickle.dumps(frame))
    assert (again.width, again.color.shape) == (8, (8, 8, 3))


def test_what_is_read_only_is_not_written_to():
    raw = openrt.raw
    value = numpy.full(1, 7, numpy.int32)
    value.flags.writeable = False
    picture = numpy.zeros((4, 4, 4), numpy.uint8)
    picture.flags.writeable = False
    for write in (lambda: raw.rtGetIntegerv(raw.RT_MATRIX_MODE, value),
                  lambda: raw.rtSetFrameBuffer(picture, 4, 4, raw.RT_RGBA_8),
                  lambda: raw.rtReadPixels(0, 0, 1, 1, raw.RT_RGBA, raw.RT_UNSIGNED_BYTE, picture),
                  lambda: raw.rtReadPixels(0, 0, 1, 1, raw.RT_RGBA, raw.RT_UNSIGNED_BYTE, b"rgba")):
        with pytest.raises(ValueError, match="read-only"):
            write()
    assert value == 7
    matrix = numpy.eye(4)
    matrix.flags.writeable = False
    raw.rtLoadMatrixd(matrix)
    raw.rtDrawPixels(1, 1, raw.RT_RGBA, raw.RT_UNSIGNED_BYTE, b"rgba")


def test_frames_of_before_exit_are_forgotten():
    openrt.queue(openrt.FrameBuffer(64, 64))
    openrt.exit()
    openrt.init()
    assert openrt.queue(openrt.FrameBuffer(64, 64)).wait()


def test_programs_end_with_frames_in_flight():
    program = ("import numpy, openrt\n"
               "openrt.init()\n"
               "openrt.camera((0, 0, 4), (0, 0, 0))\n"
               "openrt.instance(openrt.mesh(numpy.random.default_rng(1).random((3000, 3))))\n"
               "openrt.raw.rtSamples(16)\n"
               "openrt.{}\n")
    for last in ("queue(openrt.FrameBuffer(500, 500))",
                 "FrameBuffer(500, 500).bind(); openrt.raw.rtStartRendering()"):
        ended = subprocess.run([sys.executable, "-c", program.format(last)], check=False)
        assert ended.returncode == 0, last


def test_what_belongs_to_the_process_is_not_copied():
    things = [openrt.CompiledScene(), openrt.Shader("Phong"), openrt.queue(openrt.FrameBuffer(4, 4))]
    for thing in things:
        for copied in (pickle.dumps, copy.copy):
            with pytest.raises(TypeError, match="can not be copied"):
                copied(thing)


@pytest.mark.parametrize("wrong", [{"wrong": 1.0}, {"diffuse": [1] * 5}, {"diffuse": object()}])
def test_a_shader_that_is_refused_leaves_none_behind(wrong):
    kept = openrt.Shader("Phong")
    with pytest.raises((openrt.Error, ValueError)):
        openrt.Shader("Phong", shininess=40.0, **wrong)
    with pytest.raises(openrt.Error):
        openrt.raw.rtBindShader(kept.id + 1)
    kept.bind()


def test_errors_come_back_from_other_processes():
    with pytest.raises(openrt.Error) as info:
        openrt.instance(12345)
    again = pickle.loads(pickle.dumps(info.value))
    assert (str(again), again.code) == (str(info.value), info.value.code)


@pytest.mark.parametrize("wrong, text", [
    ({"isa": "avx17"}, "generic"), ({"threads": 1025}, "1024"), ({"threads": -1}, "1024")])
def test_a_start_that_is_refused_has_no_effect(wrong, text):
    context, triangle = openrt.raw.rtGetCurrentContext(), openrt.mesh(TRIANGLE)
    with pytest.raises(ValueError, match=text):
        openrt.init(**wrong)
    with pytest.raises(TypeError):
        openrt.init(threads=2.5)
    assert openrt.raw.rtGetCurrentContext() == context
    openrt.instance(triangle)
    openrt.exit()
    with pytest.raises(ValueError, match=text):
        openrt.init(**wrong)
    assert not openrt.raw.rtGetCurrentContext()


def test_hits_can_be_compared():
    with openrt.CompiledScene() as scene:
        rays = ((0, 0, 0), [[0, 0, 1]] * 2)
        assert scene.intersect(*rays) != scene.intersect(*rays)
