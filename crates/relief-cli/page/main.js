// Starts the page with the host that has served it.

import { HttpHost } from "./host.js";
import { start } from "./page.js";

start(new HttpHost());
