// Controls of the panel change the scene at once; what is refused changes nothing and says why.

import assert from "node:assert/strict";

/** Values of controls whose texts follow rules of their own. */
const WRITTEN = { background: '"gradient"', "max-memory": '"2GiB"', channel: "r", ramp: "viridis" };

const isSet = (control) => control.value !== null;

/** Another number that a control accepts. */
function otherNumber({ default: standard, value, min, max, step, kind }) {
    const now = Number(value ?? standard ?? min ?? 1) || 0;
    const small = kind === "whole" ? 1 : (step ?? 0.1);
    const [up, down] = [now + small, now - small].map((number) => Number(number.toPrecision(6)));
    return max !== null && up >= max && (min === null || down > min) ? down : up;
}

/** Sets a control by its field. Returns whether there is a way to. */
async function setByHand(seat, control) {
    const { key, kind, choices } = control;
    const row = await seat.row(key);
    if (kind === "flag") await (await row.$("input")).click();
    else if (kind === "name") {
        const isOther = ({ name, refused }) => refused === null && `"${name}"` !== control.default;
        const other = choices.find(isOther);
        if (!other) return false;
        await (await row.$("select")).select(other.name);
    } else if (kind === "number" || kind === "whole") await seat.type(key, `${otherNumber(control)}`);
    else if (typeof kind === "object") {
        const inputs = await row.$$("input:not([hidden])");
        for (const [place, input] of inputs.entries()) {
            await input.click({ count: 3 });
            await input.type(`${place + 2}`);
        }
        await inputs.at(-1).press("Enter");
    } else if (WRITTEN[key]) await seat.type(key, WRITTEN[key]);
    else return false;
    await seat.rest();
    return true;
}

export async function each_control_changes_the_scene_and_its_button_takes_it_away(seat) {
    seat.mayFail = true;
    const kinds = new Set();
    for (const control of (await seat.controls()).filter((control) => !isSet(control))) {
        const before = await seat.scene();
        if (!(await setByHand(seat, control))) continue;
        const row = await seat.row(control.key);
        const error = await row.$eval("[role=alert]", ({ textContent }) => textContent);
        if (error !== "") {
            // A value may not go with others; then nothing has changed.
            assert.equal(await seat.scene(), before, control.key);
            continue;
        }
        assert.notEqual(await seat.scene(), before, `${control.key} changed nothing`);
        assert.ok(isSet(await seat.control(control.key)), `${control.key} has no value`);
        kinds.add(typeof control.kind === "object" ? "numbers" : control.kind);
        await (await row.$(`[aria-label="default of ${control.label}"]`)).click();
        await seat.rest();
        if (!isSet(await seat.control(control.key))) continue;
        // Another value may need this one; then the control says so.
        assert.match(await row.$eval("[role=alert]", ({ textContent }) => textContent), /needs/, control.key);
        await seat.click("[data-do=undo]");
        assert.equal(await seat.scene(), before, control.key);
    }
    const all = ["flag", "name", "name-or-file", "number", "numbers", "other", "text", "whole"];
    assert.deepEqual([...kinds].sort(), all);
}

export async function a_refused_value_changes_nothing_and_says_why(seat) {
    seat.mayFail = true;
    const [scene, undo] = [await seat.scene(), await seat.undoable()];
    const row = await seat.row("ior");
    const shown = () => row.$eval("input[type=number]", ({ value }) => value);
    const before = await shown();
    await seat.type("ior", "99");
    const said = await row.$eval("[role=alert]", ({ textContent }) => textContent);
    assert.match(said, /ior/);
    assert.equal(await row.$eval("input[type=number]", (input) => input.ariaInvalid), "true");
    assert.equal(await shown(), before);
    assert.equal(await seat.scene(), scene);
    assert.deepEqual(await seat.undoable(), undo);
    await seat.type("ior", "1.4");
    assert.equal(await row.$eval("[role=alert]", ({ textContent }) => textContent), "");
    assert.equal(await row.$eval("input[type=number]", (input) => input.ariaInvalid), null);
}

export async function a_slider_is_one_drag(seat) {
    const before = await seat.scene();
    const slider = await (await seat.row("ior")).$("input[type=range]");
    const { x, y, width, height } = await slider.boundingBox();
    const { mouse } = seat.page;
    await mouse.move(x + width * 0.2, y + height / 2);
    await mouse.down();
    await mouse.move(x + width * 0.8, y + height / 2, { steps: 15 });
    await mouse.up();
    await seat.rest();
    const { value, min, max } = await seat.control("ior");
    assert.ok(Number(value) > (min + max) / 2, `ior is ${value}`);
    await seat.click("[data-do=undo]");
    assert.equal(await seat.scene(), before);
}

export async function choices_that_do_not_go_say_why(seat) {
    const control = (await seat.controls()).find(({ kind, choices }) => {
        return kind === "name" && choices.some(({ refused }) => refused !== null);
    });
    assert.ok(control, "no choice is refused");
    const refused = control.choices.filter(({ refused }) => refused !== null);
    const row = await seat.row(control.key);
    const disabled = await row.$$eval("option:disabled", (found) => {
        return found.map(({ value, title }) => [value, title]);
    });
    assert.deepEqual(disabled, refused.map(({ name, refused }) => [name, refused]));
    const listed = await row.$eval(".refused", ({ textContent }) => textContent);
    for (const { name, refused: why } of refused) assert.ok(listed.includes(name) && listed.includes(why));
}

export async function the_focus_stays_when_the_panel_changes(seat) {
    const select = await (await seat.row("method")).$("select");
    const keys = async () => (await seat.controls()).map(({ key }) => key);
    const before = await keys();
    await select.focus();
    await select.select("relief");
    await seat.rest();
    assert.notDeepEqual(await keys(), before, "the panel has the same controls");
    assert.equal(await seat.page.evaluate((node) => document.activeElement === node, select), true);
    const shown = await seat.page.$$eval("[data-key]", (rows) => rows.map(({ dataset }) => dataset.key));
    assert.deepEqual([...shown].sort(), (await keys()).sort());
}

export async function surfaces_are_added_and_removed(seat) {
    const count = async () => (await seat.state()).panel.surfaces.length;
    const tabs = () => seat.page.$$eval("[role=tab]", (found) => found.map(({ textContent }) => textContent));
    assert.deepEqual(await tabs(), ["Surface", "Scene"]);
    await seat.click("#add-surface");
    assert.equal(await count(), 2);
    assert.deepEqual(await tabs(), ["Surface 0", "Surface 1", "Scene"]);
    await seat.row("surfaces[1].scale");
    await seat.type("surfaces[1].scale", "0.02");
    assert.match((await seat.control("surfaces[1].scale")).value, /0\.02/);
    await seat.click("[role=tabpanel]:not([hidden]) .remove");
    assert.equal(await count(), 1);
}

export async function the_filter_finds_controls_on_all_tabs(seat) {
    const visible = () => {
        return seat.page.$$eval("[data-key]", (rows) => {
            return rows.filter((row) => row.checkVisibility()).map(({ dataset }) => dataset.key);
        });
    };
    const before = await visible();
    await seat.page.type("#filter", "fov");
    assert.deepEqual(await visible(), ["fov"]);
    await seat.page.$eval("#filter", (input) => (input.value = ""));
    await seat.page.type("#filter", "of revolution of a teapot");
    assert.deepEqual(await visible(), []);
    assert.match(await seat.page.$eval("#no-match", ({ textContent }) => textContent), /No control matches/);
    await seat.page.focus("#filter");
    await seat.page.keyboard.press("Escape");
    assert.deepEqual(await visible(), before);
}
