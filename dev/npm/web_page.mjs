// Opens the page of the viewer on a static host, in headless Chromium: the module draws in a worker.
//
//     node web_page.mjs FOLDER PATH/TO/relief [--browser /usr/bin/chromium]
//
// The folder holds what `cargo xtask web` writes.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { parseArgs } from "node:util";
import { fileURLToPath } from "node:url";
import puppeteer from "puppeteer-core";
import { serve } from "./serve.mjs";
import { found } from "./view/axe.mjs";
import { decoded } from "./view/png.mjs";
import { Seat } from "./view/seat.mjs";

const { values: options, positionals } = parseArgs({
    allowPositionals: true,
    options: { browser: { type: "string", default: "/usr/bin/chromium" } },
});
const [folder, relief] = positionals.map((path) => resolve(path));
if (!folder || !relief) {
    console.error("usage: node web_page.mjs FOLDER PATH/TO/relief [--browser PROGRAM]");
    process.exit(2);
}

const data = (name) => fileURLToPath(new URL(`../../data/${name}`, import.meta.url));
const FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"];
const QUIET = ["--disable-background-networking", "--disable-component-update", "--disable-sync"];

/** The page and what is seen on it. */
class Web {
    constructor(page, here) {
        Object.assign(this, { page, here, wrong: [] });
        this.canvas = Seat.prototype.canvas;
        page.on("pageerror", (error) => this.wrong.push(error.stack ?? String(error)));
        page.on("console", (message) => message.type() === "error" && this.wrong.push(message.text()));
    }

    /** Opens an address. */
    async open(address) {
        await this.page.setViewport({ width: 620, height: 420 });
        await this.page.goto(address);
    }

    /** Another page of the same browser, at an address. */
    async another(address) {
        const other = new Web(await this.page.browserContext().newPage(), this.here);
        await other.open(address);
        return other;
    }

    text(selector) {
        return this.page.$eval(selector, ({ textContent }) => textContent);
    }

    /** Opens a file of the folder by the browser's choice of files. */
    async give(name) {
        const input = await this.page.$("#files-input");
        await input.uploadFile(join(this.here, name));
    }

    /** The address with a link to the scene. */
    async link() {
        await this.page.evaluate(() => document.getElementById("copy-link").click());
        await this.page.waitForFunction(() => location.hash !== "");
        return this.page.url();
    }

    /** Waits until a whole picture of what was asked for is shown. */
    async rest(before = "") {
        const isThere = (before) => {
            const text = document.getElementById("figures").textContent;
            const canvas = document.querySelector("canvas");
            return text !== before && text !== "" && canvas.getAttribute("aria-busy") === "false";
        };
        await this.page.waitForFunction(isThere, { timeout: 120_000 }, before);
        // A coarse picture comes before the whole one.
        await new Promise((done) => setTimeout(done, 400));
        await this.page.waitForFunction(isThere, { timeout: 120_000 }, "");
    }

    /** A file that the page saves. */
    async saved(what) {
        const client = await this.page.createCDPSession();
        await client.send("Browser.setDownloadBehavior", {
            behavior: "allow",
            downloadPath: this.here,
            eventsEnabled: true,
        });
        const ended = new Promise((done) => {
            client.on("Browser.downloadProgress", ({ state }) => state === "completed" && done());
        });
        await this.page.evaluate((what) => document.querySelector(`[data-what="${what}"]`).click(), what);
        await ended;
        await client.detach();
        return readFileSync(join(this.here, what));
    }

    /** Whether the canvas has the bytes that the command draws of the saved scene. */
    async checkSame() {
        const text = (await this.saved("scene.toml")).toString();
        writeFileSync(join(this.here, "same.toml"), text);
        const words = ["render", "same.toml", "-q", "-o", "same.png", "--backend", "cpu"];
        execFileSync(relief, words, { cwd: this.here });
        const [shown, drawn] = [await this.canvas(), decoded(readFileSync(join(this.here, "same.png")))];
        assert.deepEqual([shown.width, shown.height], [drawn.width, drawn.height]);
        const isSame = shown.bytes.equals(drawn.bytes);
        assert.ok(isSame, "the canvas has other bytes than the PNG of relief render");
        rmSync(join(this.here, "scene.toml"));
    }
}

const tests = {
    async the_canvas_has_the_bytes_of_relief_render(web) {
        await web.checkSame();
        const { x, y, width, height } = await (await web.page.$("canvas")).boundingBox();
        const { mouse } = web.page;
        await mouse.move(x + width / 2, y + height / 2);
        await mouse.down();
        await mouse.move(x + width / 2 + 60, y + height / 2 + 20, { steps: 8 });
        await mouse.up();
        await web.rest();
        await new Promise((done) => setTimeout(done, 500));
        await web.rest();
        await web.checkSame();
    },

    async files_stay_in_the_browser(web) {
        const asked = [];
        web.page.on("request", (request) => asked.push(request.url()));
        await web.give("bricks.png");
        await web.page.waitForFunction(() => document.getElementById("name").textContent === "bricks.png");
        await web.rest();
        assert.deepEqual(asked.filter((address) => !address.startsWith("blob:")), []);
        await web.checkSame();
    },

    async the_first_map_takes_the_places_of_the_sample(web) {
        await web.give("bricks.png");
        await web.rest();
        const text = (await web.saved("scene.toml")).toString();
        assert.match(text, /^height = "bricks.png"/m);
        assert.doesNotMatch(text, /^color = /m);
        const field = await web.page.$eval('[data-key="height"] input', ({ value }) => value);
        assert.equal(field, "bricks.png");
    },

    async a_link_shows_the_same_on_another_page(web) {
        await web.give("bricks.png");
        await web.rest();
        await web.page.click('[data-do="compare"]');
        await web.rest();
        const link = await web.link();
        assert.ok(link.includes("#s=1&") && !link.includes("cobbles"), link);
        const other = await web.another(link);
        await other.page.waitForSelector("#empty:not([hidden])");
        assert.match(await other.text("#empty-why"), /needs bricks.png/);
        // A file of that name with another content is none of the link's.
        mkdirSync(join(web.here, "other"));
        cpSync(data("cobbles.png"), join(web.here, "other", "bricks.png"));
        await other.give("other/bricks.png");
        await other.page.waitForSelector("#errors .message");
        assert.match(await other.text("#errors"), /another content/);
        await other.give("bricks.png");
        await other.rest();
        assert.ok((await other.canvas()).bytes.equals((await web.canvas()).bytes), "another picture");
        assert.deepEqual(other.wrong, []);
        await other.page.close();
    },

    async a_link_that_cannot_be_used_leaves_what_is_there(web) {
        const sample = await web.canvas();
        const address = (await web.link()).split("#")[0];
        for (const [end, said] of [
            ["s=1&height=cobbles.png", /not whole/],
            ["s=9&height=cobbles.png&end", /version 9/],
            ["s=1&height=none.png&end", /no such sample/],
            [`s=1&height=${"a".repeat(1 << 20)}&end`, /1048\d+ characters/],
        ]) {
            const other = await web.another(`${address}#${end}`);
            await other.rest();
            assert.match(await other.text("#errors"), said);
            assert.ok((await other.canvas()).bytes.equals(sample.bytes), "the sample is not shown");
            await other.page.close();
        }
        // A link that is entered on an open page is one step.
        await web.page.evaluate(() => (location.hash = "#s=1&height=cobbles.png&method=cone&scale=0.4&end"));
        await web.page.waitForSelector('[data-do="undo"][aria-disabled="false"]');
        await web.rest();
        assert.ok(!(await web.canvas()).bytes.equals(sample.bytes), "the link is not followed");
        await web.page.click('[data-do="undo"]');
        await web.page.waitForSelector('[data-do="undo"][aria-disabled="true"]');
        await web.rest();
        assert.ok((await web.canvas()).bytes.equals(sample.bytes), "it is not undone");
    },

    async figures_are_stills_until_they_are_started(web) {
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
            execFileSync(relief, ["render", "figure.toml", "-q", "-o", "figure.png"], { cwd: web.here });
            return decoded(readFileSync(join(web.here, "figure.png")));
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
        await (await web.page.$(`${figure(6)} >>> .start`)).click();
        const said = (figure) => {
            const { shadowRoot } = document.querySelector(figure);
            return shadowRoot.querySelector("[role=alert]").textContent;
        };
        // Changes in a shadow are seen by looking again alone.
        await web.page.waitForFunction(said, { polling: 100 }, figure(6));
        assert.match(await web.page.evaluate(said, figure(6)), /none.toml.*404/);
        const breaches = web.wrong.filter((text) => !/404/.test(text));
        assert.deepEqual(breaches, [], "the page's policy forbids something that figures do");
        assert.deepEqual(await found(web), []);
        // The checker itself sets styles.
        web.wrong = [];
    },

    async a_module_that_does_not_come_is_named(web) {
        const other = new Web(await web.page.browserContext().newPage(), web.here);
        await other.page.setRequestInterception(true);
        other.page.on("request", (request) => {
            if (request.url().endsWith(".wasm")) request.respond({ status: 503, body: "" });
            else request.continue();
        });
        await other.open(web.page.url());
        await other.page.waitForSelector("#empty:not([hidden])");
        assert.match(await other.text("#empty-why"), /cannot be loaded: the server answered 503/);
        await other.page.close();
    },

    async axe_finds_nothing_grave_and_nothing_can_be_ended(web) {
        assert.deepEqual(await found(web), []);
        assert.equal(await web.page.$eval('[data-do="end"]', ({ hidden }) => hidden), true);
    },
};

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
    const each = names.map((name) => `<relief-figure scene="scenes/${name}.toml" controls="${controls}">
<img src="wall.png" width="200" height="150" alt="Cobbles"></relief-figure>`);
    return `<!doctype html><html lang="en"><head><title>Figures</title>
<meta http-equiv="Content-Security-Policy" content="${policy}">
<script type="module" src="/relief/relief-figure.js"></script></head>
<body><main><h1>Figures</h1>${each.join("\n")}</main></body></html>`;
}

/** Checks the types of the page as it is served. */
function types() {
    const config = join(mkdtempSync(join(tmpdir(), "relief-types-")), "tsconfig.json");
    const base = fileURLToPath(new URL("../../crates/relief-cli/page/jsconfig.json", import.meta.url));
    const lib = ["es2023", "dom", "dom.iterable"];
    const all = { extends: base, compilerOptions: { lib }, include: [`${folder}/*.js`, `${folder}/*.d.ts`] };
    const exclude = ["relief_web.js", "worker.js"].map((name) => `${folder}/${name}`);
    writeFileSync(config, JSON.stringify({ ...all, exclude }));
    const compiler = fileURLToPath(new URL("node_modules/typescript/bin/tsc", import.meta.url));
    execFileSync(process.execPath, [compiler, "-p", config, "--noEmit"], { stdio: "inherit" });
}

types();
const profile = mkdtempSync(join(tmpdir(), "relief-web-profile-"));
const browser = await puppeteer.launch({
    executablePath: options.browser,
    userDataDir: profile,
    args: [...FLAGS, ...QUIET],
});
const more = new Map([
    ["/docs/figures.html", figures()],
    ["/docs/scenes/wall.toml", FIGURE.replace("cobbles", "../maps/cobbles")],
    ["/docs/maps/cobbles.png", readFileSync(data("cobbles.png"))],
    ["/docs/wall.png", readFileSync(data("bricks.png"))],
]);
const { server, address } = await serve(folder, 0, more);
let failed = 0;
for (const [name, test] of Object.entries(tests)) {
    const here = mkdtempSync(join(tmpdir(), "relief-web-"));
    for (const map of ["cobbles.png", "cobbles_color.png", "bricks.png"]) cpSync(data(map), join(here, map));
    const web = new Web(await browser.newPage(), here);
    try {
        await web.open(address);
        await web.rest();
        await test(web);
        assert.deepEqual(web.wrong, []);
        console.log(`ok      ${name}`);
    } catch (error) {
        failed += 1;
        console.log(`FAILED  ${name}\n${error.stack}\n${web.wrong.join("\n")}`);
    } finally {
        await web.page.close();
        rmSync(here, { recursive: true });
    }
}
await browser.close();
server.close();
rmSync(profile, { recursive: true });
process.exit(failed > 0 ? 1 : 0);
