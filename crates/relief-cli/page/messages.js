// What the page says: the state of the picture, errors, and progress of what takes long.

/** @import { AboutPicture, Host } from "./protocol.d.ts" */

import { Gone, Outdated } from "./shared.js";
import { element, byId } from "./elements.js";

/** Milliseconds after which a request shows its progress, and between two looks at it. */
const SLOW = 300;
const LOOK = 200;

/** Words for the tasks that the host names. */
const TASKS = new Map([
    ["reading", "Reading files"],
    ["rendering", "Rendering"],
    ["exact hits", "Finding the exact hits"],
    ["sending", "Sending files"],
    ["", "Working"],
]);

export class Messages {
    /** @type {Host} */ #host;
    #errors = byId("errors");
    #status = byId("status");
    #figures = byId("figures");
    #notes = byId("notes");
    #bar = byId("progress");
    #running = 0;
    /** @type {number | undefined} */ #slow;
    #sent = -1;

    /** @param {Host} host */
    constructor(host) {
        this.#host = host;
    }

    /**
     * Shows an error until it is closed.
     * @param {unknown} error
     */
    error(error) {
        if (error instanceof Gone || error instanceof Outdated) return;
        const text = error instanceof Error ? error.message : String(error);
        const same = [...this.#errors.children].find((message) => message.firstChild?.textContent === text);
        same?.remove();
        const close = element(
            "button",
            { type: "button", class: "close", "aria-label": "Close message" },
            "×",
        );
        const message = element("div", { class: "message" }, element("p", {}, text), close);
        close.addEventListener("click", () => message.remove());
        this.#errors.append(message);
    }

    /** Removes what was said of actions before: what the user did next has worked. */
    clear() {
        this.#errors.replaceChildren();
        this.say("");
    }

    /** @param {boolean} gone */
    gone(gone) {
        byId("gone").hidden = !gone;
        byId("gone-text").textContent = gone ? this.#host.gone : "";
        if (gone) this.say("");
    }

    /**
     * Says something about the state, in words.
     * @param {string} text
     */
    say(text) {
        this.#status.textContent = text;
    }

    /**
     * Says how a picture was drawn.
     * @param {AboutPicture} about
     */
    drawn({ size, samples, seconds, views, notes }) {
        const [width, height] = size;
        const each = samples === 1 ? "1 sample" : `${samples} samples`;
        const drawn = views.find(({ failed }) => failed === null);
        const where = [drawn?.backend, drawn?.device].filter(Boolean).join(", ");
        const figures = [`${width} × ${height}`, each, `${seconds.toPrecision(2)} s`, where];
        this.#figures.textContent = figures.join(" · ");
        const lines = notes.map((note) => element("li", {}, note));
        const summary = element("summary", {}, notes.length === 1 ? "1 note" : `${notes.length} notes`);
        const open = this.#notes.querySelector("details")?.open ?? false;
        const details = element("details", {}, summary, element("ul", {}, ...lines));
        details.open = open;
        this.#notes.replaceChildren(...(notes.length > 0 ? [details] : []));
    }

    /**
     * Shows the progress of a request that takes long.
     * @template T
     * @param {Promise<T>} request
     * @returns {Promise<T>}
     */
    async during(request) {
        this.#running += 1;
        if (this.#running === 1) this.#slow = setTimeout(() => this.#look(), SLOW);
        try {
            return await request;
        } finally {
            this.#running -= 1;
            if (this.#running === 0) this.#stop();
        }
    }

    /**
     * Says which part of the files has been sent.
     * @param {number} part
     */
    sent(part) {
        this.#sent = part < 1 ? part : -1;
    }

    async #look() {
        const seen = this.#sent >= 0 ? { task: "sending", part: this.#sent } : await this.#ask();
        if (this.#running === 0) return;
        this.#show(seen);
        this.#slow = setTimeout(() => this.#look(), LOOK);
    }

    async #ask() {
        try {
            return await this.#host.progress();
        } catch {
            // The request itself says what is wrong.
            return { task: "", part: 0 };
        }
    }

    /** @param {{ task: string, part: number }} seen */
    #show({ task, part }) {
        const words = TASKS.get(task) ?? `Baking: ${task}`;
        const bar = element("progress", { max: "1", "aria-label": words });
        if (task !== "") bar.value = part;
        const percent = task === "" ? "" : ` ${Math.floor(100 * part)} %`;
        this.#bar.replaceChildren(bar, element("span", { "aria-hidden": "true" }, `${words}${percent}`));
        this.#bar.hidden = false;
    }

    #stop() {
        clearTimeout(this.#slow);
        this.#sent = -1;
        this.#bar.hidden = true;
        this.#bar.replaceChildren();
    }
}
