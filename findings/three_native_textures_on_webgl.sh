#!/usr/bin/env bash
# A function of three.js in the native language takes a texture on WebGPU, and not on WebGL 2. There the call passes
# the name of a sampler that is declared nowhere, and the program is not compiled.
#
# three.js 0.187.0 of npm, in Chromium 156 without a window. `wgslFn` with a parameter of the type texture_2d<f32>
# gets the texture's name. `glslFn` with a parameter of the type sampler2D gets that name with `_sampler` behind it:
# WGSL has such a variable beside each texture, GLSL has not. A texture node's `load` and `sample` work in both.
#
# Seen: "webgl: red is 0, 'map_sampler' : undeclared identifier" and "webgl by load: red is 1". Fails where it is
# otherwise. Needs npm, and chromium (or CHROMIUM).
set -euo pipefail

folder=$(mktemp -d)
# The browser may still write.
trap 'sleep 1; rm -rf "$folder"' EXIT
cd "$folder"
npm init -y >/dev/null
npm install --silent --no-audit --no-fund three@0.187.0

cat >page.html <<'PAGE'
<!doctype html>
<meta charset="utf-8">
<script type="importmap">{ "imports": {
    "three": "./node_modules/three/build/three.webgpu.js",
    "three/webgpu": "./node_modules/three/build/three.webgpu.js",
    "three/tsl": "./node_modules/three/build/three.tsl.js"
} }</script>
<script type="module">
    import * as THREE from "three/webgpu";
    import { glslFn, ivec2, texture } from "three/tsl";

    const said = [];
    console.error = (...words) => said.push(words.join(" "));
    function map() {
        const made = new THREE.DataTexture(new Uint8Array([255, 0, 0, 255]), 1, 1);
        made.needsUpdate = true;
        return texture(made);
    }

    async function red(colorNode) {
        const renderer = new THREE.WebGPURenderer({ forceWebGL: true });
        await renderer.init();
        const target = new THREE.RenderTarget(1, 1, { type: THREE.FloatType });
        const scene = new THREE.Scene();
        const material = new THREE.MeshBasicNodeMaterial();
        material.colorNode = colorNode;
        scene.add(new THREE.Mesh(new THREE.PlaneGeometry(4, 4), material));
        const camera = new THREE.PerspectiveCamera(50, 1, 0.1, 10);
        camera.position.z = 1;
        renderer.setClearColor(0, 0);
        renderer.setRenderTarget(target);
        renderer.render(scene, camera);
        const pixels = await renderer.readRenderTargetPixelsAsync(target, 0, 0, 1, 1);
        return pixels[0];
    }

    let answer;
    try {
        const read = glslFn("vec4 read(sampler2D map) { return texelFetch(map, ivec2(0, 0), 0); }");
        const native = await red(read({ map: map().setName("map") }));
        const fault = /'map_sampler' : undeclared identifier/.exec(said.join("\n"))?.[0] ?? "nothing is said";
        const loaded = await red(map().load(ivec2(0, 0)));
        answer = `webgl: red is ${native}, ${fault}\nwebgl by load: red is ${loaded}`;
    } catch (error) {
        answer = `error: ${error.stack ?? error}`;
    }
    await fetch("/answer", { method: "POST", body: answer });
</script>
PAGE
cat >serve.mjs <<'SERVE'
import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { createServer } from "node:http";

const kinds = { html: "text/html", js: "text/javascript" };
const server = createServer((request, reply) => {
  if (request.method === "POST") {
    let body = "";
    request.on("data", (part) => (body += part));
    request.on("end", () => {
      console.log(body);
      browser.kill();
      process.exit(0);
    });
    return;
  }
  try {
    const bytes = readFileSync(`.${request.url}`);
    reply.setHeader("content-type", kinds[request.url.split(".").pop()] ?? "text/plain");
    reply.end(bytes);
  } catch {
    reply.statusCode = 404;
    reply.end();
  }
});
let browser;
server.listen(0, "127.0.0.1", () => {
  browser = spawn(process.env.CHROMIUM ?? "chromium", [
    "--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    "--user-data-dir=profile", `http://127.0.0.1:${server.address().port}/page.html`,
  ], { stdio: "ignore" });
  setTimeout(() => process.exit(1), 120000);
});
SERVE
seen=$(node serve.mjs)
echo "$seen"
expected="webgl: red is 0, 'map_sampler' : undeclared identifier
webgl by load: red is 1"
[ "$seen" = "$expected" ] || { echo "this has changed"; exit 1; }
