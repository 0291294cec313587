/** What people do with the shape of the third job: choose it, and the style of the wire that covers it. */

import { Problem } from "../../engine/client";
import type { Up } from "../../engine/protocol";
import { kept, readPicture } from "../../state/picture/picture";
import { QUIET, type Bench, type PadState } from "../../state/contract/state";
import { solidName, type Cover, type PatternName, type ShapeName, type Solid } from "./given";
import { DURING_A_RUN, explain } from "../../state/common/words";

const MOST_FILE_BYTES = 200_000_000;

type Kind = "solid" | "style";

export class Dressing {
  /** What was asked for last: what is read for earlier ones comes too late. */
  private readonly newest = { solid: 0, style: 0 };

  constructor(private readonly bench: Bench) {}

  shape(shape: ShapeName): void {
    this.instead("solid");
    const { cover } = this.bench.doc;
    if (cover && "shape" in cover.solid && cover.solid.shape === shape) return;
    this.take({ shape });
  }

  /** A mesh from a file. A bad one leaves what was there. */
  async open(file: Blob, name: string): Promise<void> {
    await this.attempt("solid", name, async () => {
      if (file.size === 0) throw new Problem(`${name} is empty. Choose another mesh.`);
      if (file.size > MOST_FILE_BYTES) {
        throw new Problem(`${name} is ${Math.round(file.size / 1e6)} MB large. Choose a mesh of at most ${MOST_FILE_BYTES / 1e6} MB, or thin it out first.`);
      }
      // The bytes as they are now: what is on the disc may be written anew by the program it comes from.
      const solid = { key: crypto.randomUUID(), name, file: new Blob([await file.arrayBuffer()]), up: null };
      // Read for what is wrong with it, and what is up in it; the worker keeps it for whoever wants to see it.
      const { up } = await this.bench.engine.call("surface", { solid });
      return { take: () => this.take({ ...solid, up }) };
    });
  }

  /** Sets the mesh upright, or lays it down: another axis of its file points up. */
  turn(up: Up): void {
    this.instead("solid");
    const { cover } = this.bench.doc;
    if (cover && !("shape" in cover.solid)) this.take({ ...cover.solid, key: crypto.randomUUID(), up }, "Turn");
  }

  pattern(style: PatternName | null): void {
    this.instead("style");
    this.dress(style, style ? `Take the style ${style}` : "Take no style");
  }

  /** A picture whose look the wire takes on. */
  async picture(file: Blob, name: string): Promise<void> {
    await this.attempt("style", name, async () => {
      if (!this.bench.doc.cover) throw new Problem(`A style needs a shape. Choose one, then give ${name} again.`);
      const { note, ...pixels } = await readPicture(file, name);
      return { note, take: () => this.dress({ ...kept(pixels, name), key: crypto.randomUUID() }, `Take the style of ${name}`) };
    });
  }

  clear(): void {
    this.instead("solid");
    this.instead("style");
    if (this.bench.doc.cover) this.bench.edit("Take the shape away", { cover: null });
  }

  private take(solid: Solid, what = "Take the shape"): void {
    const style = this.bench.doc.cover?.style ?? null;
    this.bench.edit(`${what} ${solidName(solid)}`, { cover: { solid, style } });
  }

  private dress(style: Cover["style"], label: string): void {
    const { cover } = this.bench.doc;
    if (cover && cover.style !== style) this.bench.edit(label, { cover: { ...cover, style } });
  }

  /** Takes what `work` reads, unless something else is wanted by then. */
  private async attempt(kind: Kind, name: string, work: () => Promise<{ readonly take: () => void; readonly note?: string }>): Promise<void> {
    const mine = ++this.newest[kind];
    this.show({ ...QUIET, busy: true });
    let after: PadState;
    try {
      const { take, note = "" } = await work();
      if (this.newest[kind] !== mine) return;
      if (this.bench.busy) throw new Problem(DURING_A_RUN);
      take();
      after = { ...QUIET, note };
    } catch (error) {
      after = { ...QUIET, problem: explain(error, name) };
    }
    if (this.newest[kind] === mine) this.show(after);
  }

  /** Something else is wanted than what may be being read. */
  private instead(kind: Kind): void {
    this.newest[kind]++;
    this.show(QUIET);
  }

  private show(dressing: PadState): void {
    this.bench.store.set({ dressing });
  }
}
