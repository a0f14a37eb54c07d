// Two views stand side by side, with a divider; errors have figures, and the worst pixel is found.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { setTimeout as pause } from "node:timers/promises";
import { join } from "node:path";
import { found } from "./axe.mjs";
import { decoded } from "./png.mjs";

const SMALL = ["--size", "160x120", "--samples", "1", "--backend", "cpu", "--scale", "0.2"];
const TWO = ["cobbles.png", "--method", "relief,cone", ...SMALL];
const ERRORS = [...TWO, "--show", "error"];

/** What `relief render` draws by a method. */
function rendered(seat, method) {
    const picture = join(seat.folder, `${method}.png`);
    const scene = ["cobbles.png", "--method", method, ...SMALL];
    execFileSync(seat.relief, ["render", ...scene, "-q", "-o", picture], { cwd: seat.folder });
    return decoded(readFileSync(picture));
}

/** Whether columns of a picture are those of another. */
function same(a, b, from, to) {
    for (let row = 0; row < a.height; row += 1) {
        const [begin, end] = [from, to].map((column) => 4 * (row * a.width + column));
        if (!a.bytes.subarray(begin, end).equals(b.bytes.subarray(begin, end))) return false;
    }
    return true;
}

const divider = (seat) => seat.page.$eval("#divider", (found) => Number(found.getAttribute("aria-valuenow")));

export async function two_views_are_divided_and_swapped(seat) {
    const [relief, cone] = ["relief", "cone"].map((method) => rendered(seat, method));
    assert.ok(!same(relief, cone, 0, 160), "the methods draw the same");
    const check = async (left, right, split) => {
        const shown = await seat.canvas();
        assert.ok(same(shown, left, 0, split), "the left side is another");
        assert.ok(same(shown, right, split, 160), "the right side is another");
    };
    await check(relief, cone, 80);
    const before = seat.pictures.all;
    await seat.page.focus("#divider");
    for (let times = 0; times < 5; times += 1) await seat.page.keyboard.press("ArrowLeft");
    await seat.rest();
    assert.equal(await divider(seat), 40);
    await check(relief, cone, 64);
    await seat.page.keyboard.press("x");
    await seat.rest();
    await check(cone, relief, 64);
    assert.equal(seat.pictures.all, before, "a picture was asked for where nothing has changed");
    assert.match(await seat.scene(), /divider = 0.4, swapped = true/);
    for (let times = 0; times < 6; times += 1) await seat.click("[data-do=undo]");
    await check(relief, cone, 80);
}
two_views_are_divided_and_swapped.scene = TWO;

export async function the_divider_is_dragged(seat) {
    const { x, y, width, height } = await (await seat.page.$("#divider")).boundingBox();
    const { mouse } = seat.page;
    await mouse.move(x + width / 2, y + height / 3);
    await mouse.down();
    await mouse.move(x + width / 2 + 100, y + height / 3, { steps: 5 });
    await mouse.up();
    await seat.rest();
    const there = await divider(seat);
    assert.ok(there > 55 && there < 75, `${there}`);
    await seat.click("[data-do=undo]");
    assert.equal(await divider(seat), 50);
}
the_divider_is_dragged.scene = TWO;

export async function a_second_view_opens_and_closes(seat) {
    const shown = () => seat.page.$eval("#second", ({ hidden }) => !hidden);
    const one = await seat.canvas();
    assert.equal(await shown(), false);
    await seat.click("[data-do=compare]");
    assert.equal(await shown(), true);
    const methods = async () => (await seat.control("viewer.second")).value;
    assert.equal(await methods(), '"relief"', "beside the exact method stands another");
    await seat.page.select('[data-choice="viewer.second"]', "");
    await seat.rest();
    assert.equal(await shown(), true, "the same method closes it");
    assert.equal((await seat.control("viewer.second-show")).value, '"picture"');
    await seat.page.select('[data-choice="viewer.second-show"]', "");
    await seat.rest();
    assert.equal(await shown(), true, "the same number closes it");
    await seat.page.select('[data-choice="viewer.second"]', "cone");
    await seat.rest();
    assert.equal(await methods(), '"cone"');
    await seat.page.select('[data-choice="viewer.second-show"]', "flip");
    await seat.rest();
    assert.match(await seat.page.$eval("#second .figures", ({ textContent }) => textContent), /FLIP/);
    await seat.click("#close-second");
    assert.equal(await shown(), false);
    assert.ok((await seat.canvas()).bytes.equals(one.bytes));
    await seat.click("[data-do=undo]");
    assert.equal(await shown(), true, "closing is one step");
}
a_second_view_opens_and_closes.scene = ["cobbles.png", ...SMALL];

export async function the_worst_pixel_is_marked_and_read(seat) {
    const text = (selector) => seat.page.$eval(selector, ({ textContent }) => textContent);
    assert.match(await text("#first .figures"), /median .* texels.*99 % within.*passed/);
    assert.match(await text("#first .legend"), /texels/);
    await seat.click("#first .worst");
    const [at, read] = [await text("#reading-at"), await text("#reading-table")];
    assert.match(at, /^Pixel \d+, \d+$/);
    assert.match(read, /relief.*cone/);
    assert.match(read, /error[\d.]+ texels/);
    assert.equal(await seat.page.$eval("#mark", ({ hidden }) => hidden), false);
    const before = await seat.scene();
    await seat.click("#centre");
    assert.notEqual(await seat.scene(), before);
    assert.equal(await text("#reading-at"), "Pixel 80, 60", "what was brought to the middle is read there");
    assert.equal(await seat.page.$eval("#mark", ({ hidden }) => hidden), false);
    await seat.page.focus("#divider");
    await seat.page.keyboard.press("Escape");
    assert.equal(await seat.page.$eval("#reading", ({ hidden }) => hidden), true);
}
the_worst_pixel_is_marked_and_read.scene = ERRORS;

/** The pixel of the reading. */
async function pixelOf(seat) {
    const text = await seat.page.$eval("#reading-at", ({ textContent }) => textContent);
    return text.match(/\d+/g).map(Number);
}

export async function the_divider_gives_way_to_the_worst_pixel(seat) {
    for (const [box, far, isShown] of [
        ["#first", "Home", (x, split) => x < split],
        ["#second", "End", (x, split) => x > split],
    ]) {
        await seat.page.focus("#divider");
        await seat.page.keyboard.press(far);
        await seat.rest();
        await seat.page.$eval(`${box} .worst`, (button) => button.click());
        await seat.rest();
        const [x] = await pixelOf(seat);
        assert.ok(isShown(x, 1.6 * (await divider(seat))), `${box}: ${x} at ${await divider(seat)}`);
    }
    const overlaps = await seat.page.evaluate(() => {
        const mark = document.getElementById("mark").getBoundingClientRect();
        const boxes = [...document.querySelectorAll(".view-box")].map((box) => box.getBoundingClientRect());
        const isOver = ({ left, right, top, bottom }) =>
            left < mark.right && right > mark.left && top < mark.bottom && bottom > mark.top;
        return boxes.filter(isOver).length;
    });
    assert.equal(overlaps, 0, "a box covers the mark");
}
the_divider_gives_way_to_the_worst_pixel.scene = ERRORS;

export async function a_click_on_the_worst_pixel_waits_for_the_picture(seat) {
    // The click comes as soon as the figures are old: the next picture may be there a moment later.
    const clicked = await seat.page.evaluate(async () => {
        const box = document.getElementById("first");
        const old = new Promise((done) => {
            const observer = new MutationObserver(() => box.classList.contains("old") && done(observer));
            observer.observe(box, { attributeFilter: ["class"] });
        });
        const select = document.querySelector('[data-choice="viewer.second"]');
        select.value = "parallax";
        select.dispatchEvent(new Event("change"));
        (await old).disconnect();
        document.querySelector("#second .worst").click();
        return box.classList.contains("old");
    });
    assert.ok(clicked, "the figures were not old any more");
    await seat.rest();
    assert.equal(await seat.page.$eval("#reading", ({ hidden }) => hidden), false);
    assert.match(await seat.page.$eval("#reading-table", ({ textContent }) => textContent), /parallax/);
    assert.equal(await seat.page.$(".old"), null);
}
a_click_on_the_worst_pixel_waits_for_the_picture.scene = ERRORS;

export async function each_view_is_saved_and_the_second_is_kept(seat) {
    const texts = (all) => all.map(({ textContent }) => textContent);
    const labels = () => seat.page.$$eval("#saves button", texts);
    await seat.page.click("summary:has(+ #saves)");
    assert.ok((await labels()).includes("Method relief as functions, WGSL"), `${await labels()}`);
    await seat.page.select("#saved-view", "1");
    assert.ok((await labels()).includes("Method cone as functions, WGSL"), `${await labels()}`);
    await seat.page.keyboard.press("Escape");
    const saved = (view, what) =>
        seat.page.evaluate(
            async (query) => {
                const answer = await fetch(`save?${query}`);
                return [answer.headers.get("Content-Disposition"), await answer.text()];
            },
            `view=${view}&what=${what}`,
        );
    const [first, second] = [await saved(0, "relief.wgsl"), await saved(1, "relief.wgsl")];
    assert.match(first[0], /relief\.wgsl/);
    assert.match(second[0], /cone\.wgsl/);
    assert.notEqual(first[1], second[1]);
    assert.notEqual((await saved(0, "picture.png"))[1], (await saved(1, "picture.png"))[1]);
    const cone = rendered(seat, "cone");
    await seat.click("#keep-second");
    assert.equal(await seat.page.$eval("#second", ({ hidden }) => hidden), true);
    assert.ok(same(await seat.canvas(), cone, 0, 160), "the kept method is another");
    await seat.click("[data-do=undo]");
    assert.equal(await seat.page.$eval("#second", ({ hidden }) => hidden), false);
}
each_view_is_saved_and_the_second_is_kept.scene = TWO;

export async function what_several_surfaces_cannot_show_is_grey_and_the_other_view_stays(seat) {
    await seat.page.select('[data-choice="viewer.second-show"]', "picture");
    await seat.rest();
    await seat.click("#add-surface");
    const failed = await seat.page.$eval("#first .failed", ({ textContent }) => textContent);
    assert.match(failed, /hide each other/);
    assert.equal(await seat.page.$eval("#empty", ({ hidden }) => hidden), true);
    const refused = await seat.page.$$eval('[data-choice="viewer.second-show"] option', (all) =>
        all.filter(({ disabled }) => disabled).map(({ value }) => value),
    );
    assert.deepEqual(refused, ["error", "passed"]);
    await seat.page.select('[data-choice="viewer.show"]', "flip");
    await seat.rest();
    await seat.click("#first .worst");
    const read = await seat.page.$eval("#reading-table", ({ textContent }) => textContent);
    assert.match(read, /flip[\d.e-]+/);
    assert.match(read, /surface\d, relief/);
}
what_several_surfaces_cannot_show_is_grey_and_the_other_view_stays.scene = ERRORS;

export async function the_pixel_under_the_pointer_is_read(seat) {
    const { x, y, width, height } = await (await seat.page.$("canvas")).boundingBox();
    const hidden = () => seat.page.$eval("#reading", (box) => box.hidden);
    const before = seat.pictures.all;
    await seat.page.mouse.move(x + 0.5 * width, y + 0.55 * height);
    await seat.rest();
    assert.equal(await hidden(), false);
    assert.match(await seat.page.$eval("#reading-table", ({ textContent }) => textContent), /depth/);
    await seat.page.mouse.move(x + 0.5 * width, y + height + 20);
    await pause(100);
    assert.equal(await hidden(), true);
    assert.equal(seat.pictures.all, before);
    const target = (await seat.control("target")).value;
    await seat.page.mouse.click(x + 0.6 * width, y + 0.55 * height, { count: 2 });
    await seat.rest();
    assert.notEqual((await seat.control("target")).value, target, "a double click brings it to the middle");
}

export async function axe_finds_nothing_grave_over_two_views(seat) {
    await seat.click("#first .worst");
    for (const value of ["light", "dark"]) {
        await seat.page.emulateMediaFeatures([{ name: "prefers-color-scheme", value }]);
        assert.deepEqual(await found(seat), [], value);
    }
    await seat.page.setViewport({ width: 320, height: 640 });
    await seat.rest();
    assert.deepEqual(await found(seat), [], "narrow");
    const wide = await seat.page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= 320, `${wide} pixels wide`);
}
axe_finds_nothing_grave_over_two_views.scene = ERRORS;
