// The toolbar: its buttons, its menus, the keys that work everywhere, and the dialogs.

/** @import { Host } from "./protocol.d.ts" */
/** @import { Camera, Mode } from "./camera.js" */
/** @import { Session } from "./session.js" */

import { byId, typed } from "./elements.js";

/** Actions of buttons that only name them. */
const PLAIN = /** @type {const} */ (["undo", "redo", "reset", "fit", "frame"]);

/** @type {Record<string, [number, number]>} */
const STEPS = { "step-right": [1, 0], "step-left": [-1, 0], "step-up": [0, 1], "step-down": [0, -1] };

export class Toolbar {
    #camera;
    #views;
    /** @type {[boolean, boolean]} */ #undo = [false, false];

    /**
     * @param {Host} host
     * @param {Session} session
     * @param {Camera} camera
     * @param {{ swap: () => void }} views
     */
    constructor(host, session, camera, views) {
        this.#camera = camera;
        this.#views = views;
        for (const name of PLAIN) onClick(name, () => this.#act(name));
        for (const [name, direction] of Object.entries(STEPS)) onClick(name, () => camera.step(direction));
        onClick("zoom-in", () => camera.zoom(1));
        onClick("zoom-out", () => camera.zoom(-1));
        for (const mode of /** @type {const} */ (["pan", "light"])) onClick(mode, () => this.#switch(mode));
        onClick("help", () => typed("help-dialog", HTMLDialogElement).showModal());
        for (const button of buttons("end")) button.hidden = !host.canEnd;
        onClick("end", () => typed("end-dialog", HTMLDialogElement).showModal());
        onClick("end-now", () =>
            host.end().then(
                () => session.readState(),
                (error) => session.met(error),
            ),
        );
        session.listen({ undo: (undo) => this.#show(undo), gone: (gone) => gone && this.#closeAll() });
        document.querySelectorAll("details.menu").forEach(closesItself);
        document.addEventListener("keydown", (event) => this.#key(event));
    }

    /** @param {typeof PLAIN[number]} name */
    #act(name) {
        if (name === "undo" && !this.#undo[0]) return;
        if (name === "redo" && !this.#undo[1]) return;
        this.#camera.act({ do: name });
    }

    /**
     * Makes plain drags and arrows pan, turn the light, or orbit again.
     * @param {Mode} mode
     */
    #switch(mode) {
        this.#camera.mode = this.#camera.mode === mode ? "orbit" : mode;
        for (const each of ["pan", "light"]) {
            const isOn = this.#camera.mode === each;
            for (const button of buttons(each)) button.setAttribute("aria-pressed", `${isOn}`);
        }
    }

    /**
     * Buttons that can do nothing stay reachable, so that the focus is not lost.
     * @param {[boolean, boolean]} undo
     */
    #show(undo) {
        this.#undo = undo;
        ["undo", "redo"].forEach((name, place) => {
            for (const button of buttons(name)) button.setAttribute("aria-disabled", `${!undo[place]}`);
        });
    }

    /** @param {KeyboardEvent} event */
    #key(event) {
        if (event.key.toLowerCase() === "x" && isPlain(event)) return this.#views.swap();
        if (!(event.ctrlKey || event.metaKey) || event.altKey || isTyping(event.target)) return;
        const key = event.key.toLowerCase();
        const name = key === "y" || (key === "z" && event.shiftKey) ? "redo" : key === "z" ? "undo" : null;
        if (!name) return;
        event.preventDefault();
        this.#act(name);
    }

    #closeAll() {
        for (const dialog of document.querySelectorAll("dialog")) dialog.close();
    }
}

/**
 * Whether a key is pressed alone, and not into a field.
 * @param {KeyboardEvent} event
 */
function isPlain({ ctrlKey, metaKey, altKey, target }) {
    if (ctrlKey || metaKey || altKey) return false;
    return !(target instanceof HTMLInputElement || target instanceof HTMLSelectElement);
}

/**
 * @param {string} name
 * @returns {NodeListOf<HTMLElement>}
 */
function buttons(name) {
    return document.querySelectorAll(`[data-do="${name}"]`);
}

/**
 * @param {string} name
 * @param {() => void} act
 */
function onClick(name, act) {
    for (const button of buttons(name)) button.addEventListener("click", act);
}

/**
 * Whether a text has been changed but not entered: browsers undo that by themselves.
 * @param {EventTarget | null} target
 */
function isTyping(target) {
    if (!(target instanceof HTMLInputElement)) return false;
    return !["range", "checkbox", "file"].includes(target.type) && target.value !== target.defaultValue;
}

/**
 * Closes a menu after a choice, by Escape, and when the focus or a press goes elsewhere.
 * @param {Element} menu
 */
function closesItself(menu) {
    if (!(menu instanceof HTMLDetailsElement)) return;
    const close = () => (menu.open = false);
    menu.addEventListener("click", ({ target }) => {
        if (target instanceof Element && target.closest("li button")) close();
    });
    menu.addEventListener("keydown", ({ key }) => {
        if (key !== "Escape" || !menu.open) return;
        close();
        menu.querySelector("summary")?.focus();
    });
    menu.addEventListener("focusout", ({ relatedTarget }) => {
        if (relatedTarget instanceof Node && !menu.contains(relatedTarget)) close();
    });
    document.addEventListener("pointerdown", ({ target }) => {
        if (target instanceof Node && !menu.contains(target)) close();
    });
}

/** Says that nothing can be drawn, and why; null: the picture is there. */
export class Empty {
    #wasDrawn = false;
    /** @type {string[]} */ #needs = [];

    /** @param {string[]} names files that a link needs */
    needs(names) {
        this.#needs = names;
        this.#title();
    }

    #title() {
        const files = "Drop a height map, a mesh, a folder of textures or a scene here";
        const drop = this.#wasDrawn ? "The scene cannot be drawn" : files;
        const needed = `This link needs ${this.#needs.join(", ")}`;
        byId("empty-title").textContent = this.#needs.length > 0 ? needed : drop;
    }

    /** @param {string | null} why */
    show(why) {
        if (why === null) this.#wasDrawn = true;
        this.#title();
        byId("empty-why").textContent = why ?? "";
        byId("empty").hidden = why === null;
        byId("pane").classList.toggle("not-drawn", why !== null);
    }
}
