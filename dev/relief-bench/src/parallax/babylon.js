// Draws a plane with the parallax of Babylon.js and with the kit of three.js, both on WebGL 2. Answers
// with the colours of two pictures for each place and way, u and v, and the milliseconds of frames that
// were drawn in turn. Colours are coordinates: red rises over the tile, green and blue rise and fall 16
// times, blue half a rise ahead.
import * as THREE from "three/webgpu";
import { texture } from "three/tsl";
import { applyRelief } from "./relief.js";

export { REVISION } from "three/webgpu";

const TIMED = 15;
const COLORS = 4096;

export default async function answer(input) {
    await load("./node_modules/babylonjs/babylon.js");
    const { Version } = BABYLON.Engine;
    if (Version !== input.babylon) throw new Error(`this is Babylon.js ${Version}`);
    const engines = { babylon: babylon(input), three: await three(input) };
    const ways = [];
    for (const way of input.ways) ways.push(await engines[way.engine].way(way));
    const [pictures, times] = [[], []];
    for (const eye of input.eyes) {
        for (const engine of Object.values(engines)) engine.look(eye);
        for (const draw of ways) for (const axis of [0, 1]) pictures.push(upright(draw(axis).read(), input));
        // Times are taken in turn.
        const taken = ways.map(() => []);
        for (let round = 0; round < TIMED; round++) {
            for (const [at, draw] of ways.entries()) {
                const begin = performance.now();
                draw(0).read();
                taken[at].push(performance.now() - begin);
            }
        }
        times.push(taken);
    }
    return new Blob([...pictures, JSON.stringify(times)]);
}

function load(address) {
    const script = Object.assign(document.createElement("script"), { src: address });
    return new Promise((done, failed) => {
        const onerror = () => failed(new Error(`${address} cannot be read`));
        Object.assign(script, { onload: done, onerror });
        document.head.append(script);
    });
}

/** Red, green and blue of a picture, from the upper row down. */
function upright(pixels, { width, height }) {
    const turned = new Uint8Array(3 * width * height);
    for (let row = 0; row < height; row++) {
        for (let column = 0; column < width; column++) {
            const from = 4 * ((height - 1 - row) * width + column);
            turned.set(pixels.subarray(from, from + 3), 3 * (row * width + column));
        }
    }
    return turned;
}

/** A canvas, and how the pixels of its frame are read. */
function canvasOf({ width, height }) {
    const canvas = Object.assign(document.createElement("canvas"), { width, height });
    const pixels = new Uint8Array(4 * width * height);
    const read = () => {
        const gl = canvas.getContext("webgl2");
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        return pixels;
    };
    return { canvas, drawn: { read } };
}

/** A colour for each coordinate along an axis, and the size of its texture. */
function coordinates(axis) {
    const bytes = new Uint8Array(4 * COLORS);
    for (let at = 0; at < COLORS; at++) {
        const along = (at + 0.5) / COLORS;
        const fine = (ahead) => 1 - Math.abs(((32 * along + ahead) % 2) - 1);
        bytes.set([along, fine(0), fine(0.5)].map((part) => Math.round(70 + 180 * part)), 4 * at);
        bytes[4 * at + 3] = 255;
    }
    return { bytes, size: axis === 0 ? [COLORS, 1] : [1, COLORS] };
}

function babylon(input) {
    const { canvas, drawn } = canvasOf(input);
    const engine = new BABYLON.Engine(canvas, false, { preserveDrawingBuffer: true });
    if (engine.webGLVersion !== 2) throw new Error("Babylon.js has no WebGL 2");
    const scene = new BABYLON.Scene(engine);
    scene.clearColor = new BABYLON.Color4(0, 0, 0, 1);
    const camera = new BABYLON.FreeCamera("camera", BABYLON.Vector3.Zero(), scene);
    camera.fov = (input.fov * Math.PI) / 180;
    [camera.minZ, camera.maxZ] = [0.01, 100];
    const plane = planeOf(input.mesh, scene);
    const textureOf = (bytes, [width, height], anisotropy = 1) => {
        const filter = BABYLON.Texture.BILINEAR_SAMPLINGMODE;
        const map = BABYLON.RawTexture.CreateRGBATexture(bytes, width, height, scene, false, false, filter);
        map.wrapU = map.wrapV = BABYLON.Texture.WRAP_ADDRESSMODE;
        // More than 1 mixes what a pixel covers.
        map.anisotropicFilteringLevel = anisotropy;
        return map;
    };
    const shown = [0, 1].map((axis) => {
        const { bytes, size } = coordinates(axis);
        return textureOf(bytes, size);
    });
    // A level normal, and the height in the opacity.
    const { width, height, texels } = input.heights8;
    const bump = new Uint8Array(texels.flatMap((at) => [128, 128, 255, at]));
    return {
        look([x, y, z]) {
            camera.position.set(x, y, -z);
            camera.setTarget(BABYLON.Vector3.Zero());
        },
        async way({ occlusion, layers, anisotropy }) {
            const material = new BABYLON.StandardMaterial("", scene);
            material.disableLighting = true;
            material.emissiveColor = BABYLON.Color3.White();
            material.diffuseTexture = shown[0];
            if (occlusion === true) {
                material.bumpTexture = textureOf(bump, [width, height], anisotropy);
                material.useParallax = true;
                material.useParallaxOcclusion = true;
                material.parallaxScaleBias = input.scale;
            }
            if (layers !== undefined) material.customShaderNameResolve = () => withLayers(layers);
            await material.forceCompilationAsync(plane);
            return (axis) => {
                material.diffuseTexture = shown[axis];
                plane.material = material;
                scene.render();
                return drawn;
            };
        },
    };
}

/** The mesh, in the left-handed system that scenes have by default. */
function planeOf({ positions, normals, uvs, triangles }, scene) {
    const turned = (ways) => ways.map((part, at) => (at % 3 === 2 ? -part : part));
    const plane = new BABYLON.Mesh("plane", scene);
    const data = new BABYLON.VertexData();
    Object.assign(data, { positions: turned(positions), normals: turned(normals), uvs, indices: triangles });
    data.applyToMesh(plane);
    return plane;
}

/** Babylon's shader with another number of layers, which it has as constants. Returns its name. */
function withLayers(layers) {
    const name = `layers${layers}`;
    const { ShadersStore, IncludesShadersStore } = BABYLON.Effect;
    if (ShadersStore[`${name}PixelShader`] === undefined) {
        const constants = (least, most) =>
            `const float minSamples=${least}.;const float maxSamples=${most}.;const int iMaxSamples=${most};`;
        const functions = IncludesShadersStore.bumpFragmentFunctions;
        IncludesShadersStore[name] = replaced(functions, constants(4, 15), constants(layers, layers));
        const [own, given] = ["bumpFragmentFunctions", name].map((text) => `#include<${text}>`);
        ShadersStore[`${name}PixelShader`] = replaced(ShadersStore.defaultPixelShader, own, given);
        ShadersStore[`${name}VertexShader`] = ShadersStore.defaultVertexShader;
    }
    return name;
}

function replaced(text, from, to) {
    if (!text.includes(from)) throw new Error(`the shader of Babylon.js is without ${from}`);
    return text.replace(from, to);
}

async function three(input) {
    const { canvas, drawn } = canvasOf(input);
    const renderer = new THREE.WebGPURenderer({ canvas, antialias: false, forceWebGL: true });
    renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    renderer.setSize(input.width, input.height, false);
    await renderer.init();
    if (renderer.backend.isWebGPUBackend === true) throw new Error("three.js has no WebGL 2");
    const camera = new THREE.PerspectiveCamera(input.fov, input.width / input.height, 0.01, 100);
    const mesh = new THREE.Mesh(geometryOf(input.mesh));
    const scene = new THREE.Scene();
    scene.add(mesh);
    renderer.setClearColor(0, 1);
    const shown = [0, 1].map((axis) => {
        const { bytes, size } = coordinates(axis);
        const map = new THREE.DataTexture(bytes, ...size, THREE.RGBAFormat, THREE.UnsignedByteType);
        [map.minFilter, map.magFilter] = [THREE.LinearFilter, THREE.LinearFilter];
        [map.wrapS, map.wrapT] = [THREE.RepeatWrapping, THREE.RepeatWrapping];
        map.needsUpdate = true;
        return map;
    });
    const heights = floats(input.heights, THREE.RedFormat);
    return {
        look(eye) {
            camera.position.fromArray(eye);
            camera.lookAt(0, 0, 0);
        },
        async way({ functions, map }) {
            const material = new THREE.MeshBasicNodeMaterial();
            let at;
            if (functions !== undefined) {
                const maps = { height_map: heights };
                if (map !== undefined) maps.search_map = floats(map, THREE.RGBAFormat);
                at = applyRelief(material, functions, { renderer, maps, scale: input.scale }).uv;
            }
            const color = texture(shown[0], at).level(0);
            material.colorNode = color;
            return (axis) => {
                color.value = shown[axis];
                mesh.material = material;
                renderer.render(scene, camera);
                return drawn;
            };
        },
    };
}

function geometryOf({ positions, normals, uvs, triangles }) {
    const geometry = new THREE.BufferGeometry();
    const set = (name, numbers, size) =>
        geometry.setAttribute(name, new THREE.BufferAttribute(new Float32Array(numbers), size));
    set("position", positions, 3);
    set("normal", normals, 3);
    set("uv", uvs, 2);
    geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(triangles), 1));
    return geometry;
}

function floats({ width, height, texels }, format) {
    const map = new THREE.DataTexture(new Float32Array(texels), width, height, format, THREE.FloatType);
    map.needsUpdate = true;
    return map;
}
