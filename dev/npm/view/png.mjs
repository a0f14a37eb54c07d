// Reads the PNG files that `relief render` writes: eight bits, without palette or interlace.

import { inflateSync } from "node:zlib";

/** Bytes of a texel by PNG's type of colour. */
const CHANNELS = { 0: 1, 2: 3, 4: 2, 6: 4 };

/** Width, height and RGBA bytes of a file. */
export function decoded(file) {
    const chunks = chunksOf(file);
    const head = chunks.find(({ type }) => type === "IHDR").data;
    const [width, height] = [head.readUInt32BE(0), head.readUInt32BE(4)];
    const channels = CHANNELS[head[9]];
    if (head[8] !== 8 || !channels || head[12] !== 0) throw new Error("this kind of PNG is not read");
    const packed = chunks.filter(({ type }) => type === "IDAT").map(({ data }) => data);
    const rows = unfiltered(inflateSync(Buffer.concat(packed)), width * channels, height, channels);
    return { width, height, bytes: rgba(rows, channels) };
}

function chunksOf(file) {
    const chunks = [];
    for (let at = 8; at < file.length; ) {
        const length = file.readUInt32BE(at);
        const type = file.toString("latin1", at + 4, at + 8);
        chunks.push({ type, data: file.subarray(at + 8, at + 8 + length) });
        at += 12 + length;
    }
    return chunks;
}

/** The texels' bytes: each was written as its difference from a guess. */
function unfiltered(raw, stride, height, channels) {
    const out = Buffer.alloc(stride * height);
    for (let y = 0; y < height; y += 1) {
        const filter = raw[y * (stride + 1)];
        for (let x = 0; x < stride; x += 1) {
            const left = x >= channels ? out[y * stride + x - channels] : 0;
            const up = y > 0 ? out[(y - 1) * stride + x] : 0;
            const corner = x >= channels && y > 0 ? out[(y - 1) * stride + x - channels] : 0;
            const guess = [0, left, up, (left + up) >> 1, nearest(left, up, corner)][filter];
            out[y * stride + x] = raw[y * (stride + 1) + 1 + x] + guess;
        }
    }
    return out;
}

/** PNG's fourth guess: the neighbour that is nearest to left + up - corner. */
function nearest(left, up, corner) {
    const [toLeft, toUp, toCorner] = [left, up, corner].map((each) => Math.abs(left + up - corner - each));
    if (toLeft <= toUp && toLeft <= toCorner) return left;
    return toUp <= toCorner ? up : corner;
}

function rgba(bytes, channels) {
    const out = Buffer.alloc((bytes.length / channels) * 4, 255);
    const isGrey = channels < 3;
    for (let texel = 0; texel < bytes.length / channels; texel += 1) {
        for (let channel = 0; channel < 3; channel += 1) {
            out[texel * 4 + channel] = bytes[texel * channels + (isGrey ? 0 : channel)];
        }
        if (channels % 2 === 0) out[texel * 4 + 3] = bytes[texel * channels + channels - 1];
    }
    return out;
}
