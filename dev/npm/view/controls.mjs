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

const alert = (row) => row.$eval("[role=alert]", ({ textContent }) => textContent);
const isInvalid = (row) => row.$eval("input.number", (input) => input.ariaInvalid);
const shown = (row) =>
    row.$$eval("input:not([type=range], [hidden])", (all) => all.map(({ value }) => value));

export async function a_refused_value_changes_nothing_says_why_and_stays_to_be_corrected(seat) {
    seat.mayFail = true;
    const [scene, undo] = [await seat.scene(), await seat.undoable()];
    const row = await seat.row("ior");
    const before = await shown(row);
    for (const [text, why] of [["99", /Ior/], ["abc", /not a number/], ["1,4", /write 1\.4/]]) {
        await seat.type("ior", text);
        assert.match(await alert(row), why);
        assert.equal(await isInvalid(row), "true");
        assert.deepEqual(await shown(row), [text]);
        assert.ok(await row.$eval("[role=alert]", (node) => {
            const [{ top, bottom }, around] = [node, document.getElementById("sheets")]
                .map((each) => each.getBoundingClientRect());
            return top >= around.top && bottom <= around.bottom;
        }), "the message is not in sight");
    }
    assert.equal(await seat.scene(), scene);
    assert.deepEqual(await seat.undoable(), undo);
    await seat.type("ior", "1.4");
    assert.equal(await alert(row), "");
    assert.equal(await isInvalid(row), null);
    // Escape takes back what was refused.
    await seat.type("ior", "99");
    await (await row.$("input.number")).press("Escape");
    assert.deepEqual([await alert(row), await shown(row)], ["", ["1.4"]]);
    await seat.click("[data-do=undo]");
    assert.deepEqual(await shown(row), before);
}

export async function lengths_are_taken_with_their_units(seat) {
    await seat.type("scale", "5cm");
    assert.equal((await seat.control("scale")).value, "0.05");
    const scale = await seat.row("scale");
    assert.deepEqual(await shown(scale), ["0.05"]);
    seat.mayFail = true;
    for (const [text, why] of [["0,05", /write 0\.05/], ["5 parsec", /Scale/], ["abc", /Scale/]]) {
        await seat.type("scale", text);
        assert.match(await alert(scale), why);
        assert.equal((await seat.control("scale")).value, "0.05");
    }
    await seat.type("scale", "2mm");
    assert.deepEqual([await alert(scale), await shown(scale)], ["", ["0.002"]]);
    const row = await seat.row("tile-size");
    const [first, second] = await row.$$("input.number");
    await first.type("5cm");
    await second.type("1in");
    await second.press("Enter");
    await seat.rest();
    assert.equal((await seat.control("tile-size")).value, "[0.05, 0.0254]");
    assert.deepEqual(await shown(row), ["0.05", "0.0254"]);
}

/** Types `12`, Tab, `24` and Enter, and waits for nothing between. */
async function typePair(seat, key) {
    const [first] = await (await seat.row(key)).$$("input.number");
    await first.click({ count: 3 });
    const delay = 120;
    await seat.page.keyboard.type("12", { delay });
    await seat.page.keyboard.press("Tab", { delay });
    await seat.page.keyboard.type("24", { delay });
    await seat.page.keyboard.press("Enter");
    await seat.rest();
}

export async function a_pair_is_typed_without_a_pause(seat) {
    // Heights outside of the range cannot be shown.
    seat.mayFail = true;
    for (const [key, value] of [["tile", "[12.0, 24.0]"], ["size", "[12, 24]"], ["range", "[12.0, 24.0]"]]) {
        await typePair(seat, key);
        const row = await seat.row(key);
        assert.deepEqual(await shown(row), ["12", "24"], key);
        assert.equal(await alert(row), "");
        assert.equal((await seat.control(key)).value, value);
    }
    await seat.click("[data-do=undo]");
    await seat.click("[data-do=undo]");
    assert.deepEqual(await shown(await seat.row("size")), ["12", "120"]);
}

export async function a_text_that_is_typed_outlives_a_state_and_follows_it_after(seat) {
    const row = await seat.row("scale");
    const input = await row.$("input.number");
    await input.click({ count: 3 });
    await input.type("0.3");
    // Another page gives the scene another value.
    const action = { do: "set", key: "scale", value: 0.4 };
    const request = { method: "POST", body: JSON.stringify({ action }) };
    const send = (request) => fetch("apply", request).then((answer) => answer.json());
    const look = () => seat.page.evaluate(() => window.dispatchEvent(new Event("focus")));
    await seat.page.evaluate(send, request);
    await look();
    await seat.rest();
    assert.deepEqual(await shown(row), ["0.3"]);
    await input.press("Escape");
    assert.deepEqual(await shown(row), ["0.4"]);
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

const visibleKeys = (seat) => {
    return seat.page.$$eval("[data-key]", (rows) => {
        return rows.filter((row) => row.checkVisibility()).map(({ dataset }) => dataset.key);
    });
};

export async function plain_words_find_controls(seat) {
    const words = [["depth", "scale"], ["brightness", "exposure"], ["colour", "color"], ["sun", "light"]];
    for (const [word, key] of words) {
        await seat.page.$eval("#filter", (input) => (input.value = ""));
        await seat.page.type("#filter", word);
        assert.ok((await visibleKeys(seat)).includes(key), `${word} does not find ${key}`);
    }
}

export async function a_tab_has_a_place_of_its_own(seat) {
    const scrolled = () => seat.page.$eval("#sheets", ({ scrollTop }) => Math.round(scrollTop));
    const selected = () =>
        seat.page.$eval("[role=tab][aria-selected=true]", ({ textContent }) => textContent);
    await seat.page.$$eval("details.group", (all) => all.forEach((group) => (group.open = true)));
    await seat.page.$eval("#sheets", (sheets) => (sheets.scrollTop = 400));
    const before = await scrolled();
    assert.ok(before > 0);
    const tabs = await seat.page.$$("[role=tab]");
    await tabs[1].click();
    assert.deepEqual([await selected(), await scrolled()], ["Scene", 0]);
    await tabs[0].click();
    assert.equal(await scrolled(), before);
    await seat.click("#add-surface");
    assert.deepEqual([await selected(), await scrolled()], ["Surface 1", 0]);
    // Functions are of the surface whose tab is open.
    const label = () => seat.page.$eval("[data-what='relief.wgsl']", ({ textContent }) => textContent);
    await seat.page.click(".menu:has(#saves) summary");
    assert.match(await label(), /surface 1/);
    await (await seat.page.$("[role=tab]")).click();
    await seat.page.click(".menu:has(#saves) summary");
    assert.match(await label(), /surface 0/);
}

export async function the_filter_finds_controls_on_all_tabs(seat) {
    const visible = () => visibleKeys(seat);
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
