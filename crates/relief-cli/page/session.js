// The scene as the host holds it: sends actions one at a time, and tells the page what changed.

/** @import { Action, Applied, Host, State } from "./protocol.d.ts" */

import { Gone, Refused, newNumber } from "./shared.js";

/** Milliseconds without input after which the view is at rest. */
const REST = 150;
/** Milliseconds between attempts to reach a host that has gone. */
const RETRY = 2000;

/**
 * @typedef {object} Waiting
 * @property {Action} action
 * @property {number | null} drag
 * @property {((applied: Applied) => void)[]} done
 * @property {((error: unknown) => void)[]} failed
 */

/**
 * @typedef {object} Listener
 * @property {(state: State) => void} [state] the panel may differ
 * @property {(undo: [boolean, boolean]) => void} [undo]
 * @property {(keys: string[]) => void} [changed] the picture may differ: these keys do, or ""
 * @property {() => void} [worked] an action of this page has worked
 * @property {() => void} [rested] the view has come to rest
 * @property {(gone: boolean) => void} [gone] the host has gone, or is back
 */

export class Session {
    /** @type {Host} */ #host;
    /** @type {Waiting[]} */ #waiting = [];
    /** @type {Listener[]} */ #listeners = [];
    #sending = false;
    /** Number of actions that have been sent. */
    #sends = 0;
    #gone = false;
    #moving = false;
    /** Revision of the scene that the page knows; null: none. @type {number | null} */
    #revision = null;
    #stateWanted = false;
    #stateAsked = false;
    /** @type {number | undefined} */ #rest;
    /** @type {number | null} */ #burst = null;
    /** Whether actions of a drag wait, so that a quick picture is finished first. */
    #holds = () => false;

    /** @param {Host} host */
    constructor(host) {
        this.#host = host;
    }

    /** @param {Listener} listener */
    listen(listener) {
        this.#listeners.push(listener);
    }

    /** @param {() => boolean} holds */
    holdDragsWhile(holds) {
        this.#holds = holds;
    }

    /** Whether the view moves: input came a moment ago. */
    get moving() {
        return this.#moving;
    }

    /** The revision of the scene that the page shows; -1 before the first. */
    get revision() {
        return this.#revision ?? -1;
    }

    /** The number of a burst of keys or turns of the wheel: one drag until the view is at rest. */
    burst() {
        this.#burst ??= newNumber();
        return this.#burst;
    }

    /**
     * Sends an action when its turn has come.
     * @param {Action} action
     * @param {number | null} [drag]
     * @returns {Promise<Applied>}
     */
    apply(action, drag = null) {
        if (this.#gone) return Promise.reject(new Gone());
        if (drag !== null) this.#move();
        return new Promise((done, failed) => {
            if (!this.#gather(action, drag, done, failed)) {
                this.#waiting.push({ action, drag, done: [done], failed: [failed] });
            }
            this.flush();
        });
    }

    /**
     * Adds an action to one of its drag that still waits. Returns whether there is one.
     * @param {Action} action
     * @param {number | null} drag
     * @param {(applied: Applied) => void} done
     * @param {(error: unknown) => void} failed
     */
    #gather(action, drag, done, failed) {
        const end = this.#waiting.findLastIndex((waiting) => waiting.drag === null || waiting.drag !== drag);
        for (const waiting of this.#waiting.slice(end + 1)) {
            const both = gathered(waiting.action, action);
            if (!both) continue;
            waiting.action = both;
            waiting.done.push(done);
            waiting.failed.push(failed);
            return true;
        }
        return false;
    }

    /** Sends what waits, if nothing is on its way. */
    flush() {
        const next = this.#waiting[0];
        if (this.#sending || !next) return;
        const waitsForPicture =
            this.#moving && this.#waiting.every(({ drag }) => drag !== null) && this.#holds();
        if (waitsForPicture) return;
        this.#waiting.shift();
        this.#send(next);
    }

    /** @param {Waiting} next */
    async #send({ action, drag, done, failed }) {
        this.#sending = true;
        this.#sends += 1;
        try {
            const applied = await this.#host.apply(action, drag);
            this.took(applied);
            for (const tell of done) tell(applied);
        } catch (error) {
            this.met(error);
            for (const tell of failed) tell(error);
            // It may be refused because another page has changed the scene.
            if (error instanceof Refused) this.look();
        } finally {
            this.#sending = false;
            this.flush();
        }
    }

    /**
     * Says that the scene has changed.
     * @param {Applied} applied
     */
    took(applied) {
        this.#tell((listener) => listener.undo?.(applied.undo));
        this.#tell((listener) => listener.worked?.());
        const { changed, revision } = applied;
        // Of changes that another page has made, the keys are not known.
        const own = (this.#revision ?? revision) + (changed.length > 0 ? 1 : 0);
        const keys = revision > own ? [""] : changed;
        this.#isNews(revision);
        if (keys.length === 0) return;
        this.#tell((listener) => listener.changed?.(keys));
        this.#stateWanted = true;
        if (!this.#moving) this.readState();
    }

    /**
     * Takes note of a revision. Returns whether another page has made it.
     * @param {number} revision
     */
    #isNews(revision) {
        const isNews = this.#revision !== null && revision > this.#revision;
        this.#revision = Math.max(revision, this.#revision ?? revision);
        return isNews;
    }

    /**
     * Says which revision a picture is of: another page may have made it.
     * @param {number} revision
     */
    saw(revision) {
        if (this.#revision !== null && revision > this.#revision && !this.#sending) this.look();
    }

    /** Looks whether another page has changed the scene, such as when this one is looked at again. */
    look() {
        if (!this.#gone && !this.#moving) this.readState();
    }

    /** Reads the panel again. */
    async readState() {
        this.#stateWanted = true;
        if (this.#stateAsked) return;
        this.#stateAsked = true;
        try {
            while (this.#stateWanted) {
                this.#stateWanted = false;
                const [sends, isSending] = [this.#sends, this.#sending];
                const state = await this.#host.state();
                // An action of this page that is on its way says itself what it has changed.
                const isOwn = isSending || sends !== this.#sends;
                const isNews = !isOwn && this.#isNews(state.revision);
                this.#tell((listener) => listener.undo?.(state.undo));
                this.#tell((listener) => listener.state?.(state));
                if (isNews) this.#tell((listener) => listener.changed?.([""]));
            }
        } catch (error) {
            this.met(error);
        } finally {
            this.#stateAsked = false;
        }
    }

    /**
     * Notices whether an error means that the host has gone; then tries to reach it.
     * @param {unknown} error
     */
    met(error) {
        if (!(error instanceof Gone) || this.#gone) return;
        this.#gone = true;
        for (const { failed } of this.#waiting.splice(0)) failed.forEach((tell) => tell(error));
        this.#tell((listener) => listener.gone?.(true));
        setTimeout(() => this.#retry(), RETRY);
    }

    async #retry() {
        try {
            await this.#host.state();
        } catch {
            setTimeout(() => this.#retry(), RETRY);
            return;
        }
        [this.#gone, this.#revision] = [false, null];
        this.#tell((listener) => listener.gone?.(false));
        this.#tell((listener) => listener.changed?.([""]));
        this.readState();
    }

    /** Says that a drag goes on, and sets the clock for its end. */
    #move() {
        this.#moving = true;
        clearTimeout(this.#rest);
        this.#rest = setTimeout(() => this.#comeToRest(), REST);
    }

    #comeToRest() {
        this.#moving = false;
        this.#burst = null;
        this.flush();
        this.#tell((listener) => listener.rested?.());
        if (this.#stateWanted) this.readState();
    }

    /** @param {(listener: Listener) => void} what */
    #tell(what) {
        this.#listeners.forEach(what);
    }
}

/**
 * Two actions of a drag as one; null if they must follow each other.
 * @param {Action} first
 * @param {Action} second
 * @returns {Action | null}
 */
function gathered(first, second) {
    if (first.do === "zoom" && second.do === "zoom")
        return { do: "zoom", factor: first.factor * second.factor };
    if (first.do === "pan" && second.do === "pan") return { do: "pan", by: sum(first.by, second.by) };
    if ((first.do === "orbit" || first.do === "turn-light") && second.do === first.do) {
        return { do: first.do, degrees: sum(first.degrees, second.degrees) };
    }
    if (first.do === "set" && second.do === "set" && first.key === second.key) return second;
    return null;
}

/**
 * @param {[number, number]} first
 * @param {[number, number]} second
 * @returns {[number, number]}
 */
function sum(first, second) {
    return [first[0] + second[0], first[1] + second[1]];
}
