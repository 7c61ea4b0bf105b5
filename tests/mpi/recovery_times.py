#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How long a frame waits for a rank of a real job that was killed or stopped.

recovery_times.py PROGRAM [JOBS]

PROGRAM: mpi_program. Each job has four ranks of one thread; three of them are lost one after the
other while frames are rendered. Prints how much longer than the usual one the longest frame was.
"""
import os
import pathlib
import random
import signal
import statistics
import subprocess
import sys
import tempfile
import time

PROGRAM, JOBS = pathlib.Path(sys.argv[1]).resolve(), int(sys.argv[2]) if len(sys.argv) > 2 else 5
KEPT = 8  # frames between two losses


def environment():
    result = {k: v for k, v in os.environ.items()
              if not k.startswith(("OPENRT_", "OMPI_", "PMIX_", "PMI_"))}
    result.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                  OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_hwloc_base_binding_policy="none",
                  OMPI_MCA_btl_vader_single_copy_mechanism="none", OPENRT_THREADS="1")
    return result


def process_of(mpirun, rank):
    for task in pathlib.Path("/proc").glob(f"{mpirun}/task/*/children"):
        for child in task.read_text().split():
            variables = pathlib.Path(f"/proc/{child}/environ").read_bytes().split(b"\0")
            if f"OMPI_COMM_WORLD_RANK={rank}".encode() in variables:
                return int(child)
    raise RuntimeError(f"no rank {rank}")


def delays(how, output):
    command = ["mpirun", "--enable-recovery", "-n", "4", str(PROGRAM), output, "clock"]
    with subprocess.Popen(command, env=environment(), stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True) as job:
        found, stopped = [], []
        try:
            for rank in (3, 2, 1):
                usual = [float(job.stdout.readline()) for _ in range(6 + random.randrange(4))]
                process = process_of(job.pid, rank)
                time.sleep(statistics.median(usual) * 1e-3 * random.uniform(0.2, 0.6))
                os.kill(process, how)
                if how == signal.SIGSTOP:
                    stopped.append(process)
                after = [float(job.stdout.readline()) for _ in range(KEPT)]
                found.append(max(after) - statistics.median(usual))
        finally:
            for process in stopped:
                os.kill(process, signal.SIGKILL)
            job.kill()
        return found


def main():
    with tempfile.TemporaryDirectory() as folder:
        for name, how in (("killed", signal.SIGKILL), ("stopped", signal.SIGSTOP)):
            all_delays = []
            for _ in range(JOBS):
                all_delays += delays(how, str(pathlib.Path(folder, "out")))
            print(f"a rank is {name}: the longest frame took "
                  f"{statistics.median(all_delays):.0f} ms longer (median), "
                  f"{max(all_delays):.0f} ms (worst of {len(all_delays)})", flush=True)


if __name__ == "__main__":
    main()
