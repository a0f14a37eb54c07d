// The scale of a slider: which number each of its places stands for.

/** @import { Control } from "./protocol.d.ts" */

import { numberOf, rounded } from "./values.js";

/** Places of a slider. */
export const PLACES = 1000;
/** The widest range that a slider shows as a whole. */
const WIDEST = 10_000;
/** Greatest over least number from which a slider turns logarithmic. */
const RATIO = 100;

/**
 * @typedef {object} Scale
 * @property {number} from number at place 0
 * @property {number} to number at the last place
 * @property {boolean} logarithmic
 * @property {boolean} whole
 */

/**
 * The scale of a control; null if its numbers have no range to slide in.
 * @param {Control} control
 * @returns {Scale | null}
 */
export function scaleOf(control) {
    const { min, max, kind } = control;
    const whole = kind === "whole";
    if (min !== null && max !== null && max > min && max - min <= WIDEST) {
        return { from: min, to: max, logarithmic: min > 0 && max / min >= RATIO, whole };
    }
    const about = numberOf(control.default) || numberOf(control.value);
    return about ? around(about, control, whole) : null;
}

/**
 * A scale from a tenth of a number to ten times the number.
 * @param {number} about
 * @param {Pick<Control, "min" | "max" | "value">} control
 * @param {boolean} whole
 * @returns {Scale | null}
 */
function around(about, { min, max, value }, whole) {
    const ends = [about / 10, about * 10].map((end) =>
        Math.min(Math.max(end, min ?? -Infinity), max ?? Infinity),
    );
    const [from = 0, to = 0] = about > 0 ? ends : ends.reverse();
    const scale = { from, to, logarithmic: from * to > 0, whole };
    const now = numberOf(value);
    const outside = now !== null && (now < from || now > to);
    if (outside && now !== about && now !== 0) return around(now, { min, max, value }, whole);
    return from < to ? scale : null;
}

/**
 * The number at a place.
 * @param {Scale} scale
 * @param {number} place from 0 to 1
 */
export function numberAt({ from, to, logarithmic, whole }, place) {
    if (place <= 0) return from;
    if (place >= 1) return to;
    const number = logarithmic ? from * (to / from) ** place : from + (to - from) * place;
    if (whole) return Math.round(number);
    if (logarithmic) return rounded(number);
    // As many decimals as the range needs for its places.
    const decimals = Math.min(Math.max(Math.ceil(-Math.log10((to - from) / PLACES)), 0), 12);
    return Number(number.toFixed(decimals));
}

/**
 * The place of a number, from 0 to 1.
 * @param {Scale} scale
 * @param {number} number
 */
export function placeOf({ from, to, logarithmic }, number) {
    const inside = Math.min(Math.max(number, from), to);
    const place = logarithmic ? Math.log(inside / from) / Math.log(to / from) : (inside - from) / (to - from);
    return Math.min(Math.max(place, 0), 1);
}
