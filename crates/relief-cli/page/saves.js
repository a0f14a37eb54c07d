// Files out: a menu of what the host can make of the scene, which the browser then downloads.

/** @import { Host, Save, Saved } from "./protocol.d.ts" */
/** @import { Messages } from "./messages.js" */
/** @import { Session } from "./session.js" */

import { byId, element } from "./elements.js";

/** Milliseconds after which the memory of a download is given back. */
const DOWNLOADED = 60_000;

export class Saves {
    #host;
    #session;
    #messages;
    #shown = "";

    /**
     * @param {Host} host
     * @param {Session} session
     * @param {Messages} messages
     */
    constructor(host, session, messages) {
        this.#host = host;
        this.#session = session;
        this.#messages = messages;
        session.listen({ state: ({ saves }) => this.#show(saves) });
    }

    /** @param {Save[]} saves */
    #show(saves) {
        const shown = JSON.stringify(saves);
        if (shown === this.#shown) return;
        this.#shown = shown;
        const items = saves.map(({ what, label }) => {
            const button = element("button", { type: "button", "data-what": what }, label);
            button.addEventListener("click", () => this.#save(what, label));
            return element("li", {}, button);
        });
        byId("saves").replaceChildren(...items);
    }

    /**
     * @param {string} what
     * @param {string} label
     */
    async #save(what, label) {
        const messages = this.#messages;
        messages.clear();
        messages.say(`Making ${label}`);
        try {
            const saved = await messages.during(this.#host.save(what));
            download(saved);
            messages.say(`Saved ${saved.name}`);
        } catch (error) {
            messages.say("");
            messages.error(error);
            this.#session.met(error);
        }
    }
}

/** @param {Saved} saved */
function download({ name, blob }) {
    const address = URL.createObjectURL(blob);
    element("a", { href: address, download: name }).click();
    setTimeout(() => URL.revokeObjectURL(address), DOWNLOADED);
}
