// Types of what the page and its worker say to each other. Only the type checker reads this file.

import type { AboutPicture } from "./protocol.d.ts";

/** An address that the page takes back when the work is to end; null for work that goes on. */
export type Stop = string | null;

/** A request: the name of a call, and what it takes. */
export interface Request {
    id: number;
    /** Number of the viewer, of which the module holds several. */
    viewer: number;
    name: string;
    args: unknown;
}

/** An answer, or a word on progress. */
export type Answer =
    | { id: number; done: unknown }
    | { id: number; failed: string; isFault: boolean }
    | { progress: { task: string; part: number } };

/** A file with the path by which a scene names it. */
export interface SceneFile {
    path: string;
    file: Blob;
}

/** What a worker opens. */
export interface Opened {
    files: SceneFile[];
    scene: string;
    isSample: boolean;
    /** A link whose files are needed. */
    needs: string | null;
}

/** A picture, or some rows of it. */
export interface Painted {
    about: AboutPicture;
    pixels: Uint8Array<ArrayBuffer>;
}
