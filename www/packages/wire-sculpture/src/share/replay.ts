import type { WireShape } from "../shape";

export function openReplay(_bytes: Uint8Array): { readonly iteration: number; readonly wire: WireShape }[] {
  return [];
}
