// Links to scenes, on the page that they are made on and on others.

import assert from "node:assert/strict";
import { cpSync, mkdirSync } from "node:fs";
import { join } from "node:path";
import { data } from "./web.mjs";

export async function a_link_shows_the_same_on_another_page(web) {
    await web.give("bricks.png");
    await web.rest();
    await web.page.click('[data-do="compare"]');
    await web.rest();
    const link = await web.link();
    assert.ok(link.includes("#s=1&") && !link.includes("cobbles"), link);
    const other = await web.another(link);
    await other.page.waitForSelector("#empty:not([hidden])");
    assert.match(await other.text("#empty-title"), /needs bricks.png/);
    await other.give("cobbles.png");
    await other.page.waitForSelector("#errors .message");
    assert.match(await other.text("#errors"), /cobbles.png.*link needs, bricks.png/);
    await other.page.click("#errors button");
    // A file of that name with another content is none of the link's.
    mkdirSync(join(web.here, "other"));
    cpSync(data("cobbles.png"), join(web.here, "other", "bricks.png"));
    await other.give("other/bricks.png");
    await other.page.waitForSelector("#errors .message");
    assert.match(await other.text("#errors"), /another content/);
    await other.give("bricks.png");
    await other.rest();
    assert.ok((await other.canvas()).bytes.equals((await web.canvas()).bytes), "another picture");
    assert.deepEqual(other.wrong, []);
    await other.page.close();
}

export async function a_link_that_cannot_be_used_leaves_what_is_there(web) {
    const sample = await web.canvas();
    const address = (await web.link()).split("#")[0];
    for (const [end, said] of [
        ["s=1&height=cobbles.png", /not whole/],
        ["s=9&height=cobbles.png&end", /version 9/],
        ["s=1&height=none.png&end", /no such sample/],
        [`s=1&height=${"a".repeat(1 << 20)}&end`, /1048\d+ characters/],
    ]) {
        const other = await web.another(`${address}#${end}`);
        await other.rest();
        assert.match(await other.text("#errors"), said);
        assert.ok((await other.canvas()).bytes.equals(sample.bytes), "the sample is not shown");
        await other.page.close();
    }
    // A link that is entered on an open page is one step.
    await web.page.evaluate(() => (location.hash = "#s=1&height=cobbles.png&method=cone&scale=0.4&end"));
    await web.page.waitForSelector('[data-do="undo"][aria-disabled="false"]');
    await web.rest();
    assert.ok(!(await web.canvas()).bytes.equals(sample.bytes), "the link is not followed");
    await web.page.click('[data-do="undo"]');
    await web.page.waitForSelector('[data-do="undo"][aria-disabled="true"]');
    await web.rest();
    assert.ok((await web.canvas()).bytes.equals(sample.bytes), "it is not undone");
}
