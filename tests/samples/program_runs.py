# SPDX-License-Identifier: MIT
"""Runs openrt-render and reads its pictures, for the tests beside this file."""
import json
import pathlib
import resource
import struct
import subprocess
import zlib

# Sanitizers make everything slower and larger.
SECONDS = 60


class Runner:
    def __init__(self, program, folder):
        self.program, self.folder = program, pathlib.Path(folder)

    def run(self, scene, *arguments, output="out.png", size="16x12"):
        command = [self.program, str(scene), "-o", str(self.folder / output), "--size", size]
        return subprocess.run(command + list(arguments), capture_output=True, timeout=SECONDS,
                              cwd=self.folder)

    def refusal(self, *arguments, **more):
        """Runs what must fail; returns its one line, or what is wrong with it as an exception."""
        result = self.run(*arguments, **more)
        text = result.stderr.decode("utf-8", "replace")
        if result.returncode not in (1, 2):
            raise AssertionError(f"exit code {result.returncode}: {text[:2000]}")
        if result.stdout:
            raise AssertionError(f"something on stdout: {result.stdout[:200]}")
        if text.count("\n") != 1 or not text.endswith("\n") or len(text) > 600:
            raise AssertionError(f"not one line: {text[:2000]}")
        if not text.startswith("openrt-render: "):
            raise AssertionError(f"not the program's own words: {text}")
        return text

    def picture(self, *arguments, output="out.png", **more):
        result = self.run(*arguments, output=output, **more)
        if result.returncode != 0:
            raise AssertionError(result.stderr.decode("utf-8", "replace")[:2000])
        return Png((self.folder / output).read_bytes())

    def statistics(self, scene, *arguments):
        result = self.run(scene, "--stats=json", *arguments)
        if result.returncode != 0:
            raise AssertionError(result.stderr.decode("utf-8", "replace")[:2000])
        return json.loads(result.stdout)


def largest_child_bytes():
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024


def png(width, height, pixels, *chunks, depth=8):
    """A PNG file of RGB pixels; chunks: pairs of name and data."""
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data
                + struct.pack(">I", zlib.crc32(kind + data)))
    letter = {8: "B", 16: "H"}[depth]
    rows = b"".join(b"\0" + b"".join(struct.pack(f">3{letter}", *pixel)
                                     for pixel in pixels[y * width:(y + 1) * width])
                    for y in range(height))
    return (b"\x89PNG\r\n\x1a\n"
            + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, depth, 2, 0, 0, 0))
            + b"".join(chunk(*pair) for pair in chunks)
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class Png:
    """8-bit RGB or RGBA pixels of a PNG file, rows from the top."""

    def __init__(self, data):
        assert data[:8] == b"\x89PNG\r\n\x1a\n"
        offset, packed = 8, b""
        while offset < len(data):
            length, kind = struct.unpack_from(">I4s", data, offset)
            body = data[offset + 8:offset + 8 + length]
            if kind == b"IHDR":
                self.width, self.height, depth, colour = struct.unpack_from(">IIBB", body)
                assert depth == 8 and colour in (2, 6)
                self.channels = 3 if colour == 2 else 4
            elif kind == b"IDAT":
                packed += body
            offset += 12 + length
        self._rows = self._unfilter(zlib.decompress(packed))

    def pixel(self, x, y):
        """x from the left, y from the top."""
        at = x * self.channels
        return tuple(self._rows[y][at:at + 3])

    def colours(self):
        return {self.pixel(x, y) for y in range(self.height) for x in range(self.width)}

    def _unfilter(self, raw):
        size, step = self.width * self.channels, self.channels
        rows, above = [], bytearray(size)
        for y in range(self.height):
            kind = raw[y * (size + 1)]
            row = bytearray(raw[y * (size + 1) + 1:(y + 1) * (size + 1)])
            for i in range(size):
                left = row[i - step] if i >= step else 0
                up, corner = above[i], above[i - step] if i >= step else 0
                if kind == 1:
                    guess = left
                elif kind == 2:
                    guess = up
                elif kind == 3:
                    guess = (left + up) // 2
                elif kind == 4:
                    estimate = left + up - corner
                    guess = min((abs(estimate - left), 0, left), (abs(estimate - up), 1, up),
                                (abs(estimate - corner), 2, corner))[2]
                else:
                    guess = 0
                row[i] = (row[i] + guess) & 255
            rows.append(row)
            above = row
        return rows
