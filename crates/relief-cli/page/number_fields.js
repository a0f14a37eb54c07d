// Fields for numbers: one with a slider, or several beside each other. Both also take a text, such as "5cm".

/** @import { Control } from "./protocol.d.ts" */
/** @import { Around, Field } from "./fields.js" */
/** @import { Scale } from "./scale.js" */

import { element } from "./elements.js";
import { newNumber } from "./shared.js";
import { numberAt, placeOf, PLACES, scaleOf } from "./scale.js";
import { numberOf, numbersOf, stepped, textOf } from "./values.js";

/** Steps of the page keys. */
const PAGE = 10;

/** @implements {Field} */
export class NumberField {
    #around;
    #slider = element("input", { type: "range", min: "0", max: `${PLACES}`, step: "1" });
    /** @type {Scale | null} */ #scale = null;
    /** @type {number | null} */ #drag = null;
    /** @type {Control | null} */ #control = null;
    #shown = "";

    /** @param {Around} around */
    constructor(around) {
        this.#around = around;
        this.input = element("input", {
            type: "number",
            id: around.id,
            step: "any",
            "aria-describedby": around.about,
        });
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

    /**
     * @param {Control} control
     * @param {boolean} back
     */
    show(control, back = false) {
        const isText = control.value !== null && numberOf(control.value) === null;
        const text = textOf(control.value ?? control.default);
        const number = numberOf(text);
        this.#limit(control, isText);
        const isTyping = document.activeElement === this.input && this.input.value !== this.#shown;
        const shown = number !== null && !isText ? `${number}` : isText ? text : "";
        if (!isTyping || back || shown !== this.#shown) this.input.value = shown;
        this.#shown = this.input.defaultValue = shown;
        this.input.placeholder = control.default === null ? "default" : text;
        this.node.classList.toggle("default", control.value === null);
        this.#control = control;
        if (this.#drag === null) this.#slide(control, number);
    }

    /**
     * @param {Control} control
     * @param {boolean} isText
     */
    #limit({ min, max, kind }, isText) {
        this.input.type = isText ? "text" : "number";
        this.input.inputMode = kind === "whole" && (min ?? -1) >= 0 ? "numeric" : "decimal";
        this.input.min = min === null ? "" : `${min}`;
        this.input.max = max === null ? "" : `${max}`;
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
        this.#enter(`${number}`);
        this.#say(number);
        this.#around.set(number, this.#drag ?? this.#around.burst());
    }

    /** @param {string} text what the field shows, and the scene gets */
    #enter(text) {
        this.input.value = this.input.defaultValue = this.#shown = text;
    }

    #released() {
        this.#drag = null;
        if (this.#control) this.#slide(this.#control, numberOf(this.#shown));
    }

    #typed() {
        const text = this.input.value.trim();
        if (text === this.#shown) return;
        // A browser hands out no text of a number field that is no number.
        if (text === "" && this.input.validity.badInput) return this.#around.refuse("This is not a number.");
        if (text === "") return this.#around.lose();
        this.#around.set(numberOf(text) ?? text);
    }

    /** @param {KeyboardEvent} event */
    #key(event) {
        const steps = stepsOf(event);
        if (event.key === "Escape") this.input.value = this.#shown;
        if (steps === 0 || this.input.type !== "number" || !this.#control) return;
        event.preventDefault();
        const number = nextNumber(this.#control, numberOf(this.input.value), steps);
        this.#enter(`${number}`);
        this.#around.set(number, this.#around.burst());
    }

    focus() {
        this.input.focus();
    }
}

/** @implements {Field} */
export class NumbersField {
    #around;
    #inputs;
    #text;
    #button;
    #count;
    #shown = "";

    /**
     * @param {number} count
     * @param {Around} around
     */
    constructor(count, around) {
        this.#around = around;
        this.#count = count;
        const described = { "aria-labelledby": around.label, "aria-describedby": around.about };
        this.#inputs = Array.from({ length: count }, () => element("input", { type: "number", step: "any" }));
        this.#text = element("input", {
            type: "text",
            id: around.id,
            ...described,
            hidden: true,
            spellcheck: "false",
        });
        this.#button = element(
            "button",
            { type: "button", class: "as-text", "aria-pressed": "false" },
            "Text",
        );
        this.node = element(
            "fieldset",
            { class: "field", ...described },
            ...this.#inputs,
            this.#text,
            this.#button,
        );
        this.input = this.node;
        this.node.addEventListener("change", () => this.#changed());
        this.#button.addEventListener("click", () => this.#write(this.#text.hidden === true));
        for (const input of this.#inputs)
            input.addEventListener("keydown", (event) => this.#key(event, input));
    }

    /**
     * @param {Control} control
     * @param {boolean} back
     */
    show(control, back = false) {
        const now = control.value ?? control.default;
        const numbers = numbersOf(now, this.#count);
        const shown = now ?? "";
        const isOther = back || shown !== this.#shown;
        const stays = !isOther && this.#isHalf();
        this.#button.setAttribute("aria-label", `Write ${control.label} as text`);
        this.#inputs.forEach((input, place) => {
            this.#describe(input, place, control);
            input.defaultValue = numbers ? `${numbers[place]}` : "";
            if (!stays) input.value = input.defaultValue;
        });
        this.#text.defaultValue = textOf(now);
        if (isOther || document.activeElement !== this.#text) this.#text.value = textOf(now);
        this.#shown = shown;
        this.node.classList.toggle("default", control.value === null);
        if (control.value !== null && !numbers) this.#write(true);
    }

    /**
     * @param {HTMLInputElement} input
     * @param {number} place
     * @param {Control} control
     */
    #describe(input, place, { label, min, max, step }) {
        input.setAttribute("aria-label", `${label} ${place + 1} of ${this.#count}`);
        input.min = min === null ? "" : `${min}`;
        input.max = max === null ? "" : `${max}`;
        input.placeholder = "default";
        input.dataset["step"] = `${step ?? 1}`;
    }

    /** Whether some of the numbers have been entered and others not. */
    #isHalf() {
        const empty = this.#inputs.filter((input) => input.value === "").length;
        return empty > 0 && empty < this.#count;
    }

    /**
     * Shows one field for a text in place of the numbers, or takes it away.
     * @param {boolean} asText
     */
    #write(asText) {
        this.#text.hidden = !asText;
        for (const input of this.#inputs) input.hidden = asText;
        this.#button.setAttribute("aria-pressed", `${asText}`);
    }

    #changed() {
        if (!this.#text.hidden) return this.#changedText(this.#text.value.trim());
        const numbers = this.#inputs.map((input) => numberOf(input.value));
        const given = numbers.filter((number) => number !== null);
        if (given.length === 0) this.#around.lose();
        else if (given.length === this.#count) this.#around.set(given);
    }

    /** @param {string} text */
    #changedText(text) {
        if (text === textOf(this.#shown)) return;
        if (text === "") this.#around.lose();
        else this.#around.set(text);
    }

    /**
     * @param {KeyboardEvent} event
     * @param {HTMLInputElement} input
     */
    #key(event, input) {
        const steps = stepsOf(event);
        if (steps === 0) return;
        event.preventDefault();
        const { min, max } = input;
        const limits = { min: min === "" ? null : Number(min), max: max === "" ? null : Number(max) };
        const step = Number(input.dataset["step"]);
        input.value = `${nextNumber({ ...limits, step }, numberOf(input.value), steps)}`;
        const numbers = this.#inputs.map((each) => numberOf(each.value)).filter((number) => number !== null);
        if (numbers.length === this.#count) this.#around.set(numbers, this.#around.burst());
    }

    focus() {
        const first = this.#text.hidden ? this.#inputs[0] : this.#text;
        first?.focus();
    }
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
