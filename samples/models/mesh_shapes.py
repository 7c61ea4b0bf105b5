# SPDX-License-Identifier: MIT
"""Surfaces for the sample models: every shape is made of grids of points with smooth normals."""

import functools
import math


def hash01(*numbers):
    """A number in [0, 1) that depends on integers alone: the same on every machine."""
    h = 0x9E3779B9
    for n in numbers:
        h ^= n & 0xFFFFFFFF
        h = (h * 0x85EBCA6B) & 0xFFFFFFFF
        h ^= h >> 13
        h = (h * 0xC2B2AE35) & 0xFFFFFFFF
        h ^= h >> 16
    return h / 4294967296.0


@functools.lru_cache(maxsize=None)
def _lattice(period, seed):
    return [[hash01(i, j, seed) for i in range(period)] for j in range(period)]


def value_noise(x, y, period, seed):
    """Smooth noise in [0, 1], repeating after `period` in both directions."""
    lattice = _lattice(period, seed)
    ix, iy = math.floor(x), math.floor(y)
    fx, fy = x - ix, y - iy
    fx, fy = fx * fx * (3 - 2 * fx), fy * fy * (3 - 2 * fy)
    left, right = ix % period, (ix + 1) % period
    below, above = lattice[iy % period], lattice[(iy + 1) % period]
    low = below[left] * (1 - fx) + below[right] * fx
    high = above[left] * (1 - fx) + above[right] * fx
    return low * (1 - fy) + high * fy


def fractal_noise(x, y, period, seed, octaves):
    """Sum of octaves of value noise, in [0, 1]."""
    total, weight, norm = 0.0, 0.5, 0.0
    for octave in range(octaves):
        total += weight * value_noise(x, y, period, seed + octave)
        norm += weight
        x, y, period, weight = x * 2, y * 2, period * 2, weight * 0.5
    return total / norm


class Mesh:
    """Vertices (position, normal, texture coordinate) and triangles of one material."""

    def __init__(self):
        self.positions, self.normals, self.uvs, self.triangles = [], [], [], []

    def add(self, other):
        base = len(self.positions)
        self.positions += other.positions
        self.normals += other.normals
        self.uvs += other.uvs
        self.triangles += [(a + base, b + base, c + base) for a, b, c in other.triangles]
        return self

    def moved(self, dx, dy, dz):
        self.positions = [(x + dx, y + dy, z + dz) for x, y, z in self.positions]
        return self


def difference(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def normalized(v):
    length = math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
    return (v[0] / length, v[1] / length, v[2] / length) if length > 0 else (0.0, 1.0, 0.0)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def grid(rows, columns, point):
    """rows x columns cells; point(i, j) gives (position, uv). Normals are smooth over the whole
    grid, across a seam too, since points at the same place share theirs. Seen from the front,
    i grows upwards and j to the right."""
    mesh = Mesh()
    for i in range(rows + 1):
        for j in range(columns + 1):
            position, uv = point(i, j)
            mesh.positions.append(position)
            mesh.uvs.append(uv)
    places = [tuple(round(c * 65536) for c in p) for p in mesh.positions]
    sums = {}
    for i in range(rows):
        for j in range(columns):
            a = i * (columns + 1) + j
            b, c, d = a + 1, a + columns + 2, a + columns + 1
            for triangle in ((a, b, c), (a, c, d)):
                if len({places[k] for k in triangle}) < 3:
                    continue  # collapsed at a pole
                p, q, r = (mesh.positions[k] for k in triangle)
                n = cross(difference(q, p), difference(r, p))
                for k in triangle:
                    s = sums.get(places[k], (0.0, 0.0, 0.0))
                    sums[places[k]] = (s[0] + n[0], s[1] + n[1], s[2] + n[2])
                mesh.triangles.append(triangle)
    mesh.normals = [normalized(sums.get(place, (0.0, 1.0, 0.0))) for place in places]
    return mesh


def lathe(runs, segments, u_repeat=1.0, v_range=None):
    """Turns profiles about the y axis. Each run is a list of (radius, y) from bottom to top of
    the outside; runs meet in sharp edges. v follows the length along all runs."""
    lengths = []
    for run in runs:
        lengths.append([math.dist(run[k], run[k + 1]) for k in range(len(run) - 1)])
    whole = sum(map(sum, lengths))
    v0, v1 = v_range if v_range else (0.0, whole)
    mesh, travelled = Mesh(), 0.0
    for run, steps in zip(runs, lengths):
        vs = [travelled]
        for step in steps:
            vs.append(vs[-1] + step)
        travelled = vs[-1]

        def point(i, j, run=run, vs=vs):
            angle = 2 * math.pi * (j % segments) / segments
            r, y = run[i]
            return ((r * math.sin(angle), y, r * math.cos(angle)),
                    (u_repeat * j / segments, 1 - (v0 + (v1 - v0) * vs[i] / whole)))

        mesh.add(grid(len(run) - 1, segments, point))
    return mesh


def arc(cx, cy, radius_x, radius_y, begin, end, steps):
    """Points of an elliptic arc, degrees, for profiles."""
    return [(cx + radius_x * math.cos(math.radians(begin + (end - begin) * k / steps)),
             cy + radius_y * math.sin(math.radians(begin + (end - begin) * k / steps)))
            for k in range(steps + 1)]


def smooth_profile(points, steps):
    """Catmull-Rom curve through profile points."""
    curve = []
    for k in range(len(points) - 1):
        p0 = points[max(k - 1, 0)]
        p1, p2 = points[k], points[k + 1]
        p3 = points[min(k + 2, len(points) - 1)]
        for s in range(steps):
            t = s / steps
            curve.append(tuple(
                0.5 * (2 * p1[c] + (p2[c] - p0[c]) * t
                       + (2 * p0[c] - 5 * p1[c] + 4 * p2[c] - p3[c]) * t * t
                       + (3 * p1[c] - p0[c] - 3 * p2[c] + p3[c]) * t * t * t) for c in range(2)))
    curve.append(points[-1])
    return curve


def tube(path, radius, segments, closed, u_repeat=1.0, v_repeat=1.0):
    """A tube around a path of points; radius(k) at point k. The frame is carried along by
    projection, and its twist over a closed path is spread evenly."""
    count = len(path)
    last = count if closed else count - 1
    tangents = []
    for k in range(count):
        a = path[(k - 1) % count] if closed or k > 0 else path[0]
        b = path[(k + 1) % count] if closed or k < count - 1 else path[-1]
        tangents.append(normalized(tuple(b[c] - a[c] for c in range(3))))
    side = normalized(cross(tangents[0], (0.3, 1.0, 0.2)))
    sides = []
    for k in range(last + 1):
        t = tangents[k % count]
        dot = sum(side[c] * t[c] for c in range(3))
        side = normalized(tuple(side[c] - dot * t[c] for c in range(3)))
        sides.append(side)
    twist = 0.0
    if closed:
        t = tangents[0]
        other = cross(t, sides[0])
        twist = math.atan2(sum(sides[last][c] * other[c] for c in range(3)),
                           sum(sides[last][c] * sides[0][c] for c in range(3)))

    def point(i, j):
        k = i % count
        t, s = tangents[k], sides[i]
        o = cross(t, s)
        angle = 2 * math.pi * (j % segments) / segments - twist * i / last
        x, y = math.cos(angle) * radius(k), math.sin(angle) * radius(k)
        if closed and i == last:
            s, o = sides[0], cross(t, sides[0])
            angle = 2 * math.pi * (j % segments) / segments
            x, y = math.cos(angle) * radius(0), math.sin(angle) * radius(0)
        return (tuple(path[k][c] + s[c] * x + o[c] * y for c in range(3)),
                (u_repeat * i / last, v_repeat * j / segments))

    return grid(last, segments, point)


def quad(a, b, c, d, uvs):
    """A flat quadrilateral, counter-clockwise from the front."""
    mesh = Mesh()
    mesh.positions = [a, b, c, d]
    n = normalized(cross(difference(b, a), difference(d, a)))
    mesh.normals = [n] * 4
    mesh.uvs = list(uvs)
    mesh.triangles = [(0, 1, 2), (0, 2, 3)]
    return mesh


def box(low, high, bevel=0.0, uv_scale=1.0, uv_offset=(0.0, 0.0)):
    """A box whose edges are cut off by `bevel`; texture coordinates are metres on each face."""
    mesh = Mesh()
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for sign in (0, 1):
            corners = []
            around = ((0, 0), (1, 0), (1, 1), (0, 1))
            for cu, cv in around if sign else around[::-1]:
                p = [0.0] * 3
                p[axis] = (low, high)[sign][axis]
                p[u] = low[u] + bevel if cu == 0 else high[u] - bevel
                p[v] = low[v] + bevel if cv == 0 else high[v] - bevel
                corners.append(tuple(p))
            # The texture's grain runs along x on every face that has an x.
            along, across = (2, 1) if axis == 0 else ((0, 2) if axis == 1 else (0, 1))
            uvs = [((p[along] - low[along]) * uv_scale + uv_offset[0],
                    (p[across] - low[across]) * uv_scale + uv_offset[1]) for p in corners]
            mesh.add(quad(*corners, uvs))
    if bevel > 0:
        mesh.add(_box_bevels(low, high, bevel, uv_scale, uv_offset))
    return mesh


def _box_bevels(low, high, bevel, uv_scale, uv_offset):
    mesh = Mesh()
    centre = tuple((low[k] + high[k]) / 2 for k in range(3))

    def outward(points):
        n = cross(difference(points[1], points[0]), difference(points[2], points[0]))
        return sum(n[k] * (points[0][k] - centre[k]) for k in range(3)) > 0

    def inset(signs, flush):
        """The corner named by signs, on the face of axis `flush`, inset along the others."""
        return tuple((high[k] if s else low[k]) + (0 if k == flush else (-bevel if s else bevel))
                     for k, s in enumerate(signs))

    def uv(p):
        return ((p[0] + p[2] - low[0] - low[2]) * uv_scale + uv_offset[0],
                (p[1] - low[1]) * uv_scale + uv_offset[1])

    for axis in range(3):  # edges along this axis
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for su in (0, 1):
            for sv in (0, 1):
                ends = []
                for sa in (0, 1):
                    signs = [0] * 3
                    signs[axis], signs[u], signs[v] = sa, su, sv
                    ends.append(signs)
                points = [inset(ends[0], u), inset(ends[1], u),
                          inset(ends[1], v), inset(ends[0], v)]
                if not outward(points):
                    points.reverse()
                mesh.add(quad(*points, [uv(p) for p in points]))
    for corner in range(8):
        signs = [corner & 1, corner >> 1 & 1, corner >> 2 & 1]
        points = [inset(signs, k) for k in range(3)]
        if not outward(points):
            points.reverse()
        flat = Mesh()
        flat.positions = points
        flat.normals = [normalized(cross(difference(points[1], points[0]),
                                         difference(points[2], points[0])))] * 3
        flat.uvs = [uv(p) for p in points]
        flat.triangles = [(0, 1, 2)]
        mesh.add(flat)
    return mesh
