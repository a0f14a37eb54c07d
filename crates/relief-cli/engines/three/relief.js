// Relief on the materials of three.js: what `relief shader --entry functions` writes, as nodes
// of any MeshStandardNodeMaterial. Colour, normal, roughness, depth, silhouette, and shadows
// that are cast and received.
//
// SPDX-License-Identifier: MIT OR Apache-2.0

import { DataTexture, FloatType, FrontSide, RedFormat, Vector2, Vector4 } from 'three/webgpu';
import {
	attribute, cameraFar, cameraNear, cameraProjectionMatrix, cameraViewMatrix, code, cross, dFdx,
	dFdy, Fn, glslFn, inverse, ivec2, lightTargetDirection, materialReference, modelNormalMatrix,
	modelViewMatrix, normalGeometry, normalLocal, normalViewGeometry, positionView, select, sign,
	tangentGeometry, texture, transformNormalToView, uniform, uv, vec2, vec3, vec4,
	viewZToLogarithmicDepth, viewZToOrthographicDepth, viewZToPerspectiveDepth,
	viewZToReversedOrthographicDepth, viewZToReversedPerspectiveDepth, wgslFn,
} from 'three/tsl';

/**
 * Reads the functions of a method, by the address of their description, NAME.json. The texts lie beside it:
 * NAME.wgsl for WebGPU, NAME.glsl (of the profile es300) for WebGL 2.
 */
export async function loadRelief( url ) {

	const address = new URL( url, globalThis.location?.href );
	const read = async ( name ) => {

		const answer = await fetch( new URL( name, address ) );
		if ( ! answer.ok ) throw new Error( `relief: ${ name } cannot be read (${ answer.status })` );
		return answer;

	};

	const about = await ( await read( address.href ) ).json();
	const texts = {};
	for ( const language of [ 'wgsl', 'glsl' ] ) {

		const file = about.files.find( ( name ) => name.endsWith( `.${ language }` ) );
		if ( file !== undefined ) texts[ language ] = await ( await read( file ) ).text();

	}

	return { about, texts };

}

/**
 * Reads a picture as a height map: its red part, from 0 to 1. Browsers read 8 bits of it, which shows as
 * terraces on smooth relief.
 */
export async function loadHeights( url ) {

	const answer = await fetch( url );
	if ( ! answer.ok ) throw new Error( `relief: ${ url } cannot be read (${ answer.status })` );
	const picture = await createImageBitmap( await answer.blob(), { colorSpaceConversion: 'none' } );
	const { width, height } = picture;
	const canvas = new OffscreenCanvas( width, height ).getContext( '2d' );
	canvas.drawImage( picture, 0, 0 );
	const { data } = canvas.getImageData( 0, 0, width, height );
	const heights = new Float32Array( width * height );
	for ( let place = 0; place < heights.length; place ++ ) heights[ place ] = data[ 4 * place ] / 255;
	const texture = new DataTexture( heights, width, height, RedFormat, FloatType );
	texture.needsUpdate = true;
	return texture;

}

/** What GLSL and WGSL call the types of settings, and a setting of that type from a parameter. */
const TYPES = {
	f32: [ 'f32', 'float', ( name ) => name, ( name ) => name ],
	u32: [ 'f32', 'float', ( name ) => `u32(${ name })`, ( name ) => `uint(${ name })` ],
	vec2u: [ 'vec2f', 'vec2', ( name ) => `vec2u(${ name })`, ( name ) => `uvec2(${ name })` ],
	vec2f: [ 'vec2f', 'vec2', ( name ) => name, ( name ) => name ],
	vec4u: [ 'vec4f', 'vec4', ( name ) => `vec4u(${ name })`, ( name ) => `uvec4(${ name })` ],
};

/** The name of a type with the prefix: `rock` and `Hit` give `RockHit`. */
function typeName( prefix, name ) {

	const words = prefix.split( '_' ).map( ( word ) => word[ 0 ].toUpperCase() + word.slice( 1 ) );
	return words.join( '' ) + name;

}

/** Whether there is a function of that name. */
function has( about, name ) {

	const begin = `fn ${ about.prefix }_${ name }(`;
	return about.functions.some( ( { declaration } ) => declaration.startsWith( begin ) );

}

/**
 * The functions that nodes call, in both languages: the hit of a fragment, and the light that arrives
 * there.
 */
function sources( about ) {

	const p = about.prefix;
	const [ Settings, Point, Hit ] = [ 'Settings', 'Point', 'Hit' ].map( ( name ) => typeName( p, name ) );
	const given = { uv: '', view: '', tile: '', curvature: '', footprint: '' };
	for ( const { name } of about.point ) {

		if ( ! ( name in given ) ) throw new Error( `relief: nothing is known of ${ name }` );

	}

	const isIn = ( name ) => about.point.some( ( member ) => member.name === name );
	const parameters = ( place, declared ) =>
		about.settings.map( ( { name, type } ) => declared( name, TYPES[ type ][ place ] ) );
	const settings = ( place ) => parameters( place, ( name, of ) => of( name ) ).join( ', ' );
	const wgslTexture = ( { name, type } ) => `of_${ name }: ${ type }`;
	const passed = [
		...parameters( 0, ( name, type ) => `${ name }: ${ type }` ),
		...about.bindings.map( wgslTexture ),
	].join( ', ' );
	const passedGlsl = [
		...parameters( 1, ( name, type ) => `${ type } ${ name }` ),
		// A texel stands for a texture: three.js gives samplers names there that it does not declare.
		...about.bindings.map( ( { name } ) => `float of_${ name }` ),
	].join( ', ' );
	const members = [ 'uv', 'way', 'tile', 'curvature', 'footprint' ].filter(
		( member ) => member === 'way' || isIn( member ) ).join( ', ' );

	const wgslPoint = `
	let settings = ${ Settings }(${ settings( 2 ) });
	let at = ${ Point }(${ members });`;
	const glslPoint = `
	${ Settings } settings = ${ Settings }(${ settings( 3 ) });
	${ Point } at = ${ Point }(${ members });`;
	const wgslOfPoint = 'uv: vec2f, way: vec3f, tile: vec2f, curvature: vec3f, footprint: f32';
	const glslOfPoint = 'vec2 uv, vec3 way, vec2 tile, vec3 curvature, float footprint';
	const wgslOfLight = `${ wgslOfPoint }, place: vec3f, toward: vec3f`;
	const glslOfLight = `${ glslOfPoint }, vec3 place, vec3 toward`;
	return {
		wgsl: {
			tile: `fn ${ p }_tile_of_fragment(position: vec3f, uv: vec2f) -> vec2f {
	return ${ p }_tile(position, uv);
}`,
			curvature: `fn ${ p }_curvature_of_fragment(position: vec3f, n: vec3f, uv: vec2f) -> vec3f {
	return ${ p }_curvature(position, n, uv);
}`,
			hit: `fn ${ p }_of_fragment(${ wgslOfPoint }, ${ passed }) -> mat3x3<f32> {${ wgslPoint }
	let hit = ${ p }_hit(settings, at);
	return mat3x3<f32>(vec3f(select(0.0, 1.0, hit.hit), hit.uv), hit.normal, vec3f(hit.depth, hit.height, 0.0));
}`,
			light: `fn ${ p }_light_of_fragment(${ wgslOfLight }, ${ passed }) -> f32 {${ wgslPoint }
	let hit = ${ Hit }(true, place.xy, place.z, 0.0, vec3f(0.0, 0.0, 1.0));
	return ${ p }_light(settings, at, hit, toward);
}`,
		},
		glsl: {
			tile: `vec2 ${ p }_tile_of_fragment(vec3 position, vec2 uv) { return ${ p }_tile(position, uv); }`,
			curvature: `vec3 ${ p }_curvature_of_fragment(vec3 position, vec3 n, vec2 uv) {
	return ${ p }_curvature(position, n, uv);
}`,
			hit: `mat3 ${ p }_of_fragment(${ glslOfPoint }, ${ passedGlsl }) {${ glslPoint }
	${ Hit } hit = ${ p }_hit(settings, at);
	return mat3(vec3(hit.hit ? 1.0 : 0.0, hit.uv), hit.normal, vec3(hit.depth, hit.height, 0.0));
}`,
			light: `float ${ p }_light_of_fragment(${ glslOfLight }, ${ passedGlsl }) {${ glslPoint }
	${ Hit } hit = ${ Hit }(true, place.xy, place.z, 0.0, vec3(0.0, 0.0, 1.0));
	return ${ p }_light(settings, at, hit, toward);
}`,
		},
	};

}

/**
 * Whether the mesh that is drawn has frames of its own: unit tangents, the lengths of a tile
 * and the curvature at each vertex, as `relief engine` writes them. three.js does not turn them
 * with instances and bones.
 */
function hasFrames( { geometry, object } ) {

	const isPlain = object.isInstancedMesh !== true && object.isBatchedMesh !== true
		&& object.isSkinnedMesh !== true;
	return isPlain && [ 'tangent', '_tile', '_curvature' ].every( ( name ) => geometry.hasAttribute( name ) );

}

/** A tile along u (0) or along v (1) in view space, up to its sign along v. From the mesh's own frames. */
function ownTile( axis ) {

	const along = axis === 0 ? tangentGeometry.xyz : cross( normalGeometry, tangentGeometry.xyz );
	const tile = along.mul( attribute( '_tile', 'vec2' ).element( axis ) );
	return modelViewMatrix.mul( vec4( tile, 0 ) ).xyz.toVarying();

}

/** The curvature of the mesh. From its own frames; a mesh that is stretched along its normal is bent more. */
function ownCurvature() {

	return attribute( '_curvature', 'vec3' ).div( modelNormalMatrix.mul( normalGeometry ).length() ).toVarying();

}

/** Least squared sine of the angle between +u and +v. */
const LEAST_TURN = 1e-6;

/**
 * The frame of a fragment in view space: what measures a direction along +u and along +v, and the normal. A
 * mesh that is scaled unevenly has no right angle between +u and +v: one measures across the other. From the
 * mesh's own frames, else from derivatives.
 */
function frameOf( position, coordinates, normal ) {

	const [ dx, dy ] = [ dFdx( position ), dFdy( position ) ];
	const [ atX, atY ] = [ dFdx( coordinates ), dFdy( coordinates ) ];
	const turn = sign( atX.x.mul( atY.y ).sub( atX.y.mul( atY.x ) ) );
	const n = normal.normalize().toVar();
	const upright = ( way ) => way.sub( n.mul( n.dot( way ) ) ).normalize();
	const seen = ( changeX, changeY ) => dx.mul( changeY ).sub( dy.mul( changeX ) ).mul( turn );
	const alongV = seen( atX.x, atY.x ).negate();
	const u = Fn( ( builder ) => {

		return hasFrames( builder ) ? ownTile( 0 ).normalize() : upright( seen( atX.y, atY.y ) );

	}, 'vec3' )();
	const v = Fn( ( builder ) => {

		if ( ! hasFrames( builder ) ) return upright( alongV );
		const own = ownTile( 1 );
		return own.normalize().mul( sign( own.dot( alongV ) ) );

	}, 'vec3' )();
	const [ t, b ] = [ u.toVar(), v.toVar() ];
	const cosine = t.dot( b ).toVar();
	const squaredSine = cosine.mul( cosine ).oneMinus().max( LEAST_TURN );
	const across = ( way, other ) => way.sub( other.mul( cosine ) ).div( squaredSine );
	return [ across( t, b ).toVar(), across( b, t ).toVar(), n ];

}

/** What the depth buffer of a renderer holds with parallel rays, and in perspective. */
function depths( { reversedDepthBuffer, logarithmicDepthBuffer } ) {

	if ( reversedDepthBuffer === true ) {

		return [ viewZToReversedOrthographicDepth, viewZToReversedPerspectiveDepth ];

	}

	const isLogarithmic = logarithmicDepthBuffer === true;
	return [ viewZToOrthographicDepth, isLogarithmic ? viewZToLogarithmicDepth : viewZToPerspectiveDepth ];

}

/** Puts a relief on a material. The options and the nodes that come back are described in relief.d.ts. */
export function applyRelief( material, { about, texts }, options ) {

	const { renderer, maps, sun = null, scale = 0.05 } = options;
	const language = renderer.backend.isWebGPUBackend === true ? 'wgsl' : 'glsl';
	const text = texts[ language ];
	if ( text === undefined ) {

		const target = language === 'wgsl' ? '--target wgsl' : '--target glsl --profile es300';
		throw new Error(
			`relief: this renderer needs functions in ${ language.toUpperCase() }: write them with ${ target }, too`
		);

	}

	const ownName = ( name ) => name.slice( about.prefix.length + 1 );
	const missing = about.bindings.find( ( { name } ) => maps[ ownName( name ) ] === undefined );
	if ( missing !== undefined ) {

		const how = missing.texture?.bake?.how;
		const by = how ? `, by ${ how } --format ktx2` : '';
		throw new Error( `relief: maps.${ ownName( missing.name ) } is missing: ${ missing.holds }${ by }` );

	}

	const { width, height } = ( maps.height_map ?? Object.values( maps )[ 0 ] ).image;
	const values = {
		scale, bias: - scale, height_size: new Vector2( width, height ), height_levels: 1,
		light_radius: 0, wrap: 0, ...options.settings
	};
	const settings = {};
	for ( const { name, type, value } of about.settings ) {

		const start = values[ name ] ?? value;
		if ( start === undefined ) throw new Error( `relief: settings.${ name } is missing` );
		settings[ name ] = uniform( type === 'vec4u' ? new Vector4( ...start ) : start );

	}

	const bound = {};
	for ( const { name } of about.bindings ) {

		const map = texture( maps[ ownName( name ) ] );
		bound[ `of_${ name }` ] = language === 'wgsl'
			? map.setName( name )
			: map.load( ivec2( 0, 0 ) ).setName( name ).x;

	}

	// three.js declares the textures itself.
	const isOwn = ( line ) => line.startsWith( '@group' ) || /^(layout\(.*\) )?uniform .*sampler2D/.test( line );
	const kept = text.split( '\n' ).filter( ( line ) => ! isOwn( line ) );
	const functions = code( kept.join( '\n' ), [], language );
	const native = language === 'wgsl' ? wgslFn : glslFn;
	const source = sources( about )[ language ];

	// Tiles of the relief over the mesh's own.
	const repeat = uniform( new Vector2( ...( options.repeat ?? [ 1, 1 ] ) ) );
	const ownUV = uv().mul( repeat );
	// With parallel rays all look along the view axis: in the picture of a camera, or of a sun's shadow.
	const isParallel = cameraProjectionMatrix.element( 3 ).element( 3 ).equal( 1 );
	const view = select( isParallel, vec3( 0, 0, - 1 ), positionView.normalize() );
	const [ t, b, n ] = frameOf( positionView, ownUV, normalViewGeometry );
	const ofFrame = ( way ) => vec3( way.dot( t ), way.dot( b ), way.dot( n ) );
	const texels = ownUV.mul( settings.height_size ?? uniform( new Vector2( width, height ) ) );
	const point = {
		uv: ownUV,
		way: ofFrame( view ),
		tile: Fn( ( builder ) => {

			if ( ! hasFrames( builder ) ) {

				return native( source.tile, [ functions ] )( { position: positionView, uv: ownUV } );

			}

			return vec2( ownTile( 0 ).length(), ownTile( 1 ).length() ).div( repeat );

		}, 'vec2' )().toVar(),
		curvature: Fn( ( builder ) => {

			if ( ! about.point.some( ( { name } ) => name === 'curvature' ) ) return vec3( 0 );
			if ( ! hasFrames( builder ) ) {

				// Triangles with a normal of their own are flat.
				if ( builder.isFlatShading() ) return vec3( 0 );
				// As it is between vertices, not brought to the length 1.
				const between = transformNormalToView( normalLocal ).toVarying();
				return native( source.curvature, [ functions ] )( { position: positionView, n: between, uv: ownUV } );

			}
			const { x, y } = repeat;
			return ownCurvature().div( vec3( x.mul( x ), x.mul( y ), y.mul( y ) ) );

		}, 'vec3' )().toVar(),
		footprint: dFdx( texels ).length().min( dFdy( texels ).length() ),
	};
	const seen = native( source.hit, [ functions ] )( { ...point, ...settings, ...bound } ).toVar();
	const hitUV = seen.element( 0 ).yz;
	const place = positionView.add( view.mul( seen.element( 2 ).x ) );

	const sampled = ( map ) => {

		if ( map.flipY === true ) {

			console.warn( 'relief: a colour map has flipY: its colours lie on other stones. Set flipY = false.' );

		}

		return texture( map, hitUV ).grad( dFdx( ownUV ), dFdy( ownUV ) );

	};
	const factor = ( name, kind ) => materialReference( name, kind, material );
	if ( options.map ) material.colorNode = factor( 'color', 'color' ).mul( sampled( options.map ) );
	if ( options.roughnessMap ) {

		material.roughnessNode = factor( 'roughness', 'float' ).mul( sampled( options.roughnessMap ).g );

	}

	if ( options.metalnessMap ) {

		material.metalnessNode = factor( 'metalness', 'float' ).mul( sampled( options.metalnessMap ).b );

	}

	if ( options.aoMap ) material.aoNode = sampled( options.aoMap ).r;
	if ( options.emissiveMap ) {

		material.emissiveNode = factor( 'emissive', 'color' ).mul( sampled( options.emissiveMap ).rgb );

	}

	const bent = seen.element( 1 );
	material.normalNode = t.mul( bent.x ).add( b.mul( bent.y ) ).add( n.mul( bent.z ) ).normalize();
	material.maskNode = seen.element( 0 ).x.greaterThan( 0.5 );
	const [ ofParallel, ofPerspective ] = depths( renderer );
	material.depthNode = select(
		isParallel,
		ofParallel( place.z, cameraNear, cameraFar ),
		ofPerspective( place.z, cameraNear, cameraFar ),
	);
	material.receivedShadowPositionNode = inverse( cameraViewMatrix ).mul( vec4( place, 1 ) ).xyz;
	// From behind, a point of the mesh has no relief.
	material.shadowSide = FrontSide;
	if ( sun !== null && has( about, 'light' ) ) {

		if ( sun.castShadow !== true ) {

			const why = 'the sun casts no shadows, so the relief has none of its own';
			console.warn( `relief: ${ why }. Set sun.castShadow = true.` );

		}

		const at = vec3( hitUV, seen.element( 2 ).y );
		const arrives = native( source.light, [ functions ] )( {
			...point, place: at, toward: ofFrame( lightTargetDirection( sun ) ), ...settings, ...bound,
		} );
		material.receivedShadowNode = Fn( ( [ shadow ] ) => shadow.mul( arrives ) );

	}

	material.needsUpdate = true;
	return {
		settings, repeat, uv: hitUV, sampled, isHit: material.maskNode,
		height: seen.element( 2 ).y, depth: seen.element( 2 ).x
	};

}
