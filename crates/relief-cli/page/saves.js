// Files out: a menu of what the host can make of the scene, which the browser then downloads.

/** @import { Host, Save, Saved, State } from "./protocol.d.ts" */
/** @import { Messages } from "./messages.js" */
/** @import { Session } from "./session.js" */

import { byId, element } from "./elements.js";
import { Outdated } from "./shared.js";

/** Milliseconds after which the memory of a download is given back. */
const DOWNLOADED = 60_000;

/**
 * @typedef {object} SavesParts
 * @property {Host} host
 * @property {Session} session
 * @property {Messages} messages
 * @property {() => number} surface the surface whose tab is open
 */

export class Saves {
    /** @type {SavesParts} */ #parts;
    #list = byId("saves");
    #shown = "";
    /** @type {Save[]} */ #saves = [];
    #surfaces = 1;

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

    /** Lists what can be saved. Of several surfaces, a label says which one it is made of. */
    #show() {
        const named = this.#saves.map(({ what, label, of_surface }) => {
            const of = of_surface && this.#surfaces > 1 ? ` of surface ${this.#parts.surface()}` : "";
            return { what, label: label.replace("Method", `Method${of}`) };
        });
        const shown = JSON.stringify(named);
        if (shown === this.#shown) return;
        this.#shown = shown;
        const items = named.map(({ what, label }) => {
            const button = element("button", { type: "button", "data-what": what }, label);
            button.addEventListener("click", () => this.#save(what, label));
            return element("li", {}, button);
        });
        this.#list.replaceChildren(...items);
    }

    /**
     * @param {string} what
     * @param {string} label
     */
    async #save(what, label) {
        const { host, session, messages, surface } = this.#parts;
        messages.clear();
        messages.say(`Making ${label}`);
        try {
            const of = { surface: surface(), revision: session.revision };
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

/** @param {Saved} saved */
function download({ name, blob }) {
    const address = URL.createObjectURL(blob);
    element("a", { href: address, download: name }).click();
    setTimeout(() => URL.revokeObjectURL(address), DOWNLOADED);
}
