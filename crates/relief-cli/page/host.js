// The host over HTTP: the only module that knows addresses and statuses.

/** @import { Action, Applied, Drawn, Given, Host, Progress } from "./protocol.d.ts" */
/** @import { ReadPixel, Saved, SavedOf, State, Wish } from "./protocol.d.ts" */

import { Gone, Outdated, Refused, newNumber, viewsOf } from "./shared.js";

/** @implements {Host} */
export class HttpHost {
    canEnd = true;
    keeps = true;
    gone = "The program has ended. Start `relief view` again.";

    /** @returns {Promise<State>} */
    state() {
        return json("state");
    }

    /**
     * @param {Action} action
     * @param {number | null} drag
     * @returns {Promise<Applied>}
     */
    apply(action, drag) {
        return json("apply", posted(drag === null ? { action } : { action, drag }));
    }

    /**
     * @param {Wish} wish
     * @returns {Promise<Drawn>}
     */
    async picture({ width, height, part, samples }) {
        const query = new URLSearchParams({
            width: `${width}`,
            height: `${height}`,
            part: `${part}`,
            samples,
        });
        const answer = await ask(`picture?${query}`);
        return drawn(await arrived(answer.arrayBuffer()));
    }

    /**
     * @param {[number, number]} at
     * @returns {Promise<ReadPixel | null>}
     */
    pixel([x, y]) {
        return json(`pixel?x=${x}&y=${y}`);
    }

    /** @returns {Promise<Progress>} */
    progress() {
        return json("progress");
    }

    /**
     * Sends files, then takes them into the scene.
     * @param {Given[]} files
     * @param {string | null} key control onto which a single file was dropped
     * @param {(part: number) => void} sent
     * @returns {Promise<Applied>}
     */
    async give(files, key, sent) {
        const drop = newNumber();
        const all = files.reduce((sum, { file }) => sum + file.size, 0);
        let done = 0;
        for (const { path, file } of files) {
            sent(all > 0 ? done / all : 0);
            await ask(`files?drop=${drop}&path=${encodeURIComponent(path)}`, { method: "POST", body: file });
            done += file.size;
        }
        sent(1);
        return json("drop", posted({ drop, key }));
    }

    /**
     * @param {string} what
     * @param {SavedOf} of
     * @returns {Promise<Saved>}
     */
    async save(what, { view, surface, revision }) {
        const query = `what=${encodeURIComponent(what)}&view=${view}&surface=${surface}&revision=${revision}`;
        const answer = await ask(`save?${query}`);
        const name = fileName(answer.headers.get("Content-Disposition") ?? "") ?? what;
        return { name, blob: await arrived(answer.blob()) };
    }

    async end() {
        await json("end", { method: "POST" });
    }
}

/**
 * @param {object} body
 * @returns {RequestInit}
 */
function posted(body) {
    return { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body) };
}

/**
 * @param {string} address
 * @param {RequestInit} [request]
 */
async function json(address, request) {
    const answer = await ask(address, request);
    return arrived(answer.json());
}

/**
 * Asks, and throws what went wrong.
 * @param {string} address
 * @param {RequestInit} [request]
 */
async function ask(address, request = {}) {
    const answer = await arrived(fetch(address, { cache: "no-store", ...request }));
    if (answer.ok) return answer;
    const { error } = await answer.json().catch(() => ({ error: null }));
    if (answer.status === 409) throw new Outdated(error ?? "another change ended it");
    // Another program answers here now, or the same one with another address.
    if (error === null && [403, 404].includes(answer.status)) throw new Gone();
    throw new Refused(error ?? `the program answered ${answer.status} to ${address.split("?")[0]}`);
}

/**
 * What is received; a broken connection means that the host has gone.
 * @template T
 * @param {Promise<T>} receiving
 * @returns {Promise<T>}
 */
async function arrived(receiving) {
    try {
        return await receiving;
    } catch {
        throw new Gone();
    }
}

/**
 * @param {ArrayBuffer} bytes
 * @returns {Drawn}
 */
function drawn(bytes) {
    const length = new DataView(bytes).getUint32(0, true);
    const about = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length)));
    return { about, views: viewsOf(about, bytes, 4 + length) };
}

/**
 * The name in a Content-Disposition.
 * @param {string} header
 */
function fileName(header) {
    const encoded = /filename\*\s*=\s*UTF-8''([^;]+)/i.exec(header)?.[1];
    if (encoded !== undefined) return decodeURIComponent(encoded);
    const quoted = /filename\s*=\s*"((?:[^"\\]|\\.)*)"/i.exec(header)?.[1];
    if (quoted !== undefined) return quoted.replace(/\\(.)/g, "$1");
    return /filename\s*=\s*([^;\s]+)/i.exec(header)?.[1];
}
