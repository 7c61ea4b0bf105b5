#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Each check of this folder must find a planted fault, and pass what is in order."""
import pathlib
import platform
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path[:0] = [str(HERE), str(ROOT / "compat")]

import exported_symbols  # noqa: E402
import generate_calls  # noqa: E402
import headers_alone  # noqa: E402
import interface_kept  # noqa: E402
import isa_objects  # noqa: E402
import layering  # noqa: E402
import opengl_names  # noqa: E402
import source_form  # noqa: E402
import version_script  # noqa: E402


class SourceForm(unittest.TestCase):
    GOOD = "// SPDX-License-Identifier: MIT\n#pragma once\n"

    def problems(self, name, text):
        return source_form.problems_of(pathlib.Path(name), text)

    def test_accepts_600_lines_in_order(self):
        self.assertEqual(self.problems("libsmart/base/a.h", self.GOOD + "\n" * 598), [])

    def test_finds_line_601(self):
        self.assertEqual(len(self.problems("libsmart/base/a.h", self.GOOD + "\n" * 599)), 1)

    def test_finds_missing_licence(self):
        self.assertEqual(len(self.problems("libsmart/base/a.cpp", "int a;\n")), 1)

    def test_finds_missing_pragma(self):
        licence = self.GOOD.splitlines()[0]
        self.assertNotEqual(self.problems("libsmart/base/a.h", licence), [])
        self.assertNotEqual(self.problems("tests/api/a.h", licence), [])

    def test_accepts_the_guard_of_a_c_header(self):
        guard = "// SPDX-License-Identifier: MIT\n#ifndef A_H\n#define A_H\n#endif\n"
        self.assertEqual(self.problems("tests/api/a.h", guard), [])
        self.assertNotEqual(self.problems("libsmart/base/a.h", guard), [])


class Layering(unittest.TestCase):
    def problems(self, **texts):
        return layering.Tree({k.replace("__", "/").replace("_H", ".h").replace("_CPP", ".cpp"): v
                              for k, v in texts.items()}).problems()

    def test_accepts_left_and_own(self):
        self.assertEqual(self.problems(
            libsmart__scene__a_H='#include "libsmart/base/b.h"\n#include "libsmart/scene/c.h"',
            compat__openrt__x_CPP='#include <openrt/rt.h>\n#include "libsmart/render/f.h"'), [])

    def test_finds_include_to_the_right(self):
        self.assertIn("is below", self.problems(
            libsmart__base__a_H='#include "libsmart/scene/c.h"')[0])

    def test_finds_core_that_includes_the_front_end(self):
        for header in ("compat/recorder/recorder.h", "compat/openrt/guard.h"):
            self.assertEqual(len(self.problems(
                libsmart__render__a_CPP=f'#include "{header}"')), 1)

    def test_finds_api_header_in_core_and_recorder(self):
        self.assertEqual(len(self.problems(libsmart__shading__a_H='#include "openrt/rt.h"',
                                           compat__recorder__b_H='#include <openrt/rt.h>',
                                           libsmart__base__c_H='#include "openrt/rt_core.h"')),
                         3)

    def test_accepts_types_and_tokens_in_core(self):
        self.assertEqual(self.problems(libsmart__base__a_H='#include "openrt/types.h"',
                                       libsmart__base__b_H='#include "openrt/rt_gl_enums_1_1.h"'),
                         [])

    def test_finds_tests_and_samples_included_from_the_library(self):
        self.assertEqual(len(self.problems(libsmart__base__a_H='#include "tests/support/x.h"',
                                           libsmart__base__b_H='#include "samples/common/x.h"')),
                         2)

    def test_accepts_what_programs_share_in_the_program_of_a_layer_only(self):
        include = '#include "samples/common/standard_output.h"'
        self.assertEqual(self.problems(compat__trace__openrt_trace_CPP=include), [])
        self.assertEqual(len(self.problems(compat__trace__c_source_CPP=include)), 1)

    def test_finds_internals_in_a_sample(self):
        self.assertEqual(len(self.problems(
            samples__tools__a_CPP='#include "libsmart/scene/scene.h"')), 1)

    def test_finds_relative_include(self):
        self.assertEqual(len(self.problems(libsmart__base__a_CPP='#include "a.h"')), 1)

    def test_finds_container_that_a_kernel_sees_through_another_header(self):
        found = self.problems(libsmart__kernel__a_H='#include "libsmart/base/b.h"',
                              libsmart__base__b_H="#include <vector>\n#include <glm/glm.hpp>")
        self.assertEqual(len(found), 2)

    def test_finds_kernel_that_includes_the_builder(self):
        self.assertEqual(len(self.problems(
            libsmart__kernel__a_CPP='#include "libsmart/accel/kd_builder.h"')), 1)

    def test_finds_unknown_folder(self):
        self.assertEqual(len(self.problems(libsmart__util__a_H="")), 1)


class ExportedSymbols(unittest.TestCase):
    GOOD = {"rtInit": "OPENRT_0.1"}

    def problems(self, declared, exported, needed=("libstdc++.so.6", "libc.so.6"),
                 library="libOpenRT", soversion=exported_symbols.SOVERSION):
        return exported_symbols.problems(library, set(declared), exported, list(needed),
                                         [f"{library}.so.{soversion}"])

    def test_parses_declarations(self):
        text = ('__attribute__((visibility("default"))) void rtInit(int *argcp);'
                '__attribute__((visibility("default"))) const RTubyte * rtGetString(RTenum n);'
                'typedef void (*callback)(int);')
        self.assertEqual(exported_symbols.declared_functions(text), {"rtInit", "rtGetString"})

    def test_parses_nm(self):
        text = "0000 T rtInit@@OPENRT_0.1\n0000 A OPENRT_0.1\n0000 W _ZN5smart1fEv\n"
        self.assertEqual(exported_symbols.exported_symbols(text),
                         {"rtInit": "OPENRT_0.1", "_ZN5smart1fEv": None})

    def test_accepts_equal_sets(self):
        self.assertEqual(self.problems(["rtInit"], self.GOOD), [])

    def test_finds_each_difference(self):
        self.assertEqual(len(self.problems(["rtInit", "rtExit"], self.GOOD)), 1)
        self.assertEqual(len(self.problems(["rtInit"], {**self.GOOD, "_Z1fv": None})), 1)
        self.assertEqual(len(self.problems(["rtInit"], {"rtInit": None})), 1)
        self.assertEqual(len(self.problems(["rtInit"], self.GOOD, ["libhwy.so.1"])), 1)
        self.assertEqual(len(self.problems(["rtInit"], self.GOOD, soversion="0.1")), 1)
        self.assertNotEqual(self.problems([], {}), [])

    def test_looks_at_each_library(self):
        good = (("librtut", "rtutInit", "RTUT_0.1", "libglfw.so.3"),
                ("libOpenRT-mpi", "openrtMpiOpen", None, "libmpi.so.40"))
        for library, name, node, needed in good:
            self.assertEqual(self.problems([name], {name: node}, [needed], library), [])
            for exported, need in (({name: "OPENRT_0.1"}, needed), ({name: node}, "libhwy.so.1"),
                                   ({name: node, "_ZNSt5dequeIvE": None}, needed), ({}, needed)):
                self.assertEqual(len(self.problems([name], exported, [need], library)), 1)
        self.assertEqual(exported_symbols.declared_symbols("cc", [], "libOpenRT-mpi"),
                         {"openrtMpiComponent", "openrtMpiOpen"})

    def test_finds_planted_export_in_a_real_library(self):
        with tempfile.TemporaryDirectory() as folder:
            library = pathlib.Path(folder, "a.so")
            subprocess.run(["cc", "-shared", "-fPIC", "-x", "c", "-", "-o", str(library)],
                           input="void rtInit(void){} void leaked(void){}", text=True, check=True)
            exported = exported_symbols.exported_symbols(
                exported_symbols.output_of("nm", "-D", "--defined-only", str(library)))
            self.assertIn("libOpenRT: exported, but not declared: leaked",
                          self.problems(["rtInit"], exported))


class VersionScript(unittest.TestCase):
    GOOD = "OPENRT_0.1 { global: rtInit; local: *; };"

    def problems(self, text, declared=("rtInit",)):
        return version_script.problems("libOpenRT", text, set(declared), "0.1.0")

    def test_accepts_names(self):
        self.assertEqual(self.problems(self.GOOD), [])

    def test_accepts_a_second_node(self):
        two = self.GOOD + "\nOPENRT_0.2 { global: rtExit; } OPENRT_0.1;"
        self.assertEqual(version_script.problems("libOpenRT", two, {"rtInit", "rtExit"}, "0.2.0"), [])
        rtut = self.GOOD.replace("OPENRT", "RTUT")
        self.assertEqual(version_script.problems("librtut", rtut, {"rtInit"}, "0.1.0"), [])
        self.assertNotEqual(version_script.problems("librtut", self.GOOD, {"rtInit"}, "0.1.0"), [])

    def test_finds_each_fault(self):
        for text in ("", "OPENRT_0.1 { global: rt*; local: *; };",
                     "OPENRT_0.1 { global: rtInit; };",
                     "OPENRT_0.1 { global: rtInit; rtGone; local: *; };",
                     "OPENRT_0.1 { global: rtInit; rtInit; local: *; };",
                     "OPENRT_0.2 { global: rtInit; local: *; };",
                     self.GOOD + "OPENRT_0.1 { global: rtExit; };"):
            self.assertNotEqual(self.problems(text), [], text)
        self.assertNotEqual(self.problems(self.GOOD, ("rtInit", "rtExit")), [])


@unittest.skipUnless(platform.machine() == "x86_64", "x86 instructions")
class IsaObjects(unittest.TestCase):
    def code(self, *instructions):
        return isa_objects.Code("".join(f"   0:\t{i}\n" for i in instructions))

    def test_accepts_each_set_in_its_object(self):
        for isa, line in (("generic", "mulss  %xmm0,%xmm1"), ("sse4", "blendvps %xmm0,%xmm1,%xmm2"),
                          ("avx2", "vmulps %ymm0,%ymm1,%ymm2"),
                          ("avx512", "vmulps %zmm0,%zmm1,%zmm2"), ("", "mulps  %xmm0,%xmm1")):
            self.assertEqual(isa_objects.code_problems(isa, self.code(line)), [], isa)

    def test_finds_each_set_in_the_wrong_object(self):
        for isa, line in (("generic", "vmulss %xmm0,%xmm1,%xmm1"),
                          ("generic", "pminsd %xmm0,%xmm1"),
                          ("sse4", "mulps  %xmm0,%xmm1"), ("avx2", "vmulps %xmm0,%xmm1,%xmm2"),
                          ("avx2", "vmulps %zmm0,%zmm1,%zmm2"),
                          ("avx512", "vmulps %ymm0,%ymm1,%ymm2"), ("", "vzeroupper"),
                          ("avx2", "vfmadd213ps %ymm0,%ymm1,%ymm2")):
            self.assertNotEqual(isa_objects.code_problems(isa, self.code(line)), [], (isa, line))

    def test_accepts_own_symbols(self):
        text = ("0000 R _ZN5smart4avx26kTableE\n"
                "0000 W _ZZN5smart4avx21fEvENKUlvE_clEv\n0000 t _ZN3hwy6N_AVX23AddEv\n"
                "                 U memcpy\n                 w __gmon_start__\n")
        self.assertEqual(isa_objects.symbol_problems("avx2", text), [])

    def test_finds_symbols_that_others_see(self):
        for line in ("0000 W _ZN5smart6packetEv", "0000 T _ZN5smart6avx5121fEv",
                     "0000 u _ZN5smart1gE", "0000 V _ZTIN5smart1XE",
                     "0000 W _ZSt3minIfERKT_S2_S2_"):
            self.assertEqual(len(isa_objects.symbol_problems("avx2", line)), 1, line)

    def test_finds_start_code(self):
        self.assertEqual(len(isa_objects.start_problems("avx2", "  5 .init_array 0008")), 1)

    def build(self, folder, name, source, *flags):
        path = pathlib.Path(folder, name)
        subprocess.run(["c++", "-O2", "-c", "-x", "c++", *flags, "-", "-o", str(path)],
                       input=source, text=True, check=True)
        return str(path)

    def test_finds_avx_in_the_rest_of_an_archive(self):
        add = "void f(float* a){for(int i=0;i<64;++i)a[i]+=1;}"
        kernel = "namespace smart{namespace avx2{void f(float* a){for(int i=0;i<64;++i)a[i]+=1;}}}"
        with tempfile.TemporaryDirectory() as folder:
            own = self.build(folder, "own.o", kernel, "-O3", "-mavx2")
            plain = self.build(folder, "plain.o", add)
            planted = self.build(folder, "planted_with_a_long_name.o", add, "-O3", "-mavx2")
            good, bad = f"{folder}/good.a", f"{folder}/bad.a"
            subprocess.run(["ar", "rc", good, own, plain], check=True)
            subprocess.run(["ar", "rc", bad, own, plain, planted], check=True)
            self.assertEqual(isa_objects.check({"avx2": [own]}, good), [])
            self.assertIn("planted_with_a_long_name.o",
                          isa_objects.check({"avx2": [own]}, bad)[0])
            self.assertNotEqual(isa_objects.check({"avx2": [planted]}, good), [])

    def test_finds_contraction_in_real_code(self):
        edge = "namespace smart{namespace avx2{float e(float a,float b,float c,float d){" \
               "return a*b-c*d;}}}"
        with tempfile.TemporaryDirectory() as folder:
            fused = self.build(folder, "a.o", edge, "-mavx2", "-mfma", "-ffp-contract=fast")
            exact = self.build(folder, "b.o", edge, "-mavx2", "-mfma", "-ffp-contract=off")
            self.assertTrue(isa_objects.code_of(fused).fused)
            self.assertFalse(isa_objects.code_of(exact).fused)


class HeadersAlone(unittest.TestCase):
    def problems(self, name, text):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "openrt", name)
            path.parent.mkdir()
            path.write_text(text, encoding="utf-8")
            return headers_alone.problems([folder], "cc", "c++")[0]

    def test_accepts_a_header_in_order(self):
        self.assertEqual(self.problems("a.h", "#ifndef A\n#define A\nint f(void);\n#endif\n"), [])

    def test_finds_each_fault(self):
        for text in ("#ifndef A\n#define A\nsize_t f(void);\n#endif\n",     # needs <stddef.h>
                     "#ifndef A\n#define A\nbool f(void);\n#endif\n",       # no C99
                     "#ifndef A\n#define A\nint new(void);\n#endif\n",      # no C++
                     "struct S { int a; };\n"):                             # no guard
            self.assertNotEqual(self.problems("a.h", text), [], text)
        self.assertNotEqual(self.problems("a.txt", ""), [])


class OpenglNames(unittest.TestCase):
    CALL = {"name": "rtClear", "result": "void", "parameters": "RTbitfield mask"}

    def problems(self, declaration, tokens="", extensions=(), names=""):
        with tempfile.TemporaryDirectory() as folder:
            include = pathlib.Path(folder, "openrt")
            include.mkdir()
            pathlib.Path(include, "gl.h").write_text(
                "#include <openrt/rt.h>\n" + names, encoding="utf-8")
            pathlib.Path(include, "rt.h").write_text(
                "typedef unsigned RTbitfield;\n" + declaration + tokens, encoding="utf-8")
            pathlib.Path(include, "rt_gl.h").write_text("", encoding="utf-8")
            return opengl_names.problems([self.CALL], [{"token": "RT_FOG"}], "cc", [folder],
                                         extensions)

    def test_accepts_opengl_names(self):
        self.assertEqual(self.problems("void rtClear(RTbitfield mask);\n",
                                       "#define RT_FOG 0x0B60\n"), [])

    def test_finds_each_fault(self):
        fog = "#define RT_FOG 0x0B60\n"
        self.assertNotEqual(self.problems("", fog), [])
        self.assertNotEqual(self.problems("int rtClear(RTbitfield mask);\n", fog), [])
        self.assertNotEqual(self.problems("void rtClear(short mask);\n", fog), [])
        self.assertNotEqual(self.problems("void rtClear(RTbitfield mask);\n"), [])
        self.assertNotEqual(self.problems("void rtClear(RTbitfield mask);\n",
                                          "#define RT_FOG 0x0B61\n"), [])

    def test_names_of_extensions(self):
        declared = ("void rtClear(RTbitfield mask);\nvoid rtActiveTexture(unsigned texture);\n",
                    "#define RT_FOG 0x0B60\n#define RT_BGR 0x80E0\n#define RT_BGRA 0x80E1\n")
        token = {"name": "GL_BGR_EXT", "core": "RT_BGR"}
        function = {"name": "glActiveTextureARB", "core": "rtActiveTexture"}
        names = "#define GL_BGR_EXT 0x80E0\n#define glActiveTextureARB rtActiveTexture\n"
        good = [token, function]
        self.assertEqual(self.problems(*declared, good, names), [])
        self.assertNotEqual(self.problems(*declared, good, ""), [])
        self.assertNotEqual(self.problems(*declared, [token], names.replace("E0", "E1")), [])
        self.assertNotEqual(self.problems(*declared, [function], ""), [])
        for row in ({**token, "core": "RT_BGRA"}, {**token, "name": "GL_BGR_SGIS"},
                    {**function, "core": "rtClear"}, {**function, "name": "glActiveARB"}):
            named = f"#define {row['name']} {row['core']}\n"
            self.assertNotEqual(self.problems(*declared, [row], named), [], row)


class InterfaceKept(unittest.TestCase):
    BEFORE = {"function rtA": "void (RTint)", "token RT_A": "1", "struct RTSa": "RTuint structSize",
              "struct RTa": "int a"}

    def test_accepts_what_is_new_and_what_grows(self):
        now = dict(self.BEFORE, **{"function rtB": "void ()", "struct RTSa": "RTuint structSize; int b"})
        self.assertEqual(interface_kept.problems(self.BEFORE, now), [])

    def test_finds_each_change(self):
        for what, how in (("function rtA", "void (RTuint)"), ("token RT_A", "2"),
                          ("struct RTSa", "int b; RTuint structSize"), ("struct RTa", "int a; int b")):
            self.assertEqual(len(interface_kept.problems(self.BEFORE, dict(self.BEFORE, **{what: how}))),
                             1)
        self.assertEqual(len(interface_kept.problems(self.BEFORE, {})), 4)

    def test_reads_the_headers(self):
        now = interface_kept.interface_of(ROOT)
        self.assertEqual(now["function rtClear"], "void (RTbitfield)")
        self.assertEqual(now["token RT_INVALID"], "0xFFFFFFFF")
        self.assertTrue(now["struct RTray"].startswith("float origin[3]; float tnear"))


class GeneratedFiles(unittest.TestCase):
    def test_finds_a_changed_and_a_missing_file(self):
        files = generate_calls.generate(ROOT)
        path = next(iter(files))
        self.assertNotEqual(
            generate_calls.differences(ROOT, {path: files[path] + "/* edited */\n"}), [])
        self.assertNotEqual(generate_calls.differences(ROOT, {"include/gone.h": "x\n"}), [])


if __name__ == "__main__":
    unittest.main()
