// The picture is the one that `relief render` draws, and is asked for only when something has changed.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { setTimeout as pause } from "node:timers/promises";
import { join } from "node:path";
import { decoded } from "./png.mjs";

/** What `relief render` draws of the saved scene. */
async function rendered(seat) {
    const [scene, picture] = [await seat.savedScene(), join(seat.folder, "rendered.png")];
    execFileSync(seat.relief, ["render", scene, "-q", "-o", picture], { cwd: seat.folder });
    return decoded(readFileSync(picture));
}

async function checkSame(seat) {
    const [shown, drawn] = [await seat.canvas(), await rendered(seat)];
    assert.deepEqual([shown.width, shown.height], [drawn.width, drawn.height]);
    assert.ok(shown.bytes.equals(drawn.bytes), "the canvas has other bytes than the PNG of relief render");
    assert.ok(new Set(shown.bytes).size > 8, "the picture is empty");
}

export async function the_canvas_has_the_bytes_of_relief_render(seat) {
    await checkSame(seat);
    await seat.drag([90, 40]);
    await checkSame(seat);
}

export async function the_picture_fills_the_pane(seat) {
    const sizes = await seat.page.evaluate(() => {
        const [canvas, pane] = [document.querySelector("canvas"), document.getElementById("pane")];
        return [canvas.width, canvas.height, pane.clientWidth, pane.clientHeight];
    });
    assert.deepEqual(sizes.slice(0, 2), sizes.slice(2));
    await seat.page.setViewport({ width: 900, height: 500, deviceScaleFactor: 2 });
    await seat.rest();
    const sides = ({ clientWidth, clientHeight }) => [clientWidth, clientHeight];
    const pane = await seat.page.$eval("#pane", sides);
    const { width, height } = await seat.canvas();
    assert.deepEqual([width, height], pane.map((side) => 2 * side));
}
the_picture_fills_the_pane.scene = ["cobbles.png", "--samples", "1", "--backend", "cpu"];

export async function nothing_is_asked_at_rest_and_one_at_a_time(seat) {
    const before = seat.pictures.all;
    assert.ok(before > 0);
    await pause(1500);
    assert.equal(seat.pictures.all, before, "a picture was asked for at rest");
    await seat.drag([200, 60], 40);
    assert.ok(seat.pictures.all > before);
    assert.equal(seat.pictures.most, 1, "more than one picture was asked for at a time");
    const after = seat.pictures.all;
    await pause(1500);
    assert.equal(seat.pictures.all, after, "a picture was asked for at rest");
}

export async function an_empty_scene_offers_to_open_files(seat) {
    seat.mayFail = true;
    const title = await seat.page.$eval("#empty", (empty) => empty.innerText);
    assert.match(title, /Drop a height map/);
    await seat.drop([join(seat.folder, "bricks.png")], "#empty");
    assert.equal(await seat.page.$eval("#empty", ({ hidden }) => hidden), true, (await seat.errors()).join());
    assert.ok(new Set((await seat.canvas()).bytes).size > 8);
}
an_empty_scene_offers_to_open_files.scene = ["--samples", "1", "--backend", "cpu"];
