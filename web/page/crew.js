// Workers beside the first one: each draws a part of the rows of a picture, of the same scene as text.

/** @import { AboutPicture, AboutView, Wish } from "./protocol.d.ts" */
/** @import { Opened, Painted, Stop } from "./worker_messages.d.ts" */

import { Module } from "./module.js";
import { Outdated } from "./shared.js";

/** Most workers of a page, with the first one. */
const MOST = 4;
/** Seconds of a whole picture from which on others help. */
const SLOW = 0.1;
/** Most bytes of all files: each worker has them. */
const MOST_BYTES = 64 << 20;
/** Milliseconds, besides three times its own, that the first one waits for the others. */
const PATIENCE = 1000;
/** Least part of the rows. */
const LEAST = 0.02;
/** A picture for which a worker bakes and builds what the next ones need. */
const SMALL = { width: 16, height: 16, part: 1, samples: /** @type {const} */ ("one") };

/**
 * The request of a text and of some rows to the first worker, which sees no other one between both.
 * @typedef {(rows: [number, number]) => [Promise<{ text: string }>, Promise<Painted | null>]} Ask
 */

export class Crew {
    #module;
    #opened;
    /** @type {Helper[]} */ #helpers = [];
    /** Where the parts of the rows begin and end. */
    #bounds = [0, 1];
    /** Whether the last picture can be shared. */
    #isShared = false;

    /**
     * @param {Module} module the first worker's
     * @param {() => Promise<Opened>} opened the scene with its files
     */
    constructor(module, opened) {
        this.#module = module;
        this.#opened = opened;
    }

    /** Whether all draw the next picture. */
    get isReady() {
        return this.#isShared && this.#helpers.length > 0 && this.#helpers.every(({ isReady }) => isReady);
    }

    /**
     * Sees a picture. After a slow one at rest the others begin, unless there is nothing to share.
     * @param {AboutPicture} about
     * @param {boolean} isQuick
     */
    saw({ seconds, views }, isQuick) {
        this.#isShared = views.every(({ show, backend }) => show === "picture" && backend === "cpu");
        if (!this.#isShared || isQuick || seconds < SLOW || this.#helpers.length > 0) return;
        const count = Math.min(navigator.hardwareConcurrency || 1, MOST);
        this.#bounds = Array.from({ length: count + 1 }, (_, part) => part / count);
        this.#helpers = this.#bounds.slice(2).map(() => new Helper(this.#module.code));
        this.reopen();
    }

    /** Gives the scene with its files to all. */
    async reopen() {
        const helpers = this.#helpers;
        if (helpers.length === 0) return;
        for (const helper of helpers) helper.isReady = false;
        const opened = await this.#opened();
        const bytes = opened.files.reduce((sum, { file }) => sum + file.size, 0);
        if (bytes > MOST_BYTES) return this.dismiss();
        try {
            await Promise.all(helpers.map((helper) => helper.open(opened)));
        } catch {
            this.dismiss();
        }
    }

    /** Ends all but the first. */
    dismiss() {
        for (const helper of this.#helpers) helper.end();
        this.#helpers = [];
    }

    /**
     * @param {Ask} ask
     * @param {Wish} wish
     * @param {Stop} stop
     * @returns {Promise<Painted | null>}
     */
    async picture(ask, wish, stop) {
        const helpers = this.#helpers;
        /** @returns {[number, number]} */
        const rows = (/** @type {number} */ part) => [this.#bounds[part] ?? 0, this.#bounds[part + 1] ?? 1];
        const parts = helpers.map((_, number) => ({ ...wish, rows: rows(number + 1) }));
        const [said, own] = ask(rows(0));
        const theirs = said.then(({ text }) =>
            Promise.all(helpers.map((helper, number) => helper.draw(text, parts[number] ?? wish, stop))),
        );
        // The first worker's own error comes first.
        theirs.catch(() => {});
        const begun = performance.now();
        const first = await own;
        if (first === null || isWhole(first.about)) return first;
        const took = performance.now() - begun;
        const all = [first, ...(await this.#drawn(theirs, PATIENCE + 3 * took))];
        const painted = all.filter((part) => part !== null);
        if (painted.length < all.length) return null;
        this.#bounds = balanced(this.#bounds, painted.map(({ about }) => about.seconds));
        return merged(painted);
    }

    /**
     * @template T
     * @param {Promise<T>} theirs
     * @param {number} most milliseconds to wait
     */
    async #drawn(theirs, most) {
        let timer = 0;
        const late = new Promise((_, failed) => {
            timer = window.setTimeout(() => failed(new Error("a worker does not answer")), most);
        });
        try {
            await Promise.race([theirs, late]);
            return await theirs;
        } catch (error) {
            // One has run out of memory, perhaps: the first one goes on by itself.
            this.dismiss();
            throw new Outdated(error instanceof Error ? error.message : String(error));
        } finally {
            clearTimeout(timer);
        }
    }
}

/** A worker that draws what it is told. */
class Helper {
    isReady = false;
    #module;
    #opens = 0;

    /** @param {Promise<WebAssembly.Module> | null} code */
    constructor(code) {
        this.#module = new Module(code);
        this.#module.start();
    }

    /** @param {Opened} opened */
    async open(opened) {
        this.#opens += 1;
        const opens = this.#opens;
        await this.#module.post(1, "open", opened);
        const text = (await opened.files.find(({ path }) => path === opened.scene)?.file.text()) ?? "";
        await this.draw(text, SMALL, null);
        this.isReady = opens === this.#opens;
    }

    /**
     * @param {string} text
     * @param {Wish} wish
     * @param {Stop} stop
     * @returns {Promise<Painted | null>}
     */
    draw(text, wish, stop) {
        return this.#module.post(1, "shared", { text, wish, stop });
    }

    end() {
        this.#module.end();
    }
}

/** @param {AboutPicture} about */
function isWhole({ size: [, height], views }) {
    return views.every(({ rows: [begin, end], failed }) => failed !== null || end - begin === height);
}

/**
 * One picture of the parts of it.
 * @param {Painted[]} parts
 * @returns {Painted}
 */
function merged(parts) {
    const [first] = parts;
    if (!first) throw new Outdated("there are no parts");
    const { size: [width, height], views } = first.about;
    const begins = parts.map(() => 0);
    const shown = views.filter(({ failed }) => failed === null).length;
    const pixels = new Uint8Array(shown * width * height * 4);
    let base = 0;
    views.forEach((view, number) => {
        if (view.failed !== null) return;
        parts.forEach(({ about, pixels: own }, part) => {
            const [begin, end] = about.views[number]?.rows ?? [0, 0];
            const [from, bytes] = [begins[part] ?? 0, (end - begin) * width * 4];
            pixels.set(own.subarray(from, from + bytes), base + begin * width * 4);
            begins[part] = from + bytes;
        });
        base += width * height * 4;
    });
    const seconds = Math.max(...parts.map(({ about }) => about.seconds));
    const device = `${parts.length} threads`;
    const about = {
        ...first.about,
        seconds,
        views: views.map((/** @type {AboutView} */ view) => ({ ...view, device, rows: [0, height] })),
    };
    return { about: /** @type {AboutPicture} */ (about), pixels };
}

/**
 * Moves the places between parts so that all take the same time, half of the way.
 * @param {number[]} bounds
 * @param {number[]} seconds time of each part
 */
export function balanced(bounds, seconds) {
    const all = seconds.reduce((sum, part) => sum + part, 0);
    const ends = [...bounds];
    let [part, before] = [0, 0];
    for (let place = 1; place < bounds.length - 1; place += 1) {
        const wanted = (all * place) / seconds.length;
        while (part < seconds.length - 1 && before + (seconds[part] ?? 0) < wanted) {
            before += seconds[part] ?? 0;
            part += 1;
        }
        const [begin, end] = [bounds[part] ?? 0, bounds[part + 1] ?? 1];
        const even = begin + ((end - begin) * (wanted - before)) / Math.max(seconds[part] ?? 0, 1e-9);
        const half = ((bounds[place] ?? 0) + even) / 2;
        const [low, high] = [(ends[place - 1] ?? 0) + LEAST, 1 - LEAST * (bounds.length - 1 - place)];
        ends[place] = Math.min(Math.max(half, low), high);
    }
    return ends;
}
