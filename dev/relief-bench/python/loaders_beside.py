"""Textures that were written for engines, read by OpenImageIO and pygltflib, and what three.js sampled of
them, beside the maps that they were made from.

The argument is a file of JSON: the maps, what was written for each engine, and the answer of three.js. Each
check is made again with a change in what was read; a change that is not noticed is a failure, too.
"""

import hashlib
import json
import os
import sys

import numpy as np
import OpenImageIO as oiio
import pygltflib

job = json.load(open(sys.argv[1]))


# Texels as they are in the file. Otherwise OpenImageIO multiplies colours by alpha, although in a mask map alpha is
# smoothness.
AS_STORED = oiio.ImageSpec()
AS_STORED["oiio:UnassociatedAlpha"] = 1


def read(path):
    source = oiio.ImageInput.open(path, AS_STORED)
    if not source:
        raise SystemExit(f"OpenImageIO: {path}: {oiio.geterror()}")
    spec = source.spec()
    texels = source.read_image(0, 0, 0, spec.nchannels, spec.format)
    source.close()
    return np.asarray(texels).reshape(spec.height, spec.width, spec.nchannels)


HEIGHTS, COLOR, ORM = (read(job["maps"][name]) for name in ("height", "color", "orm"))
LAST = 65535


def normals(green):
    """Normals of the heights by central differences in double precision, for a green up or down."""
    heights = HEIGHTS[:, :, 0].astype(float) / LAST
    rows, columns = heights.shape
    along_u = (np.roll(heights, -1, 1) - np.roll(heights, 1, 1)) * columns / 2 * job["scale"]
    along_v = (np.roll(heights, -1, 0) - np.roll(heights, 1, 0)) * rows / 2 * job["scale"]
    found = np.stack([-along_u, green * along_v, np.ones_like(along_u)], -1)
    return found / np.linalg.norm(found, axis=-1, keepdims=True)


def is_right(texture, texels):
    """Whether a file's texels are what its table says that they hold."""
    holds, bits, green = texture["holds"], texture["bits"], texture["green"]
    if texels.dtype != {8: np.uint8, 16: np.uint16}[bits] or texels.shape[:2] != HEIGHTS.shape[:2]:
        return False
    most = 2**bits - 1
    if holds == "base colour":
        return texels.shape == COLOR.shape and bool((texels == COLOR).all())
    if holds == "normals":
        off = np.abs(texels[:, :, :3] / most * 2 - 1 - normals(1 if green == "+y" else -1)).max()
        return bool(off <= 1.01 / most + 1e-4)
    if holds.startswith(("heights", "depths")):
        heights = HEIGHTS[:, :, 0].astype(float) / LAST
        if holds.startswith("depths"):
            heights = 1 - heights
        return texels.shape[2] == 1 and bool((np.abs(texels[:, :, 0] - heights * most) <= 0.5 + 1e-6).all())
    parts = {"occlusion": ORM[:, :, 0], "roughness": ORM[:, :, 1], "metalness": ORM[:, :, 2]}
    parts["smoothness"] = 255 - ORM[:, :, 1]
    for part in holds.split(", "):
        value, channel = part.split(" in ")
        place = ["red", "green", "blue", "opacity"].index(channel)
        if place >= texels.shape[2] or not (texels[:, :, place] == parts[value]).all():
            return False
    return True


def swap(texels, order):
    """The channels in another order; those that are missing stay so."""
    return texels[:, :, [place for place in order if place < texels.shape[2]]]


def one_off(texels):
    changed = texels.copy()
    changed[7, 7] ^= 4
    return changed


def flip_green(texels):
    changed = texels.copy()
    changed[:, :, 1] = np.iinfo(texels.dtype).max - changed[:, :, 1]
    return changed


CHANGES = {
    "upside down": lambda holds, texels: texels[::-1],
    "mirrored": lambda holds, texels: texels[:, ::-1],
    "one texel": lambda holds, texels: one_off(texels),
    "first two channels swapped": lambda holds, texels: swap(texels, [1, 0, 2, 3]),
    "green flipped": lambda holds, texels: flip_green(texels) if holds == "normals" else None,
    "inverted": lambda holds, texels: np.iinfo(texels.dtype).max - texels,
    "8 bits in 16": lambda holds, texels: texels >> 8 << 8 if texels.dtype == np.uint16 else None,
}

rows, unnoticed = [], []
for engine in job["engines"]:
    for texture in engine["textures"]:
        path = os.path.join(engine["folder"], texture["file"])
        texels = read(path)
        noticed = tried = 0
        for name, change in CHANGES.items():
            changed = change(texture["holds"], texels)
            if changed is None or np.array_equal(changed, texels):
                continue
            tried += 1
            if is_right(texture, changed):
                unnoticed.append(f"{texture['file']}: {name}")
            else:
                noticed += 1
        is_fine = is_right(texture, texels)
        rows.append(["OpenImageIO", engine["name"], texture["file"], is_fine, f"{noticed} of {tried}"])


def image(gltf, slot):
    return None if slot is None else gltf.images[gltf.textures[slot.index].source].uri


def material_is_right(gltf, folder, ending):
    """Whether a glTF file's only material names the files of the table, which are there."""
    material = gltf.materials[0]
    metallic_roughness = material.pbrMetallicRoughness
    found = [
        image(gltf, metallic_roughness.baseColorTexture),
        image(gltf, metallic_roughness.metallicRoughnessTexture),
        image(gltf, material.occlusionTexture),
        image(gltf, material.normalTexture),
    ]
    wanted = [ending["base colour"], ending["surface"], ending["surface"], ending["normals"]]
    factors = [metallic_roughness.metallicFactor, metallic_roughness.roughnessFactor, *metallic_roughness.baseColorFactor]
    there = all(os.path.isfile(os.path.join(folder, one.uri)) for one in [*gltf.images, *gltf.buffers])
    lengths = all(one.byteLength == os.path.getsize(os.path.join(folder, one.uri)) for one in gltf.buffers)
    return found == wanted and all(factor == 1 for factor in factors) and there and lengths


def by_content(engine):
    names = {}
    for texture in engine["textures"]:
        kind = texture["holds"] if texture["holds"] in ("base colour", "normals") else None
        kind = kind or ("height" if texture["holds"].startswith(("heights", "depths")) else "surface")
        names[kind] = texture["file"]
    return names


for engine in job["engines"]:
    for file in (name for name in engine["files"] if name.endswith(".gltf")):
        folder = engine["folder"]
        gltf = pygltflib.GLTF2().load(os.path.join(folder, file))
        is_fine = material_is_right(gltf, folder, by_content(engine))
        changed = pygltflib.GLTF2().load(os.path.join(folder, file))
        changed.materials[0].normalTexture.index = changed.materials[0].occlusionTexture.index
        notices = not material_is_right(changed, folder, by_content(engine))
        if not notices:
            unnoticed.append(f"{file}: another normal map")
        rows.append(["pygltflib", engine["name"], file, is_fine, f"{int(notices)} of 1"])

# What three.js sampled: 8 bits in four channels.
three = job["three"]
engine = next(engine for engine in job["engines"] if engine["name"] == "three")
names = by_content(engine)


def sampled(texels, flipped):
    if texels.shape[2] == 1:
        texels = np.repeat(texels, 3, 2)
    full = np.full((*texels.shape[:2], 4), 255, np.uint8)
    full[:, :, : texels.shape[2]] = texels
    # Row 0 of a texture that is flipped is its last.
    full = full[::-1] if flipped else full
    return hashlib.sha256(np.ascontiguousarray(full).tobytes()).hexdigest()


def three_is_right(told, texels, srgb):
    is_same = told["size"] == [HEIGHTS.shape[1], HEIGHTS.shape[0]] and told["srgb"] == srgb
    return is_same and told["sha256"] == sampled(texels, told["flipped"])


SLOTS = [
    ("map", "base colour", True),
    ("normalMap", "normals", False),
    ("roughnessMap", "surface", False),
    ("metalnessMap", "surface", False),
    ("aoMap", "surface", False),
]
told = [(f"GLTFLoader, {slot}", names[kind], three["slots"][slot], srgb) for slot, kind, srgb in SLOTS]
told += [(f"TextureLoader", name, one, False) for name, one in three["lone"].items()]
for reader, name, one, srgb in told:
    texels = read(os.path.join(engine["folder"], name))
    is_fine = one is not None and three_is_right(one, texels, srgb)
    is_fine = is_fine and (reader == "TextureLoader" or one["repeats"])
    changes = [texels[::-1], texels[:, ::-1], one_off(texels)]
    noticed = sum(not three_is_right(one, changed, srgb) for changed in changes) if one else 0
    if noticed < len(changes):
        unnoticed.append(f"{reader}, {name}")
    rows.append([f"three.js, {reader}", "three", name, is_fine, f"{noticed} of {len(changes)}"])
flat = [1, 1, 1, 1, 1, 1, 1]
is_fine = three["type"] == "MeshStandardMaterial" and three["factors"] == flat
is_fine = is_fine and {"normal", "position", "uv"} <= set(three["attributes"])
is_fine = is_fine and np.allclose(three["box"], [[-0.5, 0, -0.5], [0.5, 0, 0.5]], atol=1e-6)
rows.append(["three.js, GLTFLoader", "three", "material and plane", bool(is_fine), "none"])

print(
    json.dumps(
        {
            "versions": {"OpenImageIO": oiio.VERSION_STRING, "renderer": three["renderer"]},
            "rows": rows,
            "unnoticed": unnoticed,
        }
    )
)
