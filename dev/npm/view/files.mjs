// Files come in by drops and choices, and go out by the menu.

import assert from "node:assert/strict";
import { mkdirSync, copyFileSync, existsSync, readFileSync, writeFileSync } from "node:fs";
import { setTimeout as pause } from "node:timers/promises";
import { join } from "node:path";

const height = async (seat) => (await seat.control("height")).value;

export async function a_dropped_map_is_shown_and_a_wrong_file_is_not(seat) {
    const before = await seat.canvas();
    await seat.drop([join(seat.folder, "bricks.png")], "canvas");
    assert.deepEqual(await seat.errors(), []);
    assert.match(await height(seat), /bricks/);
    const after = await seat.canvas();
    assert.ok(!after.bytes.equals(before.bytes), "the picture is still the same");
    const scene = await seat.scene();
    const wrong = join(seat.folder, "notes.txt");
    writeFileSync(wrong, "no map");
    seat.mayFail = true;
    await seat.drop([wrong], "canvas");
    assert.match((await seat.errors()).join(), /notes\.txt/);
    assert.equal(await seat.scene(), scene);
    assert.ok((await seat.canvas()).bytes.equals(after.bytes));
    await seat.click("#errors .close");
    assert.deepEqual(await seat.errors(), []);
}

export async function messages_go_with_the_next_action_that_works(seat) {
    const status = () => seat.page.$eval("#status", ({ textContent }) => textContent);
    await seat.drop([join(seat.folder, "bricks.png")], "canvas");
    assert.equal(await status(), "Opened bricks.png");
    assert.equal(await seat.page.$eval('[data-key="height"] input', ({ value }) => value), "bricks.png");
    await seat.type("scale", "0.1");
    assert.equal(await status(), "");
    seat.mayFail = true;
    const wrong = join(seat.folder, "empty.png");
    writeFileSync(wrong, "");
    const before = await seat.canvas();
    await seat.drop([wrong], "canvas");
    assert.match((await seat.errors()).join(), /empty\.png: is empty/);
    assert.ok((await seat.canvas()).bytes.equals(before.bytes));
    await seat.row("color");
    await seat.drop([wrong], '[data-key="color"]');
    assert.equal((await seat.errors()).length, 1);
    await seat.type("scale", "0.2");
    assert.deepEqual(await seat.errors(), []);
    // A word stays whole on a narrow page.
    await seat.page.setViewport({ width: 320, height: 700 });
    await seat.drop([join(seat.folder, "cobbles.png")], "#picture");
    const { width, height } = await (await seat.page.$("#status")).boundingBox();
    assert.ok(width > 80 && height < 60, `${width} x ${height}`);
}

export async function a_file_on_a_control_goes_to_its_key(seat) {
    const before = await height(seat);
    await seat.row("color");
    await seat.drop([join(seat.folder, "bricks.png")], '[data-key="color"]');
    assert.deepEqual(await seat.errors(), []);
    assert.match((await seat.control("color")).value, /bricks/);
    assert.equal(await height(seat), before);
    const button = await (await seat.row("roughness")).$("button[aria-label^=Choose]");
    const [chooser] = await Promise.all([seat.page.waitForFileChooser(), button.click()]);
    await chooser.accept([join(seat.folder, "bricks.png")]);
    await seat.rest();
    assert.match((await seat.control("roughness")).value, /bricks/);
}

export async function folders_are_taken_and_too_many_files_are_not(seat) {
    const many = join(seat.folder, "many");
    mkdirSync(many);
    for (let number = 0; number < 1001; number += 1) writeFileSync(join(many, `${number}.txt`), "");
    const scene = await seat.scene();
    await seat.drop([many], "canvas");
    assert.match((await seat.errors()).join(), /more than 1000 files/);
    assert.equal(await seat.scene(), scene);
    const few = join(seat.folder, "few", "wall");
    mkdirSync(few, { recursive: true });
    copyFileSync(join(seat.folder, "bricks.png"), join(few, "wall_height.png"));
    await seat.drop([join(seat.folder, "few")], "canvas");
    assert.deepEqual(await seat.errors(), []);
    assert.notEqual(await seat.scene(), scene);
}

export async function a_pasted_picture_is_taken(seat) {
    const bytes = readFileSync(join(seat.folder, "bricks.png")).toString("base64");
    const scene = await seat.scene();
    await seat.page.evaluate((bytes) => {
        const data = Uint8Array.from(atob(bytes), (letter) => letter.charCodeAt(0));
        const clipboardData = new DataTransfer();
        clipboardData.items.add(new File([data], "image.png", { type: "image/png" }));
        document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true }));
    }, bytes);
    await seat.rest();
    assert.deepEqual(await seat.errors(), []);
    assert.notEqual(await seat.scene(), scene);
}

/** The bytes that a button of the menu downloads. */
async function downloaded(seat, what) {
    const client = await seat.page.createCDPSession();
    const folder = join(seat.folder, "downloads");
    const behaviour = { behavior: "allow", downloadPath: folder, eventsEnabled: true };
    await client.send("Page.setDownloadBehavior", behaviour);
    await seat.click(".menu:has(#saves) summary");
    await seat.click(`[data-what="${what}"]`);
    const said = await seat.page.$eval("#status", ({ textContent }) => textContent);
    assert.deepEqual(await seat.errors(), []);
    const path = join(folder, said.replace(/^Saved /, ""));
    while (!existsSync(path)) await pause(50);
    return readFileSync(path);
}

export async function scene_and_picture_are_saved(seat) {
    for (const { what } of (await seat.state()).saves) {
        const file = await downloaded(seat, what);
        assert.ok(file.length > 0, what);
        const bytes = await seat.page.evaluate(async (what) => {
            const answer = await fetch(`save?what=${encodeURIComponent(what)}`);
            return [...new Uint8Array(await answer.arrayBuffer())];
        }, what);
        assert.ok(file.equals(Buffer.from(bytes)), `${what} has other bytes than the host sent`);
    }
}
