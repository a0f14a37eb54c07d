"""Meshes a height map with a package of PyPI.

Arguments: a folder, the package, columns, rows, and a number: the tolerance for pydelatin, as a height; for
the others the triangles that are wanted. The folder holds heights.raw (f32, row by row). Writes vertices.raw
(f32: column, row, height) and triangles.raw (u32). Prints one JSON object: the version, and the seconds that
meshing took from beginning to end, without what is read and written. The last two simplify all triangles of
the grid, which are made before.
"""

import json
import sys
import time
from importlib.metadata import version
from pathlib import Path

import numpy as np


def full_grid(heights):
    rows, columns = heights.shape
    y, x = np.mgrid[0:rows, 0:columns].astype(np.float32)
    vertices = np.stack([x.ravel(), y.ravel(), heights.ravel()], axis=1)
    at = np.arange(rows * columns, dtype=np.uint32).reshape(rows, columns)
    a, b, c, d = at[:-1, :-1].ravel(), at[:-1, 1:].ravel(), at[1:, :-1].ravel(), at[1:, 1:].ravel()
    return vertices, np.concatenate([np.stack([a, c, d], axis=1), np.stack([a, d, b], axis=1)])


def delatin(heights, tolerance):
    from pydelatin import Delatin

    start = time.perf_counter()
    made = Delatin(heights, max_error=tolerance)
    vertices, triangles = made.vertices, made.triangles
    seconds = time.perf_counter() - start
    # It counts rows from the last one.
    vertices = np.array(vertices)
    vertices[:, 1] = heights.shape[0] - 1 - vertices[:, 1]
    return vertices, triangles, seconds


def martini(heights, wanted):
    from pymartini import Martini

    start = time.perf_counter()
    tile = Martini(heights.shape[0]).create_tile(heights)
    # The least error that gives no more triangles.
    low, high = 0.0, 1.0
    for _ in range(30):
        middle = (low + high) / 2
        if len(tile.get_mesh(middle)[1]) > wanted:
            low = middle
        else:
            high = middle
    at, triangles = tile.get_mesh(high)
    seconds = time.perf_counter() - start
    at = np.asarray(at).reshape(-1, 2)
    z = heights[at[:, 1], at[:, 0]]
    return np.column_stack([at, z]), np.asarray(triangles), seconds


def fast_simplification(heights, wanted):
    import fast_simplification as package

    vertices, triangles = full_grid(heights)
    # As high as wide: the package knows no units.
    vertices[:, 2] *= heights.shape[0] / 10
    start = time.perf_counter()
    vertices, triangles = package.simplify(vertices, triangles, target_count=int(wanted))
    seconds = time.perf_counter() - start
    vertices[:, 2] /= heights.shape[0] / 10
    return vertices, triangles, seconds


def meshoptimizer(heights, wanted):
    import meshoptimizer as package

    vertices, triangles = full_grid(heights)
    vertices[:, 2] *= heights.shape[0] / 10
    start = time.perf_counter()
    indices = np.ascontiguousarray(triangles.ravel(), dtype=np.uint32)
    made = np.zeros_like(indices)
    count = package.simplify(
        made, indices, vertices, target_index_count=3 * int(wanted), target_error=1.0
    )
    seconds = time.perf_counter() - start
    vertices[:, 2] /= heights.shape[0] / 10
    return vertices, made[:count], seconds


def main():
    folder, package = Path(sys.argv[1]), sys.argv[2]
    columns, rows, number = int(sys.argv[3]), int(sys.argv[4]), float(sys.argv[5])
    heights = np.fromfile(folder / "heights.raw", dtype=np.float32).reshape(rows, columns)
    mesh = {
        "pydelatin": delatin,
        "pymartini": martini,
        "fast-simplification": fast_simplification,
        "meshoptimizer": meshoptimizer,
    }[package]
    vertices, triangles, seconds = mesh(heights, number)
    np.asarray(vertices, dtype=np.float32).tofile(folder / "vertices.raw")
    np.asarray(triangles, dtype=np.uint32).tofile(folder / "triangles.raw")
    print(json.dumps({"version": version(package), "seconds": seconds}))


if __name__ == "__main__":
    main()
