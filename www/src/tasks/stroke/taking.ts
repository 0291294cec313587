/** What people do with the one picture of the second job: give it, say what of it is meant, and how deep it is. */

import { Problem } from "../../engine/client";
import { kept, pixelsOf, readPicture } from "../../state/picture/picture";
import type { MaskStroke, Subject } from "./given";
import { QUIET, type Bench, type PadState } from "../../state/contract/state";
import { explain } from "../../state/common/words";

export class Sitting {
  constructor(private readonly bench: Bench) {}

  /** A picture, and the object the app finds in it. A bad one leaves what was there. */
  async give(file: Blob, name: string): Promise<void> {
    await this.attempt(name, async () => {
      const { note, ...pixels } = await readPicture(file, name);
      const subject: Subject = { picture: kept(pixels, name), object: 1, strokes: [], found: null, depth: null };
      const take = (found: Subject["found"]): void => this.bench.edit(`Take the picture ${name}`, { subject: { ...subject, found } });
      try {
        take(await this.bench.engine.call("find", { picture: { name, ...pixels }, object: 1 }));
      } catch (error) {
        // Where the app finds nothing, the person may paint it.
        if (error instanceof Problem) take(null);
        throw error;
      }
      return note;
    });
  }

  /** Another of the objects in the picture; the largest is 1. */
  async chooseObject(object: number): Promise<void> {
    const { subject } = this;
    if (!subject || object === subject.object) return;
    await this.attempt(subject.picture.name, async () => {
      const found = await this.bench.engine.call("find", { picture: await pixelsOf(subject.picture), object });
      if (this.subject === subject) this.bench.edit("Choose another object", { subject: { ...subject, object, found } });
    });
  }

  /** Brush strokes over what was found. */
  paint(strokes: readonly MaskStroke[]): void {
    this.change({ strokes }, strokes.length < (this.subject?.strokes.length ?? 0) ? "Take strokes off the object" : "Paint the object");
  }

  async giveDepth(file: Blob, name: string): Promise<void> {
    if (!this.subject) return;
    await this.attempt(name, async () => {
      const { note, ...pixels } = await readPicture(file, name, true);
      const { width, height } = this.subject!.picture;
      if (pixels.width !== width || pixels.height !== height) {
        throw new Problem(`${name} is ${pixels.width} × ${pixels.height} pixels and the picture ${width} × ${height}. Give a depth picture of the same size.`);
      }
      this.change({ depth: kept(pixels, name) }, `Take ${name} for the depth`);
      return note;
    });
  }

  clearDepth(): void {
    this.change({ depth: null }, "Leave the depth to the app");
  }

  clear(): void {
    this.show(QUIET);
    if (this.subject) this.bench.edit("Take the picture away", { subject: null });
  }

  private get subject(): Subject | null {
    return this.bench.doc.subject;
  }

  private change(change: Partial<Subject>, label: string): void {
    if (this.subject) this.bench.edit(label, { subject: { ...this.subject, ...change } });
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

  private show(sitting: PadState): void {
    this.bench.store.set({ sitting });
  }
}
