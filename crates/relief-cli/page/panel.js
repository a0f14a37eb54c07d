// The panel: a tab for each surface and for the scene, with controls in groups, and a filter over all.

/** @import { Control, Panel, State } from "./protocol.d.ts" */
/** @import { Workshop } from "./controls.js" */

import { ControlRow } from "./controls.js";
import { byId, element, newId, reconcile, typed } from "./elements.js";

/** Groups of a tab that are open at first. */
const OPEN = 2;

export class PanelView {
    /** @type {Workshop} */ #workshop;
    #tabs = byId("tabs");
    #sheets = byId("sheets");
    #filter = typed("filter", HTMLInputElement);
    #none = byId("no-match");
    /** @type {Map<string, Sheet>} */ #known = new Map();
    #chosen = "surface 0";
    /** The tab of a surface that is being added. @type {string | null} */ #added = null;
    /** How far each tab was scrolled. @type {Map<string, number>} */ #places = new Map();
    #surfaces = 1;
    #surface = 0;

    /** @param {Workshop} workshop */
    constructor(workshop) {
        this.#workshop = workshop;
        this.#filter.addEventListener("input", () => this.#showFilter());
        this.#tabs.addEventListener("keydown", (event) => this.#key(event));
        byId("add-surface").addEventListener("click", () => this.#add());
    }

    /** @param {State} state */
    show({ panel }) {
        const sheets = this.#listed(panel).map(({ id, title, controls, number }) => {
            const sheet = this.#known.get(id) ?? this.#make(id);
            sheet.show(title, controls, number);
            return sheet;
        });
        this.#known = new Map(sheets.map((sheet) => [sheet.id, sheet]));
        this.#surfaces = panel.surfaces.length;
        if (!this.#known.has(this.#chosen)) this.#chosen = "surface 0";
        reconcile(
            this.#tabs,
            sheets.map(({ tab }) => tab),
        );
        reconcile(
            this.#sheets,
            sheets.map(({ node }) => node),
        );
        const added = this.#added;
        if (added === null || !this.#known.has(added)) return this.#showFilter();
        this.#added = null;
        this.#choose(added);
    }

    /** The number of the surface whose tab is open, or was open last. */
    get surface() {
        return Math.min(this.#surface, this.#surfaces - 1);
    }

    /** @param {Panel} panel */
    #listed({ surfaces, scene }) {
        const isOne = surfaces.length === 1;
        const listed = surfaces.map((controls, number) => ({
            id: `surface ${number}`,
            title: isOne ? "Surface" : `Surface ${number}`,
            controls,
            number: isOne ? null : number,
        }));
        return [...listed, { id: "scene", title: "Scene", controls: scene, number: null }];
    }

    /** @param {string} id */
    #make(id) {
        const sheet = new Sheet(id, this.#workshop);
        sheet.tab.addEventListener("click", () => this.#choose(id));
        return sheet;
    }

    /** @param {string} id */
    #choose(id) {
        this.#places.set(this.#chosen, this.#sheets.scrollTop);
        this.#chosen = id;
        this.#surface = this.#known.get(id)?.number ?? this.#surface;
        this.#showFilter();
        this.#sheets.scrollTop = this.#places.get(id) ?? 0;
    }

    /** Shows the chosen tab, or all controls that the filter finds. */
    #showFilter() {
        const words = this.#filter.value.trim().toLowerCase();
        let found = 0;
        for (const sheet of this.#known.values()) {
            found += sheet.filter(words);
            sheet.choose(sheet.id === this.#chosen, words !== "");
        }
        this.#tabs.hidden = words !== "";
        this.#none.textContent =
            words !== "" && found === 0 ? `No control matches “${this.#filter.value.trim()}”.` : "";
    }

    /** @param {KeyboardEvent} event */
    #key(event) {
        const ids = [...this.#known.keys()];
        const place = ids.indexOf(this.#chosen);
        /** @type {Record<string, number>} */
        const places = { ArrowRight: place + 1, ArrowLeft: place - 1, Home: 0, End: ids.length - 1 };
        const next = places[event.key];
        const id = next === undefined ? undefined : ids.at(next % ids.length);
        if (id === undefined) return;
        event.preventDefault();
        this.#choose(id);
        this.#known.get(id)?.tab.focus();
    }

    async #add() {
        try {
            this.#added = `surface ${this.#surfaces}`;
            await this.#workshop.session.apply({ do: "add-surface" });
        } catch (error) {
            this.#added = null;
            this.#workshop.failed(error);
        }
    }
}

/** The controls of a surface, or of the scene. */
class Sheet {
    /** @type {Workshop} */ #workshop;
    /** @type {Map<string, ControlRow>} */ #rows = new Map();
    /** @type {Map<string, Group>} */ #groups = new Map();
    #heading = element("h3", {});
    #remove = element("button", { type: "button", class: "remove" }, "Remove this surface");
    #list = element("div", {});
    /** The surface that can be removed. @type {number | null} */ #number = null;

    /**
     * @param {string} id
     * @param {Workshop} workshop
     */
    constructor(id, workshop) {
        this.id = id;
        this.#workshop = workshop;
        const [tab, sheet] = [newId(), newId()];
        this.tab = element("button", { type: "button", role: "tab", id: tab, "aria-controls": sheet });
        this.node = element(
            "section",
            { role: "tabpanel", id: sheet, "aria-labelledby": tab },
            ...[this.#heading, this.#list, this.#remove],
        );
        this.#remove.addEventListener("click", () => this.#removeSurface());
    }

    /**
     * @param {string} title
     * @param {Control[]} controls
     * @param {number | null} number the surface that can be removed
     */
    show(title, controls, number) {
        this.tab.textContent = this.#heading.textContent = title;
        this.#number = number;
        this.#remove.hidden = number === null;
        const known = this.#rows;
        this.#rows = new Map();
        for (const control of controls) {
            const name = ownKey(control.key);
            const row = known.get(name) ?? new ControlRow(control, this.#workshop);
            row.show(control);
            this.#rows.set(name, row);
        }
        this.#showGroups(controls);
    }

    /** @param {Control[]} controls */
    #showGroups(controls) {
        const names = [...new Set(controls.map(({ group }) => group))];
        const isFirst = this.#groups.size === 0;
        const groups = names.map((name, place) => {
            const group = this.#groups.get(name) ?? new Group(name, isFirst && place < OPEN);
            const members = controls.filter((control) => control.group === name);
            group.show(members.flatMap(({ key }) => this.#rows.get(ownKey(key)) ?? []));
            return group;
        });
        this.#groups = new Map(groups.map((group) => [group.name, group]));
        reconcile(
            this.#list,
            groups.map(({ node }) => node),
        );
    }

    /**
     * Shows the controls that match. Returns their number.
     * @param {string} words
     */
    filter(words) {
        let found = 0;
        for (const group of this.#groups.values()) found += group.filter(words);
        this.node.classList.toggle("empty", found === 0);
        return found;
    }

    /**
     * @param {boolean} isChosen
     * @param {boolean} isFiltered
     */
    choose(isChosen, isFiltered) {
        this.tab.setAttribute("aria-selected", `${isChosen}`);
        this.tab.tabIndex = isChosen ? 0 : -1;
        this.#heading.hidden = !isFiltered;
        this.node.hidden = isFiltered ? this.node.classList.contains("empty") : !isChosen;
        this.#remove.hidden = isFiltered || this.#number === null;
    }

    /** The surface of several; null: the only one, or none. */
    get number() {
        return this.#number;
    }

    async #removeSurface() {
        if (this.#number === null) return;
        try {
            await this.#workshop.session.apply({ do: "remove-surface", number: this.#number });
        } catch (error) {
            this.#workshop.failed(error);
        }
    }
}

/** Controls that belong together, which can be folded away. */
class Group {
    #count = element("span", { class: "count" });
    #body = element("div", { class: "controls" });
    /** @type {ControlRow[]} */ #rows = [];
    /** Whether it was open before the filter. @type {boolean | null} */ #wasOpen = null;

    /**
     * @param {string} name
     * @param {boolean} isOpen
     */
    constructor(name, isOpen) {
        this.name = name;
        const title = name === "" ? "Other" : name.charAt(0).toUpperCase() + name.slice(1).replace(/-/g, " ");
        this.node = element(
            "details",
            { class: "group" },
            element("summary", {}, title, this.#count),
            this.#body,
        );
        this.node.open = isOpen;
    }

    /** @param {ControlRow[]} rows */
    show(rows) {
        this.#rows = rows;
        reconcile(
            this.#body,
            rows.map(({ node }) => node),
        );
        const set = rows.filter((row) => row.isSet).length;
        this.#count.textContent = set === 0 ? "" : `${set} set`;
    }

    /** @param {string} words */
    filter(words) {
        let found = 0;
        for (const row of this.#rows) {
            const matches = words === "" || row.matches(words);
            row.node.hidden = !matches;
            found += Number(matches);
        }
        this.node.hidden = found === 0;
        if (words !== "") {
            this.#wasOpen ??= this.node.open;
            this.node.open = true;
        } else if (this.#wasOpen !== null) {
            this.node.open = this.#wasOpen;
            this.#wasOpen = null;
        }
        return found;
    }
}

/**
 * A key without the surface that it belongs to: its place in the panel says which.
 * @param {string} key
 */
function ownKey(key) {
    return key.replace(/^surfaces\[\d+\]\./, "");
}
