import type { DataTexture, DirectionalLight, Node, NodeMaterial, Renderer, Texture, UniformNode } from 'three/webgpu';

/** The functions of a method. */
export interface Functions {
	/** What the description, NAME.json, says. */
	about: unknown;
	/** The functions in WGSL and in GLSL, as far as they were written. */
	texts: { wgsl?: string; glsl?: string };
}

export interface Options {
	/** The renderer, after `init()`: WebGPU takes WGSL, WebGL 2 takes GLSL. */
	renderer: Renderer;
	/**
	 * The textures that the functions read, by the names in the description without the prefix, as
	 * `height_map` and `search_map`. Floats: `RedFormat` and `FloatType` for heights from 0 to 1.
	 */
	maps: Record<string, Texture>;
	/** The length from the height 0 to the height 1, in the units of the scene. 0.05 unless given. */
	scale?: number;
	/** Tiles of the relief along u and v for each of the mesh's own. 1 by 1 unless given. */
	repeat?: [ number, number ];
	/** The colours, with the texture coordinates of the relief. */
	map?: Texture | null;
	/** The roughness, in green, as in glTF. */
	roughnessMap?: Texture | null;
	/** The metalness, in blue. */
	metalnessMap?: Texture | null;
	/** Ambient occlusion, in red. */
	aoMap?: Texture | null;
	/** The colour of the light that the surface emits. */
	emissiveMap?: Texture | null;
	/**
	 * The sun that the relief shades itself from, if the functions have a shadow. It must cast shadows, and be
	 * the only light that does: three.js has one such node for all of them.
	 */
	sun?: DirectionalLight | null;
	/** Other settings, as `bias`, or a parameter of the method. */
	settings?: Record<string, number | number[]>;
}

/** Nodes of a material with relief. */
export interface Made {
	/** The settings, whose `value` may be changed at any time. */
	settings: Record<string, UniformNode<unknown>>;
	/** Tiles of the relief for each of the mesh's own, whose `value` may be changed. */
	repeat: UniformNode<unknown>;
	/** Texture coordinates of the hit. */
	uv: Node;
	/** A texture at the hit, filtered as on the mesh: for maps that the options do not name. */
	sampled( map: Texture ): Node;
	/** Whether there is a hit. */
	isHit: Node;
	/** The hit's height, from 0 to 1. */
	height: Node;
	/** The way from the mesh to the hit along the ray. */
	depth: Node;
}

/**
 * Reads the functions of a method, by the address of their description, NAME.json. The texts lie beside it.
 * Throws where a file cannot be read.
 */
export function loadRelief( url: string | URL ): Promise<Functions>;

/** Reads a picture as a height map: 8 bits of its red part, as browsers do, from 0 to 1. */
export function loadHeights( url: string | URL ): Promise<DataTexture>;

/**
 * Puts a relief on a material: its colour, normal, roughness, depth, mask and shadows become the relief's.
 * The mesh needs normals and texture coordinates. Throws where a map or a setting is missing, or where the
 * functions were not written in the renderer's language.
 */
export function applyRelief( material: NodeMaterial, functions: Functions, options: Options ): Made;
