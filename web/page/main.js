// Starts the page with the module: a sample is shown until files come in.

import { start } from "./page.js";
import { WorkerHost } from "./worker_host.js";

/** @import { SceneFile } from "./worker_messages.d.ts" */

const SAMPLE = ["cobbles.png", "cobbles_color.png"];
const SCENE = `height = "cobbles.png"\ncolor = "cobbles_color.png"\n`;

/**
 * @param {string} path
 * @returns {Promise<SceneFile>}
 */
async function sample(path) {
    const answer = await fetch(`samples/${path}`);
    if (!answer.ok) throw new Error(`${path}: the server answered ${answer.status}`);
    return { path, file: await answer.blob() };
}

/** The link in the page's address; null if it has none. */
function linked() {
    const end = location.hash.slice(1);
    return end.startsWith("s=") ? end : null;
}

const host = new WorkerHost(SCENE, Promise.all(SAMPLE.map(sample)), linked());
const { failed, took } = start(host);
host.linked.catch(failed);
window.addEventListener("hashchange", async () => {
    const link = linked();
    if (link === null) return;
    try {
        took(await host.follow(link));
    } catch (error) {
        failed(error);
    }
});
