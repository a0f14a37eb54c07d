// Fields in which a value is entered, one for each kind of control, but for numbers.

/** @import { Applied, Control, Value } from "./protocol.d.ts" */

import { element, newId } from "./elements.js";
import { Entry, enter } from "./entry.js";
import { NumberField, NumbersField } from "./number_fields.js";
import { textOf, written } from "./values.js";

/**
 * What a field needs of its control.
 * @typedef {object} Around
 * @property {string} id of the field that the label names
 * @property {string} label id of the label
 * @property {string} about ids of what describes the field
 * @property {(value: Value, drag?: number | null) => Promise<Applied | null>} set tells what changed;
 * null: it was refused
 * @property {() => Promise<Applied | null>} lose
 * @property {() => number} burst number of the drag that key presses in a row belong to
 * @property {(error: string) => void} refuse says why nothing can be set; empty: it was taken back
 * @property {(file: File) => void} give
 */

/**
 * @typedef {object} Field
 * @property {HTMLElement} node
 * @property {(control: Control) => void} show shows the control's value. A text that the user is typing, or
 * that was refused, stays.
 * @property {boolean} [holds] whether it holds a text that the scene does not have
 * @property {() => void} [back] takes back what was typed, and what was said of it
 * @property {() => void} focus
 * @property {HTMLElement} input the element that is invalid when a value is refused
 */

/**
 * Makes the field of a control's kind.
 * @param {Control} control
 * @param {Around} around
 * @returns {Field}
 */
export function fieldOf(control, around) {
    const { kind } = control;
    if (typeof kind === "object") return new NumbersField(kind.numbers, around);
    if (kind === "number" || kind === "whole") return new NumberField(around);
    if (kind === "flag") return new FlagField(around);
    if (kind === "name") return new NameField(around);
    return new TextField(control, around);
}

/**
 * What distinguishes fields: two controls with the same shape can use the same field.
 * @param {Control} control
 */
export function shapeOf({ kind, is_file, choices }) {
    const isNumber = kind === "number" || kind === "whole";
    return JSON.stringify([isNumber ? "number" : kind, is_file, kind !== "name" && choices.length > 0]);
}

/** @implements {Field} */
class FlagField {
    /** @param {Around} around */
    constructor(around) {
        this.input = element("input", { type: "checkbox", id: around.id, "aria-describedby": around.about });
        this.node = this.input;
        this.input.addEventListener("change", () => around.set(this.input.checked));
    }

    /** @param {Control} control */
    show(control) {
        const now = control.value ?? control.default;
        this.input.checked = now === "true";
        this.input.indeterminate = now === null;
        this.input.classList.toggle("default", control.value === null);
    }

    focus() {
        this.input.focus();
    }
}

/** @implements {Field} */
class NameField {
    #chosen = element("p", { class: "chosen", id: newId() });
    #refused = element("details", { class: "refused", hidden: true });
    #shown = "";
    /** @type {Control | null} */ #control = null;

    /** @param {Around} around */
    constructor(around) {
        const described = `${around.about} ${this.#chosen.id}`;
        this.input = element("select", { id: around.id, "aria-describedby": described });
        this.node = element("div", { class: "field stacked" }, this.input, this.#chosen, this.#refused);
        this.input.addEventListener("change", () => {
            if (this.input.value === "") around.lose();
            else around.set(written(this.input.value));
        });
    }

    /** @param {Control} control */
    show(control) {
        this.#control = control;
        this.#showChoices(control);
        this.input.value = textOf(control.value);
        this.input.classList.toggle("default", control.value === null);
        const effective = textOf(control.value ?? control.default);
        this.#chosen.textContent = control.choices.find(({ name }) => name === effective)?.about ?? "";
    }

    /** @param {Control} control */
    #showChoices({ choices, default: standard, value }) {
        const shown = JSON.stringify([choices, standard, value]);
        if (shown === this.#shown) return;
        this.#shown = shown;
        const now = textOf(value);
        const first = standard === null ? "default" : `default (${textOf(standard)})`;
        const options = choices.map(({ name, about, refused }) => {
            const isRefused = refused !== null && name !== now;
            return element("option", { value: name, disabled: isRefused, title: refused ?? about }, name);
        });
        const known = value === null || choices.some(({ name }) => name === now);
        const own = known ? [] : [element("option", { value: now }, now)];
        this.input.replaceChildren(element("option", { value: "" }, first), ...options, ...own);
        this.#showRefused();
    }

    #showRefused() {
        const refused = this.#control?.choices.filter((choice) => choice.refused !== null) ?? [];
        const reasons = refused.flatMap(({ name, refused }) => [
            element("dt", {}, name),
            element("dd", {}, refused ?? ""),
        ]);
        const summary = `${refused.length} of ${this.#control?.choices.length} cannot be chosen now`;
        this.#refused.hidden = refused.length === 0;
        this.#refused.replaceChildren(element("summary", {}, summary), element("dl", {}, ...reasons));
    }

    focus() {
        this.input.focus();
    }
}

/**
 * A text, the name of a file, or a value that a scene file writes in its own way.
 * @implements {Field}
 */
class TextField {
    #isWritten;
    #around;
    #entry;
    #list = element("datalist", { id: newId() });

    /**
     * @param {Control} control
     * @param {Around} around
     */
    constructor(control, around) {
        this.#isWritten = control.kind === "other";
        this.#around = around;
        const attributes = {
            type: "text",
            id: around.id,
            "aria-describedby": around.about,
            spellcheck: "false",
        };
        this.input = element("input", { ...attributes, autocomplete: "off", autocapitalize: "off" });
        this.#entry = new Entry(this.input);
        this.node = element("div", { class: "field" }, this.input);
        if (control.kind === "name-or-file") this.#offer(control);
        if (control.is_file || control.kind === "name-or-file") this.node.append(...chooser(control, around));
        this.input.addEventListener("change", () => this.#changed());
        this.input.addEventListener("keydown", ({ key }) => key === "Escape" && this.back());
    }

    /** @param {Control} control */
    #offer({ choices }) {
        const options = choices.map(({ name, about }) =>
            element("option", { value: name, label: about || name }),
        );
        this.#list.replaceChildren(...options);
        this.input.setAttribute("list", this.#list.id);
        this.node.append(this.#list);
    }

    #changed() {
        const { set, lose } = this.#around;
        if (!this.#entry.isTyped) return this.back();
        const text = this.#entry.value;
        const value = this.#isWritten ? text : written(text);
        enter([this.#entry], () => (text === "" ? lose() : set(value)));
    }

    back() {
        this.#entry.back();
        this.#around.refuse("");
    }

    /** @param {Control} control */
    show(control) {
        const text = this.#isWritten ? (control.value ?? "") : textOf(control.value);
        this.#entry.follow(text);
        const standard = control.is_file ? "none" : "default";
        this.input.placeholder = control.default === null ? standard : `default: ${textOf(control.default)}`;
        this.input.title = text;
    }

    get holds() {
        return this.#entry.isTyped;
    }

    focus() {
        this.input.focus();
    }
}

/**
 * A button that opens the browser's choice of files.
 * @param {Control} control
 * @param {Around} around
 */
function chooser({ label }, around) {
    const input = element("input", { type: "file", hidden: true, tabindex: "-1" });
    const button = element(
        "button",
        { type: "button", "aria-label": `Choose file for ${label}` },
        "Choose file",
    );
    button.addEventListener("click", () => input.click());
    input.addEventListener("change", () => {
        const file = input.files?.[0];
        if (file) around.give(file);
        input.value = "";
    });
    return [button, input];
}
