// Opens the page of the viewer on a static host, in headless Chromium: the module draws in a worker.
//
//     node web_page.mjs FOLDER PATH/TO/relief [--browser /usr/bin/chromium] [--only NAME]
//
// The folder holds what `cargo xtask web` writes.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { parseArgs } from "node:util";
import { fileURLToPath } from "node:url";
import puppeteer from "puppeteer-core";
import { serve } from "./serve.mjs";
import * as figures from "./web_page/figures.mjs";
import * as gpu from "./web_page/gpu.mjs";
import * as links from "./web_page/links.mjs";
import * as pictures from "./web_page/pictures.mjs";
import { Web, data } from "./web_page/web.mjs";

const { values: options, positionals } = parseArgs({
    allowPositionals: true,
    options: { browser: { type: "string", default: "/usr/bin/chromium" }, only: { type: "string" } },
});
const [folder, relief] = positionals.map((path) => resolve(path));
if (!folder || !relief) {
    console.error("usage: node web_page.mjs FOLDER PATH/TO/relief [--browser PROGRAM] [--only NAME]");
    process.exit(2);
}

const FLAGS = ["--headless", "--no-sandbox", "--disable-quic", "--no-first-run"];
const QUIET = ["--disable-background-networking", "--disable-component-update", "--disable-sync"];
/** Whether a browser has WebGPU: one by software, in tests. */
const WITH_GPU = ["--enable-unsafe-webgpu"];
const WITHOUT_GPU = ["--disable-gpu"];

/** Checks the types of the page as it is served. */
function types() {
    const own = mkdtempSync(join(tmpdir(), "relief-types-"));
    const config = join(own, "tsconfig.json");
    const base = fileURLToPath(new URL("../../crates/relief-cli/page/jsconfig.json", import.meta.url));
    const lib = ["es2023", "dom", "dom.iterable"];
    const all = { extends: base, compilerOptions: { lib }, include: [`${folder}/*.js`, `${folder}/*.d.ts`] };
    const exclude = ["relief_web.js", "worker.js"].map((name) => `${folder}/${name}`);
    writeFileSync(config, JSON.stringify({ ...all, exclude }));
    const compiler = fileURLToPath(new URL("node_modules/typescript/bin/tsc", import.meta.url));
    try {
        execFileSync(process.execPath, [compiler, "-p", config, "--noEmit"], { stdio: "inherit" });
    } finally {
        rmSync(own, { recursive: true });
    }
}


types();
const { server, address } = await serve(folder, 0, figures.served);
let failed = 0;

/** Runs tests in a browser with more flags. */
async function run(tests, flags) {
    const all = Object.entries(tests).filter(([, test]) => typeof test === "function");
    const chosen = all.filter(([name]) => !options.only || name.includes(options.only));
    if (chosen.length === 0) return;
    const profile = mkdtempSync(join(tmpdir(), "relief-web-profile-"));
    const browser = await puppeteer.launch({
        executablePath: options.browser,
        userDataDir: profile,
        args: [...FLAGS, ...QUIET, ...flags],
    });
    for (const [name, test] of chosen) {
        const here = mkdtempSync(join(tmpdir(), "relief-web-"));
        for (const map of ["cobbles.png", "cobbles_color.png", "bricks.png"]) cpSync(data(map), join(here, map));
        const web = new Web(await browser.newPage(), here, relief);
        try {
            await web.open(address);
            await web.rest();
            await test(web);
            assert.deepEqual(web.wrong, []);
            console.log(`ok      ${name}`);
        } catch (error) {
            failed += 1;
            console.log(`FAILED  ${name}\n${error.stack}\n${web.wrong.join("\n")}`);
        } finally {
            await web.page.close();
            rmSync(here, { recursive: true });
        }
    }
    await browser.close();
    rmSync(profile, { recursive: true });
}

await run({ ...pictures, ...links, ...figures }, WITHOUT_GPU);
await run(gpu, WITH_GPU);
server.close();
process.exit(failed > 0 ? 1 : 0);
