// Words by which people look for a control whose name is another.

/** Other words for keys. @type {Record<string, string>} */
const OTHERS = {
    height: "displacement heightmap bump picture",
    scale: "depth strength amplitude displacement amount deep",
    bias: "offset level",
    depth: "invert inverted",
    tile: "repeat tiling",
    "tile-size": "repeat tiling",
    color: "albedo diffuse base texture",
    ramp: "gradient palette colormap",
    normal: "bump",
    roughness: "gloss shiny",
    ior: "refraction glass",
    transmission: "glass transparent transparency",
    mesh: "shape object model geometry",
    "mesh-scale": "size zoom",
    rotation: "rotate turn angle",
    position: "move place location",
    walls: "sides block",
    method: "technique algorithm parallax",
    eye: "camera viewpoint position",
    target: "camera look at center",
    fov: "angle lens zoom perspective field of view",
    look: "style preset mood",
    light: "sun direction lamp",
    lights: "sun lamp point",
    "light-angle": "soft shadow sun",
    exposure: "brightness bright dark darker brighter",
    tone: "contrast tonemapping",
    background: "sky backdrop",
    environment: "sky hdri reflection",
    ambient: "occlusion sky",
    shadow: "dark shade",
    samples: "quality noise antialiasing smooth edges",
    size: "resolution width height pixels",
    backend: "gpu cpu device",
};

/**
 * Other words for a key.
 * @param {string} key
 */
export function otherWords(key) {
    return OTHERS[key.replace(/^surfaces\[\d+\]\./, "")] ?? "";
}

/**
 * A text in small letters and in one spelling.
 * @param {string} text
 */
export function plain(text) {
    return text
        .toLowerCase()
        .replace(/colour/g, "color")
        .replace(/grey/g, "gray")
        .replace(/metre/g, "meter")
        .replace(/centre/g, "center");
}
