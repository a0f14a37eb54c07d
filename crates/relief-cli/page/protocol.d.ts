// Types of what the page and its host say to each other. Only the type checker reads this file.

/** A name to choose from. */
export interface Choice {
    name: string;
    about: string;
    /** Why it cannot be chosen with the other values. */
    refused: string | null;
}

/** What the values of a control are. */
export type Kind =
    | "text" | "name" | "name-or-file" | "flag" | "number" | "whole" | "other"
    | { numbers: number };

/** A control for a key. Default and value are texts as a scene file writes them. */
export interface Control {
    key: string;
    label: string;
    about: string;
    kind: Kind;
    unit: string;
    /** Whether a number may be a text with its unit, such as "5cm". */
    takes_unit: boolean;
    min: number | null;
    max: number | null;
    step: number | null;
    default: string | null;
    value: string | null;
    choices: Choice[];
    group: string;
    is_file: boolean;
}

export interface Panel {
    scene: Control[];
    surfaces: Control[][];
}

/** A file that the host can make of the scene. */
export interface Save {
    what: string;
    label: string;
    /** Whether it is made of one surface. */
    of_surface: boolean;
    /** Whether it is made of one view. */
    of_view: boolean;
}

export interface State {
    revision: number;
    name: string;
    /** Whether there is something to undo, and to redo. */
    undo: [boolean, boolean];
    panel: Panel;
    saves: Save[];
    /** Names of files that a link needs and that have not come. */
    needs: string[];
}

export interface Applied {
    revision: number;
    changed: string[];
    undo: [boolean, boolean];
}

export type Value = string | number | boolean | number[];

export type Action =
    | { do: "set"; key: string; value: Value }
    | { do: "lose"; key: string }
    | { do: "remove-surface"; number: number }
    | { do: "orbit" | "turn-light"; degrees: [number, number] }
    | { do: "pan"; by: [number, number] }
    | { do: "zoom"; factor: number }
    | { do: "look-at"; point: [number, number, number] }
    | { do: "add-surface" | "fit" | "frame" | "keep-second" | "undo" | "redo" | "reset" };

/** The picture that is wanted: the pane's size in device pixels, and the factor on both sides. */
export interface Wish {
    width: number;
    height: number;
    part: number;
    samples: "one" | "all";
    /** Part of the rows, from 0, at the top, to 1. */
    rows?: [number, number];
}

export interface AboutPicture {
    revision: number;
    size: [number, number];
    samples: number;
    seconds: number;
    notes: string[];
    /** One view, or two. */
    views: AboutView[];
}

/** A view: what it shows, or why it cannot be drawn. */
export interface AboutView {
    show: string;
    failed: string | null;
    /** The first row that was drawn, and the one behind the last. */
    rows: [number, number];
    method?: string;
    backend?: string;
    device?: string;
    legend?: Legend | null;
    errors?: { figures: Figures; worst: [number, number] | null } | null;
}

/** The colours of numbers, from the least to the greatest; directions have none. */
export interface Legend {
    title: string;
    unit: string;
    stops: string[];
    ticks: { place: number; label: string }[];
}

/** The errors of a view beside the exact picture. */
export type Figures =
    | { flip: number }
    | { rms: number; psnr_db: number | null }
    | { median_texels: number; p99_texels: number; max_texels: number; passed: number };

export interface Drawn {
    about: AboutPicture;
    /** The pixels of each view; null for one that cannot be drawn. */
    views: (Uint8ClampedArray<ArrayBuffer> | null)[];
}

/** What is under a pixel, in each view. */
export interface ReadPixel {
    at: [number, number];
    views: (PixelNumbers | null)[];
}

export type PixelNumbers = { shown?: ShownNumber } & (
    | { hit: false; exact_uv: [number, number] | null }
    | {
          hit: true;
          /** Number of the surface, and its method where there are several. */
          surface: number;
          method: string | null;
          uv: [number, number];
          height_m: number | null;
          depth_m: number;
          position_m: [number, number, number];
          reads: number;
          steps: number;
          error_texels: number | null;
          exact_uv: [number, number] | null;
      }
);

/** The number that a view shows at a pixel; null where there is none. */
export interface ShownNumber {
    name: string;
    unit: string;
    value: number | null;
}

export interface Progress {
    task: string;
    part: number;
}

/** A file that a user gives, with its path below what was dropped. */
export interface Given {
    path: string;
    file: File;
}

/** What a file is made of. */
export interface SavedOf {
    view: number;
    surface: number;
    revision: number;
}

export interface Saved {
    name: string;
    blob: Blob;
}

/** What the page asks of the program that holds the scene. */
export interface Host {
    /** Whether there is a program that can be ended. */
    readonly canEnd: boolean;
    /** Whether a scene outlives its page: the page may be opened again. */
    readonly keeps: boolean;
    /** What is to be done when the host does not answer. */
    readonly gone: string;
    state(): Promise<State>;
    apply(action: Action, drag: number | null): Promise<Applied>;
    picture(wish: Wish): Promise<Drawn>;
    /** Null while the picture changes, and outside of it. */
    pixel(at: [number, number]): Promise<ReadPixel | null>;
    progress(): Promise<Progress>;
    give(files: Given[], key: string | null, sent: (part: number) => void): Promise<Applied>;
    /** Fails with `Outdated` if the scene has another revision. */
    save(what: string, of: SavedOf): Promise<Saved>;
    /** A link to the scene, as the end of an address behind #; a host of one machine has none. */
    link?(): Promise<string>;
    end(): Promise<void>;
}
