/** `offline.js`, which keeps the page in the browser: it knows every file of the build that it belongs to. */

import { createHash } from "node:crypto";
import { readdir, readFile, writeFile } from "node:fs/promises";
import { join, sep } from "node:path";
import type { Plugin } from "vite";
import { bundled } from "./bundled.ts";

const SCRIPT = "offline.js";
/** Large, and not what everybody comes for: networks and what runs them, the gallery's works, the picture for other sites, English in disguise. */
const WHEN_USED = /\.onnx$|(^|\/)ort[.-]|^assets\/words-.*\.(bin|json)$|^assets\/pseudo-|^gallery\/|^og\.jpg$/;

export const offline: Plugin = {
  name: "offline",
  apply: "build",
  // Other plugins write files of their own; all of them are there once the bundle is closed.
  closeBundle: {
    order: "post",
    sequential: true,
    async handler() {
      const folder = this.environment.config.build.outDir;
      const root = join(this.environment.config.root, folder);
      const names = (await readdir(root, { recursive: true, withFileTypes: true })).filter((entry) => entry.isFile()).map((entry) => join(entry.parentPath, entry.name).slice(root.length + 1).split(sep).join("/"));
      const files = names.filter((name) => name !== SCRIPT && !WHEN_USED.test(name)).sort();
      const hash = createHash("sha256");
      for (const file of files) hash.update(file).update(await readFile(join(root, file)));
      const define = { FILES: JSON.stringify(files), BUILD: JSON.stringify(hash.digest("hex").slice(0, 16)) };
      await writeFile(join(root, SCRIPT), await bundled("src/offline/worker.ts", define));
    },
  },
};
