"""Prints what PyPI pyproj says of every coordinate system of the EPSG's list that a raster can have.

One JSON object: the versions, and "systems", a list of [kind, code, size, downward]. Kinds are "projected", "vertical" and
"geographic"; the size of a unit is in metres, of geographic systems in radians. Geographic systems with heights come a second
time, as vertical ones.
"""

import json
import sys

import pyproj
from pyproj.enums import PJType

KINDS = {
    "projected": [PJType.PROJECTED_CRS],
    "vertical": [PJType.VERTICAL_CRS],
    "geographic": [PJType.GEOGRAPHIC_2D_CRS, PJType.GEOGRAPHIC_3D_CRS],
}


def main():
    systems = []
    for kind, types in KINDS.items():
        codes = {int(code) for of in types for code in pyproj.get_codes("EPSG", of, allow_deprecated=True)}
        for code in sorted(codes):
            axes = pyproj.CRS.from_epsg(code).axis_info
            systems.append([kind, code, axes[0].unit_conversion_factor, axes[0].direction == "down"])
            if kind == "geographic" and len(axes) == 3:
                systems.append(["vertical", code, axes[2].unit_conversion_factor, axes[2].direction == "down"])
    json.dump({"pyproj": pyproj.__version__, "proj": pyproj.proj_version_str, "systems": systems}, sys.stdout)


main()
