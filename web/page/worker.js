// The module in a worker: it answers the page's requests one after the other.

/** @import { Request, Stop } from "./worker_messages.d.ts" */

import init, { SceneFiles } from "./relief_web.js";

/** Milliseconds between two looks whether the work is to end, and between two words on its progress. */
const LOOK = 40;

/** @type {import("./relief_web.js").Relief | undefined} */
let relief;
/** The requests, one after the other. @type {Promise<unknown>} */
let before = init({ module_or_path: new URL("relief_web_bg.wasm", import.meta.url) });

onmessage = ({ data }) => {
    before = before.then(() => answer(data));
};

/** @param {Request} request */
async function answer({ id, name, args }) {
    try {
        const call = calls[name];
        if (!call) throw new Error(`there is no ${name}`);
        const done = await call(args);
        postMessage({ id, done }, { transfer: sharedOf(done) });
    } catch (error) {
        // After a fault of its own the module must not be used any more.
        const isFault = error instanceof WebAssembly.RuntimeError;
        postMessage({ id, failed: error instanceof Error ? error.message : String(error), isFault });
    }
}

/**
 * The bytes of an answer, which the page gets without a copy.
 * @param {unknown} done
 * @returns {Transferable[]}
 */
function sharedOf(done) {
    const bytes = done instanceof Object ? Object.values(done).filter((part) => part instanceof Uint8Array) : [];
    return bytes.map(({ buffer }) => buffer);
}

function opened() {
    if (!relief) throw new Error("no scene is open");
    return relief;
}

/** @type {Record<string, (args: any) => unknown>} */
const calls = {
    /** @param {{ files: { path: string, file: Blob }[], scene: string, isSample: boolean, needs: string | null }} args */
    async open({ files, scene, isSample, needs }) {
        const all = new SceneFiles();
        for (const { path, file } of files) all.add(path, await bytesOf(file));
        relief?.free();
        relief = all.open(scene, isSample);
        if (needs !== null) relief.need(needs);
    },
    state: () => ({ state: JSON.parse(opened().state()), text: opened().text() }),
    apply: (sent) => JSON.parse(opened().apply(JSON.stringify(sent))),
    picture({ wish, stop }) {
        const drawn = opened().picture(JSON.stringify(wish), heard(stop));
        if (!drawn) return null;
        const pixels = drawn.pixels();
        return { about: JSON.parse(drawn.about), pixels };
    },
    pixel({ at: [x, y], stop }) {
        const found = opened().pixel(x, y, heard(stop));
        return found === undefined ? undefined : JSON.parse(found);
    },
    async give({ group, path, file }) {
        opened().give(group, path, await bytesOf(file));
    },
    take: ({ group, key }) => JSON.parse(opened().take(group, key ?? undefined)),
    link: ({ link, begins }) => JSON.parse(opened().open_link(link, begins)),
    made_link: () => ({ text: opened().link() }),
    save({ what, view, stop }) {
        const bytes = opened().save(what, view, heard(stop));
        return { bytes };
    },
};

/** @param {Blob} file */
async function bytesOf(file) {
    return new Uint8Array(await file.arrayBuffer());
}

/**
 * A function that tells the page of progress, and hears whether the work is to end. While the module works no
 * message comes in; but an address that the page takes back can no longer be read.
 * @param {Stop} stop
 */
function heard(stop) {
    let last = performance.now();
    return (/** @type {string} */ task, /** @type {number} */ part) => {
        const now = performance.now();
        if (now - last < LOOK) return false;
        last = now;
        postMessage({ progress: { task, part } });
        return stop !== null && isTakenBack(stop);
    };
}

/** @param {string} address */
function isTakenBack(address) {
    const request = new XMLHttpRequest();
    try {
        request.open("GET", address, false);
        request.send();
        return false;
    } catch {
        return true;
    }
}
