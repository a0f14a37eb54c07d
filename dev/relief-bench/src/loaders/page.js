// Loads a glTF file and lone textures with three.js' own loaders, and answers what a shader of it samples:
// the SHA-256 of all texels, row 0 first. The files come in the input, as addresses that hold them.
import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

export { REVISION } from "three";

const renderer = new THREE.WebGLRenderer({ antialias: false });

const FRAGMENT = `
    precision highp float;
    uniform sampler2D map;
    out vec4 colour;
    void main() { colour = texelFetch(map, ivec2(gl_FragCoord.xy), 0); }`;

function texels(texture) {
    const { width, height } = texture.image;
    const copy = texture.clone();
    // Without a colour space the bytes arrive as they are stored.
    copy.colorSpace = THREE.NoColorSpace;
    copy.generateMipmaps = false;
    copy.minFilter = copy.magFilter = THREE.NearestFilter;
    copy.needsUpdate = true;
    const material = new THREE.RawShaderMaterial({
        glslVersion: THREE.GLSL3,
        uniforms: { map: { value: copy } },
        vertexShader: "in vec3 position; void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }",
        fragmentShader: FRAGMENT,
    });
    const square = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material);
    square.frustumCulled = false;
    const scene = new THREE.Scene();
    scene.add(square);
    const target = new THREE.WebGLRenderTarget(width, height, { depthBuffer: false });
    renderer.setRenderTarget(target);
    renderer.render(scene, new THREE.Camera());
    const bytes = new Uint8Array(4 * width * height);
    renderer.readRenderTargetPixels(target, 0, 0, width, height, bytes);
    renderer.setRenderTarget(null);
    return bytes;
}

async function told(texture) {
    const hash = new Uint8Array(await crypto.subtle.digest("SHA-256", texels(texture)));
    return {
        size: [texture.image.width, texture.image.height],
        srgb: texture.colorSpace === THREE.SRGBColorSpace,
        flipped: texture.flipY,
        repeats: texture.wrapS === THREE.RepeatWrapping && texture.wrapT === THREE.RepeatWrapping,
        sha256: Array.from(hash, (byte) => byte.toString(16).padStart(2, "0")).join(""),
    };
}

export default async function answer({ gltf, files }) {
    const manager = new THREE.LoadingManager();
    manager.setURLModifier((address) => files[address.replace(/^.*\//, "")] ?? address);
    const loaded = await new GLTFLoader(manager).loadAsync(gltf);
    const meshes = [];
    loaded.scene.traverse((object) => object.isMesh && meshes.push(object));
    if (meshes.length !== 1) throw new Error(`the glTF file has ${meshes.length} meshes`);
    const { material, geometry } = meshes[0];
    const box = new THREE.Box3().setFromObject(meshes[0]);
    const slots = {};
    for (const name of ["map", "normalMap", "roughnessMap", "metalnessMap", "aoMap"]) {
        slots[name] = material[name] && (await told(material[name]));
    }
    const lone = {};
    for (const name of Object.keys(files).filter((name) => name.endsWith(".png"))) {
        lone[name] = await told(await new THREE.TextureLoader(manager).loadAsync(name));
    }
    const gl = renderer.getContext();
    const about = gl.getExtension("WEBGL_debug_renderer_info");
    return JSON.stringify({
        renderer: about ? gl.getParameter(about.UNMASKED_RENDERER_WEBGL) : "an unknown renderer",
        type: material.type,
        factors: [material.roughness, material.metalness, ...material.normalScale, ...material.color],
        attributes: Object.keys(geometry.attributes).sort(),
        box: [box.min.toArray(), box.max.toArray()],
        slots,
        lone,
    });
}
