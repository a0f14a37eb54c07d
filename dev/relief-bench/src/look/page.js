// Renders every picture that the input asks for with three.js. Answers one line for each:
// the bytes of red, green, blue and coverage as hexadecimal digits, row by row from the top.
import * as THREE from "three";

export { REVISION } from "three";

function geometry({ positions, normals, triangles }) {
    const made = new THREE.BufferGeometry();
    made.setAttribute("position", new THREE.BufferAttribute(new Float32Array(positions), 3));
    made.setAttribute("normal", new THREE.BufferAttribute(new Float32Array(normals), 3));
    made.setIndex(new THREE.BufferAttribute(new Uint32Array(triangles), 1));
    return made;
}

// The surroundings as three.js reads them: rows from the bottom, and the first column a quarter of a
// turn away from Relief's.
function surroundings({ width, height, texels }) {
    const data = new Float32Array(4 * width * height);
    for (let row = 0; row < height; row++) {
        for (let column = 0; column < width; column++) {
            const from = 3 * (row * width + ((column + width / 4) % width));
            data.set([...texels.slice(from, from + 3), 1], 4 * ((height - 1 - row) * width + column));
        }
    }
    const texture = new THREE.DataTexture(data, width, height, THREE.RGBAFormat, THREE.FloatType);
    texture.mapping = THREE.EquirectangularReflectionMapping;
    texture.colorSpace = THREE.LinearSRGBColorSpace;
    texture.wrapS = THREE.RepeatWrapping;
    texture.minFilter = texture.magFilter = THREE.LinearFilter;
    texture.needsUpdate = true;
    return texture;
}

function material({ base, metallic, roughness, widens }) {
    const made = new THREE.MeshStandardMaterial({ metalness: metallic, roughness });
    made.color.setRGB(...base, THREE.LinearSRGBColorSpace);
    if (!widens) {
        const widening = "material.roughness += geometryRoughness;";
        made.onBeforeCompile = (shader) => {
            const whole = shader.fragmentShader.replace(
                "#include <lights_physical_fragment>",
                THREE.ShaderChunk.lights_physical_fragment,
            );
            if (!whole.includes(widening)) throw new Error("three.js no longer widens roughness as it did");
            shader.fragmentShader = whole.replace(widening, "");
        };
        made.customProgramCacheKey = () => "plain";
    }
    return made;
}

function digits(bytes, size) {
    const rows = [];
    for (let row = size - 1; row >= 0; row--) {
        const part = bytes.subarray(4 * row * size, 4 * (row + 1) * size);
        rows.push(Array.from(part, (byte) => byte.toString(16).padStart(2, "0")).join(""));
    }
    return rows.join("");
}

export default function render(input) {
    const { size, eye, halfHeight: half } = input;
    const renderer = new THREE.WebGLRenderer({ antialias: false, alpha: true, precision: "highp" });
    renderer.setPixelRatio(1);
    renderer.setSize(size, size);
    renderer.setClearColor(0, 0);
    renderer.toneMapping = THREE.NoToneMapping;
    const camera = new THREE.OrthographicCamera(-half, half, half, -half, 0.1, 10);
    camera.position.set(...eye);
    camera.lookAt(0, 0, 0);
    const sphere = geometry(input.mesh);
    const around = input.surroundings.map(surroundings);
    const gl = renderer.getContext();
    const bytes = new Uint8Array(4 * size * size);
    const lines = input.pictures.map((picture) => {
        const scene = new THREE.Scene();
        scene.add(new THREE.Mesh(sphere, material(picture)));
        if (picture.surroundings === null) {
            // Relief's irradiance is 1 where a white surface shows as 1, which takes pi here.
            const light = new THREE.DirectionalLight(0xffffff, Math.PI);
            light.position.set(...input.light);
            scene.add(light);
        } else {
            scene.environment = around[picture.surroundings];
        }
        renderer.render(scene, camera);
        gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
        if (gl.getError() !== gl.NO_ERROR) throw new Error("WebGL reports an error");
        return digits(bytes, size);
    });
    const about = gl.getExtension("WEBGL_debug_renderer_info");
    lines.unshift(about ? gl.getParameter(about.UNMASKED_RENDERER_WEBGL) : "an unknown renderer");
    return lines.join("\n");
}
