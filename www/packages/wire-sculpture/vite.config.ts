import { defineConfig } from "vite";

/** One module that needs nothing beside it: a page, a worker and another origin's page can all run it. */
export default defineConfig({
  root: import.meta.dirname,
  publicDir: false,
  logLevel: "warn",
  build: {
    outDir: "dist",
    emptyOutDir: true,
    target: "es2022",
    modulePreload: false,
    rolldownOptions: {
      input: "src/index.ts",
      preserveEntrySignatures: "strict",
      output: { format: "es", entryFileNames: "wire-sculpture.js", codeSplitting: false },
    },
  },
});
