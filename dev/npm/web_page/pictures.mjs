// The canvas holds what the command draws, and files stay in the browser.

import assert from "node:assert/strict";
import { found } from "../view/axe.mjs";
import { Web } from "./web.mjs";

export async function the_canvas_has_the_bytes_of_relief_render(web) {
    await web.checkSame();
    const { x, y, width, height } = await (await web.page.$("canvas")).boundingBox();
    const { mouse } = web.page;
    await mouse.move(x + width / 2, y + height / 2);
    await mouse.down();
    await mouse.move(x + width / 2 + 60, y + height / 2 + 20, { steps: 8 });
    await mouse.up();
    await web.rest();
    await new Promise((done) => setTimeout(done, 500));
    await web.rest();
    await web.checkSame();
}

export async function files_stay_in_the_browser(web) {
    const asked = [];
    web.page.on("request", (request) => asked.push(request.url()));
    await web.give("bricks.png");
    await web.page.waitForFunction(() => document.getElementById("name").textContent === "bricks.png");
    await web.rest();
    assert.deepEqual(asked.filter((address) => !address.startsWith("blob:")), []);
    await web.checkSame();
}

export async function the_first_map_takes_the_places_of_the_sample(web) {
    await web.give("bricks.png");
    await web.rest();
    const text = (await web.saved("scene.toml")).toString();
    assert.match(text, /^height = "bricks.png"/m);
    assert.doesNotMatch(text, /^color = /m);
    const field = await web.page.$eval('[data-key="height"] input', ({ value }) => value);
    assert.equal(field, "bricks.png");
}

export async function a_module_that_does_not_come_is_named(web) {
    const other = new Web(await web.page.browserContext().newPage(), web.here, web.relief);
    await other.page.setRequestInterception(true);
    other.page.on("request", (request) => {
        if (request.url().endsWith(".wasm")) request.respond({ status: 503, body: "" });
        else request.continue();
    });
    await other.open(web.page.url());
    await other.page.waitForSelector("#empty:not([hidden])");
    assert.match(await other.text("#empty-why"), /cannot be loaded: the server answered 503/);
    await other.page.close();
}

export async function axe_finds_nothing_grave_and_nothing_can_be_ended(web) {
    assert.deepEqual(await found(web), []);
    assert.equal(await web.page.$eval('[data-do="end"]', ({ hidden }) => hidden), true);
}

export async function without_webgpu_the_page_says_so_and_the_cpu_draws(web) {
    await web.page.$eval('[data-key="backend"] select', (select) => {
        select.value = "gpu";
        select.dispatchEvent(new Event("change"));
    });
    await web.page.waitForSelector("#empty:not([hidden])");
    assert.match(await web.text("#empty-why"), /no GPU by WebGPU/);
    await web.page.click('[data-do="undo"]');
    await web.page.waitForSelector("#empty[hidden]", { hidden: true });
    await web.rest();
    await web.checkSame();
}

/** A page in a browser whose machine has some cores, once all workers draw its picture. */
async function shared(web, cores) {
    const other = new Web(await web.page.browserContext().newPage(), web.here, web.relief);
    await other.page.evaluateOnNewDocument((cores) => {
        Object.defineProperty(navigator, "hardwareConcurrency", { get: () => cores });
    }, cores);
    await other.open(web.page.url());
    await other.rest();
    for (let tries = 0; !(await other.text("#figures")).includes(`${Math.min(cores, 4)} threads`); tries += 1) {
        assert.ok(tries < 60, `${cores} cores do not share a picture: ${await other.text("#figures")}`);
        await other.page.focus("canvas");
        await other.page.keyboard.press("ArrowLeft");
        await other.rest();
    }
    return other;
}

export async function several_workers_draw_the_same_picture(web) {
    for (const cores of [2, 16]) {
        const other = await shared(web, cores);
        assert.equal(other.page.workers().length, Math.min(cores, 4));
        await other.checkSame();
        // Two views, then errors, which one worker draws, then a file that the others get.
        await other.page.click('[data-do="compare"]');
        await other.rest();
        assert.match(await other.text("#figures"), /threads/);
        await other.page.click('[data-do="compare"]');
        await other.rest();
        await other.checkSame();
        await other.page.select('[data-choice="viewer.show"]', "flip");
        await other.rest();
        assert.match(await other.text("#figures"), /1 thread$/);
        await other.page.select('[data-choice="viewer.show"]', "");
        await other.rest();
        await other.give("bricks.png");
        await other.page.waitForFunction(() => document.getElementById("name").textContent === "bricks.png");
        await other.rest();
        await other.checkSame();
        // Undo and redo are the first one's own.
        await other.page.click('[data-do="undo"]');
        await other.rest();
        await other.checkSame();
        assert.deepEqual(other.wrong, []);
        await other.page.close();
    }
}

export async function a_worker_that_ends_is_not_missed(web) {
    const other = await shared(web, 3);
    const [, last] = other.page.workers();
    await last.evaluate(() => self.close());
    await other.page.keyboard.press("ArrowLeft");
    await other.rest();
    await other.checkSame();
    await other.page.close();
}
