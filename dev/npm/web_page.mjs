// Opens the page of the viewer on a static host, in headless Chromium: the module draws in a worker.
//
//     node web_page.mjs FOLDER PATH/TO/relief [--browser /usr/bin/chromium]
//
// The folder holds what `cargo xtask web` writes.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
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
        Object.assign(this, { page, here });
        this.canvas = Seat.prototype.canvas;
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
        const input = await web.page.$("#files-input");
        await input.uploadFile(data("bricks.png"));
        await web.page.waitForFunction(() => document.getElementById("name").textContent === "bricks.png");
        await web.rest();
        assert.deepEqual(asked.filter((address) => !address.startsWith("blob:")), []);
        await web.checkSame();
    },

    async axe_finds_nothing_grave_and_nothing_can_be_ended(web) {
        assert.deepEqual(await found(web), []);
        assert.equal(await web.page.$eval('[data-do="end"]', ({ hidden }) => hidden), true);
    },
};

const profile = mkdtempSync(join(tmpdir(), "relief-web-profile-"));
const browser = await puppeteer.launch({
    executablePath: options.browser,
    userDataDir: profile,
    args: [...FLAGS, ...QUIET],
});
const { server, address } = await serve(folder);
let failed = 0;
for (const [name, test] of Object.entries(tests)) {
    const here = mkdtempSync(join(tmpdir(), "relief-web-"));
    for (const map of ["cobbles.png", "cobbles_color.png", "bricks.png"]) cpSync(data(map), join(here, map));
    const page = await browser.newPage();
    const wrong = [];
    page.on("pageerror", (error) => wrong.push(error.stack ?? String(error)));
    page.on("console", (message) => message.type() === "error" && wrong.push(message.text()));
    try {
        await page.setViewport({ width: 620, height: 420 });
        await page.goto(address);
        const web = new Web(page, here);
        await web.rest();
        await test(web);
        assert.deepEqual(wrong, []);
        console.log(`ok      ${name}`);
    } catch (error) {
        failed += 1;
        console.log(`FAILED  ${name}\n${error.stack}\n${wrong.join("\n")}`);
    } finally {
        await page.close();
        rmSync(here, { recursive: true });
    }
}
await browser.close();
server.close();
rmSync(profile, { recursive: true });
process.exit(failed > 0 ? 1 : 0);
