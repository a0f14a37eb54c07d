// The views on the canvas: one picture, or two with a divider between them.

/** @import { Drawn, State } from "./protocol.d.ts" */
/** @import { Session } from "./session.js" */

import { byId } from "./elements.js";
import { shownBox } from "./picture.js";
import { controlOf, numberOf } from "./values.js";

/** Part of the width that a press of an arrow key moves the divider by. */
const STEP = 0.02;
/** The part of the width between a place that is revealed and the divider. */
const BESIDE = 0.08;
/** Pixels of the page below which a view has no room for numbers, and the least width of its box. */
const FOLDED = 220;
const LEAST = 72;
/** Colour behind a view that cannot be drawn. */
const NOTHING = "#808080";

/**
 * @typedef {object} Arranged
 * @property {number} count number of views
 * @property {number} divider place of the divider, from 0 to 1
 * @property {boolean} swapped whether the second view is at the left
 */

export class Views {
    #canvas;
    #session;
    #failed;
    /** @type {CanvasRenderingContext2D} */ #context;
    /** @type {(ImageData | null)[]} */ #images = [];
    /** @type {Arranged} */ #arranged = { count: 1, divider: 0.5, swapped: false };
    #divider = byId("divider");
    #held = false;
    /** Number of values that the scene has not answered yet. */
    #onTheirWay = 0;

    /**
     * @param {HTMLCanvasElement} canvas
     * @param {Session} session
     * @param {(error: unknown) => void} failed
     */
    constructor(canvas, session, failed) {
        const context = canvas.getContext("2d", { alpha: false, willReadFrequently: true });
        if (!context) throw new Error("this browser draws no pictures on a canvas");
        this.#canvas = canvas;
        this.#session = session;
        this.#failed = failed;
        this.#context = context;
        session.listen({ state: (state) => this.#arrange(state) });
        this.#listen();
        window.addEventListener("resize", () => this.#place());
    }

    /** @param {Drawn} drawn */
    show({ about, views }) {
        const [width, height] = about.size;
        if (this.#canvas.width !== width) this.#canvas.width = width;
        if (this.#canvas.height !== height) this.#canvas.height = height;
        this.#images = views.map((pixels) => pixels && new ImageData(pixels, width, height));
        this.#arranged = { ...this.#arranged, count: views.length };
        this.#compose();
    }

    /** Exchanges the sides of the views. */
    swap() {
        if (this.#arranged.count < 2) return;
        this.#set("viewer.swapped", !this.#arranged.swapped);
    }

    /** The number of the view that is shown at a place, from 0, at the left, to 1. */
    at(/** @type {number} */ place) {
        const { count, divider, swapped } = this.#arranged;
        return count > 1 && place >= divider !== swapped ? 1 : 0;
    }

    /**
     * Moves the divider, if it hides a place of a view.
     * @param {number} place
     * @param {number} view
     */
    reveal(place, view) {
        const { count, swapped } = this.#arranged;
        if (count < 2 || this.at(place) === view) return;
        const isLeft = (view === 0) !== swapped;
        this.#move(isLeft ? place + BESIDE : place - BESIDE);
        this.#tell();
    }

    /** @param {State} state */
    #arrange({ panel, revision }) {
        const divider = numberOf(controlOf(panel, "viewer.divider")?.value ?? "0.5") ?? 0.5;
        const swapped = controlOf(panel, "viewer.swapped")?.value === "true";
        // A state from before the last move would take it back.
        const isOld = this.#held || this.#onTheirWay > 0 || revision < this.#session.revision;
        const place = isOld ? this.#arranged.divider : divider;
        this.#arranged = { ...this.#arranged, divider: place, swapped };
        this.#compose();
    }

    #compose() {
        if (this.#images.length === 0) return;
        const { count, divider, swapped } = this.#arranged;
        const { width, height } = this.#canvas;
        const split = count > 1 ? Math.round(divider * width) : width;
        const [left, right] = swapped && count > 1 ? [1, 0] : [0, 1];
        this.#put(this.#images[left], 0, split, height);
        if (count > 1) this.#put(this.#images[right], split, width - split, height);
        this.#place();
    }

    /**
     * @param {ImageData | null | undefined} image
     * @param {number} x
     * @param {number} width
     * @param {number} height
     */
    #put(image, x, width, height) {
        if (width <= 0) return;
        if (image) return this.#context.putImageData(image, 0, 0, x, 0, width, height);
        this.#context.fillStyle = NOTHING;
        this.#context.fillRect(x, 0, width, height);
    }

    /** Puts the divider where the canvas is divided. */
    #place() {
        const { count, divider, swapped } = this.#arranged;
        this.#divider.hidden = count < 2;
        this.#placeBoxes();
        byId("pane").classList.toggle("two", count > 1);
        byId("pane").classList.toggle("swapped", count > 1 && swapped);
        if (count < 2) return;
        const box = shownBox(this.#canvas);
        const style = this.#divider.style;
        style.left = `${box.left + divider * box.width}px`;
        style.top = `${box.top}px`;
        style.height = `${box.height}px`;
        this.#divider.setAttribute("aria-valuenow", `${Math.round(100 * divider)}`);
    }

    /** Each box stays within its view, and leaves out its numbers where there is no room. */
    #placeBoxes() {
        const { count, divider, swapped } = this.#arranged;
        const { left, width } = shownBox(this.#canvas);
        [byId("first"), byId("second")].forEach((box, view) => {
            const isLeft = (view === 0) !== swapped;
            const room = isLeft ? left + divider * width : left + (1 - divider) * width;
            const isFolded = count > 1 && room < FOLDED;
            box.classList.toggle("folded", isFolded);
            box.style.setProperty("--room", isFolded ? `${Math.max(room - 20, LEAST)}px` : "100%");
        });
    }

    #listen() {
        const divider = this.#divider;
        divider.addEventListener("pointerdown", (event) => {
            if (event.button !== 0) return;
            event.preventDefault();
            divider.focus({ preventScroll: true });
            divider.setPointerCapture(event.pointerId);
            this.#held = true;
        });
        divider.addEventListener("pointermove", ({ clientX }) => {
            if (!this.#held) return;
            const { left } = byId("pane").getBoundingClientRect();
            const box = shownBox(this.#canvas);
            this.#move((clientX - left - box.left) / box.width);
        });
        for (const end of /** @type {const} */ (["pointerup", "pointercancel"])) {
            divider.addEventListener(end, () => this.#leave());
        }
        divider.addEventListener("keydown", (event) => this.#key(event));
        divider.addEventListener("keyup", () => this.#leave());
        divider.addEventListener("blur", () => this.#leave());
    }

    /** @param {KeyboardEvent} event */
    #key(event) {
        const { divider } = this.#arranged;
        /** @type {Record<string, number>} */
        const places = { ArrowLeft: divider - STEP, ArrowRight: divider + STEP, Home: 0, End: 1 };
        const place = places[event.key];
        if (place === undefined) return;
        event.preventDefault();
        this.#held = true;
        this.#move(place);
    }

    /** @param {number} place */
    #move(place) {
        this.#arranged = { ...this.#arranged, divider: Math.min(Math.max(place, 0), 1) };
        this.#compose();
    }

    /** Tells the scene where the divider was left. */
    #leave() {
        if (!this.#held) return;
        this.#held = false;
        this.#tell();
    }

    #tell() {
        this.#set("viewer.divider", Number(this.#arranged.divider.toFixed(3)));
    }

    /**
     * @param {string} key
     * @param {number | boolean} value
     */
    async #set(key, value) {
        this.#onTheirWay += 1;
        try {
            await this.#session.apply({ do: "set", key, value });
        } catch (error) {
            this.#failed(error);
        } finally {
            this.#onTheirWay -= 1;
        }
    }
}
