// The module in a worker: it answers the page's requests one after the other.

/** @import { Request, SceneFile, Stop } from "./worker_messages.d.ts" */

import init, { SceneFiles } from "./relief_web.js";

/** Milliseconds between two looks whether the work is to end, and between two words on its progress. */
const LOOK = 40;

/** The viewers, by their numbers. @type {Map<number, import("./relief_web.js").Relief>} */
const viewers = new Map();
/** @type {(begun: Promise<unknown>) => void} */
let begin;
/** The requests, one after the other, once the module's code has come. @type {Promise<unknown>} */
let before = new Promise((done) => (begin = done));

onmessage = ({ data }) => {
    if (data.code) begin(init({ module_or_path: data.code }));
    else before = before.then(() => answer(data), (error) => fail(data.id, error, true));
};

/**
 * @param {number} id
 * @param {unknown} error
 * @param {boolean} isFault
 */
function fail(id, error, isFault) {
    postMessage({ id, failed: error instanceof Error ? error.message : String(error), isFault });
}

/** @param {Request} request */
async function answer({ id, viewer, name, args }) {
    try {
        const call = calls[name];
        if (!call) throw new Error(`there is no ${name}`);
        const done = await call(args, viewer);
        postMessage({ id, done }, { transfer: sharedOf(done) });
        // The picture is on the page before a GPU is made ready for the next ones.
        if (name === "picture") opened(viewer).warm();
    } catch (error) {
        // After a fault of its own the module must not be used any more.
        const isFault = error instanceof WebAssembly.RuntimeError;
        fail(id, error, isFault);
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

/** @param {number} viewer */
function opened(viewer) {
    const relief = viewers.get(viewer);
    if (!relief) throw new Error("no scene is open");
    return relief;
}

/** @type {Record<string, (args: any, viewer: number) => unknown>} */
const calls = {
    /**
     * @param {{ files: SceneFile[], scene: string, isSample: boolean, needs: string | null }} args
     * @param {number} viewer
     */
    async open({ files, scene, isSample, needs }, viewer) {
        const all = new SceneFiles();
        for (const { path, file } of files) all.add(path, await bytesOf(file));
        viewers.get(viewer)?.free();
        viewers.delete(viewer);
        const relief = all.open(scene, isSample);
        viewers.set(viewer, relief);
        if (needs !== null) relief.need(needs);
    },
    /** @param {{ scene: string, file: Blob }} args */
    async named({ scene, file }) {
        const all = new SceneFiles();
        all.add(scene, await bytesOf(file));
        const [paths, text] = [all.named(scene), all.text(scene)];
        all.free();
        return { paths, text };
    },
    state: (_, viewer) => ({ state: JSON.parse(opened(viewer).state()), text: opened(viewer).text() }),
    text: (_, viewer) => ({ text: opened(viewer).text() }),
    apply: (sent, viewer) => JSON.parse(opened(viewer).apply(JSON.stringify(sent))),
    async picture({ wish, stop }, viewer) {
        const drawn = await opened(viewer).picture(JSON.stringify(wish), heard(stop));
        if (!drawn) return null;
        const pixels = drawn.pixels();
        return { about: JSON.parse(drawn.about), pixels };
    },
    /** @param {{ text: string, wish: unknown, stop: Stop }} args @param {number} viewer */
    shared({ text, wish, stop }, viewer) {
        opened(viewer).show(text);
        return calls["picture"]?.({ wish, stop }, viewer);
    },
    async pixel({ at: [x, y], stop }, viewer) {
        const found = await opened(viewer).pixel(x, y, heard(stop));
        return found === undefined ? undefined : JSON.parse(found);
    },
    async give({ group, path, file }, viewer) {
        opened(viewer).give(group, path, await bytesOf(file));
    },
    take: ({ group, key }, viewer) => JSON.parse(opened(viewer).take(group, key ?? undefined)),
    link: ({ link, begins }, viewer) => JSON.parse(opened(viewer).open_link(link, begins)),
    made_link: (_, viewer) => ({ text: opened(viewer).link() }),
    async save({ what, view, stop }, viewer) {
        const bytes = await opened(viewer).save(what, view, heard(stop));
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
    // Where the page's policy forbids such addresses, work goes on to its end.
    const canStop = stop !== null && !isTakenBack(stop);
    return (/** @type {string} */ task, /** @type {number} */ part) => {
        const now = performance.now();
        if (now - last < LOOK) return false;
        last = now;
        postMessage({ progress: { task, part } });
        return canStop && isTakenBack(stop);
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
