"""Times PyPI topocalc's horizons of a relief.

Arguments: a file of heights in [0, 1] (f32, row by row), columns, rows, azimuths, metres of a texel, metres of the relief, runs,
and a file for the sines (f32, azimuth by azimuth). Prints one JSON object; cpu_s and wall_s are medians, over all azimuths.
Azimuth k is 2 pi k / azimuths from +u towards +v.
"""

import json
import statistics
import sys
import time
from importlib.metadata import version

import numpy as np
from topocalc.horizon import horizon


def degrees(k, azimuths):
    """topocalc counts from south, which is down in the map, by way of east."""
    angle = 90.0 - 360.0 * k / azimuths
    return angle if angle >= -180.0 else angle + 360.0


def main():
    path, width, height, azimuths, texel, scale, runs, out = sys.argv[1:]
    width, height, azimuths, runs = int(width), int(height), int(azimuths), int(runs)
    heights = np.fromfile(path, dtype=np.float32).reshape(height, width)
    dem = heights.astype(np.float64) * float(scale)
    cpu, wall = [], []
    for _ in range(runs):
        cpu_start, start = time.process_time(), time.perf_counter()
        sines = [horizon(degrees(k, azimuths), dem, float(texel)) for k in range(azimuths)]
        cpu.append(time.process_time() - cpu_start)
        wall.append(time.perf_counter() - start)
    np.asarray(sines, dtype=np.float32).tofile(out)
    print(
        json.dumps(
            {
                "version": version("topocalc"),
                "cpu_s": statistics.median(cpu),
                "wall_s": statistics.median(wall),
            }
        )
    )


main()
