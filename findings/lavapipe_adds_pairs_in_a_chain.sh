#!/usr/bin/env bash
# Mesa 22.3.6's lavapipe adds four products, (x + y) + (z + w), as ((z + w) + x) + y, under wgpu 0.32.0 for Python.
#
# What one expects: each sum is rounded as the brackets say, as on a CPU, since lavapipe runs on one and computes as
# IEEE 754 says. WGSL lets compilers take another order, but sums of plain numbers, and sums of products in a chain,
# ((x + y) + z) + w, keep theirs. What happens: where x to w are products of random numbers, three sums in ten differ
# from the brackets' in the last bits, and all of them equal the other order, to the bit. So who wants a GPU's bits to
# be a CPU's must add products in a chain.
#
# Needs Python with venv, and lavapipe (Debian 12: mesa-vulkan-drivers 22.3.6). Fails where it is no longer so.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export XDG_RUNTIME_DIR=$folder
python3 -m venv python
python/bin/pip install --quiet wgpu==0.32.0 numpy==2.2.6
cat >probe.py <<'P'
import sys
import numpy as np
import wgpu
from wgpu.utils.compute import compute_with_buffers

adapters = wgpu.gpu.enumerate_adapters_sync()
if not any("llvmpipe" in adapter.info["device"] for adapter in adapters):
    sys.exit("there is no lavapipe on this machine")
info = wgpu.utils.get_default_device().adapter.info
print(f"wgpu {wgpu.__version__}, {info['device']}, {info['description']}")

COUNT = 1 << 16
random = np.random.default_rng(1)
first, second = (random.random((COUNT, 4), dtype=np.float32) * 2 - 1 for _ in range(2))
SHADER = """
@group(0) @binding(0) var<storage, read> first: array<vec4f>;
@group(0) @binding(1) var<storage, read> second: array<vec4f>;
@group(0) @binding(2) var<storage, read_write> sums: array<vec3f>;
@compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3u) {
    let n = first[id.x];
    let p = n * second[id.x];
    sums[id.x] = vec3f((p.x + p.y) + (p.z + p.w), ((p.x + p.y) + p.z) + p.w, (n.x + n.y) + (n.z + n.w));
}
"""
out = compute_with_buffers({0: first, 1: second}, {2: (COUNT * 4, "f")}, SHADER, n=(COUNT // 64, 1, 1))
# A vec3f takes the room of four numbers.
pairs, chain, plain, _ = np.frombuffer(out[2], dtype=np.float32).reshape(COUNT, 4).T
a, b, c, d = first.T
x, y, z, w = (first * second).T
differ = {
    "products in pairs, from the brackets' order": np.mean(pairs != (x + y) + (z + w)),
    "products in pairs, from ((z + w) + x) + y": np.mean(pairs != ((z + w) + x) + y),
    "products in a chain, from the brackets' order": np.mean(chain != ((x + y) + z) + w),
    "plain numbers in pairs, from the brackets' order": np.mean(plain != (a + b) + (c + d)),
}
for name, part in differ.items():
    print(f"{name}: {part:.3f} differ")
in_pairs, *others = differ.values()
sys.exit(0 if in_pairs > 0.1 and not any(others) else "it is no longer so")
P
python/bin/python probe.py
echo 'as described'
