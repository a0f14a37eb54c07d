#!/usr/bin/env bash
# Babylon.js' PBRMaterial turns parallax round on meshes with tangents.
#
# Babylon.js 9.35.0, WebGL 2 in Chromium 156 without a window, the left-handed system that scenes have by default. A
# plane of one tile has a height of 0 everywhere in the opacity of its bump texture: a level floor, a tenth of a tile
# deep. So what one sees there moves away from the eye. On the plane as `CreateGround` makes it, it does. With tangents
# along +u at its vertices, as in glTF, `PBRMaterial` moves it toward the eye by as much: stones become pits. It does so
# along u whatever the sign of the tangents. `StandardMaterial` takes no notice of tangents. An unlit texture whose
# colour is the coordinate shows it.
#
# Seen, in fiftieths of a tile along u and v; below 0 is away from the eye:
#
#     Babylon.js 9.35.0, WebGL 2
#     StandardMaterial: -4, -5
#     StandardMaterial with tangents: -4, -5
#     PBRMaterial: -4, -5
#     PBRMaterial with tangents: 4, 5
#     PBRMaterial with tangents of the other sign: 4, -5
#
# Fails where it is otherwise. Needs npm, and chromium (or CHROMIUM).
set -euo pipefail

folder=$(mktemp -d)
# The browser may still write.
trap 'sleep 1; rm -rf "$folder"' EXIT
cd "$folder"
npm init -y >/dev/null
npm install --silent --no-audit --no-fund --ignore-scripts babylonjs@9.35.0

cat >page.html <<'PAGE'
<!doctype html>
<meta charset="utf-8">
<canvas id="canvas" width="65" height="65"></canvas>
<script src="node_modules/babylonjs/babylon.js"></script>
<script type="module">
    const tell = (body) => fetch("/answer", { method: "POST", body });
    addEventListener("unhandledrejection", ({ reason }) => tell(`error: ${reason?.stack ?? reason}`));
    const engine = new BABYLON.Engine(document.getElementById("canvas"), false, { preserveDrawingBuffer: true });
    const lines = [`Babylon.js ${BABYLON.Engine.Version}, WebGL ${engine.webGLVersion}`];

    /** A colour for each place along an axis of the plane. */
    function ramp(axis, scene) {
        const bytes = new Uint8Array(1024).map((_, at) => (at % 4 === 3 ? 255 : at / 4));
        const size = axis === 0 ? [256, 1] : [1, 256];
        const map = BABYLON.RawTexture.CreateRGBATexture(
            bytes, ...size, scene, false, false, BABYLON.Texture.BILINEAR_SAMPLINGMODE);
        map.anisotropicFilteringLevel = 1;
        return map;
    }

    /** A plane of one tile, seen by parallel rays. */
    function plane() {
        const scene = new BABYLON.Scene(engine);
        const camera = new BABYLON.FreeCamera("camera", BABYLON.Vector3.Zero(), scene);
        camera.minZ = 0.1;
        camera.mode = BABYLON.Camera.ORTHOGRAPHIC_CAMERA;
        [camera.orthoLeft, camera.orthoRight, camera.orthoBottom, camera.orthoTop] = [-0.05, 0.05, -0.05, 0.05];
        return { scene, camera, mesh: BABYLON.MeshBuilder.CreateGround("plane", { width: 1, height: 1 }, scene) };
    }

    /** An unlit material of coordinates along an axis, over a level height map of 0 or without one. */
    function materialOf(kind, axis, deep, scene) {
        const material = new BABYLON[kind]("material", scene);
        if (kind === "StandardMaterial") {
            material.disableLighting = true;
            material.emissiveColor = BABYLON.Color3.White();
            material.diffuseTexture = ramp(axis, scene);
        } else {
            material.unlit = true;
            material.albedoTexture = ramp(axis, scene);
        }
        if (deep) {
            material.bumpTexture = BABYLON.RawTexture.CreateRGBATexture(
                new Uint8Array([128, 128, 255, 0]), 1, 1, scene, false);
            material.useParallax = true;
            material.useParallaxOcclusion = true;
            material.parallaxScaleBias = 0.1;
        }
        return material;
    }

    /** How far the height map moves what the middle of the picture shows, in tiles. */
    async function moved(kind, axis, { scene, mesh }) {
        const places = [];
        for (const deep of [false, true]) {
            mesh.material = materialOf(kind, axis, deep, scene);
            await mesh.material.forceCompilationAsync(mesh);
            await scene.whenReadyAsync();
            scene.render();
            const pixel = new Uint8Array(4);
            engine._gl.readPixels(32, 32, 1, 1, engine._gl.RGBA, engine._gl.UNSIGNED_BYTE, pixel);
            places.push(pixel[0] / 256);
        }
        return places[1] - places[0];
    }

    // u grows along x, v along z. The cross product of the normal and the tangent is -z.
    const TANGENTS = { "": 0, " with tangents": -1, " with tangents of the other sign": 1 };
    for (const [kind, count] of [["StandardMaterial", 2], ["PBRMaterial", 3]]) {
        for (const [name, sign] of Object.entries(TANGENTS).slice(0, count)) {
            const drawn = plane();
            if (sign !== 0) {
                const of = Array.from({ length: drawn.mesh.getTotalVertices() }, () => [1, 0, 0, sign]);
                drawn.mesh.setVerticesData(BABYLON.VertexBuffer.TangentKind, of.flat());
            }
            drawn.camera.position.set(0.6, 0.5, 0.7);
            drawn.camera.setTarget(BABYLON.Vector3.Zero());
            const ways = [await moved(kind, 0, drawn), await moved(kind, 1, drawn)];
            lines.push(`${kind}${name}: ${ways.map((by) => Math.round(50 * by)).join(", ")}`);
            drawn.scene.dispose();
        }
    }
    tell(lines.join("\n"));
</script>
PAGE
cat >serve.mjs <<'SCRIPT'
import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { createServer } from "node:http";

const kinds = { html: "text/html", js: "text/javascript" };
let browser;
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
    reply.setHeader("content-type", kinds[request.url.split(".").pop()] ?? "application/octet-stream");
    reply.end(bytes);
  } catch {
    reply.statusCode = 404;
    reply.end();
  }
});
server.listen(0, "127.0.0.1", () => {
  browser = spawn(process.env.CHROMIUM ?? "chromium", [
    "--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    "--user-data-dir=profile", `http://127.0.0.1:${server.address().port}/page.html`,
  ], { stdio: "ignore" });
  setTimeout(() => {
    browser.kill();
    process.exit(1);
  }, 120000);
});
SCRIPT
seen=$(node serve.mjs)
echo "$seen"
expected="Babylon.js 9.35.0, WebGL 2
StandardMaterial: -4, -5
StandardMaterial with tangents: -4, -5
PBRMaterial: -4, -5
PBRMaterial with tangents: 4, 5
PBRMaterial with tangents of the other sign: 4, -5"
[ "$seen" = "$expected" ] || { echo "this has changed"; exit 1; }
