// Draws a mesh with the kit of three.js, and gives each pixel's hit: u, v, the depth along the ray, and 1.
// Other meshes are 0, 0, 0, 1. Of a floor it gives the light that arrives, from 0 to 1.
import * as THREE from "three/webgpu";
import { vec4 } from "three/tsl";
import { applyRelief } from "./relief.js";

export { REVISION } from "three/webgpu";

export default async function answer(input) {
    const { backend, width, height } = input;
    const said = [];
    for (const kind of ["warn", "error"]) console[kind] = (...words) => said.push(words.join(" "));
    const renderer = new THREE.WebGPURenderer({
        antialias: false, forceWebGL: backend === "webgl", ...(input.depth && { [input.depth]: true }),
    });
    await renderer.init();
    const found = renderer.backend.isWebGPUBackend === true ? "webgpu" : "webgl";
    if (found !== backend) throw new Error(`no ${backend}`);

    const scene = new THREE.Scene();
    scene.add(...meshesOf(input, renderer), ...(input.boxes ?? []).map(boxOf));
    if (input.floor !== undefined) scene.add(...floorOf(input.floor, renderer));
    const target = new THREE.RenderTarget(width, height, { type: THREE.FloatType });
    renderer.setRenderTarget(target);
    renderer.setClearColor(0, 0);
    renderer.render(scene, cameraOf(input));
    const pixels = await renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height);
    if (said.length > 0) throw new Error(said.join("\n"));
    return new Uint8Array(pixels.buffer, pixels.byteOffset, pixels.byteLength);
}

/** The mesh with the relief: as it is, as objects in several places, or as instances. */
function meshesOf(input, renderer) {
    const [geometry, material] = [geometryOf(input.mesh), materialOf(input, renderer)];
    const { instanced, places } = input.instances ?? { instanced: false, places: [null] };
    if (!instanced) {
        return places.map((place) => {
            const mesh = placed(new THREE.Mesh(geometry, material), place);
            mesh.castShadow = true;
            return mesh;
        });
    }
    const mesh = new THREE.InstancedMesh(geometry, material, places.length);
    places.forEach((place, number) => {
        const object = placed(new THREE.Object3D(), place);
        object.updateMatrix();
        mesh.setMatrixAt(number, object.matrix);
    });
    return [mesh];
}

function placed(object, place) {
    if (place !== null) {
        object.position.fromArray(place.position);
        object.quaternion.fromArray(place.quaternion);
        object.scale.fromArray(place.scale);
    }
    return object;
}

function geometryOf({ positions, normals, uvs, frames, triangles }) {
    const geometry = new THREE.BufferGeometry();
    const set = (name, numbers, size) =>
        geometry.setAttribute(name, new THREE.BufferAttribute(new Float32Array(numbers), size));
    set("position", positions, 3);
    set("normal", normals, 3);
    set("uv", uvs, 2);
    if (frames !== null) {
        set("tangent", frames.tangents, 4);
        set("_tile", frames.tiles, 2);
        set("_curvature", frames.curvatures, 3);
    }
    geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(triangles), 1));
    return geometry;
}

function materialOf({ heights, functions, scale, beyond }, renderer) {
    const map = new THREE.DataTexture(
        new Float32Array(heights.texels), heights.width, heights.height, THREE.RedFormat, THREE.FloatType
    );
    map.needsUpdate = true;
    const material = new THREE.MeshBasicNodeMaterial();
    const made = applyRelief(material, functions, { renderer, maps: { height_map: map }, scale });
    // Colours below 0 become 0.
    material.colorNode = vec4(made.uv.add(beyond), made.depth.add(beyond), 1);
    return material;
}

function boxOf(place) {
    const material = new THREE.MeshBasicNodeMaterial({ color: 0 });
    return placed(new THREE.Mesh(new THREE.BoxGeometry(), material), place);
}

/** A floor and its sun, with a shadow map as sharp as it has. */
function floorOf({ sun, texels, view, height }, renderer) {
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.type = THREE.BasicShadowMap;
    const light = new THREE.DirectionalLight(0xffffff, 0);
    light.position.fromArray(sun);
    // Where all of it arrives, the floor has the colour 1.
    light.intensity = (Math.PI * light.position.length()) / light.position.y;
    light.castShadow = true;
    light.shadow.mapSize.set(texels, texels);
    Object.assign(light.shadow.camera, {
        left: -view / 2, right: view / 2, bottom: -view / 2, top: view / 2, near: 0.5, far: 5,
    });
    const floor = new THREE.Mesh(new THREE.PlaneGeometry(10, 10), new THREE.MeshLambertNodeMaterial());
    floor.rotation.x = -Math.PI / 2;
    floor.position.y = height;
    floor.receiveShadow = true;
    return [light, floor];
}

/** The camera that looks at the middle, or down at a floor. */
function cameraOf({ width, height, eye, fov, floor }) {
    if (floor === undefined) {
        const camera = new THREE.PerspectiveCamera(fov, width / height, 0.01, 100);
        camera.position.fromArray(eye);
        camera.lookAt(0, 0, 0);
        return camera;
    }
    const [up, across] = [floor.seen / 2, (floor.seen / 2) * (width / height)];
    const camera = new THREE.OrthographicCamera(-across, across, up, -up, 0.01, 1);
    camera.position.fromArray(floor.eye);
    camera.up.set(0, 0, -1);
    camera.lookAt(floor.eye[0], floor.eye[1] - 1, floor.eye[2]);
    return camera;
}
