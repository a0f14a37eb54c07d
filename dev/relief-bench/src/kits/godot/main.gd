# Draws a mesh with the kit of Godot, and tells the page five pictures: where there are hits, u, and v.
extends Node3D


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
	drawn.mesh = mesh(input.mesh)
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


func mesh(from: Dictionary) -> ArrayMesh:
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = points(from.positions)
	arrays[Mesh.ARRAY_NORMAL] = points(from.normals)
	var uvs := PackedVector2Array()
	for at in range(0, from.uvs.size(), 2):
		uvs.append(Vector2(from.uvs[at], from.uvs[at + 1]))
	arrays[Mesh.ARRAY_TEX_UV] = uvs
	# Godot's front faces run clockwise.
	var corners := PackedInt32Array(from.triangles)
	corners.reverse()
	arrays[Mesh.ARRAY_INDEX] = corners
	var flags := 0
	if from.frames != null:
		arrays[Mesh.ARRAY_TANGENT] = PackedFloat32Array(from.frames.tangents)
		var first := PackedFloat32Array()
		var second := PackedFloat32Array()
		for at in range(0, from.frames.tiles.size(), 2):
			var curvature: Array = from.frames.curvatures.slice(3 * at / 2, 3 * at / 2 + 3)
			first.append_array(from.frames.tiles.slice(at, at + 2) + curvature.slice(0, 2))
			second.append_array([curvature[2], 0.0])
		arrays[Mesh.ARRAY_CUSTOM0] = first
		arrays[Mesh.ARRAY_CUSTOM1] = second
		flags = (Mesh.ARRAY_CUSTOM_RGBA_FLOAT << Mesh.ARRAY_FORMAT_CUSTOM0_SHIFT) \
				| (Mesh.ARRAY_CUSTOM_RG_FLOAT << Mesh.ARRAY_FORMAT_CUSTOM1_SHIFT)
	var made := ArrayMesh.new()
	made.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays, [], {}, flags)
	return made


func points(from: Array) -> PackedVector3Array:
	var made := PackedVector3Array()
	for at in range(0, from.size(), 3):
		made.append(Vector3(from[at], from[at + 1], from[at + 2]))
	return made
