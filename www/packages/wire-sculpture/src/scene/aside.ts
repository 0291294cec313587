/** The worker that draws, so that no slow graphics card keeps the page waiting. */

export const startWorker = (): Worker => new Worker(new URL("./backstage-worker.ts", import.meta.url), { type: "module", name: "stage" });
