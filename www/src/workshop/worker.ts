/** The worker that plans how a wire is built, and writes what that takes. */

import init, { check, made } from "../engine/wasm/wire4d_workshop";
import moduleUrl from "../engine/wasm/wire4d_workshop_bg.wasm?url";
import type { Order, Plan, Told } from "./orders";

onmessage = ({ data }: MessageEvent<Order>) => void work(data);

async function work({ id, file, wishes, kind }: Order): Promise<void> {
  try {
    await init({ module_or_path: moduleUrl });
    const text = JSON.stringify(wishes);
    if (kind) tell({ id, made: made(file, text, kind) as Uint8Array<ArrayBuffer> });
    else tell({ id, plan: JSON.parse(check(file, text)) as Plan });
  } catch (error) {
    tell({ id, problem: error instanceof Error ? error.message : String(error) });
  }
}

function tell(told: Told): void {
  postMessage(told, { transfer: "made" in told ? [told.made.buffer] : [] });
}
