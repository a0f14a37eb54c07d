// A control of the panel: its label, its field, what it means, and why a value was refused.

/** @import { Action, Applied, Control, Value } from "./protocol.d.ts" */
/** @import { Field } from "./fields.js" */
/** @import { Session } from "./session.js" */

import { fieldOf, shapeOf } from "./fields.js";
import { element, newId } from "./elements.js";
import { Gone } from "./shared.js";
import { otherWords, plain } from "./words.js";

/**
 * @typedef {object} Workshop
 * @property {Session} session
 * @property {(file: File, key: string) => void} give takes a file for a key
 * @property {(error: unknown) => void} failed says what went wrong where no control is near
 */

export class ControlRow {
    /** @type {Workshop} */ #workshop;
    /** @type {Control} */ #control;
    #ids = { field: newId(), label: newId(), about: newId(), error: newId() };
    #label = element("label", { id: this.#ids.label, for: this.#ids.field });
    #unit = element("span", { class: "unit" });
    #lose = element("button", { type: "button", class: "lose" }, "↺");
    #head = element("div", { class: "head" }, this.#label, this.#unit, this.#lose);
    #about = element("p", { class: "about", id: this.#ids.about });
    #error = element("p", { class: "error", id: this.#ids.error, role: "alert" });
    #shape = "";
    /** Revision of the scene of which the error was said. */
    #refused = 0;
    /** @type {Field} */ #field;

    /**
     * @param {Control} control
     * @param {Workshop} workshop
     */
    constructor(control, workshop) {
        this.#workshop = workshop;
        this.#control = control;
        this.#field = this.#makeField(control);
        this.node = element(
            "div",
            { class: "control" },
            this.#head,
            this.#field.node,
            this.#error,
            this.#about,
        );
        this.#lose.addEventListener("click", () => {
            this.#field.focus();
            this.#field.back?.();
            this.#takeAway();
        });
        this.#takeDrops();
        this.show(control);
    }

    /** @param {Control} control */
    #makeField(control) {
        this.#shape = shapeOf(control);
        const { field: id, label, about, error } = this.#ids;
        const { session, give } = this.#workshop;
        return fieldOf(control, {
            id,
            label,
            about: `${about} ${error}`,
            set: (value, drag = null) => this.#set(value, drag),
            lose: () => this.#takeAway(),
            burst: () => session.burst(),
            refuse: (error) => this.#say(error),
            give: (file) => give(file, this.#control.key),
        });
    }

    /**
     * Shows what the scene has for the control now.
     * @param {Control} control
     */
    show(control) {
        if (shapeOf(control) !== this.#shape) {
            const field = this.#makeField(control);
            this.#field.node.replaceWith(field.node);
            this.#field = field;
        }
        this.#control = control;
        const { key, label, about, unit, value, kind } = control;
        this.node.dataset["key"] = key;
        this.node.dataset["kind"] = typeof kind === "object" ? "numbers" : kind;
        setText(this.#label, label);
        setText(this.#unit, unit);
        setText(this.#about, about);
        this.#lose.hidden = value === null;
        this.#lose.setAttribute("aria-label", `default of ${label}`);
        this.#lose.title = `Take the value away: the default of ${label} holds`;
        this.#field.show(control);
        // What was refused stays with its text; where there is none, the next change that works ends it.
        if (!this.#field.holds && this.#workshop.session.revision !== this.#refused) this.#say("");
    }

    /** Whether the scene has a value, not the default. */
    get isSet() {
        return this.#control.value !== null;
    }

    /**
     * Whether a text that the user looks for is in what the control says of itself.
     * @param {string} words in small letters
     */
    matches(words) {
        const { key, label, about } = this.#control;
        const text = plain(`${label} ${key} ${about} ${otherWords(key)}`);
        return plain(words)
            .split(/\s+/)
            .every((word) => text.includes(word));
    }

    /**
     * @param {Value} value
     * @param {number | null} drag
     */
    #set(value, drag) {
        return this.#apply({ do: "set", key: this.#control.key, value }, drag);
    }

    #takeAway() {
        return this.#apply({ do: "lose", key: this.#control.key }, null);
    }

    /**
     * @param {Action} action
     * @param {number | null} drag
     * @returns {Promise<Applied | null>} what changed; null: it was refused
     */
    async #apply(action, drag) {
        try {
            const applied = await this.#workshop.session.apply(action, drag);
            this.#say("");
            return applied;
        } catch (error) {
            this.#say(error instanceof Gone ? "" : error instanceof Error ? error.message : String(error));
            this.#field.show(this.#control);
            return null;
        }
    }

    /** @param {string} error why a value was refused; empty: it was not */
    #say(error) {
        setText(this.#error, error);
        if (error === "") return this.#field.input.removeAttribute("aria-invalid");
        this.#refused = this.#workshop.session.revision;
        this.#field.input.setAttribute("aria-invalid", "true");
        if (this.node.checkVisibility()) this.node.scrollIntoView({ block: "nearest" });
    }

    /** Takes a single file that is dropped here. */
    #takeDrops() {
        const { node } = this;
        const takes = () => this.#control.is_file || this.#control.kind === "name-or-file";
        node.addEventListener("dragover", (event) => {
            const isOne = takes() && event.dataTransfer?.items.length === 1;
            node.classList.toggle("drop", isOne);
        });
        node.addEventListener("dragleave", () => node.classList.remove("drop"));
        node.addEventListener("drop", (event) => {
            node.classList.remove("drop");
            const items = [...(event.dataTransfer?.items ?? [])];
            const file = event.dataTransfer?.files[0];
            if (!takes() || items.length !== 1 || !file || items[0]?.webkitGetAsEntry()?.isDirectory) return;
            event.preventDefault();
            event.stopPropagation();
            document.body.classList.remove("dropping");
            this.#workshop.give(file, this.#control.key);
        });
    }
}

/**
 * @param {Element} node
 * @param {string} text
 */
function setText(node, text) {
    if (node.textContent !== text) node.textContent = text;
}
