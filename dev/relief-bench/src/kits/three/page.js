// Draws a mesh with the kit of three.js, and gives each pixel's hit: u, v, the depth along the ray, and 1.
import * as THREE from "three/webgpu";
import { vec4 } from "three/tsl";
import { applyRelief } from "./relief.js";

export { REVISION } from "three/webgpu";

export default async function answer(input) {
    const { backend, width, height, eye, fov, scale, mesh, heights, functions, beyond } = input;
    const said = [];
    for (const kind of ["warn", "error"]) console[kind] = (...words) => said.push(words.join(" "));
    const renderer = new THREE.WebGPURenderer({ antialias: false, forceWebGL: backend === "webgl" });
    await renderer.init();
    const found = renderer.backend.isWebGPUBackend === true ? "webgpu" : "webgl";
    if (found !== backend) throw new Error(`no ${backend}`);

    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(mesh.positions), 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(new Float32Array(mesh.normals), 3));
    geometry.setAttribute("uv", new THREE.BufferAttribute(new Float32Array(mesh.uvs), 2));
    if (mesh.frames !== null) {
        const { tangents, tiles, curvatures } = mesh.frames;
        geometry.setAttribute("tangent", new THREE.BufferAttribute(new Float32Array(tangents), 4));
        geometry.setAttribute("_tile", new THREE.BufferAttribute(new Float32Array(tiles), 2));
        geometry.setAttribute("_curvature", new THREE.BufferAttribute(new Float32Array(curvatures), 3));
    }
    geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(mesh.triangles), 1));
    const map = new THREE.DataTexture(
        new Float32Array(heights.texels), heights.width, heights.height, THREE.RedFormat, THREE.FloatType
    );
    map.needsUpdate = true;
    const material = new THREE.MeshBasicNodeMaterial();
    const made = applyRelief(material, functions, { renderer, maps: { height_map: map }, scale });
    // Colours below 0 become 0.
    material.colorNode = vec4(made.uv.add(beyond), made.depth.add(beyond), 1);

    const camera = new THREE.PerspectiveCamera(fov, width / height, 0.01, 100);
    camera.position.set(...eye);
    camera.lookAt(0, 0, 0);
    const scene = new THREE.Scene();
    scene.add(new THREE.Mesh(geometry, material));
    const target = new THREE.RenderTarget(width, height, { type: THREE.FloatType });
    renderer.setRenderTarget(target);
    renderer.setClearColor(0, 0);
    renderer.render(scene, camera);
    const pixels = await renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height);
    if (said.length > 0) throw new Error(said.join("\n"));
    return new Uint8Array(pixels.buffer, pixels.byteOffset, pixels.byteLength);
}
