// The errors of a view in words.

/** @import { Figures } from "./protocol.d.ts" */

/**
 * @param {Figures} figures
 * @returns {string[]}
 */
export function figuresOf(figures) {
    if ("flip" in figures) return [`mean FLIP ${short(figures.flip)}`];
    if ("rms" in figures) {
        const ratio = figures.psnr_db === null ? "equal in 8 bits" : `PSNR ${figures.psnr_db.toFixed(1)} dB`;
        return [`RMS ${short(figures.rms)}`, ratio];
    }
    return [
        `median ${short(figures.median_texels)} texels`,
        `99 % within ${short(figures.p99_texels)}`,
        `passed ${percent(figures.passed)}`,
    ];
}

/**
 * A number in three digits, without trailing zeros.
 * @param {number} number
 */
export function short(number) {
    if (number === 0) return "0";
    if (Math.abs(number) < 1e-4 || Math.abs(number) >= 1e6) return number.toExponential(1);
    return `${Number(number.toPrecision(3))}`;
}

/** @param {number} share */
function percent(share) {
    return share === 0 ? "0 %" : `${short(100 * share)} %`;
}
