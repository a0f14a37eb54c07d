// Puts the parts of the page together.

import { Camera } from "./camera.js";
import { byId, typed } from "./elements.js";
import { Files } from "./files.js";
import { Messages } from "./messages.js";
import { PanelView } from "./panel.js";
import { Picture } from "./picture.js";
import { Reading } from "./reading.js";
import { Saves } from "./saves.js";
import { Session } from "./session.js";
import { Empty, Toolbar } from "./toolbar.js";
import { ViewBoxes } from "./view_boxes.js";
import { Views } from "./views.js";

/** @import { Applied, Host, State } from "./protocol.d.ts" */

/**
 * Shows the scene of a host. Returns what shows an error, and what follows a change
 * that the host made by itself.
 * @param {Host} host
 */
export function start(host) {
    const session = new Session(host);
    const messages = new Messages(host);
    const empty = new Empty();
    const failed = (/** @type {unknown} */ error) => messages.error(error);
    const canvas = typed("picture", HTMLCanvasElement);
    const files = new Files(host, session, messages);
    const give = (/** @type {File} */ file, /** @type {string} */ key) =>
        files.give([{ path: file.name, file }], key);
    const panel = new PanelView({ session, give, failed });
    const camera = new Camera(canvas, session, failed);
    const views = new Views(canvas, session, failed);
    const reading = new Reading(canvas, host, session, views, failed);
    const boxes = new ViewBoxes(session, failed, (pixel, view) => reading.mark(pixel, view));
    new Toolbar(host, session, camera, views);
    new Saves({ host, session, messages, boxes, surface: () => panel.surface });
    new Picture({
        ...{ canvas, host, session, messages, views },
        pane: byId("pane"),
        rested: (about) => {
            messages.drawn(about);
            boxes.drawn(about);
            reading.rested(about.views.map(({ method }) => method ?? null));
        },
        drawable: (why) => empty.show(why),
    });
    session.listen({
        state: (state) => (panel.show(state), named(state), empty.needs(state.needs)),
        worked: () => messages.clear(),
        gone: (gone) => messages.gone(gone),
    });
    for (const event of ["visibilitychange", "focus"]) {
        window.addEventListener(event, () => document.visibilityState === "visible" && session.look(), true);
    }
    if (!host.keeps) warnsBeforeLoss(session);
    session.readState();
    return { failed, took: (/** @type {Applied} */ applied) => session.took(applied) };
}

/**
 * The browser asks before it leaves a page with changes that nobody keeps.
 * @param {Session} session
 */
function warnsBeforeLoss(session) {
    let hasChanges = false;
    session.listen({ undo: ([canUndo]) => (hasChanges = canUndo) });
    window.addEventListener("beforeunload", (event) => hasChanges && event.preventDefault());
}

/** @param {State} state */
function named({ name }) {
    const title = name || "Relief";
    document.title = name ? `${name} – Relief` : title;
    byId("name").textContent = title;
    byId("picture").setAttribute("aria-label", name ? `Picture of ${name}` : "Picture");
}
