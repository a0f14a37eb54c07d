// Opens the page of `relief view` in headless Chromium and uses it as a person does.
//
//     node view.mjs PATH/TO/relief [--browser /usr/bin/chromium] [--only NAME]
//
// The page's types are checked first. Each test has a page and a program of its own, in an empty folder.

import { execFileSync } from "node:child_process";
import { resolve } from "node:path";
import { parseArgs } from "node:util";
import { fileURLToPath } from "node:url";
import { Bench } from "./view/bench.mjs";
import * as cameras from "./view/cameras.mjs";
import * as controls from "./view/controls.mjs";
import * as files from "./view/files.mjs";
import * as hands from "./view/hands.mjs";
import * as hosts from "./view/hosts.mjs";
import * as pictures from "./view/pictures.mjs";
import * as views from "./view/views.mjs";

const { values: options, positionals } = parseArgs({
    allowPositionals: true,
    options: { browser: { type: "string", default: "/usr/bin/chromium" }, only: { type: "string" } },
});
const relief = positionals[0] && resolve(positionals[0]);
if (!relief) {
    console.error("usage: node view.mjs PATH/TO/relief [--browser PROGRAM] [--only NAME]");
    process.exit(2);
}

function types() {
    const compiler = fileURLToPath(new URL("node_modules/typescript/bin/tsc", import.meta.url));
    const project = fileURLToPath(new URL("../../crates/relief-cli/page/jsconfig.json", import.meta.url));
    execFileSync(process.execPath, [compiler, "-p", project, "--noEmit"], { stdio: "inherit" });
}

const tests = Object.entries({
    ...pictures, ...hosts, ...cameras, ...controls, ...files, ...hands, ...views,
});
const chosen = tests.filter(([name]) => !options.only || name.includes(options.only));
if (chosen.length === 0) {
    console.error(`no test is called '${options.only}': ${tests.map(([name]) => name).join(", ")}`);
    process.exit(2);
}

types();
const bench = await Bench.open(relief, options.browser);
let failed = 0;
for (const [name, test] of chosen) {
    try {
        await bench.run(test);
        console.log(`ok      ${name}`);
    } catch (error) {
        failed += 1;
        console.log(`FAILED  ${name}\n${error.stack}`);
    }
}
await bench.close();
console.log(`${chosen.length - failed} passed, ${failed} failed`);
process.exit(failed > 0 ? 1 : 0);
