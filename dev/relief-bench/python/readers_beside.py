"""Makes small PNG, TIFF and EXR files, and reads them with Pillow, tifffile and OpenEXR of PyPI.

Arguments: a folder, a seed, the number of files. The same seed makes the same pictures. Prints a JSON object a line: first the
versions, then for each file its name, what is in it, and what its peer reads: an error, or the size and for each channel its
name, the value of white (0 where there is none) and how far a value may be off. The samples of the channels lie as 64-bit
floats in a file of the same name and ".samples", one channel after the other, as the picture is shown: turned as its
orientation says, with the colours of its palette, with 0 as black.
"""

import json
import logging
import os
import random
import struct
import sys
import warnings
import zlib
from importlib.metadata import version
from io import BytesIO
from pathlib import Path

import numpy as np
import OpenEXR
import tifffile
from PIL import Image, ImageOps

SIGNATURE = b"\x89PNG\r\n\x1a\n"
ADAM7 = [(0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2)]


def chunk(kind, data, right=True):
    checksum = zlib.crc32(kind + data) ^ (0 if right else 1)
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", checksum)


def exif(orientation):
    return b"MM\0*" + struct.pack(">IHHHIHHI", 8, 1, 0x112, 3, 1, orientation, 0, 0)


def filtered(row, before, step, kind):
    """A row of bytes behind a PNG filter."""
    out = bytearray([kind])
    for at, byte in enumerate(row):
        left = row[at - step] if at >= step else 0
        up = before[at] if before else 0
        corner = before[at - step] if before and at >= step else 0
        guess = left + up - corner
        nearest = min((left, up, corner), key=lambda value: abs(guess - value))
        out.append((byte - [0, left, up, (left + up) // 2, nearest][kind]) & 255)
    return bytes(out)


def packed(samples, depth):
    """Rows of samples, as bytes."""
    if depth == 16:
        return [row.astype(">u2").tobytes() for row in samples.reshape(len(samples), -1)]
    bits = np.unpackbits(samples.reshape(len(samples), -1, 1).astype(np.uint8), axis=2)[:, :, 8 - depth :]
    return [np.packbits(row).tobytes() for row in bits.reshape(len(samples), -1)]


def make_png(rng, noise):
    colour, depth = rng.choice([(0, 1), (0, 2), (0, 4), (0, 8), (0, 16), (2, 8), (2, 16), (3, 1), (3, 2), (3, 4), (3, 8),
                                (4, 8), (4, 16), (6, 8), (6, 16)])
    channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[colour]
    width, height, interlaced = rng.randint(1, 20), rng.randint(1, 20), rng.random() < 0.3
    what = [f"colour type {colour}", f"{depth} bit"] + ["interlaced"] * interlaced
    odd = rng.choice([""] * 8 + ["orientation", "gAMA", "linear gAMA", "sRGB", "sBIT", "bKGD", "pHYs", "cHRM", "cICP", "animation",
                                 "bytes after the end", "wrong checksum of text", "wrong checksum of data", "no end",
                                 "short palette", "more data", "data cut off", "wrong Adler sum", "long tRNS",
                                 "unknown critical chunk", "palette of colour", "unknown filter", "unknown interlace"])
    entries = 1 << min(depth, 8)
    if odd == "short palette" and colour == 3:
        entries = max(1, entries // 2)
    if colour == 3:
        # Indices beyond a short palette are what is odd about it.
        samples = noise.integers(0, 1 << depth, (height, width, 1))
    else:
        samples = noise.integers(0, 1 << depth, (height, width, channels))
    passes = ADAM7 if interlaced else [(0, 0, 1, 1)]
    data, step = b"", max(1, channels * depth // 8)
    for left, top, columns, rows in passes:
        part = samples[top::rows, left::columns]
        before = None
        for row in packed(part, depth) if part.size else []:
            kind = rng.randrange(5)
            line = filtered(row, before, step, kind)
            data += (b"\x07" + line[1:]) if odd == "unknown filter" and before else line
            before = row
    if odd == "more data":
        data += bytes(9)
    packed_data = zlib.compress(data, rng.choice([0, 6, 9]))
    if odd == "wrong Adler sum":
        packed_data = packed_data[:-1] + bytes([packed_data[-1] ^ 1])
    if odd == "data cut off":
        packed_data = packed_data[: len(packed_data) // 2]
    head = struct.pack(">IIBBBBB", width, height, depth, colour, 0, 0, 2 if odd == "unknown interlace" else interlaced)
    out = SIGNATURE + chunk(b"IHDR", head)
    before_palette = {"gAMA": (b"gAMA", struct.pack(">I", 45455)), "linear gAMA": (b"gAMA", struct.pack(">I", 100000)),
                      "sRGB": (b"sRGB", b"\0"), "cHRM": (b"cHRM", struct.pack(">8I", *[31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000])),
                      "sBIT": (b"sBIT", bytes([max(1, min(depth, 8) - 1)] * (3 if colour == 3 else channels))),
                      "cICP": (b"cICP", bytes([1, 8, 0, 1])), "unknown critical chunk": (b"XYZA", b"what"),
                      "animation": (b"acTL", struct.pack(">II", 1, 0))}
    if odd in before_palette:
        out += chunk(*before_palette[odd])
    if colour == 3 or (odd == "palette of colour" and colour in (2, 6)):
        out += chunk(b"PLTE", noise.integers(0, 256, 3 * entries).astype(np.uint8).tobytes())
    if colour in (0, 2, 3) and (rng.random() < 0.3 or odd == "long tRNS"):
        what.append("tRNS")
        if colour == 3:
            count = entries + 3 if odd == "long tRNS" else rng.randint(1, entries)
            out += chunk(b"tRNS", noise.integers(0, 256, count).astype(np.uint8).tobytes())
        else:
            # The colour of some texel.
            key = samples[rng.randrange(height), rng.randrange(width)]
            out += chunk(b"tRNS", b"".join(struct.pack(">H", int(sample)) for sample in key) + bytes(2 * (odd == "long tRNS")))
    more = {"bKGD": (b"bKGD", {3: b"\0", 0: b"\0\1", 4: b"\0\1"}.get(colour, b"\0\1\0\1\0\1")), "pHYs": (b"pHYs", struct.pack(">IIB", 1000, 2000, 1))}
    if odd in more:
        out += chunk(*more[odd])
    if odd == "orientation":
        number = rng.randrange(10)
        what.append(f"orientation {number}")
        out += chunk(b"eXIf", exif(number))
    if odd == "wrong checksum of text":
        out += chunk(b"tEXt", b"a\0b", right=False)
    if odd == "animation":
        out += chunk(b"fcTL", struct.pack(">IIIIIHHBB", 0, width, height, 0, 0, 1, 10, 0, 0))
    cut = rng.randint(0, len(packed_data))
    for part in (packed_data[:cut], packed_data[cut:]):
        out += chunk(b"IDAT", part, right=odd != "wrong checksum of data")
    if odd != "no end":
        out += chunk(b"IEND", b"")
    if odd == "bytes after the end":
        out += b"more"
    return out, what + [odd] * bool(odd)


def read_png(data):
    image = Image.open(BytesIO(data))
    depth, colour = data[24], data[25]
    image.load()
    key, mode = image.info.get("transparency"), image.mode
    image = ImageOps.exif_transpose(image)
    if mode == "P":
        image = image.convert("RGB" if key is None else "RGBA")
    elif key is not None and mode in ("1", "L", "RGB") and depth <= 8 and not (colour == 0 and depth < 8):
        image = image.convert("RGBA" if mode == "RGB" else "LA")
    values = np.asarray(image).astype(np.float64)
    if image.mode == "1":
        values *= 255
    values = values.reshape(*values.shape[:2], -1)
    if colour == 4 and values.shape[2] == 4:
        # Grey with opacity of 16 bit comes as colours.
        values = values[:, :, [0, 3]]
    most = 65535 if image.mode.startswith("I") else 255
    names = {1: "y", 2: "ya", 3: "rgb", 4: "rgba"}[values.shape[2]]
    channels = [[name, most, 0] for name in names]
    if key is not None and colour == 0 and depth < 8:
        # Pillow compares the key with samples that are spread to 8 bit.
        white = (1 << depth) - 1
        key = key // 255 if depth == 1 else key
        values = np.dstack([values, np.where(np.round(values * white / 255) == key, 0, 255)])
        channels.append(["a", most, 0])
    if key is not None and depth == 16:
        # Pillow has no opacity of such samples; of colours it keeps 8 bits.
        if colour == 0:
            values = np.dstack([values, np.where(values == key, 0, most)])
        channels = channels[: len(names)] + [["a", most if colour == 0 else 0, 0 if colour == 0 else 2]]
        if colour != 0:
            values = np.dstack([values, np.zeros(values.shape[:2])])
    if depth == 16 and most == 255:
        channels = [[name, white, max(off, 1 / 255)] for name, white, off in channels]
    return channels, values


def make_tiff(rng, noise):
    kind = rng.choice(["u1", "u1", "u2", "u2", "u4", "u8", "i1", "i2", "i4", "f2", "f4", "f4", "f8", "bool", "c8"])
    photometric = rng.choice(["minisblack"] * 4 + ["miniswhite", "rgb", "rgb", "palette", "separated"])
    if photometric in ("palette", "separated"):
        kind = "u1" if photometric == "separated" else rng.choice(["u1", "u2"])
    if photometric == "rgb":
        kind = rng.choice(["u1", "u2", "f4", "f2"])
    bands = {"rgb": rng.choice([3, 3, 4]), "separated": 4}.get(photometric, rng.choice([1, 1, 1, 2, 3]) if photometric == "minisblack" else 1)
    width, height = rng.randint(1, 40), rng.randint(1, 40)
    shape = (height, width) if bands == 1 else (height, width, bands)
    if kind == "bool":
        photometric, bands, shape = rng.choice(["minisblack", "miniswhite"]), 1, (height, width)
        values = noise.integers(0, 2, shape).astype(bool)
    elif kind[0] in "fc":
        values = noise.normal(0, 100, shape).astype(kind)
    else:
        info = np.iinfo(kind)
        values = noise.integers(info.min, info.max, shape, dtype=kind, endpoint=True)
    compression = rng.choice([None, None, "adobe_deflate", "deflate", "lzw", "packbits", "zstd", "lzma", "lerc", "jpeg"])
    if photometric == "palette" and compression == "jpeg":
        compression = None
    predictor = compression in ("adobe_deflate", "deflate", "lzw", "zstd") and kind not in ("bool", "c8", "u8") and rng.random() < 0.5
    options = {"photometric": photometric, "compression": compression, "byteorder": rng.choice("<>"), "bigtiff": rng.random() < 0.2,
               "metadata": None, "predictor": (3 if kind[0] == "f" else 2) if predictor else None}
    what = [kind, photometric, f"{bands} bands", f"{compression}"] + ["predictor"] * bool(predictor) + ["big endian"] * (options["byteorder"] == ">")
    if bands > 1 and rng.random() < 0.4:
        options["planarconfig"] = "separate"
        values = np.moveaxis(values, 2, 0)
        what.append("planar")
    if bands in (2, 4) and photometric in ("minisblack", "rgb"):
        options["extrasamples"] = [rng.choice(["unspecified", "assocalpha", "unassalpha"])]
        what.append(options["extrasamples"][0])
    elif photometric == "minisblack" and bands == 3:
        options["extrasamples"] = ["unspecified"] * 2
    if photometric == "palette":
        options["colormap"] = noise.integers(0, 65536, (3, 256 if kind == "u1" else 65536)).astype(np.uint16)
    if kind != "bool" and rng.random() < 0.3:
        options["tile"] = (16 * rng.randint(1, 2), 16 * rng.randint(1, 2))
        what.append("tiles")
    elif rng.random() < 0.6:
        options["rowsperstrip"] = rng.randint(1, height)
    odd = rng.choice([""] * 5 + ["orientation", "orientation", "pages", "reduced copy first", "cut off", "bytes after the end", "range", "resolution"])
    if odd == "orientation":
        number = rng.randrange(10)
        what.append(f"orientation {number}")
        options["extratags"] = [(274, 3, 1, number, True)]
    if odd == "range":
        options["extratags"] = [(280, 3, 1, 10, True), (281, 3, 1, 100, True)]
    if odd == "resolution":
        options["resolution"] = (100, 200)
    stream = BytesIO()
    with tifffile.TiffWriter(stream, bigtiff=options.pop("bigtiff"), byteorder=options.pop("byteorder")) as writer:
        if odd == "reduced copy first":
            writer.write(np.zeros((4, 4), np.uint8), subfiletype=1, metadata=None)
        writer.write(values, **options)
        if odd == "pages":
            writer.write(np.zeros((4, 4), np.uint8), metadata=None)
    data = stream.getvalue()
    if odd == "cut off":
        data = data[: rng.randint(8, len(data))]
    if odd == "bytes after the end":
        data += b"more"
    return data, what + [odd] * bool(odd)


def packed_tiff(rng, noise):
    """A TIFF of samples that are no whole bytes, in one strip, which may fill its bytes from the lowest bit."""
    bits, order = rng.choice([1, 2, 4, 6, 10, 12, 14]), rng.choice([1, 1, 2])
    width, height, white = rng.randint(1, 30), rng.randint(1, 30), rng.randrange(2)
    samples = noise.integers(0, 1 << bits, (height, width))
    digits = (samples[:, :, None] >> np.arange(bits)[::-1]) & 1
    rows = np.packbits(digits.reshape(height, -1).astype(np.uint8), axis=1)
    if order == 2:
        rows = np.packbits(np.unpackbits(rows.reshape(-1, 1), axis=1)[:, ::-1], axis=1)
    strip = rows.tobytes()
    tags = [(256, width), (257, height), (258, bits), (259, 1), (262, white), (266, order), (273, 8), (277, 1), (278, height), (279, len(strip))]
    left_out = rng.choice([None] * 6 + [262, 277, 278, 279])
    tags = [(tag, value) for tag, value in tags if tag != left_out]
    directory = struct.pack("<H", len(tags)) + b"".join(struct.pack("<HHII", tag, 4, 1, value) for tag, value in tags) + bytes(4)
    strip += bytes(len(strip) % 2)
    data = b"II*\0" + struct.pack("<I", 8 + len(strip)) + strip + directory
    return data, [f"{bits} bit", f"photometric {white}", f"fill order {order}"] + [f"without tag {left_out}"] * bool(left_out)


def turned(values, number):
    """The picture as an orientation of EXIF or TIFF shows it."""
    turn = {2: lambda v: v[:, ::-1], 3: lambda v: v[::-1, ::-1], 4: lambda v: v[::-1], 5: lambda v: np.swapaxes(v, 0, 1),
            6: lambda v: np.rot90(v, -1), 7: lambda v: np.swapaxes(v[::-1, ::-1], 0, 1), 8: lambda v: np.rot90(v, 1)}
    return turn.get(number, lambda v: v)(values)


def read_tiff(data):
    with tifffile.TiffFile(BytesIO(data)) as file:
        page = next(page for page in file.pages if not page.subfiletype & 1)
        values, bits = page.asarray(), page.bitspersample
        photometric, extra, kind = int(page.photometric), page.extrasamples, values.dtype.kind
        if page.planarconfig == 2 and values.ndim == 3:
            values = np.moveaxis(values, 0, 2)
        if kind == "c":
            raise ValueError("complex samples")
        white = (1 << bits) - 1 if kind in "ub" and bits <= 16 else 0
        # Decoders of JPEG differ in their rounding, and in what they put between samples of colour.
        off = (16 if values.ndim == 3 else 4) / 255 if page.compression == 7 else 0
        values = values.reshape(*values.shape[:2], -1)
        if page.compression == 7 and photometric == 1 and values.shape[2] == 3:
            # Decoders differ in whether JPEG has mixed bands that are no colours: any value will do.
            off = 2
        if photometric == 3:
            values, white, photometric = np.moveaxis(page.colormap[:, values[:, :, 0]], 0, 2), 65535, 2
        values = values.astype(np.float64)
        if photometric == 0 and white:
            values[:, :, 0] = white - values[:, :, 0]
        orientation = page.tags.get("Orientation")
        values = turned(values, orientation.value if orientation else 1)
    bands, opacity = values.shape[2], bool(extra) and int(extra[0]) in (1, 2)
    names = {(0, 1): "y", (1, 1): "y", (2, 3): "rgb"}.get((photometric, bands))
    if opacity:
        names = {(0, 2): "ya", (1, 2): "ya", (2, 4): "rgba"}.get((photometric, bands), names)
    names = names or [f"band{band + 1}" for band in range(bands)]
    return [[name, white, off] for name in names], values


COMPRESSIONS = ["NO", "RLE", "ZIPS", "ZIP", "PIZ", "PXR24", "B44", "B44A", "DWAA", "DWAB", "HTJ2K256", "ZSTD"]
LOSSY = {"PXR24": 1e-6, "DWAA": 1e-3, "DWAB": 1e-3}


def make_exr(rng, noise):
    compression = rng.choice(COMPRESSIONS[:10] * 3 + COMPRESSIONS[10:])
    width, height = rng.randint(1, 40), rng.randint(1, 40)
    what = [compression]

    def part(name):
        channels = {}
        names = rng.choice([["Y"], ["R", "G", "B"], ["A", "R", "G", "B"], ["Z"], ["height"], ["Y", "A"], ["diffuse.R", "diffuse.G", "diffuse.B"],
                            ["N.x", "N.y", "N.z"], ["id"], ["r", "R"], ["Y", "Z", "id"]])
        types = rng.choice(["f2", "f4", "u4", "mixed"])
        for channel in names:
            kind = rng.choice(["f2", "f4", "u4"]) if types == "mixed" else types
            values = noise.integers(0, 1 << 32, (height, width)) if kind == "u4" else noise.normal(1, 2, (height, width))
            if kind != "u4" and rng.random() < 0.05:
                values.flat[rng.randrange(values.size)] = rng.choice([np.nan, np.inf])
                what.append("not finite")
            channels[channel] = values.astype(kind)
        what.append(f"{types} {' '.join(names)}")
        header = {"compression": getattr(OpenEXR, compression + "_COMPRESSION"), "type": OpenEXR.scanlineimage}
        if rng.random() < 0.3:
            tile = OpenEXR.TileDescription()
            tile.xSize, tile.ySize = rng.randint(1, 32), rng.randint(1, 32)
            header |= {"type": OpenEXR.tiledimage, "tiles": tile}
            what.append("tiles")
        header |= window
        if rng.random() < 0.15:
            header["lineOrder"] = OpenEXR.DECREASING_Y
            what.append("decreasing lines")
        return OpenEXR.Part(header, channels, name)

    window, odd = {}, rng.choice([""] * 5 + ["other display window", "moved windows", "pixel aspect", "cut off", "bytes after the end"])
    corners = lambda left, top, right, bottom: (np.array([left, top], np.int32), np.array([right, bottom], np.int32))
    if odd == "other display window":
        left, top = rng.randint(-9, 9), rng.randint(-9, 9)
        window = {"dataWindow": corners(left, top, left + width - 1, top + height - 1), "displayWindow": corners(0, 0, width + 4, height + 4)}
    if odd == "moved windows":
        window = {name: corners(-7, 5, width - 8, height + 4) for name in ("dataWindow", "displayWindow")}
    if odd == "pixel aspect":
        window = {"pixelAspectRatio": 2.0}
    parts = [part(f"part{at}") for at in range(rng.choice([1, 1, 1, 1, 2]))]
    path = scratch / "written.exr"
    with OpenEXR.File(parts) as file:
        file.write(str(path))
    data = path.read_bytes()
    if odd == "cut off":
        data = data[: rng.randint(8, len(data))]
    if odd == "bytes after the end":
        data += b"more"
    return data, what + [f"{len(parts)} parts"] * (len(parts) > 1) + [odd] * bool(odd)


def read_exr(data):
    path = scratch / "read.exr"
    path.write_bytes(data)
    with OpenEXR.File(str(path), separate_channels=True) as file:
        channels, planes = [], []
        for part in file.parts:
            off = next((off for name, off in LOSSY.items() if name in str(part.compression())), 0)
            for name, channel in part.channels.items():
                channels.append([f"{part.name()}.{name}" if len(file.parts) > 1 else name, 0, off])
                planes.append(channel.pixels.astype(np.float64))
    return channels, np.dstack(planes)


FORMATS = [("png", make_png, read_png), ("tif", lambda *a: (packed_tiff if a[0].random() < 0.15 else make_tiff)(*a), read_tiff), ("exr", make_exr, read_exr)]

warnings.simplefilter("ignore")
logging.disable(logging.CRITICAL)
# OpenEXR prints its warnings among the answers.
answers = os.fdopen(os.dup(1), "w")
os.dup2(2, 1)
scratch, seed, count = Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
print(json.dumps({name: version(name) for name in ["pillow", "tifffile", "OpenEXR"]}), file=answers)
for number in range(seed, seed + count):
    rng, noise = random.Random(number), np.random.default_rng(number)
    extension, make, read = FORMATS[number % 3]
    try:
        data, what = make(rng, noise)
    except Exception as error:
        # A pair of settings that the peer does not write.
        print(json.dumps({"unmade": f"{extension}: {error}"}), file=answers)
        continue
    file = scratch / f"{number}.{extension}"
    file.write_bytes(data)
    answer = {"file": file.name, "what": ", ".join(what)}
    try:
        channels, values = read(data)
        values.transpose(2, 0, 1).astype("<f8").tofile(f"{file}.samples")
        answer |= {"size": [values.shape[1], values.shape[0]], "channels": channels}
    except Exception as error:
        answer["error"] = f"{type(error).__name__}: {error}"
    print(json.dumps(answer), file=answers)
