// The picture: asks for frames only when something has changed, one at a time.

/** @import { AboutPicture, Drawn, Host, Wish } from "./protocol.d.ts" */
/** @import { Session } from "./session.js" */

import { Gone, Outdated } from "./shared.js";

/** Milliseconds of a whole picture above which a coarse one comes first. */
const SLOW = 300;
/** Milliseconds that a frame of a moving view may take. */
const FRAME = 1000 / 30;
/** The least and the greatest factor on both sides of a picture. */
const PARTS = [0.25, 1];
/** Steps of the factor, so that it does not flicker. */
const STEPS = 16;

/**
 * The factor after a frame with a factor took some milliseconds.
 * @param {number} part
 * @param {number} took
 */
export function nextPart(part, took) {
    const wanted = part * Math.sqrt(FRAME / Math.max(took, 1));
    // One slow frame, such as the first after a bake, must not decide alone.
    const near = clamped(wanted, 0.7 * part, 1.2 * part);
    return clamped(Math.round(near * STEPS) / STEPS, ...PARTS);
}

/**
 * @param {number} number
 * @param {number} [least]
 * @param {number} [most]
 */
function clamped(number, least = -Infinity, most = Infinity) {
    return Math.min(Math.max(number, least), most);
}

/**
 * @typedef {object} PictureParts
 * @property {HTMLCanvasElement} canvas
 * @property {HTMLElement} pane
 * @property {Host} host
 * @property {Session} session
 * @property {{ show: (drawn: Drawn) => void }} views
 * @property {{ during: <T>(request: Promise<T>) => Promise<T> }} messages
 * @property {(about: AboutPicture) => void} rested a picture of a view at rest is shown
 * @property {(why: string | null) => void} drawable says why nothing can be drawn
 */

export class Picture {
    /** @type {PictureParts} */ #parts;
    #size = { width: 0, height: 0 };
    #wanted = true;
    #asking = false;
    #quick = false;
    #part = 0.5;
    #gone = false;
    /** Whether whole pictures take long, as the first one may. */
    #slow = true;
    /** Whether a coarse picture of what is wanted has been shown. */
    #coarse = false;

    /** @param {PictureParts} parts */
    constructor(parts) {
        this.#parts = parts;
        const { session } = parts;
        session.holdDragsWhile(() => this.#asking && this.#quick);
        session.listen({
            changed: (keys) => keys.every(arranges) || this.ask(),
            rested: () => this.ask(),
            gone: (gone) => (this.#gone = gone),
        });
        this.#watchSize();
    }

    /** Asks for a frame, now or after the one that is on its way. */
    ask() {
        this.#wanted = true;
        this.#coarse = false;
        this.#draw();
    }

    async #draw() {
        if (this.#asking || this.#gone || !this.#wanted || this.#size.width === 0) return;
        [this.#asking, this.#wanted] = [true, false];
        try {
            await this.#frame();
        } catch (error) {
            this.#failed(error);
        } finally {
            this.#asking = false;
            this.#parts.session.flush();
            this.#draw();
        }
    }

    async #frame() {
        const { host, session, messages, canvas } = this.#parts;
        const isFirst = this.#slow && !this.#coarse && !session.moving;
        this.#quick = session.moving || isFirst;
        const wish = this.#wish();
        const begun = performance.now();
        canvas.setAttribute("aria-busy", "true");
        const drawn = await messages.during(host.picture(wish));
        canvas.setAttribute("aria-busy", "false");
        const took = performance.now() - begun;
        if (!this.#quick) this.#slow = took > SLOW;
        else if (!isFirst) this.#part = nextPart(this.#part, took);
        // The whole one follows, unless the scene changes meanwhile.
        if (isFirst) [this.#coarse, this.#wanted] = [true, true];
        this.#show(drawn, wish);
        session.saw(drawn.about.revision);
    }

    /** @returns {Wish} */
    #wish() {
        const [part, samples] = this.#quick
            ? [this.#part, /** @type {const} */ ("one")]
            : [1, /** @type {const} */ ("all")];
        return { ...this.#size, part, samples };
    }

    /**
     * @param {Drawn} drawn
     * @param {Wish} wish
     */
    #show(drawn, wish) {
        const { canvas, views, drawable, rested } = this.#parts;
        const { about } = drawn;
        canvas.classList.toggle("own-size", !fills(about.size, wish));
        views.show(drawn);
        drawable(null);
        if (!this.#quick) rested(about);
    }

    /** @param {unknown} error */
    #failed(error) {
        this.#parts.canvas.setAttribute("aria-busy", "false");
        if (error instanceof Outdated) this.#wanted = true;
        else if (error instanceof Gone) this.#parts.session.met(error);
        else this.#parts.drawable(error instanceof Error ? error.message : String(error));
    }

    /**
     * @param {number} width
     * @param {number} height
     */
    #resize(width, height) {
        if (width === this.#size.width && height === this.#size.height) return;
        this.#size = { width, height };
        this.ask();
    }

    /** Asks for another picture when the pane has another size in device pixels. */
    #watchSize() {
        const { pane } = this.#parts;
        const measure = (/** @type {ResizeObserverSize | undefined} */ box) => {
            const { clientWidth, clientHeight } = pane;
            this.#resize(pixels(clientWidth, box?.inlineSize), pixels(clientHeight, box?.blockSize));
        };
        const observer = new ResizeObserver(([entry]) => measure(entry?.devicePixelContentBoxSize?.[0]));
        window.addEventListener("resize", () => measure(undefined));
        try {
            observer.observe(pane, { box: "device-pixel-content-box" });
        } catch {
            // Some browsers know no boxes in device pixels.
            observer.observe(pane);
        }
    }
}

/**
 * A side of the pane in device pixels. What a browser measures counts if it differs by rounding alone: some
 * measure without the factor that the page is magnified by.
 * @param {number} side
 * @param {number} [measured]
 */
function pixels(side, measured) {
    const computed = Math.round(side * window.devicePixelRatio);
    return measured !== undefined && Math.abs(measured - computed) <= 1 ? measured : computed;
}

/**
 * Whether a picture has the proportions that were asked for, up to whole pixels.
 * @param {[number, number]} size
 * @param {Wish} wish
 */
function fills([width, height], wish) {
    const most = Math.abs(width / height - wish.width / wish.height);
    return most <= (1 / width + 1 / height) * (wish.width / wish.height);
}

/**
 * Whether a key only arranges what is shown.
 * @param {string} key
 */
export function arranges(key) {
    return key === "viewer.divider" || key === "viewer.swapped";
}

/**
 * Where a canvas shows its picture, in pixels of the page from the canvas' corner.
 * @param {HTMLCanvasElement} canvas
 */
export function shownBox(canvas) {
    const { clientWidth, clientHeight } = canvas;
    if (!canvas.classList.contains("own-size")) {
        return { left: 0, top: 0, width: clientWidth, height: clientHeight };
    }
    const factor = Math.min(clientWidth / canvas.width, clientHeight / canvas.height);
    const [width, height] = [canvas.width * factor, canvas.height * factor];
    return { left: 0.5 * (clientWidth - width), top: 0.5 * (clientHeight - height), width, height };
}
