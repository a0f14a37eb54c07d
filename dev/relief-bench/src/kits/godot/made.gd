# Meshes of Godot, made of lists.
extends RefCounted


static func mesh(from: Dictionary) -> ArrayMesh:
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


static func points(from: Array) -> PackedVector3Array:
	var made := PackedVector3Array()
	for at in range(0, from.size(), 3):
		made.append(Vector3(from[at], from[at + 1], from[at + 2]))
	return made
