// What the page and every host share: the errors of a host, and numbers of drags and drops.

/** @import { AboutPicture } from "./protocol.d.ts" */

/** The host refused a request and said why. Nothing has changed. */
export class Refused extends Error {}

/** Another change ended the request: ask again. */
export class Outdated extends Error {}

/** The host does not answer. */
export class Gone extends Error {
    /** @param {string} [why] */
    constructor(why = "") {
        super(why);
    }
}

/**
 * The pixels of each view, which lie one after the other; null for one that cannot be drawn.
 * @param {AboutPicture} about
 * @param {ArrayBuffer} bytes
 * @param {number} begin place of the first
 */
export function viewsOf({ size: [width, height], views }, bytes, begin) {
    return views.map(({ failed }) => {
        if (failed !== null) return null;
        const pixels = new Uint8ClampedArray(bytes, begin, width * height * 4);
        begin += pixels.length;
        return pixels;
    });
}

/** A number for a group of requests. It also differs from the numbers of pages opened earlier. */
let last = Date.now() * 1000;
export function newNumber() {
    last += 1;
    return last;
}
