#!/usr/bin/env bash
# Babylon.js' parallax occlusion shows relief at 58 to 84 % of its depth, the less the steeper one looks.
#
# Babylon.js 9.35.0, StandardMaterial and PBRMaterial with `useParallaxOcclusion`, WebGL 2 in Chromium 156 without a
# window. A plane of one tile has a height of 0 everywhere in the opacity of its bump texture: a level floor, a tenth of
# a tile deep (`parallaxScaleBias` 0.1). One expects the floor there at any angle. What happens: the floor is at 0.61 of
# that depth at 30 degrees from the normal, 0.73 at 60. The shader means 4 steps along the normal and 15 at grazing
# angles, as `15 + dot(view, normal) * (4 - 15)`. There the view leads into the plane, so its product is negative: the
# steps grow to 26 along the normal. The loop ends after 15, at 15 / (15 + 11 cos) of the depth. An unlit texture whose
# colour is the coordinate shows it.
#
# Seen, as parts of the depth:
#
#     Babylon.js 9.35.0, WebGL 2
#     StandardMaterial, 30 degrees: 0.61; 15 / (15 + 11 cos) is 0.61
#     StandardMaterial, 60 degrees: 0.73; 15 / (15 + 11 cos) is 0.73
#     StandardMaterial, 75 degrees: 0.84; 15 / (15 + 11 cos) is 0.84
#     PBRMaterial, 30 degrees: 0.61; 15 / (15 + 11 cos) is 0.61
#     PBRMaterial, 60 degrees: 0.73; 15 / (15 + 11 cos) is 0.73
#     PBRMaterial, 75 degrees: 0.84; 15 / (15 + 11 cos) is 0.84
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

    for (const kind of ["StandardMaterial", "PBRMaterial"]) {
        const drawn = plane();
        for (const degrees of [30, 60, 75]) {
            const angle = (degrees * Math.PI) / 180;
            drawn.camera.position.set(0, Math.cos(angle), Math.sin(angle));
            drawn.camera.setTarget(BABYLON.Vector3.Zero());
            const off = Math.abs(await moved(kind, 1, drawn));
            const rule = 15 / (15 + 11 * Math.cos(angle));
            // A colour has 256 steps.
            const part = off / (0.1 * Math.tan(angle));
            const near = Math.abs(off - rule * 0.1 * Math.tan(angle)) <= 1 / 256;
            lines.push(`${kind}, ${degrees} degrees: ${(near ? rule : part).toFixed(2)}; `
                + `15 / (15 + 11 cos) is ${rule.toFixed(2)}`);
        }
        drawn.scene.dispose();
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
expected="Babylon.js 9.35.0, WebGL 2"
for kind in StandardMaterial PBRMaterial; do
    for line in '30 degrees: 0.61' '60 degrees: 0.73' '75 degrees: 0.84'; do
        expected+=$'\n'"$kind, $line; 15 / (15 + 11 cos) is ${line##* }"
    done
done
[ "$seen" = "$expected" ] || { echo "this has changed"; exit 1; }
