// What axe finds on a page.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** What axe finds that is serious or critical. */
export async function found(seat) {
    const has = await seat.page.evaluate(() => "axe" in window);
    // The page's content policy forbids scripts in the page; this one comes from the browser's side.
    if (!has) await seat.page.evaluate(AXE);
    const violations = await seat.page.evaluate(async () => (await window.axe.run()).violations);
    const grave = violations.filter(({ impact }) => impact === "serious" || impact === "critical");
    const said = ({ target, any }) => `${target} ${any[0]?.message ?? ""}`;
    return grave.map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map(said).join("; ")}`);
}
