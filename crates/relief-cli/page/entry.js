// A text field and what a person types in it. What is typed stays until the scene has it, or until it is
// taken back; otherwise the field follows the scene.

/** @import { Applied } from "./protocol.d.ts" */

export class Entry {
    /** The scene's text. */
    #text = "";
    /** Whether the field holds a text that the scene does not have. */
    #typed = false;
    /** Number of times that the text is on its way to the scene. */
    #sent = 0;

    /** @param {HTMLInputElement} input */
    constructor(input) {
        this.input = input;
        input.addEventListener("input", () => (this.#typed = true));
    }

    /** What the field holds, without space around it. */
    get value() {
        return this.input.value.trim();
    }

    /** Whether the field holds a text that the scene does not have, such as one that was refused. */
    get isTyped() {
        return this.#typed && this.value !== this.#text;
    }

    /**
     * Shows the scene's text, unless another one is being typed, or was refused and waits to be corrected.
     * @param {string} text
     */
    follow(text) {
        const isInHand = document.activeElement === this.input || this.#sent > 0;
        if (this.isTyped && (isInHand || text === this.#text)) {
            this.#text = this.input.defaultValue = text;
        } else {
            this.put(text);
        }
    }

    /**
     * Makes a text the field's, as if the scene had it.
     * @param {string} text
     */
    put(text) {
        const { input } = this;
        const isChosen = document.activeElement === input && isSelected(input);
        this.#typed = false;
        this.#text = input.defaultValue = text;
        if (input.value === text) return;
        input.value = text;
        if (isChosen) input.select();
    }

    /** Takes back what was typed. */
    back() {
        this.put(this.#text);
    }

    /** Says that the text is on its way. Returns it. */
    send() {
        this.#sent += 1;
        return this.value;
    }

    /**
     * Says what came of a text: it stays if it was refused, or if another one has been typed since.
     * @param {string} text
     * @param {Applied | null} applied
     */
    settle(text, applied) {
        this.#sent -= 1;
        if (!applied || this.value !== text) return;
        this.#typed = false;
        if (applied.changed.length === 0) this.back();
    }
}

/**
 * Enters texts that belong together.
 * @param {Entry[]} entries
 * @param {() => Promise<Applied | null>} send
 */
export async function enter(entries, send) {
    const texts = entries.map((entry) => entry.send());
    const applied = await send();
    entries.forEach((entry, place) => entry.settle(texts[place] ?? "", applied));
}

/** @param {HTMLInputElement} input */
function isSelected({ selectionStart, selectionEnd, value }) {
    return value !== "" && selectionStart === 0 && selectionEnd === value.length;
}
