#!/usr/bin/env bash
# tiff-core 0.10.0 and naga 30.0.1 cannot be in one Cargo project once tiff-core reads 16-bit floats.
#
# What one expects: a feature adds code. What happens: tiff-core's feature `f16` asks for `half` below 2.5, naga
# for 2.5 and later. Both versions have the same major number, so Cargo takes one of them for the whole project,
# and there is none. Without the feature, or without naga, the same project resolves.
#
# So a program that draws with wgpu 30 and reads TIFF through tiff-reader 0.10, which stands on tiff-core, has to
# decode 16-bit floats itself.
#
# Needs cargo and a registry. Fails where this is no longer so.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir src
echo 'fn main() {}' >src/main.rs

# Whether a project with these dependencies resolves; what cargo says is left in `said`.
resolves() {
    rm -f Cargo.lock
    printf '[package]\nname = "probe"\nversion = "0.0.0"\nedition = "2021"\n[dependencies]\n%s\n' "$1" >Cargo.toml
    cargo generate-lockfile >said 2>&1
}

with_f16='tiff-core = { version = "=0.10.0", features = ["f16"] }'
without='tiff-core = "=0.10.0"'
naga='naga = "=30.0.1"'

fail() { echo "changed: $1"; cat said; exit 1; }
resolves "$with_f16" || fail 'tiff-core with f16 does not resolve by itself'
resolves "$without
$naga" || fail 'tiff-core and naga do not resolve without f16'
if resolves "$with_f16
$naga"; then fail 'tiff-core with f16 and naga resolve together'; fi
grep -q 'failed to select a version for `half`' said || fail 'it fails for another reason'
grep -E 'half' said
echo 'as described'
