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

start(new WorkerHost(SCENE, Promise.all(SAMPLE.map(sample))));
