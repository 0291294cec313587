/** A worker beside the engine's: computes the views of a run that it is told of, and nothing else. */

import init, { Mate } from "./wasm/wire4d";

let mate: Mate;

async function start(module: WebAssembly.Module): Promise<void> {
  await init({ module_or_path: module });
  mate = new Mate();
  postMessage(null);
}

// What is thrown here is an error event to the engine's worker.
onmessage = ({ data }: MessageEvent<WebAssembly.Module | Uint8Array>) => {
  if (data instanceof WebAssembly.Module) {
    void start(data);
    return;
  }
  const answer = mate.answer(data) as Uint8Array<ArrayBuffer>;
  postMessage(answer, { transfer: [answer.buffer] });
};
