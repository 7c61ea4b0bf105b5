# SPDX-License-Identifier: MIT
"""A walk through the module, in cells; writes a picture in the format PPM to the file named."""
# %% A sphere from arrays: rings of vertices, each with its normal.
import sys

import numpy

import openrt

openrt.init()
rings, sectors = 48, 96
latitude = numpy.linspace(-numpy.pi / 2, numpy.pi / 2, rings + 1)[:, None]
longitude = numpy.arange(sectors)[None, :] * (2 * numpy.pi / sectors)
radius = numpy.cos(latitude)
radius[[0, -1]] = 0  # at the poles all vertices of a ring are one, or there would be a hole
x, y, z = numpy.broadcast_arrays(radius * numpy.cos(longitude), numpy.sin(latitude),
                                 radius * numpy.sin(longitude))
points = numpy.stack([x, y, z], axis=-1).reshape(-1, 3)
ring = numpy.arange(rings)[:, None] * sectors
corner = (ring + numpy.arange(sectors)).ravel()
beside = (ring + (numpy.arange(sectors) + 1) % sectors).ravel()
triangles = numpy.concatenate([numpy.stack([corner, corner + sectors, beside], axis=1),
                               numpy.stack([beside, corner + sectors, beside + sectors], axis=1)])

# %% Shaders by name, parameters as keywords.
red = openrt.Shader("Phong", diffuse=(0.8, 0.2, 0.15), specular=(0.4, 0.4, 0.4), shininess=50)
grey = openrt.Shader("DiffuseShader", color=(0.7, 0.7, 0.7))
lamp = openrt.Shader("PointLight", position=(4.0, 6.0, 5.0), radiance=(60, 60, 60))

ball = openrt.mesh(points, triangles, normals=points, shader=red)
floor = openrt.mesh([[-20, -1, -20], [-20, -1, 20], [20, -1, 20], [20, -1, -20]],
                    [[0, 1, 2], [0, 2, 3]], shader=grey)

# %% A frame: camera, lights, instances; the picture and the depth are numpy arrays.
frame = openrt.FrameBuffer(640, 400, values=["depth"])
openrt.raw.rtSamples(4)
openrt.camera(eye=(0, 1.5, 7), target=(0, 0, 0), fovy=35, aspect=640 / 400)
lamp.use()
openrt.instance(floor)
for i, place in enumerate([(-2.2, 0, 0), (0, 0, 0), (2.2, 0, 0)]):
    transform = numpy.eye(4)
    transform[:3, 3] = place
    openrt.instance(ball, transform)
openrt.render(frame)
print(f"{openrt.statistics()['rays']} rays, depth from {frame.depth.min():.4f}")

# %% Rays of one's own: how high is the scene along a line?
openrt.raw.rtLoadIdentity()
openrt.instance(floor)
openrt.instance(ball)
with openrt.CompiledScene() as scene:
    xs = numpy.linspace(-2, 2, 9)
    origins = numpy.stack([xs, numpy.full(9, 5.0), numpy.zeros(9)], axis=1)
    hits = scene.intersect(origins, numpy.tile([0.0, -1.0, 0.0], (9, 1)))
print(numpy.round(5 - hits.t, 3))

# %% The picture to a file.
if len(sys.argv) > 1:
    with open(sys.argv[1], "wb") as file:
        file.write(b"P6 %d %d 255\n" % (frame.width, frame.height))
        file.write(frame.picture().tobytes())
openrt.exit()
