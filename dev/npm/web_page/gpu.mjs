// A GPU by WebGPU: what it draws, when it takes over, and what is done when it is lost.

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { Web } from "./web.mjs";

const scene = (more) => `height = "cobbles.png"
color = "cobbles_color.png"
scale = 0.2
size = [160, 120]
samples = 1
${more}
`;

/** Opens a scene, and waits for its picture. */
async function open(web, more) {
    const before = await web.text("#figures");
    writeFileSync(join(web.here, "gpu.toml"), scene(more));
    await web.give("gpu.toml", "cobbles.png", "cobbles_color.png");
    await web.rest(before);
}

/** Changes a choice, and waits for its picture. */
async function choose(web, key, value) {
    await web.page.$eval(
        `[data-key="${key}"] select`,
        (select, value) => {
            select.value = value;
            select.dispatchEvent(new Event("change"));
        },
        value,
    );
    // The figures may be the same as before.
    await web.rest();
}

/** The part of the pixels that differ by more than two steps. */
function others(shown, drawn) {
    assert.deepEqual([shown.width, shown.height], [drawn.width, drawn.height]);
    let count = 0;
    for (let at = 0; at < shown.bytes.length; at += 4) {
        const differs = [0, 1, 2].some((part) => Math.abs(shown.bytes[at + part] - drawn.bytes[at + part]) > 2);
        count += Number(differs);
    }
    return count / (shown.width * shown.height);
}

export async function webgpu_draws_what_the_command_draws(web) {
    for (const method of ["parallax", "relief", "cone"]) {
        await open(web, `method = "${method}"\nbackend = "gpu"`);
        assert.match(await web.text("#figures"), /gpu, .*webgpu/);
        const drawn = web.drawn("gpu.toml");
        const part = others(await web.canvas(), drawn);
        assert.ok(part < 0.005, `${method}: ${part} of the pixels differ from relief render`);
        // Its own picture is not that of another method.
        if (method === "parallax") continue;
        writeFileSync(join(web.here, "gpu.toml"), scene('method = "parallax"'));
        assert.ok(others(await web.canvas(), web.drawn("gpu.toml")) > 0.05, `${method} is drawn as parallax`);
    }
}

/**
 * Opens a page in whose worker the adapter looks like hardware and devices are kept; the clock stands once one is
 * open: all that the GPU does takes no time.
 */
async function pretending(web) {
    const other = new Web(await web.page.browserContext().newPage(), web.here, web.relief);
    const created = new Promise((done) => other.page.once("workercreated", done));
    await other.open(web.page.url());
    const worker = await created;
    // The worker is there before what its page may use is.
    const isReady = () => worker.evaluate(() => typeof GPUAdapterInfo === "function");
    while (!(await isReady())) await new Promise((done) => setTimeout(done, 10));
    await worker.evaluate(pretend);
    await other.rest();
    return { other, worker };
}

function pretend() {
    Object.defineProperty(GPUAdapterInfo.prototype, "isFallbackAdapter", { get: () => false });
    const { requestDevice } = GPUAdapter.prototype;
    self.devices = [];
    GPUAdapter.prototype.requestDevice = async function (...all) {
        const device = await requestDevice.apply(this, all);
        self.devices.push(device);
        const now = performance.now();
        performance.now = () => now;
        return device;
    };
}

export async function a_faster_gpu_takes_over_until_it_is_lost(web) {
    const { other, worker } = await pretending(web);
    const backend = async () => /cpu|gpu/.exec(await other.text("#figures"))?.[0];
    assert.equal(await backend(), "cpu");
    const isOpen = (count) => worker.evaluate((count) => self.devices.length === count, count);
    for (const count of [1, 2, 3]) {
        // It takes over some time after a picture, between two changes.
        for (let tries = 0; !(await isOpen(count)) || (await backend()) !== "gpu"; tries += 1) {
            assert.ok(tries < 40, `device ${count} does not take over`);
            await choose(other, "tone", tries % 2 === 0 ? "none" : "agx");
        }
        await worker.evaluate(() => self.devices.at(-1).destroy());
        await choose(other, "wrap", count % 2 === 0 ? "repeat" : "clamp");
        assert.equal(await backend(), "cpu");
        assert.match(await other.text("#notes"), /CPU draws in place of the GPU: the GPU was lost/);
        await other.checkSame();
    }
    // A GPU that is lost again and again is left alone.
    await choose(other, "wrap", "mirror");
    await choose(other, "wrap", "repeat");
    assert.equal(await backend(), "cpu");
    assert.ok(await isOpen(3), "a fourth device was opened");
    assert.deepEqual(other.wrong, []);
    await other.page.close();
}
