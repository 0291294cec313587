/** Runs `budget.ts`, whose types Node cannot strip by itself: `node tests/budget/run.mjs [part…]`, from the page's folder. */

import { runnerImport } from "vite";

const { module } = await runnerImport("./tests/budget/budget.ts", { configFile: false, logLevel: "error" });
process.exit((await module.measure(process.argv.slice(2))) ? 0 : 1);
