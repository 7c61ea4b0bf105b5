#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes microfacet_albedo_table.h: how much light a GGX surface reflects at its first bounce.

For a view direction v with cosine mu to the normal, and alpha = roughness^2,

    E(mu, alpha) = integral of D(h) G1(v) G1(l) / (4 (n.l) (n.v)) * (n.l) dl
    B(mu, alpha) = the same with the factor (1 - v.h)^5

D is the GGX distribution of normals, G1 Smith's masking of it (Walter et al., "Microfacet models
for refraction through rough surfaces", 2007). By sampling visible normals (Heitz, "Sampling the
GGX distribution of visible normals", 2018) the integrals become the mean over the unit square of
G1(l) and of G1(l) (1 - v.h)^5, which the midpoint rule takes; the distance to the rim of the disk
that the square is mapped to grows as a fourth power, for the sake of the distribution's long tail.

The table holds E and B - E (1 - mu)^5, which varies less than B. Row i belongs to roughness
least + (1 - least) i / (rows - 1), column j to log(1 + mu / alpha) / log(1 + 1 / alpha) =
j / (columns - 1): the logarithm follows the quick change where mu is near alpha.

Without arguments writes the table; --check compares each 37th entry of the file with the formula.
"""
import math
import pathlib
import re
import sys

ROWS, COLUMNS = 24, 40
LEAST_ROUGHNESS = 0.04
STEPS = 96
TABLE = pathlib.Path(__file__).with_name("microfacet_albedo_table.h")


def albedo(mu, alpha, steps=STEPS):
    """(E, B) by the midpoint rule; the integrand is symmetric in the angle."""
    mu = max(mu, 1e-9)
    sine = math.sqrt(max(0.0, 1 - mu * mu))
    length = math.hypot(alpha * sine, mu)
    vx, vz = alpha * sine / length, mu / length  # stretched view, in the plane y = 0
    blend = 0.5 * (1 + vz)
    a2 = alpha * alpha
    total = fresnel = 0.0
    for i in range(steps):
        w = (i + 0.5) / steps  # 1 - radius^2 = w^4
        radius, share = math.sqrt(1 - w ** 4), 4 * w ** 3
        for j in range(steps // 2):
            angle = math.pi * (j + 0.5) / (steps // 2) - math.pi / 2
            t1, t2 = radius * math.cos(angle), radius * math.sin(angle)
            t2 = (1 - blend) * math.sqrt(1 - t1 * t1) + blend * t2
            along = math.sqrt(max(0.0, 1 - t1 * t1 - t2 * t2))
            # tangents (0, 1, 0) and view x tangent = (-vz, 0, vx)
            hx = alpha * (-t2 * vz + along * vx)
            hy = alpha * t1
            hz = max(0.0, t2 * vx + along * vz)
            scale = 1 / math.sqrt(hx * hx + hy * hy + hz * hz)
            vh = (sine * hx + mu * hz) * scale
            lz = 2 * vh * hz * scale - mu
            if lz <= 0:
                continue
            masking = 2 * lz / (lz + math.sqrt(a2 + (1 - a2) * lz * lz))
            total += share * masking
            fresnel += share * masking * max(0.0, 1 - vh) ** 5
    count = steps * (steps // 2)
    return total / count, fresnel / count


def entry(row, column):
    rough = LEAST_ROUGHNESS + (1 - LEAST_ROUGHNESS) * row / (ROWS - 1)
    alpha = rough * rough
    mu = alpha * math.expm1(column / (COLUMNS - 1) * math.log1p(1 / alpha))
    mu = min(max(mu, 0.0), 1.0)
    e, b = albedo(mu, alpha)
    return e, b - e * (1 - mu) ** 5


def write():
    lines = ["// SPDX-License-Identifier: MIT",
             "// Written by generate_microfacet_albedo.py, which says what it holds.",
             "#pragma once", "",
             "namespace smart::builtin {", "",
             f"inline constexpr int kAlbedoRows = {ROWS}, kAlbedoColumns = {COLUMNS};",
             "/// Smoother surfaces count as this: it keeps the highlight of a point light finite.",
             f"inline constexpr float kLeastRoughness = {LEAST_ROUGHNESS}f;",
             "/// By roughness and logarithmic cosine: E, B - E (1 - mu)^5.",
             "inline constexpr float kAlbedoTable[kAlbedoRows][kAlbedoColumns][2] = {"]
    for row in range(ROWS):
        cells = [f"{{{e:.5f}f, {r:.5f}f}}"
                 for e, r in (entry(row, column) for column in range(COLUMNS))]
        for start in range(0, COLUMNS, 4):
            text = ", ".join(cells[start:start + 4])
            opening = "    {" if start == 0 else "     "
            lines.append(opening + text + ("}," if start + 4 >= COLUMNS else ","))
    lines += ["};", "", "} // namespace smart::builtin", ""]
    TABLE.write_text("\n".join(lines), encoding="utf-8")


def check():
    text = TABLE.read_text(encoding="utf-8")
    cells = re.findall(r"\{(-?[0-9.]+)f, (-?[0-9.]+)f\}", text)
    if len(cells) != ROWS * COLUMNS:
        return f"{TABLE.name}: {len(cells)} entries, not {ROWS * COLUMNS}"
    for index in range(0, len(cells), 37):
        wanted = entry(index // COLUMNS, index % COLUMNS)
        for got, value in zip(cells[index], wanted):
            if abs(float(got) - value) > 6e-6:
                return f"{TABLE.name}: entry {index} is {got}, the formula gives {value:.5f}"
    return None


if __name__ == "__main__":
    if "--check" in sys.argv[1:]:
        problem = check()
        print(problem or "the table follows its formula")
        sys.exit(1 if problem else 0)
    write()
