# Shows the scene of `relief engine godot`, and tells the page its pixels.
extends Node3D


func _ready() -> void:
	get_window().size = Vector2i(400, 300)
	add_child(load("res://stones/cobbles_demo.tscn").instantiate())
	for frame in 3:
		await RenderingServer.frame_post_draw
	var picture := get_viewport().get_texture().get_image()
	picture.convert(Image.FORMAT_RGBA8)
	JavaScriptBridge.eval("globalThis.tell('%s')" % Marshalls.raw_to_base64(picture.get_data()))
