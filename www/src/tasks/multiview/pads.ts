/** What people do with the pads. */

import { msg, str } from "@lit/localize";
import { asSentence, explain } from "../../words/sentences";
import type { Guide } from "../../engine/protocol";
import type { Bench } from "../../state/contract/bench";
import { givenFor, passingOf, QUIET, type PadState, type TaskState } from "../../state/contract/state";
import type { Files, Taker } from "../../state/contract/task";
import { deskOf, withDesk, withGiven } from "../../state/keeping/document";
import { kept, pixelsOf, readPicture } from "../../state/picture/picture";
import { viewWords } from "../../view/heading";
import { mirrored, PAPER_PX, turned, type Paper, type PictureLayer } from "./paper";
import { SLOTS, type Papers, type Slot } from "./given";
import { Previewer, type PadRemedy, type PreviewState } from "./previewer";
import type { Reading } from "./protocol";

/** What is passing about the pads, and what the drawings come to. */
export interface Passing extends PreviewState {
  readonly pads: Readonly<Record<Slot, PadState>>;
}

export class Pads implements Taker<Papers> {
  constructor(
    private readonly bench: Bench,
    private readonly task: TaskState<Papers, Passing>,
  ) {
    const { engine, store } = bench;
    const previewer = new Previewer(
      (drawings, settings) => engine.call("preview", { drawings, settings }),
      (state) => bench.pass(task, state),
    );
    store.watch(
      ({ doc }) => [doc],
      ({ doc }) => previewer.follow({ papers: this.papers, settings: deskOf(doc, task.name).settings }),
    );
  }

  /** Into the empty pads first, then from the front on; one after the other: each is an undo step of its own. */
  async take({ pictures }: Files): Promise<void> {
    const { papers } = this;
    const order = [...SLOTS.filter((slot) => !papers[slot]), ...SLOTS.filter((slot) => papers[slot])];
    for (const [i, file] of pictures.entries()) await this.give(order[i]!, file, file.name || msg(str`the ${viewWords(order[i]!)} picture`));
  }

  applyRemedy({ kind, slots, quarterTurns }: PadRemedy): void {
    const [a, b] = slots;
    if (kind === "arrange") this.bench.settings.set("arrange", "on");
    else if (kind === "mirror") this.mirror(a!);
    else if (kind === "turn") this.turn(a!, quarterTurns);
    else this.swap(a!, b!);
  }

  set(slot: Slot, paper: Paper | null, label: string): void {
    this.show(slot, QUIET);
    this.edit(label, { [slot]: paper });
  }

  /** Puts a file into a pad. A bad one leaves what was there. */
  async give(slot: Slot, file: Blob, name: string): Promise<void> {
    this.show(slot, { ...QUIET, busy: true });
    if (await this.bench.opens(file, name)) return this.show(slot, QUIET);
    try {
      const { note, ...pixels } = await readPicture(file, name);
      const picture = kept(pixels, name);
      const reading: Reading = { ink: "auto", threshold: 0 };
      const found = await this.bench.engine.call("read", { picture: { name, ...pixels }, reading, sidePx: PAPER_PX });
      const layer: PictureLayer = { kind: "picture", picture, reading, found, lay: { mirrored: false, quarterTurns: 0 } };
      this.set(slot, { layers: [layer], label: name.replace(/\.\w+$/, "") }, msg(str`Put ${name} on the ${viewWords(slot)} pad`));
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
        this.edit(msg("Find the ink in another way"), { [slot]: reread }, `reread ${slot}`);
      }
      this.show(slot, QUIET);
    } catch (error) {
      this.show(slot, { ...QUIET, problem: explain(error, layer.picture.name) });
    }
  }

  mirror(slot: Slot): void {
    this.change(slot, mirrored, msg(str`Mirror the ${viewWords(slot)} drawing`));
  }

  /** Counter-clockwise. */
  turn(slot: Slot, quarterTurns: number): void {
    this.change(slot, (paper) => turned(paper, quarterTurns), msg(str`Turn the ${viewWords(slot)} drawing`));
  }

  /** Their words go along. */
  swap(a: Slot, b: Slot): void {
    const { papers, words } = this;
    this.edit(msg(str`Swap ${viewWords(a)} and ${viewWords(b)}`), { [a]: papers[b], [b]: papers[a] }, "", { ...words, [a]: words[b] ?? "", [b]: words[a] ?? "" });
  }

  clearPad(slot: Slot): void {
    this.show(slot, QUIET);
    this.edit(msg(str`Clear the ${viewWords(slot)} pad`), { [slot]: null }, "", { ...this.words, [slot]: "" });
  }

  clear(): void {
    this.edit(msg("Start with empty pads"), this.task.blank, "", {});
  }

  /** What pulls the wire, by pad. */
  private get words(): Guide["words"] {
    return deskOf(this.bench.doc, this.task.name).guide?.words ?? {};
  }

  private get papers(): Papers {
    return givenFor(this.bench.store.get(), this.task);
  }

  private edit(label: string, change: Partial<Papers>, kind = "", words = this.words): void {
    const { doc } = this.bench;
    const { name } = this.task;
    const { guide } = deskOf(doc, name);
    const desks = guide && words !== guide.words ? withDesk(doc, name, { guide: { ...guide, words } }) : {};
    this.bench.edit(label, { ...withGiven(doc, name, { ...this.papers, ...change }), ...desks }, kind);
  }

  private change(slot: Slot, how: (paper: Paper) => Paper, label: string): void {
    const paper = this.papers[slot];
    if (paper) this.set(slot, how(paper), label);
  }

  private show(slot: Slot, pad: PadState): void {
    const { pads } = passingOf(this.bench.store.get(), this.task);
    this.bench.pass(this.task, { pads: { ...pads, [slot]: pad } });
  }
}
