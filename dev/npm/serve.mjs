// Serves a folder to this machine alone, as a static host does.
//
//     node serve.mjs FOLDER [PORT]

import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";

const TYPES = {
    ".html": "text/html; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".wasm": "application/wasm",
    ".png": "image/png",
};

/**
 * Serves a folder below a path, as hosts of projects do; `more` are texts and bytes by their paths from the
 * root. Returns the server and the address.
 * @param {string} folder
 * @param {number} [port]
 * @param {Map<string, string | Buffer>} [more]
 */
export async function serve(folder, port = 0, more = new Map()) {
    const server = createServer(async ({ url }, answer) => {
        const path = decodeURIComponent(new URL(url, "http://localhost").pathname);
        const name = path.startsWith("/relief/") ? path.slice("/relief/".length) || "index.html" : null;
        const isInside = name !== null && !normalize(name).startsWith("..");
        const inFolder = isInside ? await readFile(join(folder, name)).catch(() => null) : null;
        const bytes = more.get(path) ?? inFolder;
        answer.writeHead(bytes ? 200 : 404, { "Content-Type": TYPES[extname(name ?? path)] ?? "text/plain" });
        answer.end(bytes ?? "there is no such file");
    });
    await new Promise((done, failed) => {
        server.once("error", failed);
        server.listen(port, "127.0.0.1", done);
    });
    return { server, address: `http://127.0.0.1:${server.address().port}/relief/` };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
    const [, , folder, port] = process.argv;
    if (!folder) {
        console.error("usage: node serve.mjs FOLDER [PORT]");
        process.exit(2);
    }
    const { address } = await serve(folder, Number(port ?? 0));
    console.log(`${address} (Ctrl-C ends it)`);
}
