# Reads every shader of a list, and tells the page when all are read. Faults are printed by Godot itself.
extends Node3D


func _ready() -> void:
	for name in FileAccess.get_file_as_string("res://list.txt").split("\n"):
		var shader: Shader = load("res://%s.gdshader" % name)
		if shader.get_shader_uniform_list().is_empty():
			push_error("SHADER ERROR in %s" % name)
	await get_tree().create_timer(1.0).timeout
	JavaScriptBridge.eval("globalThis.tell('')")
