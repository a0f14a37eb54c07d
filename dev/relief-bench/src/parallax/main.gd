# Draws a plane with Godot's own deep parallax and with our kit, and tells the page its colours and times.
# Colours are coordinates: red rises over the tile, green and blue rise and fall 16 times,
# blue half a rise ahead. So filters may mix texels.
extends Node3D

const Made := preload("res://made.gd")
const TIMED := 7

var input: Dictionary
var viewport: SubViewport
var drawn: MeshInstance3D
var seconds_of_frame: float


func _ready() -> void:
	input = JSON.parse_string(FileAccess.get_file_as_string("res://input.json"))
	viewport = SubViewport.new()
	viewport.size = Vector2i(int(input.width), int(input.height))
	viewport.own_world_3d = true
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	add_child(viewport)
	RenderingServer.set_default_clear_color(Color.BLACK)
	var camera := Camera3D.new()
	camera.fov = input.fov
	camera.near = 0.01
	viewport.add_child(camera)
	drawn = MeshInstance3D.new()
	drawn.mesh = Made.mesh(input.mesh)
	viewport.add_child(drawn)

	await RenderingServer.frame_post_draw
	var heights := texture(input.heights, Image.FORMAT_RF)
	var materials := []
	for way in input.ways:
		materials.append(ours(way, heights) if way.has("shader") else theirs(way))
	var bytes := PackedByteArray()
	var seconds := []
	for eye in input.eyes:
		camera.look_at_from_position(Vector3(eye[0], eye[1], eye[2]), Vector3.ZERO)
		for at in materials.size():
			for axis in 2:
				materials[at].call(axis)
				bytes.append_array(await picture())
		# Times are taken in turn.
		var times := []
		for at in materials.size():
			times.append([])
		for round in TIMED:
			for at in materials.size():
				materials[at].call(0)
				await picture()
				times[at].append(seconds_of_frame)
		for of_one in times:
			of_one.sort()
			seconds.append(of_one[TIMED / 2])
	bytes.append_array(JSON.stringify(seconds).to_utf8_buffer())
	JavaScriptBridge.eval("globalThis.tell('%s')" % Marshalls.raw_to_base64(bytes))


# Waits for a frame until its pixels are there, and takes its time.
func picture() -> PackedByteArray:
	await RenderingServer.frame_pre_draw
	var begin := Time.get_ticks_usec()
	await RenderingServer.frame_post_draw
	var image := viewport.get_texture().get_image()
	seconds_of_frame = (Time.get_ticks_usec() - begin) / 1e6
	image.convert(Image.FORMAT_RGB8)
	return image.get_data()


# A material of Godot's own. Returns a function that shows u or v.
func theirs(way: Dictionary) -> Callable:
	var material := StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.texture_filter = BaseMaterial3D.TEXTURE_FILTER_LINEAR
	if way.layers > 0:
		material.heightmap_enabled = true
		material.heightmap_deep_parallax = true
		material.heightmap_min_layers = int(way.layers)
		material.heightmap_max_layers = int(way.layers)
		material.heightmap_scale = input.scale * 100.0
		material.heightmap_texture = texture(input.heights8, Image.FORMAT_R8)
	var shown := [coordinates(0), coordinates(1)]
	return func(axis: int) -> void:
		material.albedo_texture = shown[axis]
		drawn.material_override = material


# A material with our functions.
func ours(way: Dictionary, heights: Texture2D) -> Callable:
	var material := ShaderMaterial.new()
	material.shader = load("res://" + way.shader)
	material.set_shader_parameter("relief_scale", input.scale)
	material.set_shader_parameter("relief_height_map", heights)
	if way.has("map"):
		material.set_shader_parameter("relief_search_map", texture(way.map, Image.FORMAT_RGBAF))
	var shown := [coordinates(0), coordinates(1)]
	return func(axis: int) -> void:
		material.set_shader_parameter("shown", shown[axis])
		drawn.material_override = material


func coordinates(axis: int) -> ImageTexture:
	var count := 4096
	var bytes := PackedByteArray()
	for at in count:
		var along := (at + 0.5) / count
		var fine := [0.0, 0.5].map(func(ahead: float) -> float:
			return 1.0 - absf(fposmod(32.0 * along + ahead, 2.0) - 1.0))
		for part in [along] + fine:
			bytes.append(roundi(70.0 + 180.0 * part))
	var image := Image.create_from_data(count if axis == 0 else 1, 1 if axis == 0 else count, false, Image.FORMAT_RGB8, bytes)
	return ImageTexture.create_from_image(image)


func texture(from: Dictionary, format: Image.Format) -> ImageTexture:
	var bytes := PackedByteArray(from.texels) if format == Image.FORMAT_R8 \
			else PackedFloat32Array(from.texels).to_byte_array()
	var image := Image.create_from_data(int(from.width), int(from.height), false, format, bytes)
	return ImageTexture.create_from_image(image)
