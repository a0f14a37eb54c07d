#!/usr/bin/env bash
# three.js 0.187.0 takes the layers of an uncompressed KTX2 array, and the faces of a cube, for one picture.
#
# What one expects: its loader returns a texture with as many layers or faces as the file has, as it does for
# compressed files (CompressedArrayTexture, CompressedCubeTexture) and for volumes (Data3DTexture); or it refuses
# the file. What happens: it returns a plain DataTexture of one layer's width and height, whose data holds all
# layers. There is neither an error nor a warning.
#
# The files are written by ktx-parse 1.1.0, which three.js reads them with, too, and read back here first: they have
# the layers and faces. Needs Node and npm. Fails where it is no longer so.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
echo '{ "private": true, "type": "module" }' >package.json
npm install --silent --no-audit --no-fund three@0.187.0 ktx-parse@1.1.0
cat >probe.js <<'J'
import { createDefaultContainer, read, write } from 'ktx-parse';
import { KTX2Loader } from 'three/examples/jsm/loaders/KTX2Loader.js';

const [SIDE, R8G8B8A8_UNORM] = [2, 37];

// A file of pictures of one grey each.
function file({ layers = 0, faces = 1, depth = 0 }) {
  const pictures = Math.max(layers, 1) * faces * Math.max(depth, 1);
  const bytes = SIDE * SIDE * 4;
  const data = new Uint8Array(bytes * pictures);
  for (let k = 0; k < pictures; k++) data.fill(10 * (k + 1), k * bytes, (k + 1) * bytes);
  const container = createDefaultContainer();
  Object.assign(container, {
    vkFormat: R8G8B8A8_UNORM, typeSize: 1, pixelWidth: SIDE, pixelHeight: SIDE, pixelDepth: depth,
    layerCount: layers, faceCount: faces, levelCount: 1,
    levels: [{ levelData: data, uncompressedByteLength: data.length }],
  });
  Object.assign(container.dataFormatDescriptor[0], {
    colorModel: 1, colorPrimaries: 1, transferFunction: 1, texelBlockDimension: [0, 0, 0, 0],
    bytesPlane: [4, 0, 0, 0, 0, 0, 0, 0],
    samples: [0, 1, 2, 15].map((channelType, k) => ({
      bitOffset: 8 * k, bitLength: 7, channelType, samplePosition: [0, 0, 0, 0], sampleLower: 0, sampleUpper: 255,
    })),
  });
  return write(container);
}

const loader = new KTX2Loader();
loader.workerConfig = {};
async function loaded(what) {
  const bytes = file(what);
  const back = read(bytes);
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  const texture = await new Promise((resolve, reject) => loader.parse(buffer, resolve, reject));
  const { width, height, depth, data } = texture.image;
  console.log(`layers ${back.layerCount}, faces ${back.faceCount}, depth ${back.pixelDepth}: ${texture.constructor.name} `
    + `of ${width}x${height}${depth ? `x${depth}` : ''}, ${data.length} bytes`);
  return [texture.constructor.name, depth, data.length];
}

const found = [await loaded({}), await loaded({ depth: 3 }), await loaded({ layers: 3 }), await loaded({ faces: 6 })];
const expected = [
  ['DataTexture', undefined, 16], ['Data3DTexture', 3, 48], ['DataTexture', undefined, 48], ['DataTexture', undefined, 96],
];
if (JSON.stringify(found) !== JSON.stringify(expected)) {
  console.error('it is no longer so');
  process.exit(1);
}
process.exit(0);
J
node probe.js
echo 'as described'
