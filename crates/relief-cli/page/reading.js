// The numbers of the pixel under the pointer, or of one that is marked, in each view.

/** @import { Host, PixelNumbers, ReadPixel } from "./protocol.d.ts" */
/** @import { Session } from "./session.js" */
/** @import { Views } from "./views.js" */

import { byId, element } from "./elements.js";
import { short } from "./figures.js";
import { arranges, shownBox } from "./picture.js";
import { Gone, Outdated } from "./shared.js";

/** Pixels of the page that a press may move by and be a click. */
const CLICK = 4;

/** @typedef {[number, number]} Pixel */

export class Reading {
    #canvas;
    #host;
    #session;
    #views;
    #failed;
    #box = byId("reading");
    #mark = byId("mark");
    /** @type {Pixel | null} */ #marked = null;
    /** @type {Pixel | null} */ #wanted = null;
    /** @type {ReadPixel | null} */ #read = null;
    #asking = false;
    #resting = false;
    /** @type {Pixel | null} */ #pressed = null;
    /** @type {(string | null)[]} */ #methods = [];

    /**
     * @param {HTMLCanvasElement} canvas
     * @param {Host} host
     * @param {Session} session
     * @param {Views} views
     * @param {(error: unknown) => void} failed
     */
    constructor(canvas, host, session, views, failed) {
        this.#canvas = canvas;
        this.#host = host;
        this.#session = session;
        this.#views = views;
        this.#failed = failed;
        session.listen({ changed: (keys) => keys.every(arranges) || this.#gone() });
        window.addEventListener("resize", () => this.#gone());
        canvas.addEventListener("pointermove", (event) => event.buttons === 0 && this.#over(event));
        canvas.addEventListener("pointerleave", () => this.#ask(this.#marked));
        canvas.addEventListener("pointerdown", ({ clientX, clientY }) => {
            this.#pressed = [clientX, clientY];
        });
        canvas.addEventListener("click", (event) => this.#click(event));
        canvas.addEventListener("dblclick", (event) => this.#centre(this.#pixelOf(event), event));
        canvas.addEventListener("keydown", ({ key }) => key === "Escape" && this.#unmark());
        byId("unmark").addEventListener("click", () => this.#unmark());
        byId("centre").addEventListener("click", () => this.#centre(this.#marked));
    }

    /**
     * A picture at rest is shown: its pixels can be read.
     * @param {(string | null)[]} methods
     */
    rested(methods) {
        this.#methods = methods;
        this.#resting = true;
    }

    /**
     * Marks a pixel and shows its numbers.
     * @param {Pixel} pixel
     */
    mark(pixel) {
        this.#marked = pixel;
        this.#ask(pixel);
    }

    #unmark() {
        this.#marked = null;
        this.#ask(null);
    }

    /** What was read belongs to another picture. */
    #gone() {
        this.#resting = false;
        this.#unmark();
    }

    /** @param {MouseEvent} event */
    #over(event) {
        if (this.#resting && !this.#marked) this.#ask(this.#pixelOf(event));
    }

    /** @param {MouseEvent} event */
    #click(event) {
        const [x, y] = this.#pressed ?? [0, 0];
        const isDrag = Math.hypot(event.clientX - x, event.clientY - y) > CLICK;
        const pixel = this.#pixelOf(event);
        if (this.#resting && !isDrag && pixel) this.mark(pixel);
    }

    /**
     * The pixel of the picture at a place of the page.
     * @param {MouseEvent} event
     * @returns {Pixel | null}
     */
    #pixelOf({ clientX, clientY }) {
        const pane = byId("pane").getBoundingClientRect();
        const box = shownBox(this.#canvas);
        const x = Math.floor(((clientX - pane.left - box.left) / box.width) * this.#canvas.width);
        const y = Math.floor(((clientY - pane.top - box.top) / box.height) * this.#canvas.height);
        const isIn = x >= 0 && y >= 0 && x < this.#canvas.width && y < this.#canvas.height;
        return isIn ? [x, y] : null;
    }

    /**
     * Reads a pixel now, or after the one that is being read; null: shows none.
     * @param {Pixel | null} pixel
     */
    #ask(pixel) {
        this.#wanted = pixel;
        if (!pixel) this.#show(null);
        this.#next();
    }

    async #next() {
        const pixel = this.#wanted;
        if (this.#asking || !pixel || !this.#resting) return;
        this.#asking = true;
        this.#wanted = null;
        try {
            const read = await this.#host.pixel(pixel);
            const isWanted = this.#resting && (this.#marked === null || same(this.#marked, pixel));
            if (isWanted) this.#show(read);
        } catch (error) {
            if (error instanceof Gone) this.#session.met(error);
            else if (!(error instanceof Outdated)) this.#failed(error);
        } finally {
            this.#asking = false;
            this.#next();
        }
    }

    /** @param {ReadPixel | null} read */
    #show(read) {
        this.#read = read;
        this.#box.hidden = read === null;
        byId("reading-buttons").hidden = this.#marked === null;
        this.#mark.hidden = read === null || this.#marked === null;
        if (!read) return;
        const [x, y] = read.at;
        byId("reading-at").textContent = `Pixel ${x}, ${y}`;
        const columns = read.views.map((numbers) => lines(numbers));
        const names = [...new Set(columns.flatMap((column) => [...column.keys()]))];
        const head = element(
            "tr",
            {},
            element("td", {}),
            ...read.views.map((_, number) => element("th", { scope: "col" }, this.#methods[number] ?? "")),
        );
        const rows = names.map((name) =>
            element(
                "tr",
                {},
                element("th", { scope: "row" }, name),
                ...columns.map((column) => element("td", {}, column.get(name) ?? "–")),
            ),
        );
        byId("reading-table").replaceChildren(...(read.views.length > 1 ? [head, ...rows] : rows));
        const box = shownBox(this.#canvas);
        this.#mark.style.left = `${box.left + ((x + 0.5) / this.#canvas.width) * box.width}px`;
        this.#mark.style.top = `${box.top + ((y + 0.5) / this.#canvas.height) * box.height}px`;
    }

    /**
     * Brings what is seen at a pixel to the middle of the picture.
     * @param {Pixel | null} pixel
     * @param {MouseEvent} [event]
     */
    async #centre(pixel, event) {
        if (!pixel || !this.#resting) return;
        try {
            const isRead = this.#read && same(this.#read.at, pixel);
            const read = isRead ? this.#read : await this.#host.pixel(pixel);
            const own = read?.views[this.#views.at(pixel[0] / this.#canvas.width)];
            const seen = [own, ...(read?.views ?? [])].find((numbers) => numbers?.hit);
            if (seen?.hit) await this.#session.apply({ do: "look-at", point: seen.position_m });
        } catch (error) {
            if (!(error instanceof Outdated)) this.#failed(error);
        }
        event?.preventDefault();
    }
}

/**
 * @param {Pixel} a
 * @param {Pixel} b
 */
function same(a, b) {
    return a[0] === b[0] && a[1] === b[1];
}

/**
 * The numbers of a pixel by name.
 * @param {PixelNumbers | null} numbers
 * @returns {Map<string, string>}
 */
function lines(numbers) {
    if (!numbers) return new Map();
    if (!numbers.hit) return new Map([["hit", numbers.exact_uv ? "missed" : "none"]]);
    const { uv, height_m, depth_m, reads, steps, error_texels } = numbers;
    const all = new Map([["u, v", uv.map((part) => part.toFixed(4)).join(", ")]]);
    if (height_m !== null) all.set("height", `${short(height_m)} m`);
    all.set("depth", `${short(depth_m)} m`);
    all.set("reads, steps", `${reads}, ${steps}`);
    if (error_texels !== null) all.set("error", `${short(error_texels)} texels`);
    return all;
}
