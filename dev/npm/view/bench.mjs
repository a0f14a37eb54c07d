// Runs a test: a folder with maps, a program that shows one of them, and a page of a browser.

import { spawn } from "node:child_process";
import { once } from "node:events";
import { cpSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { fileURLToPath } from "node:url";
import puppeteer from "puppeteer-core";
import { Seat } from "./seat.mjs";

const DATA = fileURLToPath(new URL("../../../data/", import.meta.url));
const FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"];
const QUIET = ["--disable-background-networking", "--disable-component-update", "--disable-sync"];
/** The scene of a test that says no other. */
const SCENE = ["cobbles.png", "--size", "160x120", "--samples", "1", "--backend", "cpu"];

export class Bench {
    static async open(relief, browser) {
        const bench = new Bench();
        bench.relief = relief;
        bench.profile = mkdtempSync(join(tmpdir(), "relief-view-profile-"));
        bench.browser = await puppeteer.launch({
            executablePath: browser,
            userDataDir: bench.profile,
            args: [...FLAGS, ...QUIET],
        });
        return bench;
    }

    /** A test may say which scene it needs, in `test.scene`. */
    async run(test) {
        const folder = mkdtempSync(join(tmpdir(), "relief-view-"));
        for (const map of ["cobbles.png", "bricks.png"]) cpSync(join(DATA, map), join(folder, map));
        const context = await this.browser.createBrowserContext();
        let program;
        try {
            program = await Program.start(this.relief, folder, test.scene ?? SCENE);
            const seat = new Seat(await context.newPage(), program, folder, this.relief);
            await seat.sit();
            await test(seat);
            seat.checkQuiet();
        } finally {
            program?.kill();
            await context.close();
            rmSync(folder, { recursive: true });
        }
    }

    async close() {
        await this.browser.close();
        rmSync(this.profile, { recursive: true });
    }
}

/** A running `relief view`. */
export class Program {
    static async start(relief, folder, scene) {
        const program = new Program();
        const all = ["view", ...scene, "--no-open"];
        program.process = spawn(relief, all, { cwd: folder, stdio: ["ignore", "pipe", "pipe"] });
        program.address = await addressOf(program.process);
        return program;
    }

    kill() {
        this.process.kill("SIGKILL");
    }
}

/** The address that a program prints. */
async function addressOf(process) {
    const said = [];
    for (const stream of [process.stdout, process.stderr]) {
        createInterface({ input: stream }).on("line", (line) => {
            said.push(line);
            const address = /http:\/\/\S+/.exec(line)?.[0];
            if (address) process.emit("address", address);
        });
    }
    const ended = once(process, "exit").then(() => null);
    const address = await Promise.race([once(process, "address").then(([address]) => address), ended]);
    if (!address) throw new Error(`relief view ended: ${said.join("\n")}`);
    return address;
}
