// A program that has gone is missed, and found again when it is back. Two pages of one program agree.

import assert from "node:assert/strict";
import { once } from "node:events";
import { createServer, request } from "node:http";
import { Seat } from "./seat.mjs";

/** A way to the program that can be cut, so that it goes and comes back at the same address. */
async function bridge(address) {
    const { host, origin, pathname } = new URL(address);
    const server = createServer((asked, answer) => {
        const headers = { ...asked.headers, host };
        if (headers.origin) headers.origin = origin;
        const onward = request(origin + asked.url, { method: asked.method, headers }, (answered) => {
            answer.writeHead(answered.statusCode, answered.headers);
            answered.pipe(answer);
        });
        asked.pipe(onward);
        onward.on("error", () => answer.destroy());
    });
    const open = async (port) => {
        server.listen(port, "127.0.0.1");
        await once(server, "listening");
        return server.address().port;
    };
    const port = await open(0);
    const close = () => (server.closeAllConnections(), server.close());
    return { address: `http://127.0.0.1:${port}${pathname}`, close, open: () => open(port) };
}

export async function a_host_that_goes_is_missed_and_found_again(seat) {
    seat.mayFail = true;
    const { page } = seat;
    const way = await bridge(seat.program.address);
    await page.goto(way.address);
    await seat.rest();
    way.close();
    await (await page.$("canvas")).press("ArrowRight");
    await page.waitForSelector("#gone:not([hidden])");
    assert.match(await page.$eval("#gone", ({ textContent }) => textContent), /The program has ended/);
    await way.open();
    await page.waitForSelector("#gone[hidden]");
    await seat.rest();
    const text = await seat.scene();
    await (await page.$("canvas")).press("ArrowRight");
    await seat.rest();
    assert.notEqual(await seat.scene(), text);
    await page.goto("about:blank");
    way.close();
}

export async function a_second_page_follows_the_first(seat) {
    seat.mayFail = true;
    const page = await seat.page.browserContext().newPage();
    const other = new Seat(page, seat.program, seat.folder, seat.relief);
    other.mayFail = true;
    await other.sit();
    await seat.page.bringToFront();
    await seat.type("scale", "0.2");
    const now = await seat.canvas();
    // Nothing is asked behind the first page; a save there would be of another picture.
    const said = await other.page.evaluate(async () => {
        const { revision } = await fetch("state").then((answer) => answer.json());
        return fetch(`save?what=scene.toml&revision=${revision - 1}`).then((answer) => answer.status);
    });
    assert.equal(said, 409);
    assert.ok(!(await other.canvas()).bytes.equals(now.bytes));
    const shown = () => other.page.$eval('[data-key="scale"] input.number', ({ value }) => value);
    assert.notEqual(await shown(), "0.2");
    await other.page.$eval("[data-what='scene.toml']", (button) => button.click());
    await other.rest();
    assert.match((await other.errors()).join(), /another page/);
    assert.ok((await other.canvas()).bytes.equals(now.bytes), "the picture is still the old one");
    assert.equal(await shown(), "0.2");
    // It also looks when it comes to the front.
    await seat.type("scale", "0.3");
    await other.page.bringToFront();
    await other.page.evaluate(() => window.dispatchEvent(new Event("focus")));
    await other.rest();
    assert.equal(await shown(), "0.3");
    assert.ok((await other.canvas()).bytes.equals((await seat.canvas()).bytes));
    // Its message goes away with what works next.
    await other.click("[data-do=undo]");
    assert.deepEqual(await other.errors(), []);
    other.checkQuiet();
}
