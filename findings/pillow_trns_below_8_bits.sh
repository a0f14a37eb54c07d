#!/usr/bin/env bash
# Pillow 13.0.0 compares the transparent grey of a PNG below 8 bits with samples that it has widened.
#
# What one expects: the chunk tRNS of a grey PNG names one sample in the file's own depth, 0 to 3 for 2 bits
# (PNG specification, third edition, 11.3.1.1). All texels with this sample are transparent.
# What happens: Pillow widens 2-bit samples to 0, 85, 170, 255 and keeps the
# chunk's number as it is. With the sample 1 nothing becomes transparent; with 3 nothing does either. Only 0,
# which widening leaves alone, works. A file of 8 bits works throughout.
#
# Shown with a row of the four samples, for each transparent sample, in 2 and 8 bits, beside pypng 0.20220715.0,
# which follows the specification. Needs Python 3 and pip. Fails where it is no longer so.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet pillow==13.0.0 pypng==0.20220715.0
cd "$folder"
"$folder/venv/bin/python" - <<'P'
import png
from PIL import Image

def opacities(bits, transparent):
    samples = list(range(4))
    with open("row.png", "wb") as file:
        png.Writer(4, 1, greyscale=True, bitdepth=bits, transparent=transparent).write(file, [samples])
    pillow = list(Image.open("row.png").convert("LA").getchannel("A").get_flattened_data())
    rows = png.Reader("row.png").asRGBA8()[2]
    return pillow, list(list(rows)[0])[3::4]

wrong = {}
for bits in (2, 8):
    for transparent in range(4):
        pillow, pypng = opacities(bits, transparent)
        assert pypng == [0 if at == transparent else 255 for at in range(4)], pypng
        print(f"{bits} bits, transparent {transparent}: Pillow {pillow}, pypng {pypng}")
        wrong[bits, transparent] = pillow != pypng
assert [key for key in wrong if wrong[key]] == [(2, 1), (2, 2), (2, 3)], wrong
P
echo 'as described'
