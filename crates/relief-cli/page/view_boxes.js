// What stands over each view: its method, what it shows, the legend, and its errors.

/** @import { AboutPicture, AboutView, Action, Control, State } from "./protocol.d.ts" */
/** @import { Session } from "./session.js" */

import { byId, element } from "./elements.js";
import { figuresOf } from "./figures.js";
import { arranges } from "./picture.js";
import { newNumber } from "./shared.js";
import { controlOf, textOf, written } from "./values.js";

/** Methods of a second view when it is opened: the truth beside any other method. */
const SECOND = ["exact", "relief"];

/** Least distance between two numbers of a legend, as a part of its width. */
const APART = 0.24;

export class ViewBoxes {
    #session;
    #failed;
    #worst;
    /** @type {Box[]} */ #boxes;
    /** @type {string[]} */ #methods = [];
    #hasSecond = false;
    /** Whether the second view has a method and a number of its own. */
    #given = [false, false];
    /** What the first view shows. */
    #first = "picture";

    /**
     * @param {Session} session
     * @param {(error: unknown) => void} failed
     * @param {(pixel: [number, number], view: number) => void} worst shows a pixel of a view
     */
    constructor(session, failed, worst) {
        this.#session = session;
        this.#failed = failed;
        this.#worst = worst;
        const set = (/** @type {string} */ key, /** @type {string} */ name) => {
            if (name !== "") this.#act({ do: "set", key, value: written(name) });
            else if (key === "viewer.show" || this.#given.every((given) => given)) this.#act({ do: "lose", key });
            else this.#showTwice();
        };
        this.#boxes = [
            new Box("first", ["viewer.show"], set, (pixel) => this.#worst(pixel, 0)),
            new Box("second", ["viewer.second", "viewer.second-show"], set, (pixel) => this.#worst(pixel, 1)),
        ];
        byId("keep-second").addEventListener("click", () => this.#act({ do: "keep-second" }));
        byId("close-second").addEventListener("click", () => this.toggle());
        for (const button of document.querySelectorAll('[data-do="compare"]')) {
            button.addEventListener("click", () => this.toggle());
        }
        session.listen({
            state: (state) => this.#state(state),
            changed: (keys) => keys.every(arranges) || this.#boxes.forEach((box) => box.age()),
        });
    }

    /** The method of each view. */
    get methods() {
        return this.#methods;
    }

    /** Opens the second view, or closes it. */
    toggle() {
        if (!this.#hasSecond) {
            const value = SECOND.find((name) => name !== this.#methods[0]) ?? "exact";
            this.#act({ do: "set", key: "viewer.second", value });
            return;
        }
        // Both are undone together.
        const drag = newNumber();
        for (const key of ["viewer.second", "viewer.second-show"]) this.#act({ do: "lose", key }, drag);
    }

    /** The second view shows the same as the first one, and stays: something else is to be chosen next. */
    #showTwice() {
        const drag = newNumber();
        this.#act({ do: "set", key: "viewer.second-show", value: written(this.#first) }, drag);
        this.#act({ do: "lose", key: "viewer.second" }, drag);
    }

    /** @param {AboutPicture} about */
    drawn({ views }) {
        this.#methods = views.map(({ method }, number) => method ?? this.#methods[number] ?? "");
        views.forEach((view, number) => this.#boxes[number]?.drawn(view));
    }

    /** @param {State} state */
    #state({ panel }) {
        const given = (/** @type {string} */ key) => controlOf(panel, key)?.value ?? null;
        this.#given = ["viewer.second", "viewer.second-show"].map((key) => given(key) !== null);
        this.#hasSecond = this.#given.includes(true);
        const first = controlOf(panel, "viewer.show");
        this.#first = textOf(first?.value ?? first?.default ?? "picture");
        for (const box of this.#boxes) box.state((key) => controlOf(panel, key));
        byId("second").hidden = !this.#hasSecond;
        if (!this.#hasSecond) this.#methods.splice(1);
        for (const button of document.querySelectorAll('[data-do="compare"]')) {
            button.setAttribute("aria-pressed", `${this.#hasSecond}`);
        }
    }

    /**
     * @param {Action} action
     * @param {number | null} [drag]
     */
    async #act(action, drag = null) {
        try {
            await this.#session.apply(action, drag);
        } catch (error) {
            this.#failed(error);
        }
    }
}

/** The box of a view. */
class Box {
    /** @type {Map<string, HTMLSelectElement>} */ #selects = new Map();
    #shown = "";
    #method;
    #legend;
    #figures;
    #failed;
    #worst;
    /** @type {[number, number] | null} */ #pixel = null;
    #box;
    #isOld = false;
    /** Whether the worst pixel of the next picture is to be shown. */
    #isAsked = false;
    #show;

    /**
     * @param {string} id
     * @param {string[]} keys
     * @param {(key: string, name: string) => void} set
     * @param {(pixel: [number, number]) => void} worst
     */
    constructor(id, keys, set, worst) {
        const box = byId(id);
        this.#box = box;
        this.#show = worst;
        const part = (/** @type {string} */ name) => {
            const found = box.querySelector(`.${name}`);
            if (!(found instanceof HTMLElement)) throw new Error(`the view '${id}' has no ${name}`);
            return found;
        };
        this.#legend = part("legend");
        this.#figures = part("figures");
        this.#failed = part("failed");
        this.#method = box.querySelector(".method");
        for (const key of keys) {
            const select = box.querySelector(`select[data-choice="${key}"]`);
            if (!(select instanceof HTMLSelectElement)) throw new Error(`there is no choice of ${key}`);
            select.addEventListener("change", () => set(key, select.value));
            this.#selects.set(key, select);
        }
        this.#worst = part("worst");
        this.#worst.addEventListener("click", () => this.#ask());
    }

    #ask() {
        if (this.#isOld) this.#isAsked = true;
        else if (this.#pixel) this.#show(this.#pixel);
    }

    /** What it says is of a picture that will be another soon. */
    age() {
        this.#isOld = true;
        this.#box.classList.add("old");
        this.#figures.setAttribute("aria-busy", "true");
    }

    /** @param {(key: string) => Control | undefined} controlled */
    state(controlled) {
        const controls = [...this.#selects.keys()].map(controlled);
        const shown = JSON.stringify(controls.map((control) => [control?.choices, control?.value]));
        if (shown === this.#shown) return;
        this.#shown = shown;
        [...this.#selects.values()].forEach((select, number) => {
            const control = controls[number];
            if (control) showChoices(select, control);
        });
    }

    /** @param {AboutView} view */
    drawn({ method, legend, errors, failed }) {
        if (this.#method && method) this.#method.textContent = method;
        this.#failed.textContent = failed ?? "";
        this.#legend.replaceChildren(...(legend ? legendOf(legend) : []));
        const lines = errors ? figuresOf(errors.figures) : [];
        this.#figures.replaceChildren(...lines.map((line) => element("span", {}, line)));
        this.#pixel = errors?.worst ?? null;
        this.#worst.hidden = this.#pixel === null;
        this.#isOld = false;
        this.#box.classList.remove("old");
        this.#figures.setAttribute("aria-busy", "false");
        if (this.#isAsked) this.#ask();
        this.#isAsked = false;
    }
}

/**
 * @param {HTMLSelectElement} select
 * @param {Control} control
 */
function showChoices(select, { key, choices, value, default: standard }) {
    const now = textOf(value);
    const first = key === "viewer.second" ? "this method" : standard === null ? "the same" : textOf(standard);
    const others = choices.filter(({ name }) => standard === null || name !== textOf(standard));
    const options = others.map(({ name, about, refused }) =>
        element(
            "option",
            { value: name, disabled: refused !== null && name !== now, title: refused ?? about },
            name,
        ),
    );
    select.replaceChildren(element("option", { value: "" }, first), ...options);
    select.value = standard !== null && now === textOf(standard) ? "" : now;
}

/**
 * @param {import("./protocol.d.ts").Legend} legend
 * @returns {HTMLElement[]}
 */
function legendOf({ title, stops, ticks }) {
    const name = element("p", {}, title);
    if (stops.length === 0) return [name];
    const bar = element("div", { class: "bar", "aria-hidden": "true" });
    bar.style.background = `linear-gradient(to right, ${stops.join(", ")})`;
    const shown = apart(ticks).map(({ place, label }) => {
        const tick = element("span", {}, label);
        tick.style.left = `${100 * place}%`;
        tick.style.translate = `${-100 * place}%`;
        return tick;
    });
    return [name, bar, element("div", { class: "ticks" }, ...shown)];
}

/**
 * The numbers that have room: the ends, which come first, and what lies apart from them.
 * @param {{ place: number, label: string }[]} ticks
 */
function apart(ticks) {
    /** @type {typeof ticks} */
    const kept = [];
    for (const tick of ticks) {
        if (kept.every(({ place }) => Math.abs(place - tick.place) >= APART)) kept.push(tick);
    }
    return kept.sort((a, b) => a.place - b.place);
}
