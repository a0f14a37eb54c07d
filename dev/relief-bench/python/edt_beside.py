"""Times PyPI edt's transform of the volume above a relief.

Arguments: a file of heights in [0, 1] (f32, row by row), columns, rows, slices, metres of a tile along u and v, metres of the
relief, runs. Prints one JSON object; cpu_s and wall_s are medians, of the transform alone.
"""

import json
import statistics
import sys
import time
from importlib.metadata import version

import edt
import numpy as np


def main():
    path, width, height, slices, tile_u, tile_v, scale, runs = sys.argv[1:]
    width, height, slices, runs = int(width), int(height), int(slices), int(runs)
    heights = np.fromfile(path, dtype=np.float32).reshape(height, width)
    padded = np.pad(heights, 1, mode="edge")
    tops = np.max(
        [padded[j : j + height, i : i + width] for j in range(3) for i in range(3)], axis=0
    )
    levels = (np.arange(slices, dtype=np.float32) + 0.5) / slices
    # Free voxels are foreground: their distance is that to the nearest solid voxel.
    free = np.ascontiguousarray(levels[:, None, None] > tops[None])
    voxel = (float(scale) / slices, float(tile_v) / height, float(tile_u) / width)
    cpu, wall = [], []
    for _ in range(runs):
        cpu_start, start = time.process_time(), time.perf_counter()
        distances = edt.edt(free, anisotropy=voxel, black_border=False, parallel=1)
        cpu.append(time.process_time() - cpu_start)
        wall.append(time.perf_counter() - start)
    mean = float(distances[free].mean(dtype=np.float64))
    print(
        json.dumps(
            {
                "version": version("edt"),
                "cpu_s": statistics.median(cpu),
                "wall_s": statistics.median(wall),
                "mean": mean,
            }
        )
    )


main()
