"""Looks at solids with trimesh and manifold3d of PyPI.

Arguments: files. Prints one JSON object: the versions, and for each file what trimesh says of it (watertight,
wound the same way, volume, triangles) and what manifold3d makes of it (its status and volume). Vertices are
those of the file, by its own numbers; an STL has none, so there equal positions are one vertex.
"""

import json
import sys
from importlib.metadata import version
from pathlib import Path

import manifold3d
import numpy as np
import trimesh


def looked_at(path):
    is_stl = path.suffix == ".stl"
    mesh = trimesh.load(path, force="mesh", process=is_stl, maintain_order=True)
    vertices = np.asarray(mesh.vertices, dtype=np.float32)
    triangles = np.asarray(mesh.faces, dtype=np.uint32)
    solid = manifold3d.Manifold(manifold3d.Mesh(vert_properties=vertices, tri_verts=triangles))
    return {
        "watertight": bool(mesh.is_watertight),
        "consistent": bool(mesh.is_winding_consistent),
        "volume": float(mesh.volume),
        "triangles": len(mesh.faces),
        "status": str(solid.status()).split(".")[-1],
        "solid_volume": float(solid.volume()),
    }


files = [Path(name) for name in sys.argv[1:]]
versions = {name: version(name) for name in ["trimesh", "manifold3d"]}
print(json.dumps({"versions": versions, "files": [looked_at(path) for path in files]}))
