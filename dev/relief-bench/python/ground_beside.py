"""Whether `relief mesh` writes maps where they lie, judged by trimesh and pyproj.

Arguments: the command `relief`, and a folder. Writes six GeoTIFFs into the folder (metres, feet, degrees, Web
Mercator, rotated, and one that says nothing), makes a GLB of each, and reads it with trimesh. Prints one JSON
object: for each model the greatest distance of a corner, with the origin that the file names, from where the
GeoTIFF's own numbers put it; what is allowed; how far the metres are from pyproj's; and, of a mesh to 1 m and
of one with half of its triangles, the greatest distance from the relief at 64 points a texel.
"""

import json
import struct
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import numpy as np
import pyproj
import tifffile
import trimesh

WIDTH, HEIGHT = 40, 24
WGS84 = pyproj.Geod(ellps="WGS84")

# a b c d e f of x = a column + b row + c, y = d column + e row + f, and the keys.
MODELS = {
    "metres": ((10, 0, 5e5, 0, -10, 5e6), {1024: 1, 3072: 32633, 3076: 9001}),
    "feet": ((32.5, 0, 6e6, 0, -32.5, 2e6), {1024: 1, 3072: 2225, 3076: 9003, 4099: 9001}),
    "degrees": ((1e-4, 0, 7, 0, -1e-4, 46), {1024: 2, 2048: 4326}),
    "mercator": ((14, 0, 8e5, 0, -14, 5.8e6), {1024: 1, 3072: 3857, 3076: 9001}),
    "rotated": ((8, 6, 5e5, 6, -8, 5e6), {1024: 1, 3072: 32633, 3076: 9001}),
    "none": (None, {}),
}


def hills():
    y, x = np.mgrid[0:HEIGHT, 0:WIDTH]
    waves = (np.sin(x / 7) * np.cos(y / 5) + 1) / 2
    waves = (waves - waves.min()) / (waves.max() - waves.min())
    return (waves * 100 + 100).astype(np.float32)


def write(path, heights, transform, keys):
    tags = []
    if transform:
        a, b, c, d, e, f = transform
        matrix = (a, b, 0, c, d, e, 0, f, 0, 0, 0, 0, 0, 0, 0, 1)
        directory = [1, 1, 0, len(keys)]
        for key, value in keys.items():
            directory += [key, 0, 1, value]
        tags = [
            (34264, 12, 16, tuple(map(float, matrix)), True),
            (34735, 3, len(directory), tuple(directory), True),
        ]
    tifffile.imwrite(path, heights, metadata=None, photometric="minisblack", extratags=tags)


def made(relief, tif, glb, *flags):
    command = [relief, "mesh", tif, *flags, "-o", glb, "--json"]
    about = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
    scene = trimesh.load(glb, process=False, force="scene")
    mesh = scene.to_geometry() if hasattr(scene, "to_geometry") else scene.dump(concatenate=True)
    data = Path(glb).read_bytes()
    (length,) = struct.unpack_from("<I", data, 12)
    extras = json.loads(data[20 : 20 + length])["nodes"][0].get("extras", {})
    return about, mesh, extras.get("georeference")


def metres_by_pyproj(crs, x, y):
    """Metres of a unit of the coordinates at a point, along x and y."""
    crs = pyproj.CRS.from_user_input(crs)
    if crs.is_geographic:
        lon, lat, step = x, y, 1e-3
        return [
            WGS84.line_length([lon - step / 2, lon + step / 2], [lat, lat]) / step,
            WGS84.line_length([lon, lon], [lat - step / 2, lat + step / 2]) / step,
        ]
    if crs.to_epsg() == 3857:
        to_degrees = pyproj.Transformer.from_crs(crs, 4326, always_xy=True)
        step = 10.0
        ends = [to_degrees.transform(x + at * step / 2, y) for at in (-1, 1)]
        along = WGS84.line_length(*zip(*ends)) / step
        ends = [to_degrees.transform(x, y + at * step / 2) for at in (-1, 1)]
        return [along, WGS84.line_length(*zip(*ends)) / step]
    return [axis.unit_conversion_factor for axis in crs.axis_info[:2]]


def farthest(mesh, heights, uv, size):
    """The greatest distance of triangles from the bilinear surface at 8 x 8 points a texel."""
    columns, rows = 8 * WIDTH, 8 * HEIGHT
    greatest, seen = 0.0, np.zeros((rows, columns), dtype=bool)
    padded = np.pad(heights.astype(np.float64), 1, mode="edge")
    for face in mesh.faces:
        corners, height = uv[face], mesh.vertices[face][:, 1]
        low = np.floor(corners.min(axis=0) * (columns, rows)).astype(int)
        high = np.ceil(corners.max(axis=0) * (columns, rows)).astype(int)
        i, j = np.meshgrid(np.arange(low[0], high[0]), np.arange(low[1], high[1]))
        at = np.stack([(i.ravel() + 0.5) / columns, (j.ravel() + 0.5) / rows], axis=1)
        matrix = np.vstack([corners.T, np.ones(3)])
        weights = np.linalg.solve(matrix, np.vstack([at.T, np.ones(len(at))])).T
        inside = (weights >= -1e-9).all(axis=1)
        if not inside.any():
            continue
        at, weights = at[inside], weights[inside]
        x, y = at[:, 0] * WIDTH + 0.5, at[:, 1] * HEIGHT + 0.5
        k, l = np.floor(x).astype(int), np.floor(y).astype(int)
        s, t = x - k, y - l
        surface = (
            padded[l, k] * (1 - s) * (1 - t)
            + padded[l, k + 1] * s * (1 - t)
            + padded[l + 1, k] * (1 - s) * t
            + padded[l + 1, k + 1] * s * t
        )
        greatest = max(greatest, np.abs(weights @ height / size + heights.min() - surface).max())
        seen[(at[:, 1] * rows).astype(int), (at[:, 0] * columns).astype(int)] = True
    return float(greatest), bool(seen.all())


def main():
    relief, folder = sys.argv[1], Path(sys.argv[2])
    heights = hills()
    report = {"trimesh": version("trimesh"), "pyproj": version("pyproj"), "models": {}}
    for name, (transform, keys) in MODELS.items():
        tif, glb = str(folder / f"{name}.tif"), str(folder / f"{name}.glb")
        write(tif, heights, transform, keys)
        about, mesh, place = made(relief, tif, glb, "--error", "1m" if transform else "0.1%")
        # trimesh counts v upward.
        uv = mesh.visual.uv * (1, -1) + (0, 1)
        corners = np.array([[0, 0], [1, 0], [0, 1], [1, 1]], dtype=float)
        at = [np.abs(uv - corner).max(axis=1).argmin() for corner in corners]
        found = mesh.vertices[at]
        row = {}
        if transform:
            a, b, c, d, e, f = transform
            x, y, _ = place["origin"]
            middle = (a * WIDTH / 2 + b * HEIGHT / 2 + c, d * WIDTH / 2 + e * HEIGHT / 2 + f)
            metres = np.array(metres_by_pyproj(place["crs"], *middle))
            per_unit = np.array(place["metres_per_unit"])
            placed = np.array([x, y]) + found[:, [0, 2]] * (1, -1) / per_unit
            texels = corners * (WIDTH, HEIGHT)
            expected = np.stack(
                [texels @ (a, b) + c, texels @ (d, e) + f],
                axis=1,
            )
            row["off_m"] = float(np.linalg.norm((placed - expected) * per_unit, axis=1).max())
            length = WIDTH * float(np.hypot(a * per_unit[0], d * per_unit[1]))
            row["allowed_m"] = max(1e-3, length * 2.0**-23)
            row["metres_off"] = float(np.abs(per_unit / metres - 1).max())
            row["error_m"], row["all_seen"] = farthest(mesh, heights, uv, 1.0)
            half = str(len(mesh.faces) // 2)
            _, fewer, _ = made(relief, tif, glb, "--triangles", half)
            row["half_error_m"], _ = farthest(fewer, heights, fewer.visual.uv * (1, -1) + (0, 1), 1.0)
        else:
            expected = (corners - 0.5) * (1, HEIGHT / WIDTH)
            row["off_m"] = float(np.linalg.norm(found[:, [0, 2]] - expected, axis=1).max())
            row["allowed_m"] = 2.0**-23
        row["triangles"] = about["triangles"]
        report["models"][name] = row
    print(json.dumps(report))


main()
