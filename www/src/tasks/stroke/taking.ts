/** What people do with the one picture: give it, say what of it is meant, and how deep it is. */

import { msg, str } from "@lit/localize";
import { Problem } from "../../engine/client";
import type { Picture } from "../../engine/protocol";
import { explain } from "../../words/sentences";
import type { Bench } from "../../state/contract/bench";
import { givenFor, QUIET, type PadState, type TaskState } from "../../state/contract/state";
import type { Files, Taker } from "../../state/contract/task";
import { withGiven } from "../../state/keeping/document";
import { kept, pixelsOf, readPicture, type KeptPicture } from "../../state/picture/picture";
import { hintsOf, isPointedAt, type MaskStroke, type Subject } from "./given";
import type { FoundObject } from "./protocol";

/** A change of where a person points. */
export type Pointing = (subject: Subject) => Pick<Subject, "box" | "marks">;

/** What the worker knows pictures by. */
const keys = new WeakMap<Blob, number>();
let nextKey = 1;

export function keyOf({ rgba }: KeptPicture): number {
  const key = keys.get(rgba) ?? nextKey++;
  keys.set(rgba, key);
  return key;
}

export class SubjectTaker implements Taker<Subject | null> {
  /** Strokes are drawn faster than they are cut out: each waits for the one before. */
  private pointed: Promise<void> = Promise.resolve();
  /** What was looked for last. */
  private sought: { readonly asked: string; readonly found: Promise<FoundObject> } | null = null;

  constructor(
    private readonly bench: Bench,
    private readonly task: TaskState<Subject | null, PadState>,
  ) {}

  async take({ pictures }: Files): Promise<void> {
    for (const file of pictures) await this.give(file, file.name || msg("the picture"));
  }

  /** A picture, and the object the app finds in it. A bad one leaves what was there. */
  async give(file: Blob, name: string): Promise<void> {
    await this.attempt(name, async () => {
      if (await this.bench.opens(file, name)) return;
      const { note, ...pixels } = await readPicture(file, name);
      const picture = kept(pixels, name);
      const subject: Subject = { picture, object: 1, strokes: [], found: null, depth: await this.guessDepth(picture) };
      const take = (found: Subject["found"]): void => this.edit(msg(str`Take the picture ${name}`), { ...subject, found });
      try {
        take(await this.seek(subject));
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
      const chosen: Subject = { ...subject, object, box: null, marks: [] };
      const found = await this.seek(chosen);
      if (this.subject === subject) this.edit(msg("Choose another object"), { ...chosen, found });
    });
  }

  /** Another box or other marks, and what they point at; `quick` where people go on drawing meanwhile. */
  point(label: string, change: Pointing, quick = false): Promise<void> {
    return (this.pointed = this.pointed.then(async () => {
      const { subject } = this;
      if (!subject) return;
      const work = async (): Promise<void> => {
        const next = pointedAt(subject, change);
        const found = await this.seek(next);
        if (this.subject === subject) this.edit(label, { ...next, found });
      };
      await this.attempt(subject.picture.name, work, !quick);
    }));
  }

  /** What a change would find, for showing while a stroke is drawn; null if nothing. */
  async foresee(change: Pointing): Promise<FoundObject | null> {
    const { subject } = this;
    return subject && this.seek(pointedAt(subject, change)).catch(() => null);
  }

  /** Brush strokes over what was found. */
  paint(strokes: readonly MaskStroke[]): void {
    this.change({ strokes }, strokes.length < (this.subject?.strokes.length ?? 0) ? msg("Take strokes off the object") : msg("Paint the object"));
  }

  async giveDepth(file: Blob, name: string): Promise<void> {
    if (!this.subject) return;
    await this.attempt(name, async () => {
      const { note, ...pixels } = await readPicture(file, name, true);
      const { width, height } = this.subject!.picture;
      if (pixels.width !== width || pixels.height !== height) {
        throw new Problem(msg(str`${name} is ${pixels.width} × ${pixels.height} pixels and the picture ${width} × ${height}. Give a depth picture of the same size.`));
      }
      this.change({ depth: kept(pixels, name) }, msg(str`Take ${name} for the depth`));
      return note;
    });
  }

  clearDepth(): void {
    this.change({ depth: null }, msg("Leave the depth to the app"));
  }

  clear(): void {
    this.show(QUIET);
    if (this.subject) this.edit(msg("Take the picture away"), null);
  }

  /** The object of a picture that came without, for showing: it needs the core. */
  complete(subject: Subject | null): void {
    if (subject) void this.findIn(subject);
  }

  private get subject(): Subject | null {
    return givenFor(this.bench.store.get(), this.task);
  }

  private async findIn(subject: Subject): Promise<void> {
    const { project, store } = this.bench;
    const { name } = this.task;
    // Nobody is to hear that it was not found while it is sought.
    this.bench.pass(this.task, { busy: true });
    // Where there is no core, that is said elsewhere.
    const found = await this.seek(subject).catch(() => null);
    // Whoever gave another picture meanwhile is waiting for that one.
    if (this.subject !== subject) return;
    this.bench.pass(this.task, { busy: false });
    if (!found || this.bench.busy) return;
    const shown = { ...subject, found };
    project.amend((doc) => (doc.given[name] === subject ? { ...doc, ...withGiven(doc, name, shown) } : doc));
    const { examples } = store.get();
    if (examples[name] === subject) store.set({ examples: { ...examples, [name]: shown } });
  }

  /** As a network says, where one is open; a picture is fine without. */
  private async guessDepth(picture: KeptPicture): Promise<KeptPicture | null> {
    const guessed = await this.bench.engine.call("guessDepth", { picture: await pixelsOf(picture) }).catch(() => null);
    return guessed && kept(guessed, guessed.name);
  }

  /** What was foreseen of a mark is what it finds. */
  private seek(subject: Subject): Promise<FoundObject> {
    const { picture, object, box, marks } = subject;
    const key = keyOf(picture);
    const asked = JSON.stringify([key, object, box, marks]);
    const known = this.sought?.asked === asked ? this.sought : { asked, found: this.ask(subject, key) };
    this.sought = known;
    // What failed may go well another time.
    known.found.catch(() => (this.sought = null));
    return known.found;
  }

  private async ask(subject: Subject, key: number): Promise<FoundObject> {
    const { picture, object } = subject;
    const ask = (pixels: Picture | null) => this.bench.engine.call("find", { key, picture: pixels, object, hints: hintsOf(subject) });
    return ((await ask(null)) ?? (await ask(await pixelsOf(picture))))!;
  }

  private edit(label: string, subject: Subject | null): void {
    this.bench.edit(label, withGiven(this.bench.doc, this.task.name, subject));
  }

  private change(change: Partial<Subject>, label: string): void {
    if (this.subject) this.edit(label, { ...this.subject, ...change });
  }

  /** `work` may end with a note. */
  private async attempt(name: string, work: () => Promise<string | void>, busy = true): Promise<void> {
    this.show({ ...QUIET, busy });
    try {
      this.show({ ...QUIET, note: (await work()) ?? "" });
    } catch (error) {
      this.show({ ...QUIET, problem: explain(error, name) });
    }
  }

  private show(pad: PadState): void {
    this.bench.pass(this.task, pad);
  }
}

function pointedAt(subject: Subject, change: Pointing): Subject {
  const next = { ...subject, ...change(subject) };
  // Of what is pointed at there is one.
  return isPointedAt(next) ? { ...next, object: 1 } : next;
}
