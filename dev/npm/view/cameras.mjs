// Drags, the wheel, keys and buttons turn the camera and the light; undo takes each back at once.

import assert from "node:assert/strict";

/** What an act does is one undo, and redo makes it again. */
async function checkOneUndo(seat, act) {
    const before = await seat.scene();
    const could = await seat.undoable();
    await act();
    const after = await seat.scene();
    assert.notEqual(after, before, "nothing changed");
    await seat.click("[data-do=undo]");
    assert.equal(await seat.scene(), before, "one undo does not take it back");
    assert.equal((await seat.undoable())[0], could[0]);
    await seat.click("[data-do=redo]");
    assert.equal(await seat.scene(), after, "redo does not make it again");
}

export async function drags_are_one_undo(seat) {
    await checkOneUndo(seat, () => seat.drag([120, 40]));
    await checkOneUndo(seat, () => seat.drag([60, 40], 12, "right"));
    await checkOneUndo(seat, () => seat.drag([60, 40], 12, "middle"));
    await seat.click("[data-do=light]");
    await checkOneUndo(seat, () => seat.drag([60, -20]));
    await seat.click("[data-do=light]");
    assert.match(await seat.scene(), /^light = /m);
}

export async function a_drag_turns_as_far_as_the_hand_moved(seat) {
    const eye = async () => JSON.parse((await seat.control("eye")).value);
    await seat.drag([1, 0], 1);
    const [x, , z] = await eye();
    const { height } = await (await seat.page.$("canvas")).boundingBox();
    // Half the height that the picture has in the pane is a quarter of a turn.
    const size = await seat.canvas();
    const { width } = await (await seat.page.$("canvas")).boundingBox();
    const shown = Math.min(height, (width * size.height) / size.width);
    await seat.drag([Math.round(shown / 2), 0], 30);
    const [endX, , endZ] = await eye();
    const target = JSON.parse((await seat.control("target")).value ?? "[0, 0, 0]");
    const heading = (x, z) => Math.atan2(x - target[0], z - target[2]) * (180 / Math.PI);
    const turned = (((heading(x, z) - heading(endX, endZ)) % 360) + 360) % 360;
    assert.ok(Math.abs(turned - 90) < 2, `turned by ${turned} degrees`);
}

export async function keys_move_the_camera_and_the_light(seat) {
    const canvas = await seat.page.$("canvas");
    for (const key of ["ArrowRight", "ArrowUp", "+", "-", "f", "Home"]) {
        await canvas.press(key);
        await seat.rest();
    }
    const { keyboard } = seat.page;
    await checkOneUndo(seat, async () => {
        for (const key of ["ArrowLeft", "ArrowLeft", "ArrowDown"]) await canvas.press(key);
        await seat.rest();
    });
    await canvas.focus();
    await keyboard.down("l");
    await keyboard.press("ArrowRight");
    await keyboard.up("l");
    await seat.rest();
    assert.match(await seat.scene(), /^light = /m);
    const after = await seat.scene();
    for (const [keys, can] of [[["Control", "z"], true], [["Control", "Shift", "Z"], false]]) {
        await canvas.focus();
        for (const key of keys.slice(0, -1)) await keyboard.down(key);
        await keyboard.press(keys.at(-1));
        for (const key of keys.slice(0, -1)) await keyboard.up(key);
        await seat.rest();
        assert.equal((await seat.undoable())[1], can);
    }
    assert.equal(await seat.scene(), after);
    await canvas.press("Escape");
    assert.equal(await seat.page.evaluate(() => document.activeElement === document.body), true);
}

export async function the_wheel_and_buttons_move_the_camera(seat) {
    await checkOneUndo(seat, async () => {
        const { x, y } = await (await seat.page.$("canvas")).clickablePoint();
        await seat.page.mouse.move(x, y);
        for (let turn = 0; turn < 3; turn += 1) await seat.page.mouse.wheel({ deltaY: -100 });
        await seat.rest();
    });
    for (const name of ["step-left", "step-up", "zoom-out", "frame", "fit"]) {
        const before = await seat.scene();
        await seat.click(`[data-do=${name}]`);
        if (name !== "fit") assert.notEqual(await seat.scene(), before, name);
    }
    await seat.click("[data-do=reset]");
    assert.doesNotMatch(await seat.scene(), /^eye = /m);
}

export async function fingers_orbit_pan_and_zoom(seat) {
    const { page } = seat;
    const { x, y, width, height } = await (await page.$("canvas")).boundingBox();
    const [middleX, middleY] = [x + width / 2, y + height / 2];
    await checkOneUndo(seat, async () => {
        const finger = await page.touchscreen.touchStart(middleX, middleY);
        for (let step = 1; step < 8; step += 1) await finger.move(middleX + 8 * step, middleY + 2 * step);
        await finger.end();
        await seat.rest();
    });
    const target = (await seat.control("target")).value;
    await checkOneUndo(seat, async () => {
        const fingers = [await page.touchscreen.touchStart(middleX - 40, middleY)];
        fingers.push(await page.touchscreen.touchStart(middleX + 40, middleY));
        for (let step = 1; step < 8; step += 1) {
            await fingers[0].move(middleX - 40 - 4 * step, middleY + 3 * step);
            await fingers[1].move(middleX + 40 + 4 * step, middleY + 3 * step);
        }
        for (const finger of fingers) await finger.end();
        await seat.rest();
    });
    assert.notEqual((await seat.control("target")).value, target);
}

/** The part of the picture's height and width that differs from its first row. */
async function filled(seat) {
    const { width, height, bytes } = await seat.canvas();
    const isOther = (x, y) => [0, 1, 2].some((part) => bytes[4 * (y * width + x) + part] !== bytes[part]);
    const rows = [...Array(height).keys()].filter((y) => [...Array(width).keys()].some((x) => isOther(x, y)));
    const columns = [...Array(width).keys()].filter((x) => rows.some((y) => isOther(x, y)));
    const span = (all) => (all.length === 0 ? 0 : all.at(-1) - all[0] + 1);
    return Math.max(span(rows) / height, span(columns) / width);
}

export async function a_zoom_ends_and_frame_finds_all_again(seat) {
    await seat.click("[data-do=fit]");
    const fit = await filled(seat);
    assert.ok(fit > 0.85, `Fit fills ${fit}`);
    const away = async () => {
        const values = await Promise.all(["eye", "target"].map((key) => seat.control(key)));
        const [eye, target] = values.map(({ value }) => JSON.parse(value));
        return Math.hypot(...eye.map((at, axis) => at - target[axis]));
    };
    const canvas = await seat.page.$("canvas");
    for (const [wheel, least, most] of [[-2000, 1e-6, 1e-2], [2000, 10, 1e4]]) {
        await canvas.hover();
        for (let turn = 0; turn < 12; turn += 1) await seat.page.mouse.wheel({ deltaY: wheel });
        await seat.rest();
        const distance = await away();
        assert.ok(distance > least && distance < most, `${distance} m after ${wheel}`);
        await seat.click("[data-do=frame]");
        const framed = await filled(seat);
        assert.ok(Math.abs(framed - fit) < 0.1, `Frame fills ${framed}, Fit ${fit}`);
    }
}
a_zoom_ends_and_frame_finds_all_again.scene = [
    ...["cobbles.png", "--size", "160x120", "--samples", "1", "--backend", "cpu"],
    ...["--background", "1,0,1"],
];

export async function a_look_without_a_light_says_so(seat) {
    seat.mayFail = true;
    const canvas = await seat.page.$("canvas");
    await canvas.focus();
    await seat.page.keyboard.down("l");
    await seat.page.keyboard.press("ArrowRight");
    await seat.page.keyboard.up("l");
    await seat.rest();
    assert.match((await seat.errors()).join(), /no light that can be turned/);
    await canvas.press("ArrowRight");
    await seat.rest();
    assert.deepEqual(await seat.errors(), []);
}
a_look_without_a_light_says_so.scene = [
    ...["cobbles.png", "--size", "160x120", "--samples", "1", "--backend", "cpu"],
    ...["--look", "overcast"],
];
