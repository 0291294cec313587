/** What people do with the pads of the first job. */

import type { Reading } from "../../engine/protocol";
import { mirrored, PAPER_PX, turned, type Paper, type PictureLayer } from "./drawing/paper";
import { kept, pixelsOf, readPicture } from "../../state/picture/picture";
import type { Slot } from "../../state/keeping/document";
import { QUIET, type Bench, type PadState } from "../../state/contract/state";
import { asSentence, explain } from "../../state/common/words";

export class Pads {
  constructor(private readonly bench: Bench) {}

  set(slot: Slot, paper: Paper | null, label: string): void {
    this.show(slot, QUIET);
    this.bench.edit(label, { papers: { ...this.papers, [slot]: paper } });
  }

  /** Puts a file into a pad. A bad one leaves what was there. */
  async give(slot: Slot, file: Blob, name: string): Promise<void> {
    this.show(slot, { ...QUIET, busy: true });
    try {
      const { note, ...pixels } = await readPicture(file, name);
      const picture = kept(pixels, name);
      const reading: Reading = { ink: "auto", threshold: 0 };
      const found = await this.bench.engine.call("read", { picture: { name, ...pixels }, reading, sidePx: PAPER_PX });
      const layer: PictureLayer = { kind: "picture", picture, reading, found, lay: { mirrored: false, quarterTurns: 0 } };
      this.set(slot, { layers: [layer], label: name.replace(/\.\w+$/, "") }, `Put ${name} on the ${slot} pad`);
      const notes = [note, asSentence(found.note ?? "")].filter((words) => words.length > 1);
      this.show(slot, { ...QUIET, note: notes.join(" ") });
    } catch (error) {
      this.show(slot, { ...QUIET, problem: explain(error, name) });
    }
  }

  /** Finds the ink of the pad's picture in another way. */
  async reread(slot: Slot, reading: Reading): Promise<void> {
    const paper = this.papers[slot];
    const at = paper?.layers.findIndex((layer) => layer.kind === "picture") ?? -1;
    const layer = paper?.layers[at] as PictureLayer | undefined;
    if (!paper || !layer) return;
    this.show(slot, { ...QUIET, busy: true });
    try {
      const picture = await pixelsOf(layer.picture);
      const found = await this.bench.engine.call("read", { picture, reading, sidePx: PAPER_PX });
      // Unless the pad was drawn on meanwhile.
      if (this.papers[slot] === paper) {
        const reread = { ...paper, layers: paper.layers.with(at, { ...layer, reading, found }) };
        this.bench.edit("Find the ink in another way", { papers: { ...this.papers, [slot]: reread } }, `reread ${slot}`);
      }
      this.show(slot, QUIET);
    } catch (error) {
      this.show(slot, { ...QUIET, problem: explain(error, layer.picture.name) });
    }
  }

  mirror(slot: Slot): void {
    this.change(slot, mirrored, `Mirror the ${slot} drawing`);
  }

  /** Counter-clockwise. */
  turn(slot: Slot, quarterTurns: number): void {
    this.change(slot, (paper) => turned(paper, quarterTurns), `Turn the ${slot} drawing`);
  }

  swap(a: Slot, b: Slot): void {
    const { papers } = this;
    this.bench.edit(`Swap ${a} and ${b}`, { papers: { ...papers, [a]: papers[b], [b]: papers[a] } });
  }

  clear(slot: Slot): void {
    this.set(slot, null, `Clear the ${slot} pad`);
  }

  private get papers() {
    return this.bench.doc.papers;
  }

  private change(slot: Slot, how: (paper: Paper) => Paper, label: string): void {
    const paper = this.papers[slot];
    if (paper) this.set(slot, how(paper), label);
  }

  private show(slot: Slot, pad: PadState): void {
    const { store } = this.bench;
    store.set({ pads: { ...store.get().pads, [slot]: pad } });
  }
}
