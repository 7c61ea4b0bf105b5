# SPDX-License-Identifier: MIT
"""Rays in arrays, against the closed form and against brute force in double."""
import threading

import numpy
import openrt
import pytest


def brute_force(corners, origins, directions):
    """Nearest t and triangle of each ray by Cramer's rule in double."""
    a, b, c = (corners[:, k].astype(float) for k in range(3))
    t = numpy.full(len(directions), numpy.inf)
    nearest = numpy.full(len(directions), openrt.MISS, numpy.uint32)
    for i, (o, d) in enumerate(zip(origins.astype(float), directions.astype(float))):
        normal = numpy.cross(b - a, c - a)
        with numpy.errstate(divide="ignore", invalid="ignore"):
            distance = numpy.einsum("ij,ij->i", a - o, normal) / (normal @ d)
            p = o + distance[:, None] * d
            inside = numpy.ones(len(a), bool)
            for u, v in ((a, b), (b, c), (c, a)):
                inside &= numpy.einsum("ij,ij->i", numpy.cross(v - u, p - u), normal) >= 0
        distance[~inside | ~(distance >= 0)] = numpy.inf
        if numpy.isfinite(distance.min()):
            t[i], nearest[i] = distance.min(), distance.argmin()
    return t, nearest


@pytest.mark.parametrize("coherent", [False, True])
def test_soup_against_brute_force(coherent):
    random = numpy.random.default_rng(7)
    corners = (random.uniform(-1, 1, (300, 1, 3)) + random.uniform(-0.4, 0.4, (300, 3, 3)))
    corners = corners.astype(numpy.float32)
    origins = random.uniform(-2, 2, (1000, 3)).astype(numpy.float32)
    directions = random.normal(size=(1000, 3)).astype(numpy.float32)
    openrt.instance(openrt.mesh(corners.reshape(-1, 3)))
    with openrt.CompiledScene() as scene:
        hits = scene.intersect(origins, directions, coherent=coherent)
        blocked = scene.occluded(origins, directions, coherent=coherent)
    t, nearest = brute_force(corners, origins, directions)
    assert (hits.primitive == nearest).mean() > 0.998  # rays through edges may go either way
    same = (hits.primitive == nearest) & hits.hit
    assert same.sum() > 100
    assert numpy.allclose(hits.t[same], t[same], rtol=1e-5)
    assert (blocked == hits.hit).all()


def test_limits_normals_and_ids():
    openrt.raw.rtLoadIdentity()
    square = openrt.mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
    moved = numpy.eye(4)
    moved[2, 3] = -3
    openrt.instance(square)
    openrt.instance(square, moved)
    with openrt.CompiledScene() as scene:
        hits = scene.intersect((0.25, 0.5, 1), [[0, 0, -1]] * 3, tnear=[0, 2, 0], tfar=[9, 9, 0.5])
    assert hits.t.tolist() == [1, 4, 0.5]
    assert hits.instance.tolist() == [0, 1, openrt.MISS]
    assert hits.primitive.tolist() == [1, 1, openrt.MISS]
    assert hits.object.tolist() == [square, square, openrt.MISS]
    assert hits.hit.tolist() == [True, True, False]
    assert hits.normal.tolist() == [[0, 0, 1], [0, 0, 1], [0, 0, 0]]


def test_several_threads_ask_one_scene():
    openrt.instance(openrt.mesh([[-9, -9, 0], [9, -9, 0], [0, 9, 0]]))
    random = numpy.random.default_rng(1)
    directions = random.normal(size=(5000, 3)).astype(numpy.float32)
    results = [None] * 4
    with openrt.CompiledScene() as scene:
        def ask(k):
            results[k] = scene.intersect((0, 0, 2), directions)

        threads = [threading.Thread(target=ask, args=(k,)) for k in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    for result in results:
        assert (result.t == results[0].t).all()
    down = directions[:, 2] < 0
    assert not results[0].hit[~down].any()


def test_bad_arrays_are_exceptions():
    with openrt.CompiledScene() as scene:
        with pytest.raises(ValueError):
            scene.intersect([[0, 0, 0]], [[1, 0]])
        with pytest.raises(ValueError):
            scene.intersect([[0, 0, 0]] * 2, [[1, 0, 0]] * 3)
        assert not scene.intersect((0, 0, 0), numpy.empty((0, 3))).hit.any()
        rays = numpy.full((4, 3), numpy.nan)
        assert not scene.intersect(rays, rays).hit.any()
    with pytest.raises(ValueError):
        scene.occluded((0, 0, 0), [[1, 0, 0]])
    scene.close()
