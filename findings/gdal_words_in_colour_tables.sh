#!/usr/bin/env bash
# GDAL 3.10.3 reads a word in a table of `gdaldem color-relief` as the number 0.
#
# What one expects: the tables are said to follow the rules of GRASS' r.colors, where a line `default` has the colour
# of all elevations that no other line covers. A comment may end a line. A word that is not understood is an error.
# What happens, without a warning:
#   - `default 9 9 9` is an entry at the elevation 0. It stands beside the table's own entry there, and changes every
#     colour up to the next entry. Elevations beyond the table do not get its colour.
#   - `0 1 2 3 # sea` has a fifth field, `#`. It is the opacity, so with -alpha the whole picture is transparent.
#   - 300 for a colour is 44, 256 less, at its entry and beyond; between two such entries it is 255.
#
# Shown by the library that the wheel rasterio 1.4.4 holds, called as the program calls it, on five elevations. Needs
# Python 3 and pip, on Linux. Fails where it is no longer so.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install --quiet rasterio==1.4.4 numpy==2.2.6
cat >probe.py <<'P'
import ctypes, glob
import numpy, rasterio
from rasterio.transform import from_origin

gdal = ctypes.CDLL(glob.glob("venv/lib/python3*/site-packages/rasterio.libs/libgdal*")[0])
pointer, text, number = ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int
gdal.GDALOpen.restype, gdal.GDALOpen.argtypes = pointer, [text, number]
gdal.GDALClose.argtypes = [pointer]
gdal.GDALDEMProcessingOptionsNew.restype = pointer
gdal.GDALDEMProcessingOptionsNew.argtypes = [pointer, pointer]
gdal.GDALDEMProcessing.restype = pointer
gdal.GDALDEMProcessing.argtypes = [text, pointer, text, text, pointer, pointer]
gdal.GDALAllRegister()

elevations = numpy.array([[-50, 0, 50, 100, 150]], "float32")
about = dict(driver="GTiff", width=5, height=1, count=1, dtype="float32", transform=from_origin(0, 1, 1, 1))
with rasterio.open("in.tif", "w", **about) as file:
    file.write(elevations, 1)


def tinted(table, *flags):
    with open("table.txt", "w") as file:
        file.write(table)
    words = (text * (len(flags) + 1))(*[flag.encode() for flag in flags], None)
    options = gdal.GDALDEMProcessingOptionsNew(ctypes.cast(words, pointer), None)
    source = gdal.GDALOpen(b"in.tif", 0)
    gdal.GDALClose(gdal.GDALDEMProcessing(b"out.tif", source, b"color-relief", b"table.txt", options, None))
    gdal.GDALClose(source)
    with rasterio.open("out.tif") as file:
        return [tuple(int(value) for value in texel) for texel in file.read()[:, 0, :].T]


print(rasterio.__gdal_version__)
print("plain  ", tinted("0 10 0 0\n100 200 0 0\n"))
print("default", tinted("0 10 0 0\n100 200 0 0\ndefault 9 9 9\n"))
print("comment", tinted("0 1 2 3 # sea\n100 11 12 13 # land\n", "-alpha"))
print("beyond ", tinted("0 300 0 0\n100 300 0 0\n"))
P
venv/bin/python probe.py 2>log | tee said || { cat log; exit 1; }
cat >expected <<'E'
3.10.3
plain   [(10, 0, 0), (10, 0, 0), (105, 0, 0), (200, 0, 0), (200, 0, 0)]
default [(10, 0, 0), (10, 0, 0), (104, 4, 4), (200, 0, 0), (200, 0, 0)]
comment [(1, 2, 3, 0), (1, 2, 3, 0), (6, 7, 8, 0), (11, 12, 13, 0), (11, 12, 13, 0)]
beyond  [(44, 0, 0), (44, 0, 0), (255, 0, 0), (44, 0, 0), (44, 0, 0)]
E
diff expected said || { echo 'changed: see above'; exit 1; }
echo 'as described'
