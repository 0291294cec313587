import { build, type Plugin, type Rolldown } from "vite";
import { defineConfig } from "vitest/config";
import { embedPage } from "./plugins/embed-page.ts";
import { gallery } from "./plugins/gallery.ts";
import { includes } from "./plugins/includes.ts";
import { offline } from "./plugins/offline.ts";
import { openGraph } from "./plugins/open-graph.ts";
import { policies } from "./plugins/policies.ts";
import { words } from "./plugins/words/index.ts";

/** Each a page of its own. */
const PAGES = ["index.html", "embed.html", "docs.html", "gallery.html", "teachers.html"];

const ELEMENT = "packages/wire-sculpture";

/** The element for everybody's pages lies beside this one, under a name that stays. */
const wireSculpture: Plugin = {
  name: "wire-sculpture",
  async generateBundle() {
    const made = (await build({ configFile: `${ELEMENT}/vite.config.ts`, build: { write: false } })) as Rolldown.RolldownOutput;
    const [{ fileName, code }] = made.output;
    this.emitFile({ type: "asset", fileName, source: code });
  },
  configureServer: ({ middlewares }) => {
    middlewares.use("/wire-sculpture.js", (_, response) => void response.writeHead(302, { location: `/${ELEMENT}/src/index.ts` }).end());
  },
};

/**
 * What every visit needs of state and of tasks is one script: in pieces it would be larger. Elements come by the columns
 * that they are in, and later comes what is only wanted later. What is remembered comes before: the language is.
 */
const isOfStudio = (id: string): boolean => /\/src\/(state|tasks)\/.*\.ts$/.test(id) && !/\/(parts|example|engine|teaching)\/|\/lesson\/(reading|lesson|asked)\.|\/(help|png16|rare|remember)\./.test(id);

/** A script that is left as it came ends in `.js`: not every host knows `.mjs` for a script. */
const assetFileNames = ({ names }: { readonly names: readonly string[] }): string => `assets/[name]-[hash]${names[0]?.endsWith(".mjs") ? ".js" : "[extname]"}`;

// Relative URLs: the built page works from any host and any subpath.
export default defineConfig({
  base: "./",
  plugins: [words, includes, gallery, embedPage(), policies, openGraph(), wireSculpture, offline],
  worker: { format: "es", rolldownOptions: { output: { assetFileNames } } },
  server: { fs: { allow: [".."] } },
  build: {
    outDir: "../dist",
    emptyOutDir: true,
    target: "es2022",
    assetsInlineLimit: 0,
    // Where a browser does not know it, scripts come as they are asked for.
    modulePreload: { polyfill: false },
    rolldownOptions: {
      input: PAGES,
      output: { assetFileNames, codeSplitting: { includeDependenciesRecursively: false, groups: [{ name: "studio", test: isOfStudio }] } },
    },
  },
  test: {
    projects: [
      { extends: true, test: { name: "unit", include: ["src/**/*.test.ts", "packages/*/src/**/*.test.ts"] } },
      // The built page in a real Chromium: slow machines get their time. Two files at a time would keep two cores no busier,
      // and each other waiting.
      {
        extends: true,
        test: {
          name: "browser",
          include: ["tests/browser/**/*.test.ts"],
          testTimeout: 180_000,
          hookTimeout: 60_000,
          expect: { poll: { timeout: 30_000 } },
          fileParallelism: false,
        },
      },
    ],
  },
});
