"""Times PyPI embreex, Embree's rays one by one, over a triangle mesh.

Arguments: a folder, runs. The folder holds vertices.raw (f32, x y z), triangles.raw (i32, three corners), and for each
set of rays NAME.rays (f32, origin and direction). Writes NAME.depths (f32, the parameter of each ray's hit). Prints one
JSON object: seconds and bytes that building takes, and for each set rays a second, of processor time and from beginning
to end, medians.

Everything runs on one core. Bytes are those of the process that were not there before the mesh was handed over.
"""

import json
import os
import statistics
import sys
import time
from importlib.metadata import version
from pathlib import Path

import numpy as np
from embreex import rtcore_scene
from embreex.mesh_construction import TriangleMesh


def resident():
    for line in Path("/proc/self/status").read_text().splitlines():
        if line.startswith("VmRSS:"):
            return int(line.split()[1]) * 1024
    return 0


def build(vertices, triangles):
    scene = rtcore_scene.EmbreeScene()
    mesh = TriangleMesh(scene, vertices, triangles)
    # The first ray builds the hierarchy.
    scene.run(np.array([[0, 0, 9]], np.float32), np.array([[0, 0, 1]], np.float32))
    return scene, mesh


def main():
    folder, runs = Path(sys.argv[1]), int(sys.argv[2])
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    vertices = np.fromfile(folder / "vertices.raw", dtype=np.float32).reshape(-1, 3)
    triangles = np.fromfile(folder / "triangles.raw", dtype=np.int32).reshape(-1, 3)
    before = resident()
    cpu, wall, held = [], [], []
    for run in range(runs):
        scene = mesh = None
        cpu_start, start = time.process_time(), time.perf_counter()
        scene, mesh = build(vertices, triangles)
        cpu.append(time.process_time() - cpu_start)
        wall.append(time.perf_counter() - start)
        held.append(resident() - before)
    answer = {
        "version": version("embreex"),
        "build_cpu_s": statistics.median(cpu),
        "build_wall_s": statistics.median(wall),
        # Later runs may find memory that the first has left.
        "bytes": held[0],
    }
    for file in sorted(folder.glob("*.rays")):
        rays = np.fromfile(file, dtype=np.float32).reshape(-1, 6)
        origins, directions = np.ascontiguousarray(rays[:, :3]), np.ascontiguousarray(rays[:, 3:])
        cpu, wall = [], []
        for run in range(runs):
            cpu_start, start = time.process_time(), time.perf_counter()
            depths = scene.run(origins, directions, query="DISTANCE")
            cpu.append(len(rays) / (time.process_time() - cpu_start))
            wall.append(len(rays) / (time.perf_counter() - start))
        np.asarray(depths, np.float32).tofile(file.with_suffix(".depths"))
        answer[file.stem] = {"cpu": statistics.median(cpu), "wall": statistics.median(wall)}
    print(json.dumps(answer))


main()
