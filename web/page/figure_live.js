// A figure that has started: its scene is drawn over its picture, with some of the scene's controls below.

/** @import { Control, Drawn, Panel } from "./protocol.d.ts" */
/** @import { SceneFile } from "./worker_messages.d.ts" */

import { Camera } from "./camera.js";
import { ControlRow } from "./controls.js";
import { element } from "./elements.js";
import { Module } from "./module.js";
import { Picture } from "./picture.js";
import { Session } from "./session.js";
import { WorkerHost } from "./worker_host.js";

const module = new Module();

/**
 * Shows the scene of a figure in its frame. Ends when the first picture is there.
 * @param {HTMLElement} figure
 * @param {HTMLElement} frame
 */
export async function show(figure, frame) {
    const name = figure.getAttribute("scene");
    if (!name) throw new Error('the figure names no scene: <relief-figure scene="wall.toml">');
    const { text, files } = await scene(new URL(name, document.baseURI));
    const host = new WorkerHost(text, Promise.resolve(files), null, module);
    const session = new Session(host);
    const alt = figure.querySelector("img")?.alt ?? figure.getAttribute("alt") ?? "Figure";
    const canvas = element("canvas", { tabindex: "0", role: "application", "aria-label": alt });
    canvas.setAttribute("aria-description", "Arrow keys orbit, plus and minus zoom, Home goes back, Escape leaves.");
    const said = element("p", { role: "alert" });
    const failed = (/** @type {unknown} */ error) => {
        said.textContent = error instanceof Error ? error.message : String(error);
    };
    const camera = new Camera(canvas, session, failed, () => figure.shadowRoot?.activeElement === canvas);
    const back = element("button", { type: "button", class: "back" }, figure.getAttribute("back") ?? "Back");
    back.addEventListener("click", () => camera.act({ do: "fit" }));
    frame.append(canvas, back);
    const rows = new Rows(session, failed, (figure.getAttribute("controls") ?? "").split(","));
    frame.after(rows.node, rows.unknown, said);
    session.listen({
        state: ({ panel }) => rows.show(panel),
        worked: () => (said.textContent = ""),
        gone: (gone) => (said.textContent = gone ? host.gone : ""),
    });
    const context = canvas.getContext("2d", { alpha: false });
    if (!context) throw new Error("this browser draws no pictures on a canvas");
    /** @type {Promise<void>} */
    const drawn = new Promise((done, ended) => {
        const views = {
            show: (/** @type {Drawn} */ { about, views: [pixels] }) => {
                [canvas.width, canvas.height] = about.size;
                const [width, height] = about.size;
                if (pixels) context.putImageData(new ImageData(pixels, width, height), 0, 0);
                frame.classList.add("live");
                done();
            },
        };
        /** @type {{ during: <T>(request: Promise<T>) => Promise<T> }} */
        const messages = { during: (request) => request };
        const drawable = (/** @type {string | null} */ why) => {
            said.textContent = why ?? "";
            if (why !== null) ended(new Error(why));
        };
        new Picture({
            ...{ canvas, pane: frame, host, session, drawable, views, messages },
            rested: () => {},
        });
    });
    session.readState();
    await drawn.catch((error) => {
        canvas.remove();
        back.remove();
        rows.node.remove();
        rows.unknown.remove();
        said.remove();
        throw error;
    });
    canvas.focus({ preventScroll: true });
}

/** The controls of a figure. */
class Rows {
    #session;
    #failed;
    #names;
    /** @type {Map<string, ControlRow>} */ #rows = new Map();
    node = element("div", { class: "controls" });
    /** Says which names are none. */
    unknown = element("p", { role: "alert" });

    /**
     * @param {Session} session
     * @param {(error: unknown) => void} failed
     * @param {string[]} names keys and settings, such as method and search.steps
     */
    constructor(session, failed, names) {
        this.#session = session;
        this.#failed = failed;
        this.#names = names.map((name) => name.trim()).filter((name) => name !== "");
    }

    /** @param {Panel} panel */
    show(panel) {
        const controls = [...panel.surfaces.flat(), ...panel.scene];
        const wanted = this.#names.flatMap((name) => {
            const found = controls.find(({ key }) => key === name || key === `set.${name}`);
            return found ? [this.#row(found).node] : [];
        });
        this.#check(new Set(controls.map(({ key }) => key)));
        const isSame = wanted.length === this.node.children.length &&
            wanted.every((node, place) => node === this.node.children[place]);
        if (!isSame) this.node.replaceChildren(...wanted);
    }

    /**
     * Says which names are none. Settings, which have a point, come and go with the method.
     * @param {Set<string>} keys
     */
    #check(keys) {
        const unknown = this.#names.filter((name) => !name.includes(".") && !keys.has(name));
        const said = unknown.length > 0 ? `A scene has no control named ${unknown.join(", ")}.` : "";
        if (this.unknown.textContent !== said) this.unknown.textContent = said;
    }

    /** @param {Control} control */
    #row(control) {
        const row = this.#rows.get(control.key) ?? this.#newRow(control);
        row.show(control);
        return row;
    }

    /** @param {Control} control */
    #newRow(control) {
        const [session, failed] = [this.#session, this.#failed];
        const give = () => failed(new Error("a figure takes no files"));
        const row = new ControlRow(control, { session, give, failed });
        this.#rows.set(control.key, row);
        return row;
    }
}

/**
 * Fetches a scene with the files that it names.
 * @param {URL} address
 * @returns {Promise<{ text: string, files: SceneFile[] }>}
 */
async function scene(address) {
    const at = decodeURIComponent(address.pathname).slice(1);
    module.start();
    const { paths, text } = await module.post(0, "named", { scene: at, file: await fetched(address) });
    const files = paths.map(async (/** @type {string} */ path) => {
        const place = new URL(path.split("/").map(encodeURIComponent).join("/"), `${address.origin}/`);
        return { path, file: await fetched(place) };
    });
    return { text, files: await Promise.all(files) };
}

/** @param {URL} address */
async function fetched(address) {
    const answer = await fetch(address);
    if (!answer.ok) throw new Error(`${address.pathname}: the server answered ${answer.status}`);
    return answer.blob();
}
