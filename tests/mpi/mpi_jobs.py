#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Programs that mpirun starts render the same bits as one process with one thread.

mpi_jobs.py BIN LIBRARY SHADERS MODEL [--full]

BIN: folder of the programs; LIBRARY: libOpenRT; SHADERS: folder of shader libraries; MODEL: a
scene. With --full each sample is run with 1, 2, 3 and 4 ranks, else with one of these numbers.
Several jobs run at once: most of a job's time is waiting for its start and end.
"""
import concurrent.futures
import functools
import itertools
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

BIN, LIBRARY, SHADERS, MODEL = (pathlib.Path(a).resolve() for a in sys.argv[1:5])
FULL = "--full" in sys.argv[5:]
PORTS = ["checker", "clip", "fog", "gears", "isosurface", "lightmap", "material_grid", "mirror",
         "model", "movelight", "nested_lists", "overlay", "panes", "planet", "revolution", "robot",
         "scene", "shadows", "spots", "terrain", "texbind", "text", "torus", "varray",
         "rt_teapots", "rt_mirror"]
SHORT = {"02_instances": ["out.png"], "01_triangle": ["out.png"], "03_sphere": ["out.pfm"],
         "04_floor": ["out.pfm"], "06_shaders": ["out.png"], "07_frame_queue": ["frame", "2"]}
SIZE = "96x72"
CHANGING = ["flight", "shoal", "sheet", "day_and_night"]
SECONDS = 600
AT_ONCE = 4


def environment(**changes):
    result = {k: v for k, v in os.environ.items()
              if not k.startswith(("OPENRT_", "OMPI_", "PMIX_", "PMI_"))}
    result.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                  OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_hwloc_base_binding_policy="none",
                  OMPI_MCA_btl_vader_single_copy_mechanism="none", OPENRT_MPI_REPORT="1",
                  OMPI_MCA_pml="ob1", OMPI_MCA_btl="self,vader")  # a quicker start
    # Open MPI keeps memory for ever; what the library keeps other tests look at. A rank preloads it.
    result["ASAN_OPTIONS"] = (result.get("ASAN_OPTIONS", "") +
                              ":detect_leaks=0:verify_asan_link_order=0")
    result.update(changes)
    return result


def mpirun(*blocks):
    """Runs blocks of (ranks, environment, command); the result with its text."""
    command = ["mpirun"]
    for i, (ranks, changes, program) in enumerate(blocks):
        command += [":"] * (i > 0) + ["-n", str(ranks)]
        for name, value in changes.items():
            command += ["-x", f"{name}={value}"]
        command += [str(part) for part in program]
    return subprocess.run(command, env=environment(), capture_output=True, timeout=SECONDS,
                          text=True)


def kill_rank(mpirun_pid, rank):
    """Kills the process of that rank; whether there was one."""
    for task in pathlib.Path("/proc").glob(f"{mpirun_pid}/task/*/children"):
        for child in task.read_text().split():
            variables = pathlib.Path(f"/proc/{child}/environ").read_bytes().split(b"\0")
            if f"OMPI_COMM_WORLD_RANK={rank}".encode() in variables:
                os.kill(int(child), signal.SIGKILL)
                return True
    return False


def alone(*program):
    return subprocess.run([str(part) for part in program], capture_output=True, timeout=SECONDS,
                          text=True, env=environment(OPENRT_MPI="0", OPENRT_THREADS="1"))


def remote_tiles(text):
    found = re.search(r"(\d+) of its tiles by (\d+) other", text)
    return (int(found[1]), int(found[2])) if found else (0, 0)


def at_once(function, arguments):
    """Calls function(*a) for all, several at a time; what went wrong is raised in the end."""
    with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
        for future in [pool.submit(function, *a) for a in arguments]:
            future.result()


class Jobs(unittest.TestCase):
    compared = itertools.count()
    shared = itertools.count()

    def setUp(self):
        self._temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._temporary.name)

    def tearDown(self):
        self._temporary.cleanup()

    @staticmethod
    def files(folder):
        return {p.name: p.read_bytes() for p in sorted(folder.iterdir())}

    def compare(self, ranks, command, code=0, changes=None):
        """command(folder) gives the program that writes its pictures there."""
        folder = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        for name in ("alone", "together"):
            (folder / name).mkdir()
        first = alone(*command(folder / "alone"))
        self.assertEqual(first.returncode, code, first.stderr)
        result = mpirun((ranks, changes or {}, command(folder / "together")))
        self.assertEqual(result.returncode, code, result.stderr)
        pictures = self.files(folder / "alone")
        self.assertEqual(pictures, self.files(folder / "together"), command(folder)[0])
        self.assertTrue(pictures)
        self.assertEqual(result.stdout.replace("/together/", "/alone/"), first.stdout)
        self.assertNotIn("renders no more", result.stderr)
        tiles, others = remote_tiles(result.stderr)
        self.assertEqual(others, ranks - 1, result.stderr)
        next(Jobs.compared)
        if tiles > 0:
            next(Jobs.shared)
        shutil.rmtree(folder)
        return tiles

    def until(self, attempt):
        """Calls attempt(samples) with ever more samples a pixel until it is true: a short job may
        be over before the other ranks have taken a tile, and more so on a busy machine."""
        self.assertTrue(any(attempt(samples) for samples in (2, 8, 32, 128, 512)))

    def compare_shared(self, ranks, command, changes=None):
        """compare, until other ranks have had a part in it; command(samples)(folder)."""
        self.until(lambda samples: self.compare(ranks, command(samples), changes=changes) > 0)

    def program(self, way, samples=4):
        return lambda folder: [BIN / "mpi_program", folder / "out", way, "--rt-samples", samples]

    def frames_alone(self, samples):
        """The pictures of one process and one thread."""
        folder = self.folder / f"alone{samples}"
        folder.mkdir()
        alone(*self.program("frames", samples)(folder))
        return (folder / "out").read_bytes()

    def compare_all(self, programs):
        at_once(self.compare, [(ranks, command) for i, command in enumerate(programs)
                               for ranks in ((1, 2, 3, 4) if FULL else (1 + i % 4,))])

    def offscreen(self, program):
        return lambda folder: [program, "--rt-offscreen", 2, "--rt-size", SIZE,
                               "--rt-output", folder / "frame%03d.png"]

    def test_samples(self):
        self.compare_all(
            [self.offscreen(BIN / "ports" / p) for p in PORTS] +
            [self.offscreen(BIN / "changing" / p) for p in CHANGING] +
            [lambda folder, p=p, a=a: [BIN / p, folder / a[0], *a[1:]] for p, a in SHORT.items()])

    def test_render_a_scene(self):
        def render(name):
            return lambda samples: lambda folder: [
                BIN / "openrt-render", MODEL, "-o", folder / name, "--size", "320x240",
                "--samples", samples, "--frames", 2]
        at_once(self.compare_shared, [
            (ranks, render(name), {"OPENRT_MPI_PACK": packing})
            for ranks, name, packing in ((2, "out.png", "never"), (4, "out.exr", "always"))])

    def test_frames_of_scenes_that_change(self):
        self.assertEqual(self.compare(1, self.program("frames")), 0)
        for ranks in (2, 3, 4):
            self.compare_shared(ranks, functools.partial(self.program, "frames"))

    def test_packed_tiles_are_fewer_bytes(self):
        def received(packing, samples):
            text = mpirun((2, {"OPENRT_MPI_PACK": packing},
                           self.program("frames", samples)(self.folder))).stderr
            found = re.search(r"received (\d+) bytes of pixels as (\d+);", text)
            plain, sent = int(found[1]), int(found[2])
            if plain > 0:
                self.assertEqual(sent < plain, packing == "always", text)
                self.assertGreater(sent, 0)
            return plain > 0
        for packing in ("always", "never"):
            self.until(functools.partial(received, packing))

    def test_pictures_that_become_textures(self):
        self.compare_shared(3, functools.partial(self.program, "copy"))

    def test_contexts(self):
        self.compare(3, self.program("contexts"))

    def test_leaving_without_rtExit(self):
        self.compare(2, self.program("exit"), code=3)

    def test_leaving_in_the_middle_of_a_frame(self):
        result = mpirun((3, {}, self.program("abandon")(self.folder)))
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_library_opened_at_run_time(self):
        self.compare(2, lambda folder: [BIN / "opened_library", LIBRARY, folder / "out"])

    def recovering(self, folder, rank, frames):
        """A job in which that rank is killed, where mpirun does not end the job then, as Open MPI
        4.1 with this option; its program, and what it wrote of errors."""
        folder.mkdir()
        program = [str(part) for part in self.offscreen(BIN / "ports" / "gears")(folder)]
        program[program.index("--rt-offscreen") + 1] = str(frames)
        program[program.index("--rt-size") + 1] = "160x120"
        job = subprocess.Popen(["mpirun", "--enable-recovery", "-n", "3", *program],
                               env=environment(OPENRT_THREADS="1", OPENRT_MPI_SILENCE="5"),
                               text=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        try:
            end = time.time() + SECONDS
            while not (folder / "frame005.png").exists() and job.poll() is None:
                self.assertLess(time.time(), end)
                time.sleep(0.01)
            killed = kill_rank(job.pid, rank)
            _, text = job.communicate(timeout=SECONDS)
        finally:
            job.kill()
            job.wait()
        if "unrecognized" in text or "unknown option" in text:
            self.skipTest("mpirun has no --enable-recovery")
        self.assertTrue(killed, text)
        return program, text

    def test_frames_go_on_when_a_rank_is_killed(self):
        together, single = self.folder / "together", self.folder / "alone"
        single.mkdir()
        frames = 60
        program, text = self.recovering(together, 2, frames)
        program[-1] = str(single / "frame%03d.png")
        alone(*program)
        self.assertEqual(len(self.files(single)), frames)
        self.assertEqual(self.files(together).keys(), self.files(single).keys(), text)
        self.assertEqual(self.files(together), self.files(single))

    def test_ranks_end_when_the_first_is_killed(self):
        self.recovering(self.folder / "together", 0, 100000)

    def test_ranks_of_different_instruction_sets(self):
        def shared(samples):
            program = self.program("frames", samples)(self.folder)
            result = mpirun((1, {"OPENRT_ISA": "generic"}, program), (1, {}, program),
                            (1, {"OPENRT_ISA": "sse4"}, program))
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual((self.folder / "out").read_bytes(), self.frames_alone(samples))
            return remote_tiles(result.stderr)[0] > 0
        self.until(shared)

    def test_a_plug_in_that_a_rank_lacks_is_named(self):
        shaders = self.folder / "shaders"
        shaders.mkdir()
        shutil.copy(SHADERS / "marble.so", shaders / "only_here.so")
        with_it = {"OPENRT_SHADER_PATH": str(shaders)}

        def named(samples):
            program = [str(p) for p in self.program("plugin", samples)(self.folder)]
            first = subprocess.run(program, capture_output=True, timeout=SECONDS,
                                   env=environment(OPENRT_MPI="0", **with_it))
            self.assertEqual((first.returncode, first.stdout), (0, b""))
            expected = (self.folder / "out").read_bytes()
            result = mpirun((2, with_it, program))
            self.assertEqual((result.returncode, result.stdout), (0, ""), result.stderr)
            self.assertEqual((self.folder / "out").read_bytes(), expected)
            result = mpirun((2, with_it, program), (1, {"OPENRT_SHADER_PATH": "/"}, program))
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual((self.folder / "out").read_bytes(), expected)
            if not result.stdout:  # over before that rank had said it
                return False
            self.assertRegex(result.stderr, "rank 2 renders no more: rtGenNewShaderClass")
            self.assertIn("error: ", result.stdout)  # and an error of the interface, once
            self.assertIn("rank 2", result.stdout)
            self.assertEqual(result.stdout.count("\n"), 1)
            return True
        self.until(named)

    def test_another_build_of_the_library_is_left_out(self):
        other = self.folder / "other"
        other.mkdir()
        data = bytearray(LIBRARY.read_bytes())
        at = data.find(b"\x04\0\0\0\x14\0\0\0\x03\0\0\0GNU\0")
        if at < 0:
            self.skipTest("no build id in the library")
        data[at + 16] ^= 1
        (other / "libOpenRT.so.0").write_bytes(data)
        shutil.copy(LIBRARY.parent / "libOpenRT-mpi.so.0", other)

        def left_out(samples):
            program = self.program("frames", samples)(self.folder)
            result = mpirun((2, {}, program), (1, {"LD_LIBRARY_PATH": other, "LD_PRELOAD":
                                                   other / "libOpenRT.so.0"}, program))
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual((self.folder / "out").read_bytes(), self.frames_alone(samples))
            if not result.stdout:  # over before that rank had greeted
                return False
            self.assertRegex(result.stderr, "rank 2 renders no more: its library is another one")
            self.assertIn("its library is another one", result.stdout)
            return True
        self.until(left_out)

    def test_asked_for_without_a_launcher(self):
        program = self.program("frames")(self.folder)
        result = subprocess.run([str(p) for p in program], capture_output=True, timeout=SECONDS,
                                text=True, env=environment(OPENRT_MPI="1"))
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_without_the_component(self):
        lonely = self.folder / "lonely"
        lonely.mkdir()
        shutil.copy(LIBRARY, lonely / "libOpenRT.so.0")
        program = [BIN / "opened_library", lonely / "libOpenRT.so.0", self.folder / "out"]
        result = subprocess.run([str(p) for p in program], capture_output=True, timeout=SECONDS,
                                text=True, env=environment(OPENRT_MPI="1"))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("renders alone: libOpenRT-mpi.so.0", result.stderr)


def main():
    with concurrent.futures.ThreadPoolExecutor(3) as pool:
        tests = unittest.defaultTestLoader.loadTestsFromTestCase(Jobs)
        results = list(pool.map(run_timed, tests))
    for test, result, seconds in results:
        print(f"{test.id()}: {seconds:.1f} s {'' if result.wasSuccessful() else 'FAILED'}")
        for _, text in result.errors + result.failures:
            print(text)
        for _, reason in result.skipped:
            print(f"  skipped: {reason}")
    print(f"{next(Jobs.compared)} jobs had the same pictures as one thread, other ranks had a part "
          f"in {next(Jobs.shared)} of them")
    return not results or not all(result.wasSuccessful() for _, result, _ in results)


def run_timed(test):
    result, start = unittest.TestResult(), time.monotonic()
    test.run(result)
    return test, result, time.monotonic() - start


if __name__ == "__main__":
    sys.exit(main())
