// Times of the page of `relief view` in headless Chromium: to the first picture of a dropped map, and from a
// movement of the pointer to the picture that shows it. Prints JSON.
//
//     node view_figures.mjs PATH/TO/relief PATH/TO/map.png [--browser /usr/bin/chromium] [--frames 300]

import { resolve } from "node:path";
import { parseArgs } from "node:util";
import { Bench } from "./view/bench.mjs";
import { dropped, orbited, watch } from "./view/times.mjs";

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
await run("a map of 2048x2048 texels, drop to picture", ["--backend", "cpu"], (seat) => dropped(seat, map));
const orbit = (seat) => orbited(seat, frames);
await run("orbit, exact on a plane", ["cobbles.png", "--backend", "cpu"], orbit);
const torus = ["cobbles.png", "--mesh", "torus", "--tile", "6,2", "--backend", "cpu"];
const bent = [...torus, "--method", "relief", "--surface", "quadric-vertical"];
await run("orbit, relief on a torus", bent, orbit);
await bench.close();
console.log(JSON.stringify(figures, null, 1));
