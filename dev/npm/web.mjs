// Uses the module for the web in Node: its pictures are compared with the command's, byte for byte.
//
//     node web.mjs FOLDER PATH/TO/relief
//     node web.mjs --size FOLDER
//
// The folder holds the module that `cargo xtask web` builds; for its size, the whole page.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { parseArgs } from "node:util";
import { fileURLToPath, pathToFileURL } from "node:url";
import { brotliCompressSync, constants } from "node:zlib";

const { values: options, positionals } = parseArgs({
    allowPositionals: true,
    options: { size: { type: "boolean", default: false } },
});
const [folder, relief] = positionals.map((path) => resolve(path));
if (!folder || (!relief && !options.size)) {
    console.error("usage: node web.mjs FOLDER PATH/TO/relief, or node web.mjs --size FOLDER");
    process.exit(2);
}
/** Most bytes of the compressed page: the module, scripts, styles and the document. */
const MOST_BYTES = 2_200_000;

if (options.size) {
    const compressed = (name) => {
        const bytes = readFileSync(join(folder, name));
        const params = {
            [constants.BROTLI_PARAM_QUALITY]: 11,
            [constants.BROTLI_PARAM_LGWIN]: 24,
            [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length,
        };
        return brotliCompressSync(bytes, { params }).length;
    };
    const names = readdirSync(folder).filter((name) => /\.(css|html|js|wasm)$/.test(name));
    const sizes = new Map(names.map((name) => [name, compressed(name)]));
    const all = [...sizes.values()].reduce((sum, size) => sum + size);
    const module = sizes.get("relief_web_bg.wasm");
    console.log(`by brotli: ${all} bytes, of them ${module} of the module and ${all - module} of ${names.length - 1} others`);
    assert(all <= MOST_BYTES, `the page may take ${MOST_BYTES} bytes`);
    process.exit(0);
}

const module = readFileSync(join(folder, "relief_web_bg.wasm"));
const { SceneFiles, initSync } = await import(pathToFileURL(join(folder, "relief_web.js")));
initSync({ module });

const sample = (name) => readFileSync(fileURLToPath(new URL(`../../data/${name}`, import.meta.url)));

/** Heights without symmetry, few enough that maps are baked in no time. */
function heights(side) {
    const height = (at) => {
        const [x, y] = [at % side, Math.floor(at / side)];
        return (x * x * 3 + y * x * 7 + (y > side / 3 ? 90 : 0)) % 251;
    };
    const texels = Array.from({ length: side * side }, (_, at) => height(at));
    return Buffer.concat([Buffer.from(`P5 ${side} ${side} 255\n`), Buffer.from(texels)]);
}

const FILES = { "wall.pgm": heights(40), "maps/colours.png": sample("piebald.png") };
const SCENE = 'height = "wall.pgm"\ncolor = "maps/colours.png"\nsize = [96, 72]\nbackend = "cpu"\n';

/** A viewer of a scene with this text, in the folder `there`; `lanes` is the SIMD width. */
function opened(text, files = FILES, lanes = undefined) {
    const given = new SceneFiles();
    for (const [name, bytes] of Object.entries({ ...files, "scene.toml": Buffer.from(text) })) {
        given.add(`there/${name}`, bytes);
    }
    return given.open("there/scene.toml", false, lanes);
}

/** The file that the command writes of the same scene. */
function byCommand(text, what) {
    const here = mkdtempSync(join(tmpdir(), "relief-web-"));
    try {
        execFileSync("mkdir", [join(here, "maps")]);
        for (const [name, bytes] of Object.entries({ ...FILES, "scene.toml": text })) {
            writeFileSync(join(here, name), bytes);
        }
        const written = what === "aov.exr" ? ["-o", "picture.png", "--aov", what] : ["-o", what];
        execFileSync(relief, ["render", "scene.toml", "-q", ...written], { cwd: here });
        return readFileSync(join(here, what));
    } finally {
        rmSync(here, { recursive: true });
    }
}

async function assertSame(text, what) {
    const same = byCommand(text, what).equals(await opened(text).save(what, 0));
    assert(same, `${what} is another one than the command's for\n${text}`);
}

function methodsOfReliefs() {
    const { panel } = JSON.parse(opened(SCENE).state());
    const control = panel.surfaces.flat().find(({ key }) => key === "method");
    return control.choices.filter(({ refused }) => refused === null).map(({ name }) => name);
}

const tests = {
    async everyMethodOfReliefsIsTheCommands() {
        const methods = methodsOfReliefs();
        assert(methods.length > 25, methods.join());
        for (const method of methods) await assertSame(`${SCENE}method = "${method}"\n`, "picture.png");
    },

    async lanesGiveTheBitsOfSingleNumbers() {
        const clamped = 'wrap = "clamp"\n';
        const more = ["", 'mesh = "torus"\n', clamped, "tile = [2.5, 1.5]\nsamples = 4\n"];
        const searches = ["exact", "relief", "cone", "frustum", "occlusion", "interval", "sphere-tracing"];
        const methods = [...searches, "bump"];
        for (const [number, method] of methods.entries()) {
            const text = `${SCENE}method = "${method}"\n${more[number % more.length]}`;
            const saved = async (lanes) => Buffer.from(await opened(text, FILES, lanes).save("aov.exr", 0));
            const [one, four] = [await saved("1"), await saved("4")];
            assert(one.equals(four), `lanes differ for\n${text}`);
        }
        assert.throws(() => opened(SCENE, FILES, "8"), /no vectors of 8 lanes/);
    },

    async everyFileIsTheCommands() {
        await assertSame(SCENE, "picture.jpg");
        await assertSame(SCENE, "aov.exr");
        // In other looks the system's own sine decides the last bit of some floats.
        await assertSame(`${SCENE}look = "plain"\n`, "picture.exr");
        await assertSame(`${SCENE}mesh = "torus"\nsamples = 4\n`, "picture.png");
    },

    async picturesFollowActions() {
        const viewer = opened(SCENE);
        const wish = { width: 40, height: 30, part: 0.5, samples: "one" };
        const drawn = (heard) => viewer.picture(JSON.stringify(wish), heard);
        const tasks = [];
        const first = await drawn((task, part) => { tasks.push([task, part]); });
        const about = JSON.parse(first.about);
        const told = [about.revision, about.size, about.samples, about.views[0].backend];
        assert.deepEqual(told, [0, [48, 36], 1, "cpu"]);
        const before = first.pixels();
        assert.equal(before.length, 4 * 48 * 36);
        assert.deepEqual(tasks.at(-1), ["rendering", 1]);
        const action = { do: "orbit", degrees: [30, 0] };
        const applied = JSON.parse(viewer.apply(JSON.stringify({ action, drag: null })));
        assert.equal(applied.revision, 1);
        assert.deepEqual(applied.undo, [true, false]);
        assert(!Buffer.from(before).equals((await drawn()).pixels()), "the camera turned");
        viewer.apply(JSON.stringify({ action: { do: "undo" }, drag: null }));
        assert(Buffer.from(before).equals((await drawn()).pixels()), "undo turns it back");
        assert.equal(await drawn(() => true), undefined, "who hears of it may end it");
        assert.throws(() => viewer.apply('{"action": {"do": "jump"}}'), /jump/);
        const far = { do: "set", key: "samples", value: 5000 };
        assert.throws(() => viewer.apply(JSON.stringify({ action: far, drag: null })), /1024/);
    },

    async droppedFilesAreTaken() {
        const viewer = opened(SCENE);
        viewer.give(7, "Brick/brick_height.pgm", FILES["wall.pgm"]);
        viewer.give(7, "Brick/brick_color.png", FILES["maps/colours.png"]);
        assert(JSON.parse(viewer.take(7, undefined)).changed.includes("textures"));
        const text = Buffer.from(await viewer.save("scene.toml", 0)).toString();
        assert.match(text, /textures = "Brick"/);
        viewer.give(8, "other.pgm", FILES["wall.pgm"]);
        viewer.take(8, "height");
        assert.match(Buffer.from(await viewer.save("scene.toml", 0)).toString(), /height = "other.pgm"/);
        assert.throws(() => viewer.give(9, "../up.pgm", FILES["wall.pgm"]), /no path of a dropped file/);
        viewer.give(10, "notes.txt", Buffer.from("text"));
        assert.throws(() => viewer.take(10, undefined), /notes.txt: it is no picture/);
        await assert.rejects(viewer.save("picture.bmp", 0), /nothing that can be saved/);
    },

    async missingFilesAreNamed() {
        const gltf = { asset: { version: "2.0" }, buffers: [{ uri: "parts/one.bin", byteLength: 36 }] };
        gltf.bufferViews = [{ buffer: 0, byteLength: 36 }];
        const bounds = { min: [0, 0, 0], max: [1, 1, 1] };
        gltf.accessors = [{ bufferView: 0, count: 3, componentType: 5126, type: "VEC3", ...bounds }];
        gltf.meshes = [{ primitives: [{ attributes: { POSITION: 0 } }] }];
        gltf.nodes = [{ mesh: 0 }];
        const viewer = opened('mesh = "mesh.gltf"\n', { "mesh.gltf": Buffer.from(JSON.stringify(gltf)) });
        const wish = JSON.stringify({ width: 40, height: 30, part: 1, samples: "one" });
        await assert.rejects(viewer.picture(wish), /there\/parts\/one.bin.*it is not among the files/);
    },
};

for (const [name, test] of Object.entries(tests)) {
    const start = performance.now();
    await test();
    console.log(`${name} ... ok <${((performance.now() - start) / 1000).toFixed(3)}s>`);
}
