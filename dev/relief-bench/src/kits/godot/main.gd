# Draws a mesh with the kit of Godot, and tells the page five pictures: where there are hits, u, and v.
extends Node3D

const Made := preload("res://made.gd")


func _ready() -> void:
	var input: Dictionary = JSON.parse_string(FileAccess.get_file_as_string("res://input.json"))
	var viewport := SubViewport.new()
	viewport.size = Vector2i(int(input.width), int(input.height))
	viewport.own_world_3d = true
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	add_child(viewport)
	RenderingServer.set_default_clear_color(Color.BLACK)

	var camera := Camera3D.new()
	camera.fov = input.fov
	camera.near = 0.01
	camera.far = 100.0
	viewport.add_child(camera)
	camera.look_at_from_position(Vector3(input.eye[0], input.eye[1], input.eye[2]), Vector3.ZERO)

	var material := ShaderMaterial.new()
	material.shader = load("res://shown.gdshader")
	material.set_shader_parameter("relief_scale", input.scale)
	material.set_shader_parameter("beyond", input.beyond)
	material.set_shader_parameter("relief_height_map", heights(input.heights))
	var drawn := MeshInstance3D.new()
	drawn.mesh = Made.mesh(input.mesh)
	drawn.material_override = material
	viewport.add_child(drawn)

	var bytes := PackedByteArray()
	for part in 5:
		material.set_shader_parameter("part", part)
		for frame in 2:
			await RenderingServer.frame_post_draw
		var picture := viewport.get_texture().get_image()
		picture.convert(Image.FORMAT_RGB8)
		bytes.append_array(picture.get_data())
	JavaScriptBridge.eval("globalThis.tell('%s')" % Marshalls.raw_to_base64(bytes))


func heights(from: Dictionary) -> ImageTexture:
	var texels := PackedFloat32Array(from.texels).to_byte_array()
	var image := Image.create_from_data(int(from.width), int(from.height), false, Image.FORMAT_RF, texels)
	return ImageTexture.create_from_image(image)
