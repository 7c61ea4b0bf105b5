#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""One line about a rendered picture: summary.py PICTURE < statistics of openrt-render as JSON."""

import json
import sys

statistics = json.load(sys.stdin)
rays = sum(statistics[kind + "_rays"] for kind in ("primary", "shadow", "secondary"))
print("{}: {:.3f} s a frame, {:,} triangles in {:,} instances, {:.2f} million rays/s".format(
    sys.argv[1], statistics["frame_seconds"], statistics["triangles"], statistics["instances"],
    rays / max(statistics["frame_seconds"], 1e-9) / 1e6))
