// A page of the viewer on a static host, and what is seen on it.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { decoded } from "../view/png.mjs";
import { Seat } from "../view/seat.mjs";

/** The path of a map of the project. */
export const data = (name) => fileURLToPath(new URL(`../../../data/${name}`, import.meta.url));

/** The page and what is seen on it. */
export class Web {
    constructor(page, here, relief) {
        Object.assign(this, { page, here, relief, wrong: [] });
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
        const other = new Web(await this.page.browserContext().newPage(), this.here, this.relief);
        await other.open(address);
        return other;
    }

    text(selector) {
        return this.page.$eval(selector, ({ textContent }) => textContent);
    }

    /** Opens files of the folder by the browser's choice of files. */
    async give(...names) {
        const input = await this.page.$("#files-input");
        await input.uploadFile(...names.map((name) => join(this.here, name)));
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
        const [shown, drawn] = [await this.canvas(), this.drawn("same.toml")];
        assert.deepEqual([shown.width, shown.height], [drawn.width, drawn.height]);
        const isSame = shown.bytes.equals(drawn.bytes);
        assert.ok(isSame, "the canvas has other bytes than the PNG of relief render");
        rmSync(join(this.here, "scene.toml"));
    }

    /** The picture that the command draws of a scene of the folder. */
    drawn(scene) {
        const words = ["render", scene, "-q", "-o", "drawn.png", "--backend", "cpu"];
        execFileSync(this.relief, words, { cwd: this.here });
        return decoded(readFileSync(join(this.here, "drawn.png")));
    }
}
