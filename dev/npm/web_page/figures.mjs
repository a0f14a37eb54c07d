// Figures in a page of another project.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { found } from "../view/axe.mjs";
import { data } from "./web.mjs";

/** The scene of figures: its size is the picture's, so that both can be compared. */
const FIGURE = `height = "cobbles.png"
method = "relief"
scale = 0.2
size = [200, 150]
samples = 1
`;

/** A page of another project, whose policy allows what figures need and no more. */
function figures() {
    const policy = [
        "default-src 'none'",
        "img-src 'self'",
        "style-src 'self'",
        "script-src 'self' 'wasm-unsafe-eval'",
        "worker-src 'self'",
        "connect-src 'self' blob:",
    ].join("; ");
    const names = ["wall", "wall", "wall", "wall", "wall", "none"];
    const controls = "method, search.steps";
    const each = names.map((name, at) => `<relief-figure scene="scenes/${name}.toml"
controls="${at === 4 ? "metod" : controls}">
<img src="wall.png" width="200" height="150" alt="Cobbles"></relief-figure>`);
    return `<!doctype html><html lang="en"><head><title>Figures</title>
<meta http-equiv="Content-Security-Policy" content="${policy}">
<script type="module" src="/relief/relief-figure.js"></script></head>
<body><main><h1>Figures</h1>${each.join("\n")}</main></body></html>`;
}

/** Files of that project, besides those of the viewer. */
export const served = new Map([
    ["/docs/figures.html", figures()],
    ["/docs/scenes/wall.toml", FIGURE.replace("cobbles", "../maps/cobbles")],
    ["/docs/maps/cobbles.png", readFileSync(data("cobbles.png"))],
    ["/docs/wall.png", readFileSync(data("bricks.png"))],
]);

export async function figures_are_stills_until_they_are_started(web) {
    const asked = [];
    web.page.on("request", (request) => asked.push(new URL(request.url()).pathname));
    await web.page.goto(new URL("/docs/figures.html", web.page.url()).href);
    await web.page.waitForFunction(() => document.querySelectorAll("relief-figure").length === 6);
    await new Promise((done) => setTimeout(done, 300));
    const heavy = (path) => /\.wasm$|worker|\.toml$/.test(path);
    assert.deepEqual(asked.filter(heavy), [], "a figure loads something before it is started");
    const figure = (number) => `relief-figure:nth-of-type(${number})`;
    const canvas = async (number) => {
        await web.page.waitForFunction(
            (figure) => {
                const frame = document.querySelector(figure).shadowRoot.querySelector(".frame.live");
                return frame?.querySelector("canvas").getAttribute("aria-busy") === "false";
            },
            { timeout: 60_000 },
            figure(number),
        );
        await new Promise((done) => setTimeout(done, 600));
        return web.canvas(figure(number));
    };
    for (const number of [1, 3]) await (await web.page.$(`${figure(number)} >>> .start`)).click();
    const drawn = (text) => {
        writeFileSync(join(web.here, "figure.toml"), text);
        return web.drawn("figure.toml");
    };
    for (const number of [1, 3]) {
        assert.ok((await canvas(number)).bytes.equals(drawn(FIGURE).bytes), `figure ${number}`);
    }
    assert.equal(asked.filter((path) => path.endsWith(".wasm")).length, 1, "one download");
    assert.equal(web.page.workers().length, 1, "one worker");
    // A control changes its own figure alone.
    await (await web.page.$(`${figure(1)} >>> select`)).select("cone");
    await new Promise((done) => setTimeout(done, 500));
    const cone = drawn(FIGURE.replace("relief", "cone"));
    assert.ok((await canvas(1)).bytes.equals(cone.bytes), "the method");
    assert.ok((await canvas(3)).bytes.equals(drawn(FIGURE).bytes), "another figure changed");
    // Arrows turn it; a figure without a scene says so and keeps its picture.
    await web.page.keyboard.press("Tab");
    await (await web.page.$(`${figure(3)} >>> canvas`)).focus();
    await web.page.keyboard.press("ArrowLeft");
    await new Promise((done) => setTimeout(done, 500));
    assert.ok(!(await canvas(3)).bytes.equals(drawn(FIGURE).bytes), "the figure was not turned");
    await (await web.page.$(`${figure(3)} >>> .back`)).click();
    await new Promise((done) => setTimeout(done, 500));
    assert.ok((await canvas(3)).bytes.equals(drawn(FIGURE).bytes), "it does not go back");
    for (const number of [5, 6]) await (await web.page.$(`${figure(number)} >>> .start`)).click();
    const said = (figure) => {
        const { shadowRoot } = document.querySelector(figure);
        return [...shadowRoot.querySelectorAll("[role=alert]")].map(({ textContent }) => textContent).join("");
    };
    // Changes in a shadow are seen by looking again alone.
    for (const [number, text] of [[5, /no control named metod/], [6, /none.toml.*404/]]) {
        await web.page.waitForFunction(said, { polling: 100 }, figure(number));
        assert.match(await web.page.evaluate(said, figure(number)), text);
    }
    const breaches = web.wrong.filter((text) => !/404/.test(text));
    assert.deepEqual(breaches, [], "the page's policy forbids something that figures do");
    assert.deepEqual(await found(web), []);
    // The checker itself sets styles.
    web.wrong = [];
}
