// A program that has gone is missed, and found again when it is back.

import assert from "node:assert/strict";
import { once } from "node:events";
import { createServer, request } from "node:http";

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
