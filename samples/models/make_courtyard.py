#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes courtyard.glb, the scene that the demo renders: a peristyle with a pool and a bronze.

Every byte follows from this folder's sources, so the committed file can be made again:
    python3 make_courtyard.py courtyard.glb
Metres, y up; the picture looks along -z.
"""

import argparse
import math

import procedural_textures as images
from glb_writer import GlbWriter
from mesh_shapes import (arc, box, fractal_noise, grid, hash01, lathe, quad, smooth_profile, tube,
                         Mesh)


def about_y(degrees):
    half = math.radians(degrees) / 2
    return (0, math.sin(half), 0, math.cos(half))


def looking(x, y, z):
    """Rotation that turns -z, where cameras and lights look, to direction (x, y, z)."""
    length = math.sqrt(x * x + y * y + z * z)
    yaw, pitch = math.atan2(-x, -z) / 2, math.asin(y / length) / 2
    return (math.cos(yaw) * math.sin(pitch), math.sin(yaw) * math.cos(pitch),
            -math.sin(yaw) * math.sin(pitch), math.cos(yaw) * math.cos(pitch))


def column():
    """A fluted shaft with entasis between a moulded base and a Doric capital; 4.2 m."""
    flutes, steps = 20, 6
    heights = [0, 0.02, 0.04, 0.06] + [0.1 + 0.8 * k / 8 for k in range(9)] + [0.94, 0.96, 0.98, 1]

    def shaft(i, j):
        t = heights[i]
        radius = 0.36 - 0.05 * t * t - 0.012 * t
        fade = min(1, max(0, min(t, 1 - t) / 0.05))
        phase = (j % steps) / steps
        radius -= 0.034 * fade * math.sin(math.pi * phase) if phase else 0
        angle = 2 * math.pi * (j % (flutes * steps)) / (flutes * steps)
        return ((radius * math.sin(angle), 0.32 + 3.4 * t, radius * math.cos(angle)),
                (2 * j / (flutes * steps), 3.4 * t))

    mesh = grid(len(heights) - 1, flutes * steps, shaft)
    base = [[(0.47, 0.12)] + arc(0.45, 0.17, 0.05, 0.05, -90, 90, 8)[1:] + [(0.41, 0.22)],
            arc(0.43, 0.25, 0.035, 0.03, 180, 90, 4)[:0:-1] + [(0.395, 0.25)],
            arc(0.39, 0.28, 0.03, 0.03, -90, 90, 6), [(0.37, 0.31), (0.36, 0.325)]]
    capital = [arc(0.305, 3.735, 0.022, 0.022, -90, 90, 5),
               [(0.30, 3.757), (0.30, 3.80)],
               smooth_profile([(0.30, 3.80), (0.34, 3.86), (0.42, 3.93), (0.455, 3.98),
                               (0.44, 4.02)], 4)]
    mesh.add(lathe(base, 40, 2)).add(lathe(capital, 40, 2))
    mesh.add(box((-0.5, 0, -0.5), (0.5, 0.12, 0.5), 0.012))
    return mesh.add(box((-0.48, 4.02, -0.48), (0.48, 4.2, 0.48), 0.012))


def entablature(length):
    """Beam over the columns along x, centred: architrave, frieze with triglyphs, cornice."""
    half = length / 2
    mesh = box((-half, 0, -0.36), (half, 0.34, 0.36), 0.01)
    mesh.add(box((-half, 0.34, -0.40), (half, 0.40, 0.40), 0.01))
    mesh.add(box((-half, 0.40, -0.34), (half, 0.80, 0.34)))
    count = round(length / 0.9)
    for k in range(count):
        x = -half + (k + 0.5) * length / count
        for bar in (-0.12, 0.0, 0.12):
            for side in (-1, 1):
                z = 0.34 * side
                mesh.add(box((x + bar - 0.045, 0.42, min(z, z + 0.05 * side)),
                             (x + bar + 0.045, 0.80, max(z, z + 0.05 * side))))
    mesh.add(box((-half, 0.80, -0.44), (half, 0.88, 0.44), 0.01))
    return mesh.add(box((-half, 0.88, -0.56), (half, 1.02, 0.56), 0.02))


def amphora():
    """Body by a lathe, open at the top, and two handles."""
    outside = smooth_profile([(0.13, 0.0), (0.15, 0.03), (0.09, 0.07), (0.16, 0.16), (0.29, 0.36),
                              (0.36, 0.60), (0.33, 0.80), (0.20, 0.93), (0.115, 1.00),
                              (0.105, 1.12), (0.14, 1.19), (0.185, 1.22)], 5)
    inside = [(0.185, 1.22), (0.18, 1.235), (0.15, 1.23), (0.10, 1.15), (0.09, 1.0), (0.0, 0.98)]
    body = lathe([outside], 60, 1).add(lathe([inside], 60, 1, (0.0, 0.02)))
    handles = Mesh()
    for side in (-1, 1):
        path = [(side * x, y, 0.0) for x, y in smooth_profile(
            [(0.11, 1.13), (0.22, 1.17), (0.30, 1.08), (0.29, 0.93), (0.255, 0.87)], 5)]
        handles.add(tube(path, lambda k: 0.022, 12, False))
    return body, handles


def planter():
    outside = smooth_profile([(0.26, 0.0), (0.30, 0.03), (0.27, 0.09), (0.30, 0.16), (0.42, 0.34),
                              (0.47, 0.50), (0.46, 0.56)], 4)
    rim = arc(0.475, 0.585, 0.035, 0.03, -90, 90, 8)
    inside = [(0.475, 0.615), (0.44, 0.60), (0.42, 0.54), (0.0, 0.54)]
    return lathe([outside, rim, inside], 44, 3)


def knot():
    """Torus knot (2, 3) whose tube swells as it turns."""
    count = 380
    path = []
    for k in range(count):
        a = 2 * math.pi * k / count
        r = 0.62 + 0.25 * math.cos(3 * a)
        path.append((r * math.cos(2 * a), 0.34 * math.sin(3 * a), r * math.sin(2 * a)))
    upright = [(x, z, y) for x, y, z in path]
    return tube(upright, lambda k: 0.118 + 0.03 * math.cos(2 * math.pi * 5 * k / count), 22, True,
                8, 2)


def water(half_x, half_z):
    """The pool's surface with a few rings that spread from the fountain."""
    def point(i, j):
        x, z = -half_x + 2 * half_x * j / 30, half_z - 2 * half_z * i / 48
        d = math.sqrt(x * x + (z + half_z * 0.7) ** 2)
        y = (0.0035 * math.sin(9 * d) / (1 + 0.8 * d)
             + 0.0016 * (fractal_noise(x * 2 + 64, z * 2 + 64, 256, 40, 2) - 0.5))
        return (x, y, z), (x, z)
    return grid(48, 30, point)


def cypress():
    """A tall tree: a pointed body with noise in its radius."""
    def point(i, j):
        t = i / 42
        angle = 2 * math.pi * (j % 36) / 36
        radius = 0.75 * (math.sin(math.pi * min(1, t * 1.15) ** 0.62) if t * 1.15 < 1 else 0)
        radius = max(radius, 0.55 * math.sqrt(max(0, 1 - t)) * min(1, t * 9))
        radius *= 0.72 + 0.5 * fractal_noise((j % 36) * 8 / 36, t * 24, 8, 60, 3)
        return ((radius * math.sin(angle), 0.25 + 6.4 * t, radius * math.cos(angle)),
                (j / 36 * 2, t * 6))
    return grid(42, 36, point)


def topiary():
    def point(i, j):
        t, angle = math.pi * i / 26, 2 * math.pi * (j % 44) / 44
        radius = 0.42 * (0.93 + 0.14 * fractal_noise((j % 44) * 11 / 44, i * 0.8, 11, 80, 2))
        return ((radius * math.sin(t) * math.sin(angle), -radius * math.cos(t),
                 radius * math.sin(t) * math.cos(angle)), (j / 22, i / 16))
    return grid(26, 44, point)


def terrain():
    """Hills that rise behind the court."""
    def point(i, j):
        x, z = -110 + 220 * j / 70, -12 - 150 * (i / 54) ** 1.4
        distance = -z - 12
        hills = fractal_noise(x / 46 + 32, z / 46 + 32, 64, 90, 5)
        y = -0.6 + distance * 0.035 + hills * min(1, distance / 60) * 34
        return (x, y - 6 * min(1, distance / 60), z), (x / 9, z / 9)
    return grid(54, 70, point)


def roof_tile_row():
    """Five overlapping barrel tiles in a row down the slope, along +z and downwards."""
    mesh = Mesh()
    for k in range(5):
        def point(i, j, k=k):
            angle = math.pi * j / 10
            wide = 0.115 + 0.012 * i
            return ((-wide * math.cos(angle), 0.10 * math.sin(angle) + 0.025 * i,
                     0.62 * (k + 1) - 0.66 * (1 - i)), (j / 10, 0.6 * i + 0.37 * k))
        tile = grid(1, 10, lambda i, j: point(1 - i, j))
        mesh.add(tile)
    return mesh


def bench():
    seat = Mesh()
    for k in range(3):
        seat.add(box((-0.95, 0.44, -0.27 + 0.185 * k), (0.95, 0.49, -0.10 + 0.185 * k), 0.008, 0.9,
                     (0.37 * k, 0.21 * k)))
    legs = Mesh()
    for x in (-0.7, 0.7):
        legs.add(box((x - 0.09, 0, -0.24), (x + 0.09, 0.44, 0.24), 0.02))
    return seat, legs


def lantern():
    frame = Mesh()
    for x in (-0.1, 0.1):
        for z in (-0.1, 0.1):
            frame.add(box((x - 0.012, -0.17, z - 0.012), (x + 0.012, 0.17, z + 0.012)))
    frame.add(lathe([[(0.0, 0.30), (0.02, 0.29), (0.03, 0.26), (0.17, 0.17)][::-1]], 24))
    frame.add(box((-0.14, -0.2, -0.14), (0.14, -0.17, 0.14), 0.005))
    frame.add(tube([(0, 0.29 + 0.1 * k, 0) for k in range(8)], lambda k: 0.008, 8, False))
    globe = lathe([arc(0, 0, 0.075, 0.075, -90, 90, 12)], 24)
    return frame, globe


def make(path):
    out = GlbWriter("OpenRT sample model generator")
    white_marble = out.texture("white marble", images.marble(
        256, [(164, 155, 146), (214, 207, 197), (241, 237, 230)], 3))
    dark_marble = out.texture("dark marble", images.marble(
        256, [(104, 124, 112), (42, 62, 52), (22, 38, 32)], 31))
    sandstone = out.texture("sandstone", images.stone(
        128, [(178, 150, 112), (208, 184, 146), (228, 208, 174)], 5))
    plaster = out.texture("plaster", images.stone(
        128, [(150, 58, 40), (170, 70, 48), (184, 86, 60)], 15, 0.2))
    wood = out.texture("wood", images.wood(256, 3))
    grass = out.texture("meadow", images.meadow(256, 3))
    leaves = out.texture("foliage", images.foliage(128, 3))
    bronze_colour = out.texture("bronze", images.patina(128, 3))
    bronze_surface = out.texture("bronze roughness", images.patina_roughness(128, 3))
    figures = out.texture("amphora", images.amphora(768, 384))

    stone_m = out.material("sandstone", texture=sandstone, roughness=0.9)
    light_m = out.material("white marble", (0.95, 0.94, 0.92), white_marble, roughness=0.35)
    dark_m = out.material("dark marble", texture=dark_marble, roughness=0.25)
    wall_m = out.material("red plaster", texture=plaster, roughness=0.95)
    wood_m = out.material("wood", texture=wood, roughness=0.6)
    grass_m = out.material("meadow", texture=grass)
    leaf_m = out.material("foliage", texture=leaves, roughness=0.9)
    clay_m = out.material("clay", (0.62, 0.30, 0.17), roughness=0.8)
    figure_m = out.material("painted clay", texture=figures, roughness=0.3)
    glaze_m = out.material("turquoise glaze", (0.03, 0.30, 0.34), roughness=0.08)
    bronze_m = out.material("bronze", texture=bronze_colour, metallic=1.0, roughness=1.0,
                            roughness_texture=bronze_surface)
    gold_m = out.material("gold", (0.95, 0.68, 0.28), metallic=1.0, roughness=0.06)
    # A dark mirror: renderers that reflect metals only show the court in it too.
    water_m = out.material("water", (0.05, 0.085, 0.09), metallic=1.0, roughness=0.0)
    iron_m = out.material("iron", (0.10, 0.09, 0.085), metallic=1.0, roughness=0.5)
    lamp_m = out.material("lamp", (1, 1, 1), emissive=(1.0, 0.72, 0.38))

    columns = out.mesh("column", [(column(), light_m)])
    row = out.mesh("tile row", [(roof_tile_row(), clay_m)])
    slabs = []
    for k, material in enumerate((light_m, light_m, dark_m, dark_m, light_m, dark_m)):
        offset = (hash01(k, 1), hash01(k, 2))
        slabs.append(out.mesh("slab %d" % k, [(box((-0.492, -0.06, -0.492), (0.492, 0, 0.492),
                                                   0.007, 0.5, offset), material)]))

    court = out.node(name="court")
    _floor(out, court, slabs, stone_m)
    _peristyle(out, court, columns, row, stone_m, wall_m, wood_m, dark_m)
    _pool(out, court, stone_m, light_m, bronze_m, gold_m, water_m)
    _furniture(out, court, figure_m, clay_m, glaze_m, leaf_m, wood_m, stone_m, iron_m, lamp_m)

    land = out.node(name="land")
    out.node(land, out.mesh("terrain", [(terrain(), grass_m)]))
    trees = out.mesh("cypress", [(cypress(), leaf_m)])
    for k, (x, z) in enumerate(((-6.6, -14.5), (-4.3, -15.3), (-2.1, -16.6), (2.4, -16.9),
                                (4.6, -15.0), (6.9, -14.2), (-10, -19), (10.5, -20), (-13, -17),
                                (13.5, -16), (-17, -30), (19, -34), (9, -38), (-8, -41))):
        size = 0.75 + 0.5 * hash01(k, 7)
        out.node(land, trees, (x, -0.5, z), about_y(360 * hash01(k, 8)), (size, size * 1.05, size))

    out.light("directional", (1.0, 0.88, 0.70), 3.8, rotation=looking(-0.30, -0.46, -0.84),
              name="sun")
    out.light("spot", (1.0, 0.93, 0.82), 60, {"innerConeAngle": 0.16, "outerConeAngle": 0.3},
              translation=(2.2, 4.6, 1.2), rotation=looking(-2.2, -2.6, -6.2),
              name="spot on bronze")
    out.camera(math.radians(52), 0.05, 400, translation=(1.15, 1.78, 8.2),
               rotation=looking(-0.115, -0.035, -1), name="view")
    out.write(path)


def _floor(out, court, slabs, stone_m):
    ground = quad((-9, -0.075, 9.5), (9, -0.075, 9.5), (9, -0.075, -12.5), (-9, -0.075, -12.5),
                  ((0, 0), (18, 0), (18, 22), (0, 22)))
    steps = box((-8.2, -0.5, -12.2), (8.2, -0.08, 9.4), 0.02)
    out.node(court, out.mesh("foundation", [(ground.add(steps), stone_m)]))
    floor = out.node(court, name="floor")
    for i in range(-8, 8):
        for j in range(-12, 9):
            if -2.4 < i + 0.5 < 2.4 and -8.2 < j + 0.5 < 3.2:
                continue  # the pool
            dark = (i + j) % 2
            pick = [k for k in range(6) if (k in (2, 3, 5)) == bool(dark)]
            slab = slabs[pick[int(hash01(i, j, 3) * len(pick))]]
            turn = 90 * int(hash01(i, j, 4) * 4) + 0.5 * (hash01(i, j, 5) - 0.5)
            out.node(floor, slab, (i + 0.5, 0.006 * (hash01(i, j, 6) - 0.5), j + 0.5),
                     about_y(turn))


def _peristyle(out, court, columns, row, stone_m, wall_m, wood_m, dark_m):
    places = [(x, z) for x in (-4.6, 4.6) for z in (-9.8, -6.8, -3.8, -0.8, 2.2, 5.2, 8.2)]
    places += [(x, -9.8) for x in (-1.55, 1.55)]
    colonnade = out.node(court, name="colonnade")
    for k, (x, z) in enumerate(places):
        out.node(colonnade, columns, (x, 0, z), about_y(18 * (k % 5)))

    beam = out.mesh("beam", [(entablature(9.65), stone_m)])
    for x in (-4.6, 4.6):
        for z in (-5.625, 4.025):
            out.node(court, beam, (x, 4.2, z), about_y(90))
    out.node(court, beam, (0, 4.201, -9.8))

    wall = out.mesh("wall", [
        (box((-9.8, 1.15, -0.12), (9.8, 6.3, 0.12), 0, 0.5), wall_m),
        (box((-9.8, 0, -0.15), (9.8, 1.05, 0.15), 0.01, 0.5), dark_m),
        (box((-9.8, 1.05, -0.18), (9.8, 1.15, 0.18), 0.01, 0.5), stone_m)])
    rafters = Mesh()
    for k in range(14):
        rafters.add(box((-9.5 + 1.45 * k, -0.08, -0.1), (-9.36 + 1.45 * k, 0.08, 3.55), 0.005))
    rafters.add(box((-9.8, 0.08, -0.1), (9.8, 0.11, 3.62)))
    ceiling = out.mesh("ceiling", [(rafters, wood_m)])
    for sign in (-1, 1):
        aisle = out.node(court, name="aisle", translation=(sign * 7.9, 0, -0.8),
                         rotation=about_y(90 * -sign if sign > 0 else 90))
        out.node(aisle, wall)
        half = math.radians(14.5) / 2
        roof = out.node(aisle, translation=(0, 6.05, 0.1),
                        rotation=(math.sin(half), 0, 0, math.cos(half)))
        out.node(roof, ceiling)
        for k in range(72):
            out.node(roof, row, (-9.66 + 0.272 * k, 0.12, 0.35))


def _pool(out, court, stone_m, light_m, bronze_m, gold_m, water_m):
    basin = Mesh()
    for x in (-2.35, 2.05):
        basin.add(box((x, -0.2, -8.0), (x + 0.3, 0.26, 3.0), 0.02))
    for z in (-8.3, 3.0):
        basin.add(box((-2.35, -0.2, z), (2.35, 0.26, z + 0.3), 0.02))
    out.node(court, out.mesh("basin", [(basin, light_m)]))
    surface = out.mesh("water", [(water(2.06, 5.51), water_m)], fine_normals=True)
    out.node(court, surface, (0, 0.12, -2.5))
    steps = lathe([[(0.98, 0.0), (0.98, 0.26)], arc(0.96, 0.28, 0.02, 0.02, 0, 90, 3),
                   [(0.96, 0.30), (0.76, 0.30)], [(0.76, 0.30), (0.76, 0.48)],
                   [(0.76, 0.48), (0.52, 0.48)],
                   smooth_profile([(0.52, 0.48), (0.46, 0.56), (0.40, 0.75), (0.39, 1.1),
                                   (0.43, 1.25), (0.52, 1.32)], 4),
                   [(0.52, 1.32), (0.52, 1.40)], [(0.52, 1.40), (0.0, 1.40)]], 48, 4)
    out.node(court, out.mesh("pedestal", [(steps, stone_m)]), (0, 0.02, -5.4))
    bronze = out.mesh("knot", [(knot(), bronze_m)], fine_normals=True)
    out.node(court, bronze, (0, 2.42, -5.4), about_y(24))
    ball = lathe([arc(0, 0, 0.3, 0.3, -90, 90, 28)], 48)
    balls = out.mesh("ball", [(ball, gold_m)], fine_normals=True)
    for x in (-2.2, 2.2):
        for z in (-8.15, 3.15):
            out.node(court, balls, (x, 0.26 + 0.2, z), scale=(0.7, 0.7, 0.7))


def _furniture(out, court, figure_m, clay_m, glaze_m, leaf_m, wood_m, stone_m, iron_m, lamp_m):
    body, handles = amphora()
    painted = out.mesh("painted amphora", [(body, figure_m), (handles, figure_m)])
    pots = out.mesh("planter", [(planter(), glaze_m)], fine_normals=True)
    bushes = out.mesh("topiary", [(topiary(), leaf_m)])
    for k, (x, z, size) in enumerate(((-3.25, 3.9, 1.05), (3.3, 1.0, 1.0), (-3.3, -3.7, 0.95),
                                      (5.95, -2.3, 1.2), (-5.9, 1.2, 1.15))):
        out.node(court, painted, (x, 0, z), about_y(40 + 63 * k), (size, size, size))
    for x in (-3.3, 3.3):
        for z in (-7.4, -0.6, 5.0):
            if x > 0 and z > 4:
                continue
            out.node(court, pots, (x, 0, z))
            out.node(court, bushes, (x, 0.9, z), about_y(50 * z))
    seat, legs = bench()
    benches = out.mesh("bench", [(seat, wood_m), (legs, stone_m)])
    out.node(court, benches, (3.25, 0, -3.6), about_y(90))
    out.node(court, benches, (-3.25, 0, 1.4), about_y(-90))
    frame, globe = lantern()
    lanterns = out.mesh("lantern", [(frame, iron_m), (globe, lamp_m)])
    for x in (-6.2, 6.2):
        for z in (-5.3, 0.7):
            out.node(court, lanterns, (x, 3.2, z))
    # One lamp a side is enough to light the aisles.
    for x in (-6.2, 6.2):
        out.light("point", (1.0, 0.62, 0.30), 9, parent=court, translation=(x, 2.75, -2.3),
                  name="lamp")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("output", help="the .glb file to write")
    make(parser.parse_args().output)
