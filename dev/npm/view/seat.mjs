// What a test does at the page, and what it sees there.

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";

export class Seat {
    constructor(page, program, folder, relief) {
        Object.assign(this, { page, program, folder, relief });
        /** Requests for pictures: all, those on their way, and the most at a time. */
        this.pictures = { all: 0, now: 0, most: 0 };
        this.wrong = [];
        /** Whether the browser may report answers that are errors. */
        this.mayFail = false;
    }

    /** Opens the page and waits for its picture. */
    async sit(address = this.program.address) {
        const { page } = this;
        await page.setViewport({ width: 1100, height: 760 });
        page.setDefaultTimeout(60_000);
        page.on("pageerror", (error) => this.wrong.push(error.stack ?? String(error)));
        page.on("console", (message) => {
            if (message.type() === "error") this.wrong.push(message.text());
        });
        this.#count();
        await page.goto(address);
        await this.rest();
    }

    #count() {
        const { page, pictures } = this;
        const isPicture = (request) => new URL(request.url()).pathname.endsWith("/picture");
        page.on("request", (request) => {
            if (!isPicture(request)) return;
            pictures.all += 1;
            pictures.now += 1;
            pictures.most = Math.max(pictures.most, pictures.now);
        });
        for (const end of ["requestfinished", "requestfailed"]) {
            page.on(end, (request) => (pictures.now -= Number(isPicture(request))));
        }
    }

    /** The page must not have met errors of its own, such as breaches of the content policy. */
    checkQuiet() {
        const answered = (text) => /Failed to load resource/.test(text);
        const wrong = this.wrong.filter((text) => !(this.mayFail && answered(text)));
        assert.deepEqual(wrong, []);
    }

    /** Waits until nothing is asked any more. */
    async rest() {
        await this.page.waitForNetworkIdle({ idleTime: 500, timeout: 120_000 });
    }

    state() {
        return this.page.evaluate(() => fetch("state").then((answer) => answer.json()));
    }

    async undoable() {
        return (await this.state()).undo;
    }

    /** The scene as a file. */
    async scene() {
        const { saves } = await this.state();
        const scene = saves.find(({ what }) => what.endsWith(".toml"));
        assert.ok(scene, `no scene among ${JSON.stringify(saves)}`);
        return this.page.evaluate(
            (what) => fetch(`save?what=${encodeURIComponent(what)}`).then((answer) => answer.text()),
            scene.what,
        );
    }

    /** Writes the scene beside the maps. Returns its path. */
    async savedScene() {
        const path = join(this.folder, "saved.toml");
        writeFileSync(path, await this.scene());
        return path;
    }

    /** Width, height and bytes of the canvas; of one in the shadow of a host, if one is named. */
    async canvas(host = null) {
        const { width, height, bytes } = await this.page.evaluate((host) => {
            const root = host === null ? document : document.querySelector(host).shadowRoot;
            const canvas = root.querySelector("canvas");
            const { width, height } = canvas;
            const { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
            let text = "";
            for (const byte of data) text += String.fromCharCode(byte);
            return { width, height, bytes: btoa(text) };
        }, host);
        return { width, height, bytes: Buffer.from(bytes, "base64") };
    }

    /** All controls of the panel, with the surface's first. */
    async controls() {
        const { panel } = await this.state();
        return [...panel.surfaces.flat(), ...panel.scene];
    }

    async control(key) {
        return (await this.controls()).find((control) => control.key === key);
    }

    /** The element of a control, on its tab and in its open group. */
    async row(key) {
        await this.page.evaluate((key) => {
            const row = document.querySelector(`[data-key="${key}"]`);
            row.closest("details.group").open = true;
            document.getElementById(row.closest("[role=tabpanel]").getAttribute("aria-labelledby")).click();
            row.scrollIntoView({ block: "center" });
        }, key);
        return this.page.$(`[data-key="${key}"]`);
    }

    /** Enters a text in the field of a control, as by hand. */
    async type(key, text, field = "input:not([type=range], [type=file], [hidden])") {
        const input = await (await this.row(key)).$(field);
        await input.click({ count: 3 });
        await input.press("Backspace");
        await input.type(text);
        await input.press("Enter");
        await this.rest();
    }

    async click(selector) {
        await this.page.locator(selector).click();
        await this.rest();
    }

    /** Drags on the picture by pixels, in steps. */
    async drag([right, down], steps = 12, button = "left") {
        const { mouse } = this.page;
        const { x, y, width, height } = await (await this.page.$("canvas")).boundingBox();
        const [fromX, fromY] = [x + width / 2, y + height / 2];
        await mouse.move(fromX, fromY);
        await mouse.down({ button });
        await mouse.move(fromX + right, fromY + down, { steps });
        await mouse.up({ button });
        await this.rest();
    }

    /** The texts of the errors that are shown. */
    errors() {
        return this.page.$$eval("#errors .message p", (found) => found.map(({ textContent }) => textContent));
    }

    /** Drops files of the disk on an element. */
    async drop(paths, selector) {
        const client = await this.page.createCDPSession();
        const element = await this.page.$(selector);
        const { x, y } = await element.clickablePoint();
        const data = { items: [], files: paths, dragOperationsMask: 1 };
        for (const type of ["dragEnter", "dragOver", "drop"]) {
            await client.send("Input.dispatchDragEvent", { type, x, y, data });
        }
        await client.detach();
        await this.rest();
    }
}
