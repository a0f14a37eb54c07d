// Times of the page without a server, in headless Chromium, and of its module in Node. Prints JSON.
//
//     node web_figures.mjs FOLDER PATH/TO/map.png [--browser /usr/bin/chromium] [--frames 300]
//
// The folder holds what `cargo xtask web` writes.

import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { parseArgs } from "node:util";
import { pathToFileURL } from "node:url";
import puppeteer from "puppeteer-core";
import { serve } from "./serve.mjs";
import { Seat } from "./view/seat.mjs";
import { dropped, orbited, rounded, watch } from "./view/times.mjs";

const { values: options, positionals } = parseArgs({
    allowPositionals: true,
    options: {
        browser: { type: "string", default: "/usr/bin/chromium" },
        frames: { type: "string", default: "300" },
    },
});
const [folder, map] = positionals.map((path) => resolve(path));
if (!map) {
    console.error("usage: node web_figures.mjs FOLDER PATH/TO/map.png [--browser PROGRAM] [--frames N]");
    process.exit(2);
}
const figures = {};

/** Milliseconds of a picture by each width of lanes, the least of some in turn. */
async function lanes() {
    const { SceneFiles, initSync } = await import(pathToFileURL(join(folder, "relief_web.js")));
    initSync({ module: readFileSync(join(folder, "relief_web_bg.wasm")) });
    const wish = JSON.stringify({ width: 640, height: 480, part: 1, samples: "one" });
    for (const method of ["exact", "relief", "cone", "occlusion", "parallax-slope"]) {
        const viewers = [];
        for (const width of ["1", "4"]) {
            const files = new SceneFiles();
            files.add("cobbles.png", readFileSync(join(folder, "samples", "cobbles.png")));
            const scene = `height = "cobbles.png"\nscale = 0.1\nmethod = "${method}"\n`;
            files.add("scene.toml", Buffer.from(scene));
            const viewer = files.open("scene.toml", false, width);
            await viewer.picture(wish);
            viewers.push(viewer);
        }
        const least = [Infinity, Infinity];
        for (let turn = 0; turn < 5; turn += 1) {
            for (const [width, viewer] of viewers.entries()) {
                const begun = performance.now();
                (await viewer.picture(wish)).pixels();
                least[width] = Math.min(least[width], performance.now() - begun);
            }
        }
        const [one, four] = least.map(rounded);
        const found = { "ms, one lane": one, "ms, four lanes": four, ratio: rounded(one / four) };
        figures[`module, ${method} at 640x480`] = found;
    }
}

class WebSeat extends Seat {
    async rest() {
        const isThere = () => {
            const isDrawn = document.getElementById("figures").textContent !== "";
            return isDrawn && document.querySelector("canvas").getAttribute("aria-busy") === "false";
        };
        // A whole picture follows a coarse one.
        for (let quiet = 0; quiet < 3; quiet += 1) {
            await new Promise((done) => setTimeout(done, 400));
            await this.page.waitForFunction(isThere, { timeout: 120_000 });
        }
    }
}

async function onThePage() {
    const profile = mkdtempSync(join(tmpdir(), "relief-web-profile-"));
    const args = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"];
    const browser = await puppeteer.launch({ executablePath: options.browser, userDataDir: profile, args });
    const { server, address } = await serve(folder);
    for (const turn of ["first visit", "second visit"]) {
        const page = await browser.newPage();
        await page.setViewport({ width: 1280, height: 800 });
        await page.evaluateOnNewDocument(watch);
        await page.goto(address);
        const seat = new WebSeat(page);
        await seat.rest();
        const { shown } = await page.evaluate(() => window.seen);
        const [first, whole] = [shown[0], shown.at(-1)].map(({ at }) => rounded(at));
        figures[`sample, ${turn}`] = { "first ms": first, "whole ms": whole };
        await page.close();
    }
    for (const cores of [1, 2]) {
        const page = await browser.newPage();
        await page.setViewport({ width: 1280, height: 800 });
        await page.evaluateOnNewDocument(watch);
        await page.evaluateOnNewDocument((cores) => {
            Object.defineProperty(navigator, "hardwareConcurrency", { get: () => cores });
        }, cores);
        await page.goto(address);
        const seat = new WebSeat(page);
        await seat.rest();
        const by = `by ${cores} worker${cores > 1 ? "s" : ""}`;
        figures[`a map of 2048x2048 texels, drop to picture, ${by}`] = await dropped(seat, map);
        // The others get the map in the background.
        await new Promise((done) => setTimeout(done, 5000));
        figures[`orbit of that map, exact, ${by}`] = await orbited(seat, Number(options.frames));
        const text = await page.$eval("#figures", ({ textContent }) => textContent);
        figures[`whole picture of that map, ${by}`] = text;
        await page.close();
    }
    await browser.close();
    server.close();
    rmSync(profile, { recursive: true });
}

await lanes();
await onThePage();
console.log(JSON.stringify(figures, null, 1));
