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

/** Pixels of the page around a mark that nothing else covers. */
const MARK = 16;

/** The boxes of the views, which give way to the mark. */
const BOXES = ["first", "second"];

/** Numbers that are read in any case. */
const READ = ["height", "depth", "reads", "steps", "error"];

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
    /** Whether a pixel is being brought to the middle. */
    #isCentred = false;
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
        document.addEventListener("keydown", (event) => this.#key(event));
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
        if (this.#isCentred) this.mark([this.#canvas.width >> 1, this.#canvas.height >> 1]);
        this.#isCentred = false;
        // A pixel may have been asked for before.
        this.#next();
    }

    /** @param {KeyboardEvent} event */
    #key({ key, target, defaultPrevented }) {
        const isOfOther = target instanceof Element && target.closest("input, select, dialog, .menu[open]");
        if (key === "Escape" && !defaultPrevented && !isOfOther) this.#unmark();
    }

    /**
     * Marks a pixel and shows its numbers; and the pixel itself, if the divider hides it in the view that is
     * meant.
     * @param {Pixel} pixel
     * @param {number} [view]
     */
    mark(pixel, view) {
        this.#marked = pixel;
        if (view !== undefined) this.#views.reveal((pixel[0] + 0.5) / this.#canvas.width, view);
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
        if (!read) {
            for (const box of BOXES) byId(box).style.translate = "";
            return;
        }
        this.#place(read.at);
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
    }

    /**
     * Puts the mark on a pixel, and what stands over it beside it.
     * @param {Pixel} pixel
     */
    #place([x, y]) {
        const box = shownBox(this.#canvas);
        const [left, top] = [
            box.left + ((x + 0.5) / this.#canvas.width) * box.width,
            box.top + ((y + 0.5) / this.#canvas.height) * box.height,
        ];
        this.#mark.style.left = `${left}px`;
        this.#mark.style.top = `${top}px`;
        const pane = byId("pane").getBoundingClientRect();
        this.#box.classList.toggle("left", left > 0.55 * pane.width && top > 0.55 * pane.height);
        for (const over of BOXES.map(byId)) {
            over.style.translate = "";
            const rect = over.getBoundingClientRect();
            const [x, y] = [pane.left + left, pane.top + top];
            const isBeside = x < rect.left - MARK || x > rect.right + MARK;
            const isOver = !isBeside && y > rect.top - MARK && y < rect.bottom + MARK;
            if (!isOver || this.#marked === null) continue;
            const [wanted, most] = [y + MARK - rect.top, pane.bottom - 10 - rect.bottom];
            over.style.translate = `0 ${Math.max(0, Math.min(wanted, most))}px`;
        }
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
            if (!seen?.hit) return;
            const applied = this.#session.apply({ do: "look-at", point: seen.position_m });
            // What is in the middle is read again.
            this.#isCentred = true;
            await applied;
        } catch (error) {
            this.#isCentred = false;
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
    /** @type {Map<string, string>} */ const all = new Map();
    const { shown } = numbers;
    if (shown && !READ.includes(shown.name)) {
        const value = shown.value === null ? "–" : `${short(shown.value)} ${shown.unit}`;
        all.set(shown.name, value.trim());
    }
    if (!numbers.hit) return all.set("hit", numbers.exact_uv ? "missed" : "none");
    const { uv, height_m, depth_m, reads, steps, error_texels, surface, method } = numbers;
    if (method !== null) all.set("surface", `${surface}, ${method}`);
    all.set("u, v", uv.map((part) => part.toFixed(4)).join(", "));
    if (height_m !== null) all.set("height", `${precise(height_m)} m`);
    all.set("depth", `${precise(depth_m)} m`);
    all.set("reads, steps", `${reads}, ${steps}`);
    if (error_texels !== null) all.set("error", `${short(error_texels)} texels`);
    return all;
}

/**
 * A length in five digits: neighbours differ.
 * @param {number} length
 */
function precise(length) {
    return Math.abs(length) < 1e-4 ? short(length) : `${Number(length.toPrecision(5))}`;
}
