// Files in: by drop, by the browser's choice of files and folders, and from the clipboard.

/** @import { Given, Host } from "./protocol.d.ts" */
/** @import { Messages } from "./messages.js" */
/** @import { Session } from "./session.js" */

import { typed } from "./elements.js";

/** Most files that are taken at once. */
const MOST = 1000;

const TOO_MANY = `These are more than ${MOST} files. Choose a smaller folder.`;

export class Files {
    #host;
    #session;
    #messages;
    /** The files on their way: others wait. @type {Promise<void>} */ #before = Promise.resolve();

    /**
     * @param {Host} host
     * @param {Session} session
     * @param {Messages} messages
     */
    constructor(host, session, messages) {
        this.#host = host;
        this.#session = session;
        this.#messages = messages;
        this.#takeChosen();
        this.#takeDrops();
        document.addEventListener("paste", (event) => this.#pasted(event));
    }

    /**
     * Sends files and takes them into the scene. After an error the scene is the one before.
     * @param {Given[]} files
     * @param {string | null} [key]
     */
    give(files, key = null) {
        if (files.length === 0) return;
        if (files.length > MOST) return this.#messages.error(TOO_MANY);
        this.#before = this.#before.then(() => this.#send(files, key));
    }

    /**
     * @param {Given[]} files
     * @param {string | null} key
     */
    async #send(files, key) {
        const messages = this.#messages;
        const what = files.length === 1 ? (files[0]?.path ?? "") : `${files.length} files`;
        messages.clear();
        messages.say(`Sending ${what}`);
        try {
            const applied = await messages.during(this.#host.give(files, key, (part) => messages.sent(part)));
            this.#session.took(applied);
            messages.say(applied.changed.length > 0 ? `Opened ${what}` : `${what}: nothing has changed`);
        } catch (error) {
            messages.say("");
            messages.error(error);
            this.#session.met(error);
            this.#session.look();
        }
    }

    #takeChosen() {
        for (const [what, several] of [
            ["open-files", "files"],
            ["open-folder", "folder"],
        ]) {
            const input = typed(`${several}-input`, HTMLInputElement);
            for (const button of document.querySelectorAll(`[data-do="${what}"]`)) {
                button.addEventListener("click", () => input.click());
            }
            input.addEventListener("change", () => {
                const files = [...(input.files ?? [])];
                this.give(files.map((file) => ({ path: file.webkitRelativePath || file.name, file })));
                input.value = "";
            });
        }
    }

    #takeDrops() {
        const body = document.body;
        document.addEventListener("dragover", (event) => {
            if (!event.dataTransfer?.types.includes("Files")) return;
            event.preventDefault();
            event.dataTransfer.dropEffect = "copy";
            body.classList.add("dropping");
        });
        document.addEventListener("dragleave", ({ relatedTarget }) => {
            if (relatedTarget === null) body.classList.remove("dropping");
        });
        document.addEventListener("drop", (event) => {
            body.classList.remove("dropping");
            if (!event.dataTransfer?.types.includes("Files")) return;
            event.preventDefault();
            this.#dropped(event.dataTransfer);
        });
    }

    /** @param {DataTransfer} transfer */
    async #dropped(transfer) {
        // Entries and files must be asked for before the event ends.
        const entries = [...transfer.items].flatMap((item) => item.webkitGetAsEntry() ?? []);
        const plain = [...transfer.files].map((file) => ({ path: file.name, file }));
        try {
            this.give(entries.length > 0 ? await filesOf(entries) : plain);
        } catch (error) {
            this.#messages.error(error);
        }
    }

    /** @param {ClipboardEvent} event */
    #pasted(event) {
        const files = [...(event.clipboardData?.files ?? [])];
        if (files.length === 0) return;
        event.preventDefault();
        this.give(files.map((file) => ({ path: file.name, file })));
    }
}

/**
 * The files of what was dropped, and of its folders.
 * @param {FileSystemEntry[]} entries
 * @returns {Promise<Given[]>}
 */
async function filesOf(entries) {
    /** @type {Given[]} */ const found = [];
    const waiting = [...entries];
    for (let entry = waiting.shift(); entry; entry = waiting.shift()) {
        if (isFile(entry)) found.push({ path: entry.fullPath.replace(/^\//, ""), file: await fileOf(entry) });
        else if (isFolder(entry)) waiting.push(...(await entriesOf(entry)));
        if (found.length + waiting.length > MOST) throw new Error(TOO_MANY);
    }
    return found;
}

/**
 * @param {FileSystemEntry} entry
 * @returns {entry is FileSystemFileEntry}
 */
function isFile(entry) {
    return entry.isFile;
}

/**
 * @param {FileSystemEntry} entry
 * @returns {entry is FileSystemDirectoryEntry}
 */
function isFolder(entry) {
    return entry.isDirectory;
}

/**
 * @param {FileSystemFileEntry} entry
 * @returns {Promise<File>}
 */
function fileOf(entry) {
    return new Promise((done, failed) => entry.file(done, failed));
}

/**
 * All entries of a folder, which a browser hands out in parts.
 * @param {FileSystemDirectoryEntry} folder
 * @returns {Promise<FileSystemEntry[]>}
 */
async function entriesOf(folder) {
    const reader = folder.createReader();
    /** @type {FileSystemEntry[]} */ const all = [];
    for (;;) {
        /** @type {FileSystemEntry[]} */
        const part = await new Promise((done, failed) => reader.readEntries(done, failed));
        if (part.length === 0 || all.length > MOST) return all;
        all.push(...part);
    }
}
