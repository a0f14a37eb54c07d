#!/usr/bin/env bash
# three.js 0.187.0 darkens metals of roughness 1 by a tenth.
#
# What one expects: since its standard material makes up for the light that facets reflect more than once, a
# white metal of any roughness gives back all light. The factor is 1 + F0 (1 / E - 1), where E is the part
# that facets reflect once. What happens: E is read from a table of 16 x 16 texels, whose centres are at odd
# 32nds of the roughness. Beyond the last one, at 31/32, the table is clamped. E falls fast there: seen
# along the normal, the table has the value for 0.97 at roughness 1, so a white metal gives back 0.89 of the
# light in place of 1. At 31/32 and below the table is right to 2 %.
#
# Shown by the table itself, read as its texture is (linear, clamped to the edge), beside the integral of
# facets after Trowbridge and Reitz with Smith's hidden part. Needs Node and npm. Fails where it is no
# longer so.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
echo '{ "private": true, "type": "module" }' >package.json
npm install --silent --no-audit --no-fund three@0.187.0
cat >probe.js <<'J'
import { DataUtils } from 'three';
import { getDFGLUT } from './node_modules/three/src/renderers/shaders/DFGLUTData.js';

const { data, width, height } = getDFGLUT().image;
const value = (x, y) => [0, 1].map((k) => DataUtils.fromHalfFloat(data[2 * (y * width + x) + k]));

// The part that white facets reflect once, by the table.
function table(roughness, cosine) {
  const clamp = (at, side) => Math.min(Math.max(at, 0), side - 1);
  const [x, y] = [roughness * width - 0.5, cosine * height - 0.5];
  const [i, j] = [Math.floor(x), Math.floor(y)];
  let sum = 0;
  for (const [dx, dy] of [[0, 0], [1, 0], [0, 1], [1, 1]]) {
    const weight = (dx ? x - i : 1 - x + i) * (dy ? y - j : 1 - y + j);
    const [scale, bias] = value(clamp(i + dx, width), clamp(j + dy, height));
    sum += weight * (scale + bias);
  }
  return sum;
}

// The same by the integral, seen along the normal, where all azimuths are alike: facets are drawn by their
// distribution times their cosine.
function integral(roughness) {
  const squared = roughness ** 4;
  const count = 100000;
  let sum = 0;
  for (let k = 0; k < count; k++) {
    const part = (k + 0.5) / count;
    const cosine = Math.sqrt((1 - part) / (1 + (squared - 1) * part));
    const light = 2 * cosine * cosine - 1;
    if (light <= 0) continue;
    const hidden = Math.sqrt(light * light * (1 - squared) + squared);
    // The light over the density: masking of the view along the normal is 1.
    sum += (4 * light * cosine * 0.5) / ((light + hidden) * cosine);
  }
  return sum / count;
}

const given = {};
for (const roughness of [0.5, 0.75, 31 / 32, 1]) {
  const [read, right] = [table(roughness, 1), integral(roughness)];
  given[roughness] = right / read;
  console.log(`roughness ${roughness.toFixed(3)}: table ${read.toFixed(3)}, integral ${right.toFixed(3)}, `
    + `a white metal gives back ${given[roughness].toFixed(3)}`);
}
const near = (a, b, off) => Math.abs(a - b) < off;
const holds = [0.5, 0.75, 31 / 32].every((roughness) => near(given[roughness], 1, 0.02))
  && near(given[1], 0.89, 0.005);
if (!holds) {
  console.error('it is no longer so');
  process.exit(1);
}
J
node probe.js
echo 'as described'
