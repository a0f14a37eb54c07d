// The host in a worker of the page: the module draws on the CPU, and no file leaves the browser.

/** @import { Action, Applied, Drawn, Given, Host, Progress, ReadPixel, Saved, State } from "./protocol.d.ts" */
/** @import { SavedOf, Wish } from "./protocol.d.ts" */
/** @import { Painted, SceneFile } from "./worker_messages.d.ts" */

import { Crew } from "./crew.js";
import { Module } from "./module.js";
import { Gone, Outdated, viewsOf } from "./shared.js";

/** Actions that move the camera alone: what is being baked serves them, too. */
const OF_CAMERA = ["orbit", "pan", "zoom", "fit", "frame", "look-at"];
/** Tasks that draw. All others bake. */
const DRAWING = ["rendering", "exact hits"];

const FAULT = "The module has met a fault or has run out of memory. It starts again with your scene and files.";

/** The name of the scene that is opened. */
const SCENE = "scene.toml";

/** @implements {Host} */
export class WorkerHost {
    canEnd = false;
    keeps = false;
    gone = FAULT;
    #module;
    #viewer;
    /** Workers that draw with this one; none where the module is shared. @type {Crew | null} */ #crew;
    /** Number of the worker that holds the scene. */
    #worker = -1;
    /** Groups of files in links are counted from 1. */
    #group = 1000;
    /** @type {{ stop: string, isQuick: boolean } | null} */ #drawing = null;
    /** The files that came in, for a module that starts again. @type {{ group: number, given: Given }[]} */
    #given = [];
    /** The scene as it is. */
    #text;
    #files;
    /** Whether the scene has been opened: other requests wait for it. @type {Promise<unknown>} */
    #opened = Promise.resolve();
    /** The link that was followed, whose files a module that starts again needs. @type {string | null} */
    #link = null;
    /** Fails if the link that the page began with cannot be followed. @type {Promise<unknown>} */ linked;

    /**
     * @param {string} text the scene, as a file
     * @param {Promise<SceneFile[]>} files the files that it names
     * @param {string | null} [link] a link to another scene, in place of this one
     * @param {Module | null} [shared] a module that other hosts share
     */
    constructor(text, files, link = null, shared = null) {
        this.#module = shared ?? new Module();
        this.#viewer = this.#module.newViewer();
        this.#crew = shared ? null : new Crew(this.#module, () => this.#everything());
        this.#text = text;
        this.#files = files;
        this.#start();
        this.linked = this.#begin(link);
        // Other requests wait for it.
        this.#opened = this.linked.catch(() => {});
    }

    /** @param {string | null} link */
    async #begin(link) {
        await this.#opened;
        if (link === null) return;
        await this.#post("link", { link, begins: true });
        this.#link = link;
    }

    /** Opens the scene with all files, in a worker that starts if there is none. */
    #start() {
        this.#crew?.dismiss();
        this.#worker = this.#module.start();
        // What is wrong with the scene, the next request says.
        this.#opened = this.#open().catch(() => {});
    }

    async #open() {
        await this.#post("open", await this.#everything());
    }

    /** The scene with all files. */
    async #everything() {
        const scene = { path: SCENE, file: new Blob([this.#text]) };
        const given = this.#given.map(({ group, given: { path, file } }) => ({
            path: `given/${group}/${path}`,
            file,
        }));
        const files = [scene, ...(await this.#files), ...given];
        return { files, scene: SCENE, isSample: true, needs: this.#link };
    }

    /**
     * @param {string} name
     * @param {unknown} [args]
     * @returns {Promise<any>}
     */
    async #ask(name, args = {}) {
        await this.#opened;
        return this.#post(name, args);
    }

    /**
     * @param {string} name
     * @param {unknown} args
     * @returns {Promise<any>}
     */
    #post(name, args) {
        if (!this.#module.runs(this.#worker)) return Promise.reject(new Gone());
        return this.#module.post(this.#viewer, name, args);
    }

    /** @returns {Promise<State>} */
    async state() {
        if (!this.#module.runs(this.#worker)) this.#start();
        const { state, text } = await this.#ask("state");
        this.#text = text;
        return state;
    }

    /**
     * @param {Action} action
     * @param {number | null} drag
     * @returns {Promise<Applied>}
     */
    apply(action, drag) {
        const arranges = "key" in action && ["viewer.divider", "viewer.swapped"].includes(action.key);
        if (!arranges) this.#endWhatIsOld(OF_CAMERA.includes(action.do));
        return this.#ask("apply", { action, drag });
    }

    /** @param {boolean} isOfCamera whether the change moves the camera alone */
    #endWhatIsOld(isOfCamera) {
        if (!this.#drawing) return;
        const draws = DRAWING.includes(this.#module.progress.task);
        if (draws ? !this.#drawing.isQuick : !isOfCamera) URL.revokeObjectURL(this.#drawing.stop);
    }

    /**
     * @param {Wish} wish
     * @returns {Promise<Drawn>}
     */
    async picture(wish) {
        const isQuick = wish.samples === "one";
        const drawn = await this.#stoppable(isQuick, (stop) => this.#painted(wish, stop));
        if (drawn === null) throw new Outdated("another change ended it");
        const { about, pixels } = drawn;
        this.#crew?.saw(about, isQuick);
        return { about, views: viewsOf(about, pixels.buffer, 0) };
    }

    /**
     * @param {Wish} wish
     * @param {string} stop
     * @returns {Promise<Painted | null>}
     */
    async #painted(wish, stop) {
        await this.#opened;
        if (!this.#crew?.isReady) return this.#post("picture", { wish, stop });
        const ask = (/** @type {[number, number]} */ rows) => [
            this.#post("text", {}),
            this.#post("picture", { wish: { ...wish, rows }, stop }),
        ];
        return this.#crew.picture(/** @type {import("./crew.js").Ask} */ (ask), wish, stop);
    }

    /**
     * @param {[number, number]} at
     * @returns {Promise<ReadPixel | null>}
     */
    async pixel(at) {
        const found = await this.#stoppable(false, (stop) => this.#ask("pixel", { at, stop }));
        if (found === undefined) throw new Outdated("another change ended it");
        return found;
    }

    /**
     * @template T
     * @param {boolean} isQuick
     * @param {(stop: string) => Promise<T>} work
     */
    async #stoppable(isQuick, work) {
        const stop = URL.createObjectURL(new Blob());
        this.#drawing = { stop, isQuick };
        this.#module.progress = { task: "rendering", part: 0 };
        try {
            return await work(stop);
        } finally {
            URL.revokeObjectURL(stop);
            if (this.#drawing?.stop === stop) this.#drawing = null;
            this.#module.progress = { task: "", part: 0 };
        }
    }

    /** @returns {Promise<Progress>} */
    progress() {
        return Promise.resolve(this.#module.progress);
    }

    /**
     * @param {Given[]} files
     * @param {string | null} key
     * @param {(part: number) => void} sent
     * @returns {Promise<Applied>}
     */
    async give(files, key, sent) {
        this.#endWhatIsOld(false);
        this.#group += 1;
        const group = this.#group;
        for (const [number, { path, file }] of files.entries()) {
            sent(number / files.length);
            await this.#ask("give", { group, path, file });
        }
        sent(1);
        const applied = await this.#ask("take", { group, key });
        this.#given.push(...files.map((given) => ({ group, given })));
        this.#crew?.reopen();
        return applied;
    }

    /**
     * Goes to the scene of a link.
     * @param {string} link
     * @returns {Promise<Applied>}
     */
    async follow(link) {
        this.#endWhatIsOld(false);
        const applied = await this.#ask("link", { link, begins: false });
        this.#link = link;
        this.#crew?.reopen();
        return applied;
    }

    /** @returns {Promise<string>} */
    async link() {
        return (await this.#ask("made_link")).text;
    }

    /**
     * @param {string} what
     * @param {SavedOf} of
     * @returns {Promise<Saved>}
     */
    async save(what, { view, revision }) {
        // The picture in hand is drawn again afterwards.
        if (this.#drawing) URL.revokeObjectURL(this.#drawing.stop);
        const { state } = await this.#ask("state");
        if (state.revision !== revision) throw new Outdated("the scene has changed");
        const { bytes } = await this.#ask("save", { what, view, stop: null });
        return { name: what, blob: new Blob([bytes]) };
    }

    end() {
        return Promise.resolve();
    }
}
