/** What people do with the shape of the third job: choose it, and the style of the wire that covers it. */

import { Problem } from "../../engine/client";
import { kept, readPicture } from "../drawing/picture";
import { QUIET, type Bench, type PadState } from "../studio-state";
import { solidName, type Cover, type PatternName, type ShapeName, type Solid } from "../surface/cover";
import { explain } from "../words";

const MOST_FILE_BYTES = 200_000_000;

export class Dressing {
  constructor(private readonly bench: Bench) {}

  shape(shape: ShapeName): void {
    this.show(QUIET);
    const { cover } = this.bench.doc;
    if (cover && "shape" in cover.solid && cover.solid.shape === shape) return;
    this.take({ shape });
  }

  /** A mesh from a file. A bad one leaves what was there. */
  async open(file: Blob, name: string): Promise<void> {
    await this.attempt(name, async () => {
      if (file.size === 0) throw new Problem(`${name} is empty. Choose another mesh.`);
      if (file.size > MOST_FILE_BYTES) {
        throw new Problem(`${name} is ${Math.round(file.size / 1e6)} MB large. Choose a mesh of at most ${MOST_FILE_BYTES / 1e6} MB, or thin it out first.`);
      }
      const solid: Solid = { key: crypto.randomUUID(), name, file };
      // Read for what is wrong with it; the worker keeps it for whoever wants to see it.
      await this.bench.engine.call("surface", { solid });
      this.take(solid);
    });
  }

  pattern(style: PatternName | null): void {
    this.show(QUIET);
    this.dress(style, style ? `Take the style ${style}` : "Take no style");
  }

  /** A picture whose look the wire takes on. */
  async picture(file: Blob, name: string): Promise<void> {
    await this.attempt(name, async () => {
      const { note, ...pixels } = await readPicture(file, name);
      this.dress(kept(pixels, name), `Take the style of ${name}`);
      return note;
    });
  }

  clear(): void {
    this.show(QUIET);
    if (this.bench.doc.cover) this.bench.edit("Take the shape away", { cover: null });
  }

  private take(solid: Solid): void {
    const style = this.bench.doc.cover?.style ?? null;
    this.bench.edit(`Take the shape ${solidName(solid)}`, { cover: { solid, style } });
  }

  private dress(style: Cover["style"], label: string): void {
    const { cover } = this.bench.doc;
    if (cover && cover.style !== style) this.bench.edit(label, { cover: { ...cover, style } });
  }

  /** `work` may end with a note. */
  private async attempt(name: string, work: () => Promise<string | void>): Promise<void> {
    this.show({ ...QUIET, busy: true });
    try {
      this.show({ ...QUIET, note: (await work()) ?? "" });
    } catch (error) {
      this.show({ ...QUIET, problem: explain(error, name) });
    }
  }

  private show(dressing: PadState): void {
    this.bench.store.set({ dressing });
  }
}
