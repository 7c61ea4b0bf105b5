# SPDX-License-Identifier: MIT
"""The defects that mutants.py plants."""
import pathlib
import re


class Mutant:
    """A text that is replaced by another; as a named one it must occur exactly once."""

    def __init__(self, name, file, old, new):
        self.name, self.file, self.old, self.new = name, file, old, new

    def apply(self, text):
        if text.count(self.old) != 1:
            raise ValueError(f"{self.name}: {self.file} has the text {text.count(self.old)} times")
        return text.replace(self.old, self.new)


class MechanicalMutant:
    """A change at one place, by its position."""

    def __init__(self, file, start, old, new, line):
        self.name = f"{file}:{line}: {old.strip()} becomes {new.strip()}"
        self.file, self.start, self.old, self.new = file, start, old, new

    def apply(self, text):
        end = self.start + len(self.old)
        assert text[self.start:end] == self.old
        return text[:self.start] + self.new + text[end:]


ASSEMBLER = "compat/recorder/primitive_assembler.cpp"
TRIANGLE = "libsmart/shading/fixed_triangle.cpp"
LIGHTING = "libsmart/shading/fixed_lighting.cpp"
FUNCTION = "libsmart/shading/fixed_function.cpp"
TEXTURE = "libsmart/shading/texture.cpp"
FRAGMENTS = "libsmart/render/fragments.cpp"
LAYER = "libsmart/render/layer_pass.cpp"

NAMED = [
    Mutant("flipped_strip", ASSEMBLER,
           "if (odd_) std::swap(out[0].corners[0], out[0].corners[1]);", ""),
    Mutant("quad_strip_off_by_one", ASSEMBLER,
           "        held_[0] = c;\n        held_[1] = vertex;\n        count_ = 2;",
           "        held_[0] = b;\n        held_[1] = vertex;\n        count_ = 2;"),
    Mutant("fan_without_centre", ASSEMBLER,
           "edges(1, 1, 1), false};\n        held_[1] = vertex;",
           "edges(1, 1, 1), false};\n        held_[0] = b;\n        held_[1] = vertex;"),
    Mutant("wrong_normal_matrix", TRIANGLE, "? cofactors / determinant : cofactors",
           "? glm::dmat3(x, y, z) : cofactors"),
    Mutant("half_pixel_shift", "libsmart/render/sampling.h",
           "if (n <= 1) return {0.5f, 0.5f};", "if (n <= 1) return {0.0f, 0.0f};"),
    Mutant("swapped_u_v", TEXTURE,
           "const Place place{wrapped(s, options_.wrapS), wrapped(t, options_.wrapT)};",
           "const Place place{wrapped(t, options_.wrapS), wrapped(s, options_.wrapT)};"),
    Mutant("wrong_fog", FUNCTION, "factor = math::exp(-(depth * depth));",
           "factor = math::exp(-depth);"),
    Mutant("no_linear_attenuation", LIGHTING, "light.linearAttenuation * distance +", ""),
    Mutant("no_spot_exponent", LIGHTING, "power(cosine, light.spotExponent)", "1.0"),
    Mutant("back_lit_by_front_normal", LIGHTING, "other ? -normal : normal", "normal"),
    Mutant("viewer_always_local", LIGHTING,
           "const bool local = lighting.localViewer || viewer.alwaysLocal;",
           "const bool local = true;"),
    Mutant("blend_factors_swapped", FRAGMENTS,
           "source * weight(ops.sourceRgb, ops.sourceAlpha)",
           "source * weight(ops.destinationRgb, ops.destinationAlpha)"),
    Mutant("other_face_culled", LAYER, "(raster.cullFace == FixedFace::Front) == front",
           "(raster.cullFace == FixedFace::Front) != front"),
    Mutant("other_side_clipped", LAYER, "glm::dvec4(point, 1.0)) < 0.0)",
           "glm::dvec4(point, 1.0)) > 0.0)"),
    Mutant("flat_by_first_vertex", TRIANGLE,
           "provoking.empty() ? ShadingData::kLastCorner : provoking[triangle]",
           "provoking.empty() ? 0 : 0"),
]

# What gives the calls of OpenGL their meaning.
MUTATED = ["compat/recorder/primitive_assembler.cpp", "compat/recorder/transforms.cpp",
           "compat/recorder/fixed_state_recorder.cpp", "compat/recorder/geometry_recording.cpp",
           "compat/recorder/attrib_stack.cpp", "compat/recorder/matrix_stack.h",
           "compat/recorder/layers.cpp", "compat/recorder/recorder_layers.cpp",
           "compat/openrt/api_fixed_lighting.cpp", "compat/openrt/api_fixed_fog.cpp",
           "compat/openrt/api_arrays.cpp", "compat/openrt/array_elements.cpp",
           "libsmart/shading/fixed_function.cpp", "libsmart/shading/fixed_lighting.cpp",
           "libsmart/shading/fixed_texture_env.cpp", "libsmart/shading/fixed_triangle.cpp",
           "libsmart/shading/texture.cpp", "libsmart/render/fragments.cpp",
           "libsmart/render/fixed_function_shader.cpp", "libsmart/render/layer_pass.cpp",
           "libsmart/render/layer_edges.cpp",
           "libsmart/render/line_raster.cpp", "libsmart/render/point_raster.cpp",
           "libsmart/render/image_raster.cpp", "libsmart/render/pixel_primitives.cpp"]

CHANGES = [(re.compile(pattern), new) for pattern, new in [
    (r" \+ ", " - "), (r" - ", " + "), (r" \* ", " + "), (r" / ", " * "),
    (r" < ", " <= "), (r" <= ", " < "), (r" > ", " >= "), (r" >= ", " > "),
    (r" == ", " != "), (r" != ", " == "), (r" && ", " || "), (r" \|\| ", " && "),
    (r"(?<=[(, ])-(?=[a-z(])", ""), (r"\[0\]", "[1]"), (r"\[1\]", "[0]"), (r"\[2\]", "[1]"),
    (r"(?<![\w.])0\.0f?(?!\w)", "1.0"), (r"(?<![\w.])1\.0f?(?!\w)", "2.0"),
    (r"(?<![\w.])0\.5f?(?!\w)", "0.25"), (r"\.x\b", ".y"), (r"\.y\b", ".x")]]


def is_code(line):
    text = line.strip()
    return bool(text) and not text.startswith(("//", "///", "#", "*", "template", "using", "static_"
                                               "assert", "}"))


def mechanical(tree):
    """Every mechanical mutant of the files above, in a fixed order."""
    found = []
    for file in MUTATED:
        path = pathlib.Path(tree, file)
        if not path.is_file():
            continue
        text, start = path.read_text(encoding="utf-8"), 0
        for number, line in enumerate(text.splitlines(keepends=True), 1):
            code = line.split("//")[0] if is_code(line) and '"' not in line else ""
            for pattern, new in CHANGES:
                for match in pattern.finditer(code):
                    found.append(MechanicalMutant(file, start + match.start(), match.group(), new,
                                                  number))
            start += len(line)
    return found
