// Fields for numbers: one with a slider, or several beside each other. Both take lengths such as "5cm".

/** @import { Control } from "./protocol.d.ts" */
/** @import { Around, Field } from "./fields.js" */
/** @import { Scale } from "./scale.js" */

import { element } from "./elements.js";
import { Entry, enter } from "./entry.js";
import { newNumber } from "./shared.js";
import { numberAt, placeOf, PLACES, scaleOf } from "./scale.js";
import { numberOf, numbersOf, stepped, textOf, written } from "./values.js";

/** Steps of the page keys. */
const PAGE = 10;

/** @implements {Field} */
export class NumberField {
    #around;
    #slider = element("input", { type: "range", min: "0", max: `${PLACES}`, step: "1" });
    /** @type {Scale | null} */ #scale = null;
    /** @type {number | null} */ #drag = null;
    /** @type {Control | null} */ #control = null;
    #entry;

    /** @param {Around} around */
    constructor(around) {
        this.#around = around;
        this.input = numberInput({ id: around.id, "aria-describedby": around.about });
        this.#entry = new Entry(this.input);
        this.node = element("div", { class: "field" }, this.#slider, this.input);
        this.#slider.setAttribute("aria-labelledby", around.label);
        this.input.addEventListener("change", () => this.#typed());
        this.input.addEventListener("keydown", (event) => this.#key(event));
        this.#slider.addEventListener("pointerdown", () => (this.#drag = newNumber()));
        this.#slider.addEventListener("input", () => this.#slid());
        for (const end of ["change", "pointerup", "pointercancel", "blur"]) {
            this.#slider.addEventListener(end, () => this.#released());
        }
    }

    /** @param {Control} control */
    show(control) {
        const isText = control.value !== null && numberOf(control.value) === null;
        const text = textOf(control.value ?? control.default);
        const number = numberOf(text);
        this.input.inputMode = keyboardFor(control);
        this.#entry.follow(number !== null && !isText ? `${number}` : isText ? text : "");
        this.input.placeholder = control.default === null ? "default" : text;
        this.node.classList.toggle("default", control.value === null && !this.#entry.isTyped);
        this.#control = control;
        if (this.#drag === null) this.#slide(control, number);
    }

    get holds() {
        return this.#entry.isTyped;
    }

    /**
     * @param {Control} control
     * @param {number | null} number
     */
    #slide(control, number) {
        this.#scale = scaleOf(control);
        this.#slider.hidden = this.#scale === null;
        this.node.classList.toggle("unknown", number === null);
        if (!this.#scale) return;
        const { from, to } = this.#scale;
        this.#slider.value = `${Math.round(PLACES * placeOf(this.#scale, number ?? (from + to) / 2))}`;
        this.#say(number);
    }

    /** @param {number | null} number */
    #say(number) {
        const unit = this.#control?.unit ?? "";
        this.#slider.setAttribute("aria-valuetext", number === null ? "default" : `${number} ${unit}`.trim());
    }

    #slid() {
        if (!this.#scale) return;
        const number = numberAt(this.#scale, Number(this.#slider.value) / PLACES);
        this.#entry.put(`${number}`);
        this.#say(number);
        this.#around.set(number, this.#drag ?? this.#around.burst());
    }

    #released() {
        this.#drag = null;
        if (this.#control) this.show(this.#control);
    }

    #typed() {
        if (!this.#control) return;
        if (!this.#entry.isTyped) return this.back();
        const text = this.#entry.value;
        const part = partOf(text, this.#control);
        if (part.wrong !== null) return this.#around.refuse(part.wrong);
        const { set, lose } = this.#around;
        enter([this.#entry], () => (text === "" ? lose() : set(part.number ?? text)));
    }

    back() {
        this.#entry.back();
        this.#around.refuse("");
    }

    /** @param {KeyboardEvent} event */
    #key(event) {
        if (event.key === "Escape") this.back();
        const steps = stepsOf(event);
        const { value } = this.#entry;
        const now = numberOf(value);
        if (steps === 0 || !this.#control || (value !== "" && now === null)) return;
        event.preventDefault();
        const number = nextNumber(this.#control, now, steps);
        this.#entry.put(`${number}`);
        this.#around.set(number, this.#around.burst());
    }

    focus() {
        this.input.focus();
    }
}

/** @implements {Field} */
export class NumbersField {
    #around;
    #entries;
    #text;
    #button;
    #count;
    /** @type {Control | null} */ #control = null;

    /**
     * @param {number} count
     * @param {Around} around
     */
    constructor(count, around) {
        this.#around = around;
        this.#count = count;
        const described = { "aria-labelledby": around.label, "aria-describedby": around.about };
        this.#entries = Array.from({ length: count }, () => new Entry(numberInput({})));
        const attributes = { type: "text", id: around.id, ...described, hidden: true, spellcheck: "false" };
        this.#text = new Entry(element("input", attributes));
        this.#button = element(
            "button",
            { type: "button", class: "as-text", "aria-pressed": "false" },
            "Text",
        );
        const inputs = this.#entries.map(({ input }) => input);
        this.node = element(
            "fieldset",
            { class: "field", ...described },
            ...inputs,
            this.#text.input,
            this.#button,
        );
        this.input = this.node;
        this.node.addEventListener("change", () => this.#changed());
        this.node.addEventListener("keydown", ({ key }) => key === "Escape" && this.back());
        this.#button.addEventListener("click", () => this.#write(!this.#isText));
        for (const entry of this.#entries)
            entry.input.addEventListener("keydown", (event) => this.#key(event, entry));
    }

    /** @param {Control} control */
    show(control) {
        const now = control.value ?? control.default;
        const numbers = numbersOf(now, this.#count);
        this.#control = control;
        this.#button.setAttribute("aria-label", `Write ${control.label} as text`);
        this.#entries.forEach((entry, place) => {
            this.#describe(entry.input, place, control);
            entry.follow(numbers ? `${numbers[place]}` : "");
        });
        this.#text.follow(textOf(now));
        this.node.classList.toggle("default", control.value === null && !this.holds);
        if (control.value !== null && !numbers && !this.holds) this.#write(true);
    }

    get holds() {
        return [this.#text, ...this.#entries].some((entry) => entry.isTyped);
    }

    /** Whether one field for a text is shown in place of the numbers. */
    get #isText() {
        return this.#text.input.hidden !== true;
    }

    /**
     * @param {HTMLInputElement} input
     * @param {number} place
     * @param {Control} control
     */
    #describe(input, place, control) {
        input.setAttribute("aria-label", `${control.label} ${place + 1} of ${this.#count}`);
        input.inputMode = keyboardFor(control);
        input.placeholder = "default";
    }

    /**
     * Shows one field for a text in place of the numbers, or takes it away.
     * @param {boolean} asText
     */
    #write(asText) {
        this.#text.input.hidden = !asText;
        for (const { input } of this.#entries) input.hidden = asText;
        this.#button.setAttribute("aria-pressed", `${asText}`);
    }

    #changed() {
        const { set, lose, refuse } = this.#around;
        if (!this.#control) return;
        if (!this.holds) return this.back();
        if (this.#isText) {
            const text = this.#text.value;
            return void enter([this.#text], () => (text === "" ? lose() : set(asWritten(text))));
        }
        const control = this.#control;
        const given = this.#entries.filter(({ value }) => value !== "");
        const parts = given.map(({ value }) => ({ value, ...partOf(value, control) }));
        const wrong = parts.find((part) => part.wrong !== null)?.wrong;
        if (wrong) return refuse(wrong);
        if (given.length === 0) enter(this.#entries, lose);
        else if (given.length === this.#count) enter(this.#entries, () => set(listOf(parts)));
    }

    back() {
        for (const entry of [this.#text, ...this.#entries]) entry.back();
        this.#around.refuse("");
    }

    /**
     * @param {KeyboardEvent} event
     * @param {Entry} entry
     */
    #key(event, entry) {
        const steps = stepsOf(event);
        const now = numberOf(entry.value);
        if (steps === 0 || !this.#control || (entry.value !== "" && now === null)) return;
        event.preventDefault();
        entry.put(`${nextNumber(this.#control, now, steps)}`);
        const numbers = this.#entries.map(({ value }) => numberOf(value)).filter((number) => number !== null);
        if (numbers.length === this.#count) this.#around.set(numbers, this.#around.burst());
    }

    focus() {
        const first = this.#isText ? this.#text : this.#entries[0];
        first?.input.focus();
    }
}

/**
 * A field for a number. It is one for texts: a browser's own takes letters and commas away without a word.
 * @param {Record<string, string>} attributes
 */
function numberInput(attributes) {
    const plain = { type: "text", class: "number", autocomplete: "off", autocapitalize: "off" };
    return element("input", { ...plain, spellcheck: "false", ...attributes });
}

/**
 * The keyboard of a touch screen: units have letters, and few keyboards of numbers have a minus.
 * @param {Control} control
 */
function keyboardFor({ kind, min, takes_unit }) {
    if (takes_unit || (min ?? -1) < 0) return "text";
    return kind === "whole" ? "numeric" : "decimal";
}

/**
 * What was typed for a number: the number, or none if it is a text for the scene; and what is wrong with it.
 * @param {string} text
 * @param {Control} control
 * @returns {{ number: number | null, wrong: string | null }}
 */
function partOf(text, { takes_unit, unit }) {
    const number = numberOf(text);
    const comma = /^([+-]?\d*),(\d+)\s*([^\d,]*)$/.exec(text);
    if (number !== null || text === "") return { number, wrong: null };
    if (comma) {
        const [, whole, part, behind] = comma;
        return { number, wrong: `“${text}” has a comma: write ${whole || "0"}.${part}${behind}.` };
    }
    if (takes_unit) return { number, wrong: null };
    const plain = unit === "" ? "a number" : `a number, in ${unit}`;
    return { number, wrong: `“${text}” is not ${plain}.` };
}

/**
 * A list of numbers or a text, such as "az=315,alt=45", as a scene file writes it.
 * @param {string} text
 */
function asWritten(text) {
    if (text.startsWith("[")) return text;
    const isList = text.split(",").every((part) => numberOf(part) !== null);
    return isList ? `[${text}]` : written(text);
}

/**
 * Numbers as a list, or as the text of one if some are lengths with units.
 * @param {{ value: string, number: number | null }[]} parts
 */
function listOf(parts) {
    const numbers = parts.map(({ number }) => number).filter((number) => number !== null);
    if (numbers.length === parts.length) return numbers;
    return `[${parts.map(({ value, number }) => number ?? written(value)).join(", ")}]`;
}

/**
 * The steps that a key asks for.
 * @param {KeyboardEvent} event
 */
function stepsOf({ key, altKey, ctrlKey, metaKey }) {
    if (altKey || ctrlKey || metaKey) return 0;
    return { ArrowUp: 1, ArrowDown: -1, PageUp: PAGE, PageDown: -PAGE }[key] ?? 0;
}

/**
 * The number some steps on, within its limits.
 * @param {Pick<Control, "min" | "max" | "step">} limits
 * @param {number | null} number
 * @param {number} steps
 */
function nextNumber({ min, max, step }, number, steps) {
    const next = stepped(number ?? 0, steps * (step ?? 1));
    return Math.min(Math.max(next, min ?? -Infinity), max ?? Infinity);
}
