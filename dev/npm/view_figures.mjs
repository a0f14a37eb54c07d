// Times of the page of `relief view` in headless Chromium: to the first picture of a dropped map, and from a
// movement of the pointer to the picture that shows it. Prints JSON.
//
//     node view_figures.mjs PATH/TO/relief PATH/TO/map.png [--browser /usr/bin/chromium] [--frames 300]

import { resolve } from "node:path";
import { parseArgs } from "node:util";
import { setTimeout as pause } from "node:timers/promises";
import { Bench } from "./view/bench.mjs";

const { values: options, positionals } = parseArgs({
    allowPositionals: true,
    options: {
        browser: { type: "string", default: "/usr/bin/chromium" },
        frames: { type: "string", default: "300" },
    },
});
const [relief, map] = positionals.map((path) => resolve(path));
if (!map) {
    const flags = "[--browser PROGRAM] [--frames N]";
    console.error(`usage: node view_figures.mjs PATH/TO/relief PATH/TO/map.png ${flags}`);
    process.exit(2);
}
const frames = Number(options.frames);

/** Keeps in the page what is asked and what is shown, with times. */
function watch() {
    const seen = { drops: [], moves: [], sent: [], shown: [], sizes: [] };
    window.seen = seen;
    addEventListener("drop", () => seen.drops.push(performance.now()), true);
    addEventListener("pointermove", (event) => event.buttons && seen.moves.push(performance.now()), true);
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
    // The number of changes that the next picture shows.
    let revision = 0;
    const { arrayBuffer } = Response.prototype;
    Response.prototype.arrayBuffer = async function () {
        const bytes = await arrayBuffer.call(this);
        const length = new DataView(bytes).getUint32(0, true);
        revision = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length))).revision;
        return bytes;
    };
    const { putImageData } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.putImageData = function (picture, ...place) {
        putImageData.call(this, picture, ...place);
        seen.shown.push({ at: performance.now(), revision });
        seen.sizes.push(picture.width);
    };
}

const part = (sorted, at) => sorted[Math.min(sorted.length - 1, Math.floor(at * sorted.length))];
const rounded = (number) => Math.round(10 * number) / 10;

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

async function dropped(seat) {
    await seat.drop([map], "body");
    const { drops, shown } = await seat.page.evaluate(() => window.seen);
    return rounded(shown.find(({ at }) => at > drops.at(-1)).at - drops.at(-1));
}

async function orbited(seat) {
    const { page } = seat;
    const { mouse } = page;
    await mouse.move(500, 400);
    await mouse.down();
    // Moves at the pace of a hand's pointer, sixty a second.
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

const size = { width: 1280, height: 800 };
const bench = await Bench.open(relief, options.browser);
const figures = {};
const run = async (name, scene, test) => {
    const body = async (seat) => {
        // Of a page without a scene nothing can be drawn.
        seat.mayFail = true;
        await seat.page.setViewport(size);
        // A picture that is on its way while the page is loaded anew would be waited for without end.
        await seat.rest();
        await seat.page.evaluateOnNewDocument(watch);
        await seat.page.reload();
        await seat.rest();
        figures[name] = await test(seat);
    };
    body.scene = scene;
    await bench.run(body);
};
await run("a map of 2048x2048 texels, drop to picture, ms", ["--backend", "cpu"], dropped);
await run("orbit, exact on a plane", ["cobbles.png", "--backend", "cpu"], orbited);
const torus = ["cobbles.png", "--mesh", "torus", "--tile", "6,2", "--backend", "cpu"];
const onTorus = [...torus, "--method", "relief", "--surface", "quadric-vertical"];
await run("orbit, relief on a torus", onTorus, orbited);
await bench.close();
console.log(JSON.stringify(figures, null, 1));
