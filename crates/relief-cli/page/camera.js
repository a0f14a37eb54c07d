// The camera and the light: what drags, the wheel and keys on the picture ask for.

/** @import { Action } from "./protocol.d.ts" */
/** @import { Session } from "./session.js" */

import { newNumber } from "./shared.js";
import { shownBox } from "./picture.js";

/** Degrees that a drag over the height of the picture turns by. */
const TURN = 180;
/** Degrees, heights of the picture and factor of a press of a key. */
const KEY_TURN = 5;
const KEY_PAN = 0.05;
const KEY_ZOOM = 1.1;
/** Natural logarithm of the factor for a pixel of the wheel, and for a pixel of a pinch on a touchpad. */
const WHEEL = 0.0015;
const PINCH = 0.01;
/** Pixels of a line and of a page of the wheel. */
const LINES = [1, 16, 400];

/** @typedef {"orbit" | "pan" | "light"} Mode */
/** @typedef {{ x: number, y: number }} Point */

/** @type {Record<string, [number, number]>} */
const ARROWS = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

export class Camera {
    #canvas;
    /** @type {Session} */ #session;
    #failed;
    #takesWheel;
    /** @type {Map<number, Point>} */ #pointers = new Map();
    /** @type {number | null} */ #drag = null;
    /** @type {Mode} */ #held = "orbit";
    #lightKey = false;
    /** What plain drags and arrows do. @type {Mode} */
    mode = "orbit";

    /**
     * @param {HTMLCanvasElement} canvas
     * @param {Session} session
     * @param {(error: unknown) => void} failed
     * @param {() => boolean} [takesWheel] whether the wheel zooms; it scrolls the page otherwise
     */
    constructor(canvas, session, failed, takesWheel = () => true) {
        this.#takesWheel = takesWheel;
        this.#canvas = canvas;
        this.#session = session;
        this.#failed = failed;
        canvas.addEventListener("pointerdown", (event) => this.#down(event));
        canvas.addEventListener("pointermove", (event) => this.#move(event));
        for (const end of /** @type {const} */ (["pointerup", "pointercancel", "lostpointercapture"])) {
            canvas.addEventListener(end, (event) => this.#up(event));
        }
        canvas.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
        canvas.addEventListener("contextmenu", (event) => event.preventDefault());
        canvas.addEventListener("keydown", (event) => this.#key(event));
        canvas.addEventListener("keyup", ({ key }) => this.#keyUp(key));
        canvas.addEventListener("blur", () => (this.#lightKey = false));
    }

    /**
     * @param {Action} action
     * @param {number | null} [drag]
     */
    async act(action, drag = null) {
        try {
            await this.#session.apply(action, drag);
        } catch (error) {
            this.#failed(error);
        }
    }

    /**
     * One step to the right and up, as of an arrow key.
     * @param {[number, number]} direction
     * @param {Mode} mode
     */
    step([right, up], mode = this.mode) {
        const drag = this.#session.burst();
        if (mode === "pan") return this.act({ do: "pan", by: [-right * KEY_PAN, -up * KEY_PAN] }, drag);
        return this.act({ do: turn(mode), degrees: [right * KEY_TURN, up * KEY_TURN] }, drag);
    }

    /** @param {number} steps larger, or smaller where negative */
    zoom(steps) {
        return this.act({ do: "zoom", factor: KEY_ZOOM ** steps }, this.#session.burst());
    }

    /** @param {PointerEvent} event */
    #down(event) {
        if (event.button > 2) return;
        // The middle button would scroll the page.
        if (event.button === 1) event.preventDefault();
        this.#canvas.focus({ preventScroll: true });
        this.#canvas.setPointerCapture(event.pointerId);
        this.#pointers.set(event.pointerId, point(event));
        const pans = event.button !== 0 || event.shiftKey;
        this.#held = pans ? "pan" : this.#lightKey ? "light" : this.mode;
        this.#drag ??= newNumber();
        this.#canvas.classList.add("dragged");
    }

    /** @param {PointerEvent} event */
    #move(event) {
        const before = this.#pointers.get(event.pointerId);
        if (!before || this.#drag === null) return;
        const now = point(event);
        const others = [...this.#pointers].filter(([id]) => id !== event.pointerId).map(([, other]) => other);
        this.#pointers.set(event.pointerId, now);
        const other = others[0];
        if (other) this.#twoFingers(before, now, other);
        else this.#dragged(now.x - before.x, now.y - before.y, this.#held, 1);
    }

    /**
     * @param {number} right
     * @param {number} down
     * @param {Mode} mode
     * @param {number} part of the way that counts
     */
    #dragged(right, down, mode, part) {
        if (right === 0 && down === 0) return;
        const [x, y] = [right, down].map((way) => (way * part) / shownBox(this.#canvas).height);
        if (x === undefined || y === undefined) return;
        if (mode === "pan") this.act({ do: "pan", by: [x, -y] }, this.#drag);
        // The surface follows the hand, so the eye goes the other way; the light follows it.
        else if (mode === "orbit") this.act({ do: "orbit", degrees: [-x * TURN, y * TURN] }, this.#drag);
        else this.act({ do: "turn-light", degrees: [x * TURN, -y * TURN] }, this.#drag);
    }

    /**
     * Pans with the middle of two fingers, and zooms with their distance.
     * @param {Point} before
     * @param {Point} now
     * @param {Point} other
     */
    #twoFingers(before, now, other) {
        this.#dragged(now.x - before.x, now.y - before.y, "pan", 0.5);
        const [from, to] = [before, now].map(({ x, y }) => Math.hypot(x - other.x, y - other.y));
        const factor = from && to ? to / from : 1;
        if (factor !== 1) this.act({ do: "zoom", factor }, this.#drag);
    }

    /** @param {PointerEvent} event */
    #up(event) {
        this.#pointers.delete(event.pointerId);
        if (this.#pointers.size > 0) return;
        this.#drag = null;
        this.#canvas.classList.remove("dragged");
    }

    /** @param {WheelEvent} event */
    #wheel(event) {
        if (!this.#takesWheel()) return;
        event.preventDefault();
        const pixels = event.deltaY * (LINES[event.deltaMode] ?? 1);
        // A pinch on a touchpad is said to be a turn of the wheel with the control key.
        const factor = Math.exp(-pixels * (event.ctrlKey ? PINCH : WHEEL));
        if (factor !== 1) this.act({ do: "zoom", factor }, this.#drag ?? this.#session.burst());
    }

    /** @param {KeyboardEvent} event */
    #key(event) {
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        if (this.#pressed(event)) event.preventDefault();
    }

    /**
     * Does what a key asks for. Returns whether it asks for something.
     * @param {KeyboardEvent} event
     */
    #pressed({ key, shiftKey }) {
        const arrow = ARROWS[key];
        if (arrow) this.step(arrow, shiftKey ? "pan" : this.#lightKey ? "light" : this.mode);
        else if (key === "+" || key === "=") this.zoom(1);
        else if (key === "-") this.zoom(-1);
        else if (key.toLowerCase() === "f") this.act({ do: "frame" });
        else if (key === "Home") this.act({ do: "fit" });
        else if (key.toLowerCase() === "l") this.#lightKey = true;
        else if (key === "Escape") this.#leave();
        else return false;
        return true;
    }

    /** @param {string} key */
    #keyUp(key) {
        if (key.toLowerCase() === "l") this.#lightKey = false;
    }

    /** Ends a drag, or takes the focus away from the picture. */
    #leave() {
        const pointers = [...this.#pointers.keys()];
        for (const id of pointers) this.#canvas.releasePointerCapture(id);
        if (pointers.length === 0) this.#canvas.blur();
    }
}

/**
 * @param {Mode} mode
 * @returns {"orbit" | "turn-light"}
 */
function turn(mode) {
    return mode === "light" ? "turn-light" : "orbit";
}

/**
 * @param {PointerEvent} event
 * @returns {Point}
 */
function point({ clientX, clientY }) {
    return { x: clientX, y: clientY };
}
