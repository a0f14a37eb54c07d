// Exports shaders as WGSL and compiles each with Tint, Chromium's compiler. It refuses some texts that naga
// takes. Needs no GPU: the device is Dawn's null device.
//
//     node tint.mjs PATH/TO/relief
//
// Exported are all methods, as shaders and as functions, and every variant of the other stages on
// the method `relief`, or on `voxels` where it needs a volume, or on `shell-map` where it needs a
// motif, in both samplings.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { create, globals } from "webgpu";

Object.assign(globalThis, globals);

// Names of the stages in `relief methods --json`, and the flags that choose a variant of them.
const STAGES = {
    surface: "--surface",
    shadow: "--shadow",
    "shadow search": "--shadow-search",
    "ambient light": "--ambient",
    detail: "--detail",
};

// What a stage needs beside it.
const BESIDE = { "shadow search": ["--shadow", "ray"] };

const relief = process.argv[2];
if (!relief) {
    console.error("usage: node tint.mjs PATH/TO/relief");
    process.exit(2);
}

// Kept: Dawn's instance must live as long as its devices.
const gpu = create(["backend=null"]);
const adapter = await gpu.requestAdapter();
const device = await adapter.requestDevice();

// What Tint says against a text; nothing where it compiles.
async function errors(code) {
    device.pushErrorScope("validation");
    const compiled = device.createShaderModule({ code });
    const { messages } = await compiled.getCompilationInfo();
    await device.popErrorScope();
    const wrong = messages.filter(({ type }) => type === "error");
    return wrong.map(({ lineNum, message }) => `${lineNum}: ${message}`);
}

// Methods that variants of the other stages are exported with: the first that goes with a variant.
const METHODS = ["relief", "voxels", "shell-map"];

// The export of a selection, by the flags that make it.
function exported(flags) {
    const folder = mkdtempSync(join(tmpdir(), "relief-tint-"));
    try {
        const all = ["shader", ...flags, "--target", "wgsl", "-q", "-o", folder];
        execFileSync(relief, all, { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
        const files = readdirSync(folder).filter((name) => name.endsWith(".wgsl"));
        return files.map((name) => readFileSync(join(folder, name), "utf8"));
    } finally {
        rmSync(folder, { recursive: true });
    }
}

const all = execFileSync(relief, ["methods", "--json"], { encoding: "utf8", maxBuffer: 1 << 26 });
const known = JSON.parse(all);
// For each selection lists of flags; the first that go together are taken.
const selections = known.methods.map(({ name }) => [["--method", name]]);
// The methods as functions, on flat and on bent meshes.
for (const { name } of known.methods) {
    const functions = ["--method", name, "--entry", "functions"];
    const bent = ["--surface", "quadric-vertical", "--shadow", "ray", "--wrap", "clamp"];
    selections.push([functions], [[...functions, ...bent]]);
}
for (const [stage, flag] of Object.entries(STAGES)) {
    for (const { name } of known[stage]) {
        selections.push(METHODS.map((method) => ["--method", method, ...(BESIDE[stage] ?? []), flag, name]));
    }
}

// The first of some selections that can be exported, and its texts; no texts where the command says of each
// that its variants do not go together.
function firstExport(selections, sampling) {
    for (const selection of selections) {
        const flags = [...selection, "--sampling", sampling];
        try {
            return [flags, exported(flags)];
        } catch (error) {
            if (error.status !== 2) throw error;
        }
    }
    return [];
}

let [compiled, failed, refused] = [0, 0, 0];
for (const selection of selections) {
    for (const sampling of ["exact", "fast"]) {
        const [flags, texts] = firstExport(selection, sampling);
        if (texts === undefined) {
            refused += 1;
            continue;
        }
        for (const text of texts) {
            const found = await errors(text);
            compiled += 1;
            if (found.length > 0) {
                failed += 1;
                console.log(`${flags.join(" ")}:\n  ${found.slice(0, 3).join("\n  ")}`);
            }
            // A text with a fault must not pass.
            const entry = /fn (shade_pixel|gathered_in_shell|relief_base_of_point)\(/;
            const broken = text.replace(entry, "fn $1s(");
            if (broken === text || (await errors(broken)).length === 0) {
                throw new Error(`${flags.join(" ")}: a fault in the text was not noticed`);
            }
        }
    }
}
const count = `${compiled} shaders compiled, ${failed} refused by it`;
console.log(`Tint: ${count}, ${refused} selections that do not go together`);
process.exit(failed > 0 || compiled === 0 ? 1 : 0);
