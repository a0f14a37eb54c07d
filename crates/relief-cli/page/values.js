// Values as a scene file writes them (TOML), and numbers as people read them.

/** @import { Control, Panel } from "./protocol.d.ts" */

/** What follows a backslash in a text. */
const ESCAPES = /** @type {Record<string, string>} */ ({
    b: "\b",
    t: "\t",
    n: "\n",
    f: "\f",
    r: "\r",
    e: "\x1b",
});

/**
 * The text in a written value: without quotation marks if it has some.
 * @param {string | null} written
 */
export function textOf(written) {
    if (written === null) return "";
    const literal = /^'''\n?([^]*)'''$/.exec(written) ?? /^'([^']*)'$/.exec(written);
    if (literal) return literal[1] ?? "";
    const basic = /^"""\n?([^]*)"""$/.exec(written) ?? /^"([^]*)"$/.exec(written);
    return basic ? unescaped(basic[1] ?? "") : written;
}

/** @param {string} text */
function unescaped(text) {
    return text.replace(
        /\\(?:u([0-9A-Fa-f]{4})|U([0-9A-Fa-f]{8})|x([0-9A-Fa-f]{2})|([^]))/g,
        (_, four, eight, two, one) => {
            const code = four ?? eight ?? two;
            return code ? String.fromCodePoint(parseInt(code, 16)) : (ESCAPES[one] ?? one);
        },
    );
}

/**
 * A text as a scene file writes it.
 * @param {string} text
 */
export function written(text) {
    return JSON.stringify(text).replace(/\x7f/g, "\\u007f");
}

/**
 * The number that is written; null if it is none, or not a finite one.
 * @param {string | null} written
 */
export function numberOf(written) {
    const plain = written?.trim().replace(/_/g, "") ?? "";
    if (!/^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/.test(plain)) return null;
    const number = Number(plain);
    return Number.isFinite(number) ? number : null;
}

/**
 * The numbers of a written list; null if it is none.
 * @param {string | null} written
 * @param {number} count
 * @returns {number[] | null}
 */
export function numbersOf(written, count) {
    const inner = /^\s*\[([^\]]*)\]\s*$/.exec(written ?? "")?.[1];
    const numbers = inner
        ?.split(",")
        .filter((part) => part.trim() !== "")
        .map(numberOf);
    if (numbers?.length !== count) return null;
    const all = numbers.filter((number) => number !== null);
    return all.length === count ? all : null;
}

/**
 * A number with this many digits, without zeros at its end.
 * @param {number} number
 * @param {number} digits
 */
export function rounded(number, digits = 3) {
    return Number(number.toPrecision(digits));
}

/**
 * The sum of a number and a step, without the last digits that only binary numbers have.
 * @param {number} number
 * @param {number} step
 */
export function stepped(number, step) {
    return Number((number + step).toPrecision(12));
}

/**
 * The control of a key of the scene.
 * @param {Panel} panel
 * @param {string} key
 * @returns {Control | undefined}
 */
export function controlOf(panel, key) {
    return panel.scene.find((control) => control.key === key);
}
