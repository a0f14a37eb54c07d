// Files out: a menu of what the host can make of the scene, which the browser then downloads.

/** @import { Host, Save, Saved, State } from "./protocol.d.ts" */
/** @import { ViewBoxes } from "./view_boxes.js" */
/** @import { Messages } from "./messages.js" */
/** @import { Session } from "./session.js" */

import { byId, element } from "./elements.js";
import { Outdated } from "./shared.js";

/** Names of the views. */
const NAMES = ["first view", "second view"];

/** Milliseconds after which the memory of a download is given back. */
const DOWNLOADED = 60_000;

/**
 * @typedef {object} SavesParts
 * @property {Host} host
 * @property {Session} session
 * @property {Messages} messages
 * @property {() => number} surface the surface whose tab is open
 * @property {ViewBoxes} boxes
 */

export class Saves {
    /** @type {SavesParts} */ #parts;
    #list = byId("saves");
    #shown = "";
    /** @type {Save[]} */ #saves = [];
    #surfaces = 1;
    /** The number of the view that files are made of. */
    #view = 0;

    /** @param {SavesParts} parts */
    constructor(parts) {
        this.#parts = parts;
        parts.session.listen({ state: (state) => this.#know(state) });
        this.#list.previousElementSibling?.addEventListener("click", () => this.#show());
    }

    /** @param {State} state */
    #know({ saves, panel }) {
        [this.#saves, this.#surfaces] = [saves, panel.surfaces.length];
        this.#show();
    }

    /**
     * Lists what can be saved. Of several surfaces, a label says which one it is made of; of two views, a
     * choice above.
     */
    #show() {
        const methods = this.#parts.boxes.methods;
        const view = Math.min(this.#view, methods.length - 1);
        const named = this.#saves.map(({ what, label, of_surface, of_view }) => {
            const isOne = this.#surfaces === 1;
            const of = isOne ? ` ${methods[view] ?? ""}` : ` of surface ${this.#parts.surface()}`;
            return { what, of_view, label: of_surface ? label.replace("Method", `Method${of}`) : label };
        });
        const shown = JSON.stringify([methods, view, named]);
        if (shown === this.#shown) return;
        this.#shown = shown;
        const items = named.map(({ what, label, of_view }) => {
            const button = element("button", { type: "button", "data-what": what }, label);
            button.addEventListener("click", () => this.#save(what, label, of_view ? view : 0));
            return element("li", {}, button);
        });
        if (this.#parts.host.link) {
            const button = element("button", { type: "button", id: "copy-link" }, "Link to this scene");
            button.addEventListener("click", () => this.#copyLink());
            items.push(element("li", {}, button));
        }
        const choice = methods.length > 1 ? [element("li", {}, this.#choice(methods, view))] : [];
        this.#list.replaceChildren(...choice, ...items);
    }

    /** Puts a link to the scene into the address of the page, and copies it. */
    async #copyLink() {
        const { host, session, messages } = this.#parts;
        messages.clear();
        try {
            const link = await host.link?.();
            history.replaceState(null, "", `#${link}`);
            const isCopied = await copied(location.href);
            const elsewhere = "The link is the address of this page: copy it there";
            messages.say(isCopied ? "The link is copied" : elsewhere);
        } catch (error) {
            messages.error(error);
            session.met(error);
        }
    }

    /**
     * The choice of the view that files are made of.
     * @param {string[]} methods
     * @param {number} view
     */
    #choice(methods, view) {
        const option = (/** @type {string} */ method, /** @type {number} */ number) => {
            const attributes = { value: `${number}`, selected: number === view };
            return element("option", attributes, `${NAMES[number]}: ${method}`);
        };
        const select = element("select", { id: "saved-view" }, ...methods.map(option));
        select.addEventListener("change", () => {
            this.#view = Number(select.value);
            this.#show();
            byId("saved-view").focus();
        });
        return element("label", { class: "of-view" }, "Of the ", select);
    }

    /**
     * @param {string} what
     * @param {string} label
     * @param {number} view
     */
    async #save(what, label, view) {
        const { host, session, messages, surface } = this.#parts;
        messages.clear();
        messages.say(`Making ${label}`);
        try {
            const of = { view, surface: surface(), revision: session.revision };
            const saved = await messages.during(host.save(what, of));
            download(saved);
            messages.say(`Saved ${saved.name}`);
        } catch (error) {
            messages.say("");
            messages.error(error instanceof Outdated ? error.message : error);
            session.met(error);
            session.look();
        }
    }
}

/**
 * Copies a text, where the browser lets a page do so.
 * @param {string} text
 */
async function copied(text) {
    try {
        await navigator.clipboard.writeText(text);
        return true;
    } catch {
        return false;
    }
}

/** @param {Saved} saved */
function download({ name, blob }) {
    const address = URL.createObjectURL(blob);
    element("a", { href: address, download: name }).click();
    setTimeout(() => URL.revokeObjectURL(address), DOWNLOADED);
}
