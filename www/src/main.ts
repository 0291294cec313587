const worker = new Worker(new URL("./engine/worker.ts", import.meta.url), { type: "module" });
worker.onmessage = (event: MessageEvent<string>) => {
  document.body.textContent = `Wire4D ${event.data}`;
};
