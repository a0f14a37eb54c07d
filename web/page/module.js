// The module in a worker, which all hosts of a page share: one download, one thread.

/** @import { Progress } from "./protocol.d.ts" */
/** @import { Answer } from "./worker_messages.d.ts" */

import { Gone, Refused } from "./shared.js";

/** @typedef {{ done: (value: any) => void, failed: (error: Error) => void }} Waiting */

export class Module {
    /** @type {Worker | null} */ #worker = null;
    /** @type {Map<number, Waiting>} */ #waiting = new Map();
    #last = 0;
    #viewers = 0;
    /** Number of workers that have ended by a fault. */
    #faults = 0;
    /**
     * The module's code, for this worker and the next ones.
     * @type {Promise<WebAssembly.Module> | null}
     */
    #code = null;
    /** Whether the worker has got the code. @type {Promise<void>} */
    #sent = Promise.resolve();
    /** What is being done. @type {Progress} */
    progress = { task: "", part: 0 };

    /** @param {Promise<WebAssembly.Module> | null} [code] code that another one has loaded */
    constructor(code = null) {
        this.#code = code;
    }

    /** The module's code, once a worker has started. */
    get code() {
        return this.#code;
    }

    /** Ends the worker. */
    end() {
        this.#lose();
    }

    /** A number for a viewer of its own. */
    newViewer() {
        this.#viewers += 1;
        return this.#viewers;
    }

    /** Starts a worker if there is none. Returns its number: viewers of earlier ones are lost. */
    start() {
        if (!this.#worker) {
            const worker = new Worker(new URL("worker.js", import.meta.url), { type: "module" });
            worker.addEventListener("message", ({ data }) => this.#heard(data));
            worker.addEventListener("error", (event) => {
                event.preventDefault();
                this.#lose();
            });
            this.#worker = worker;
            this.#code ??= loaded(new URL("relief_web_bg.wasm", import.meta.url));
            this.#sent = this.#code.then((code) => worker.postMessage({ code }));
            // Each request says it; the next worker tries again.
            this.#sent.catch(() => (this.#code = null));
        }
        return this.#faults;
    }

    /**
     * Whether the worker of this number is at work.
     * @param {number} number
     */
    runs(number) {
        return this.#worker !== null && this.#faults === number;
    }

    /**
     * @param {number} viewer
     * @param {string} name
     * @param {unknown} args
     * @returns {Promise<any>}
     */
    async post(viewer, name, args) {
        const worker = this.#worker;
        if (worker) await this.#sent;
        if (!worker || worker !== this.#worker) throw new Gone();
        this.#last += 1;
        const id = this.#last;
        worker.postMessage({ id, viewer, name, args });
        return new Promise((done, failed) => this.#waiting.set(id, { done, failed }));
    }

    /** @param {Answer} answer */
    #heard(answer) {
        if ("progress" in answer) {
            this.progress = answer.progress;
            return;
        }
        const waiting = this.#waiting.get(answer.id);
        this.#waiting.delete(answer.id);
        if ("done" in answer) waiting?.done(answer.done);
        else if (answer.isFault) {
            waiting?.failed(new Gone());
            this.#lose();
        } else waiting?.failed(new Refused(answer.failed));
    }

    /** Gives up a worker that has met a fault. */
    #lose() {
        this.#worker?.terminate();
        this.#worker = null;
        this.#faults += 1;
        for (const { failed } of this.#waiting.values()) failed(new Gone());
        this.#waiting.clear();
    }
}

/**
 * Loads code, and compiles it while it comes in.
 * @param {URL} address
 */
async function loaded(address) {
    try {
        const answer = await fetch(address);
        if (!answer.ok) throw new Error(`the server answered ${answer.status}`);
        // Some hosts do not know the type of such files.
        const isNamed = answer.headers.get("Content-Type")?.startsWith("application/wasm");
        return await (isNamed
            ? WebAssembly.compileStreaming(answer)
            : WebAssembly.compile(await answer.arrayBuffer()));
    } catch (error) {
        const why = error instanceof Error ? error.message : String(error);
        throw new Error(`The module cannot be loaded: ${why}. Load the page again.`);
    }
}
