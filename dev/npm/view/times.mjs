// Times of a page: to the first picture of a dropped map, and from a movement of the pointer to
// the picture that shows it.

import { setTimeout as pause } from "node:timers/promises";

/** Keeps in the page what is asked of the program or of the worker, and what is shown, with times. */
export function watch() {
    const seen = { drops: [], moves: [], sent: [], shown: [], sizes: [] };
    window.seen = seen;
    addEventListener("drop", () => seen.drops.push(performance.now()), true);
    addEventListener("pointermove", (event) => event.buttons && seen.moves.push(performance.now()), true);
    // The number of changes that the next picture shows.
    let revision = 0;
    const { fetch } = window;
    window.fetch = async (...asked) => {
        const at = performance.now();
        const answer = await fetch(...asked);
        if (String(asked[0]).includes("apply")) {
            const { revision } = await answer.clone().json();
            if (revision !== undefined) seen.sent.push({ at, revision });
        }
        return answer;
    };
    const { arrayBuffer } = Response.prototype;
    Response.prototype.arrayBuffer = async function () {
        const bytes = await arrayBuffer.call(this);
        const length = new DataView(bytes).getUint32(0, true);
        if (this.url.includes("/picture?")) {
            revision = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length))).revision;
        }
        return bytes;
    };
    const asked = new Map();
    let hasFirst = false;
    window.Worker = class extends Worker {
        constructor(...all) {
            super(...all);
            // The others draw what the first one is told.
            if (hasFirst) return;
            hasFirst = true;
            this.addEventListener("message", ({ data: { id, done } }) => {
                if (done?.about) revision = done.about.revision;
                if (asked.has(id) && done) seen.sent.push({ at: asked.get(id), revision: done.revision });
            });
        }

        postMessage(data, ...rest) {
            if (data.name === "apply") asked.set(data.id, performance.now());
            super.postMessage(data, ...rest);
        }
    };
    const { putImageData } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.putImageData = function (picture, ...place) {
        putImageData.call(this, picture, ...place);
        seen.shown.push({ at: performance.now(), revision });
        seen.sizes.push(picture.width);
    };
}

const part = (sorted, at) => sorted[Math.min(sorted.length - 1, Math.floor(at * sorted.length))];
export const rounded = (number) => Math.round(10 * number) / 10;

/** Milliseconds from each movement to the first picture that shows it. */
function waits({ moves, sent, shown }) {
    const each = moves.map((move) => {
        const change = sent.find(({ at }) => at >= move);
        const shows = ({ at, revision }) => at >= change.at && revision >= change.revision;
        const picture = change && shown.find(shows);
        return picture && picture.at - move;
    });
    return each.filter((wait) => wait !== undefined).sort((a, b) => a - b);
}

/** Milliseconds from the drop of a map to the first picture after it, and to the last. */
export async function dropped(seat, map) {
    await seat.drop([map], "body");
    const { drops, shown } = await seat.page.evaluate(() => window.seen);
    const after = shown.filter(({ at }) => at > drops.at(-1)).map(({ at }) => rounded(at - drops.at(-1)));
    return { "first ms": after[0], "whole ms": after.at(-1) };
}

/** Waits of an orbit by a hand's pointer, sixty movements a second. */
export async function orbited(seat, frames) {
    const { page } = seat;
    const { mouse } = page;
    await mouse.move(500, 400);
    await mouse.down();
    for (let frame = 0; frame < frames; frame += 1) {
        await mouse.move(500 + 200 * Math.sin(frame / 20), 400 + 60 * Math.sin(frame / 33));
        await pause(16);
    }
    await mouse.up();
    await seat.rest();
    const seen = await page.evaluate(() => window.seen);
    const all = waits(seen);
    const during = seen.shown.filter(({ at }) => at > seen.moves[0] && at <= seen.moves.at(-1));
    const seconds = (seen.moves.at(-1) - seen.moves[0]) / 1000;
    const widths = seen.sizes.slice(1, -1).sort((a, b) => a - b);
    return {
        moves: seen.moves.length,
        "p50 ms": rounded(part(all, 0.5)),
        "p95 ms": rounded(part(all, 0.95)),
        "pictures a second": rounded(during.length / seconds),
        "median width": part(widths, 0.5),
    };
}
