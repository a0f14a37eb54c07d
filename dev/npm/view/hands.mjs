// The page serves every hand and eye: names and roles, contrast, the keyboard, small and magnified pages.

import assert from "node:assert/strict";
import { found } from "./axe.mjs";

async function openAll(seat, isOpen) {
    await seat.page.$$eval("details.group", (all, open) => all.forEach((each) => (each.open = open)), isOpen);
}

async function showTab(seat, name) {
    await seat.page.evaluate((name) => {
        [...document.querySelectorAll("[role=tab]")].find((tab) => tab.textContent === name).click();
    }, name);
}

export async function axe_finds_nothing_grave(seat) {
    await openAll(seat, true);
    const looks = [
        { name: "prefers-color-scheme", value: "light" },
        { name: "prefers-color-scheme", value: "dark" },
    ];
    for (const look of looks) {
        await seat.page.emulateMediaFeatures([look]);
        for (const tab of ["Surface", "Scene"]) {
            await showTab(seat, tab);
            assert.deepEqual(await found(seat), [], `${look.value}, ${tab}`);
        }
    }
    const client = await seat.page.createCDPSession();
    for (const value of ["light", "dark"]) {
        const scheme = { name: "prefers-color-scheme", value };
        const features = [{ name: "forced-colors", value: "active" }, scheme];
        await client.send("Emulation.setEmulatedMedia", { features });
        assert.equal(await seat.page.evaluate(() => matchMedia("(forced-colors: active)").matches), true);
        assert.deepEqual(await found(seat), [], `forced colours, ${value}`);
    }
}

export async function axe_finds_nothing_grave_in_messages_and_dialogs(seat) {
    seat.mayFail = true;
    await seat.type("ior", "99");
    assert.deepEqual(await found(seat), []);
    await seat.click(".menu summary");
    assert.deepEqual(await found(seat), []);
    for (const name of ["help", "end"]) {
        await seat.click(`[data-do=${name}]`);
        assert.equal(await seat.page.$eval(`#${name}-dialog`, ({ open }) => open), true);
        assert.deepEqual(await found(seat), [], name);
        await seat.page.keyboard.press("Escape");
    }
}

/** The check must be able to fail. */
export async function axe_complains_of_a_label_that_is_taken_away(seat) {
    await seat.page.$eval('[data-key="scale"] label', (label) => label.remove());
    const said = await found(seat);
    assert.ok(said.some((each) => /^label/.test(each)), `only ${said.join()}`);
}

export async function every_control_has_role_name_and_description(seat) {
    await openAll(seat, true);
    for (const tab of ["Surface", "Scene"]) {
        await showTab(seat, tab);
        const poor = await seat.page.evaluate(() => {
            const rows = [...document.querySelectorAll("[data-key]")];
            return rows.filter((row) => row.checkVisibility()).filter((row) => {
                const field = row.querySelector("select, fieldset, input:not([type=range], [hidden])");
                const about = (field.getAttribute("aria-describedby") ?? "").split(" ");
                const words = about.map((id) => document.getElementById(id)?.textContent ?? "").join("");
                return words === "" || row.querySelector("label").textContent === "";
            }).map(({ dataset }) => dataset.key);
        });
        assert.deepEqual(poor, []);
    }
    const tree = JSON.stringify(await seat.page.accessibility.snapshot({ interestingOnly: false }));
    for (const { label } of (await seat.state()).panel.scene) assert.ok(tree.includes(label), label);
}

/** What Tab reaches, by a name for each element. */
async function reached(seat, most) {
    const names = new Set();
    await seat.page.evaluate(() => document.activeElement?.blur());
    for (let press = 0; press < most; press += 1) {
        await seat.page.keyboard.press("Tab");
        const name = await seat.page.evaluate(() => {
            const at = document.activeElement;
            const style = getComputedStyle(at);
            const key = at.closest("[data-key]")?.dataset.key ?? "";
            const isSeen = at === document.body || style.outlineStyle !== "none";
            return isSeen ? `${key}/${at.id || at.dataset.do || at.tagName}` : `unseen: ${at.outerHTML}`;
        });
        assert.ok(!name.startsWith("unseen"), name);
        names.add(name);
    }
    return names;
}

export async function tab_reaches_everything_and_the_focus_is_seen(seat) {
    await openAll(seat, true);
    const wanted = await seat.page.evaluate(() => {
        const rows = [...document.querySelectorAll("[data-key]")].filter((row) => row.checkVisibility());
        return rows.map(({ dataset }) => dataset.key);
    });
    const names = [...(await reached(seat, 60 + 4 * wanted.length))];
    for (const name of ["/picture", "/undo", "/light", "/help", "/filter"]) {
        assert.ok(names.includes(name), name);
    }
    const keys = new Set(names.map((name) => name.split("/")[0]));
    assert.deepEqual(wanted.filter((key) => !keys.has(key)), []);
}

/** What is cut off or reaches beyond the page's width, and buttons too small to hit. */
function lacking(seat) {
    return seat.page.evaluate(() => {
        const wrong = [];
        if (document.documentElement.scrollWidth > innerWidth) wrong.push("the page scrolls sideways");
        for (const each of document.querySelectorAll("button, summary, select, input:not([hidden])")) {
            if (!each.checkVisibility()) continue;
            const { left, right, width, height } = each.getBoundingClientRect();
            const name = each.outerHTML.slice(0, 90);
            if (left < 0 || right > innerWidth + 0.5) wrong.push(`beyond the page: ${name}`);
            if (width < 23.9 || height < 23.9) wrong.push(`${width} x ${height}: ${name}`);
        }
        return wrong;
    });
}

export async function small_and_magnified_pages_lose_nothing(seat) {
    await openAll(seat, true);
    const pages = [
        { width: 320, height: 640, deviceScaleFactor: 1 },
        { width: 320, height: 200, deviceScaleFactor: 4 },
        { width: 699, height: 900, deviceScaleFactor: 1 },
        { width: 1280, height: 800, deviceScaleFactor: 1 },
    ];
    for (const page of pages) {
        await seat.page.setViewport(page);
        await seat.rest();
        assert.deepEqual(await lacking(seat), [], `${page.width} x ${page.height}`);
    }
}
