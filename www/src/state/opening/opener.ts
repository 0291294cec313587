/** Wires from elsewhere: links, files, and the examples of a first visit. */

import { openShareCode, ShareCodeError } from "../../embed/share/code";
import type { WireShape } from "../../embed/shape";
import { Problem } from "../../engine/client";
import type { Job, ViewMeasures } from "../../engine/protocol";
import { sheetOf } from "../../engine/sheet";
import { readFragment } from "../address/fragment";
import { fragmentIn } from "../address/pasted";
import { pixelsOf } from "../picture/picture";
import { untouched, withDesk, type Made } from "../keeping/document";
import { NOTHING_TO_SEE } from "../run/runner";
import type { Options } from "../settings/options";
import { whenIdle, type Bench } from "../contract/state";
import type { Subject } from "../../tasks/stroke/given";
import { wordsOf, type Cover, type CoverWords } from "../../tasks/fill/given";
import { asSentence, DURING_A_RUN, explain, named } from "../common/words";

/** Where a wire comes from: an example also tells how well it matches, since the core cannot measure without pictures. */
type From = { readonly source: "link" } | { readonly source: "example"; readonly measured: readonly ViewMeasures[] };

export class Opener {
  /** A job whose wire is on the stage and not yet in the document. */
  private opening: Job | null = null;

  constructor(
    private readonly bench: Bench,
    private readonly options: Options,
    private readonly page: {
      /** Once what was kept is back. */
      recalled(): Promise<unknown>;
      choose(job: Job): void;
      wire(wire: WireShape): void;
      /** What the document has. */
      show(): void;
      /** A wire is on its way that is of what is there now. */
      awaits(): void;
    },
  ) {}

  /** Whether the stage shows what a link or an example carries, ahead of the document. */
  get ahead(): boolean {
    return this.opening === this.bench.doc.job;
  }

  /** Shows the wire and takes the settings that an address carries; false if it carries no wire. */
  async fragment(hash: string): Promise<boolean> {
    const { job, code, cover, settings, newer } = readFragment(fragmentIn(hash) ?? hash);
    this.bench.warn("");
    if (newer) {
      this.bench.warn("This link was made by a newer Wire4D. Reload the page to get it, then open the link again.");
      return false;
    }
    if (!job) return false;
    if (code !== null) this.opening = job;
    this.page.choose(job);
    this.options.ask(job, settings);
    if (job === "fill") void this.page.recalled().then(() => this.cover(cover, code));
    return code !== null && this.code(code, job, { source: "link" });
  }

  /** The shape that a link names: a wire without one is not shown over another. */
  private cover({ shape, style }: CoverWords, code: string | null): void {
    const { doc, busy, project } = this.bench;
    const has = doc.cover && wordsOf(doc.cover);
    if (busy || (code !== null && this.has(code, "fill"))) return;
    if ((!shape && code === null) || (shape && has?.shape === shape && has.style === style)) return;
    const cover: Cover | null = shape && { solid: { shape }, style };
    if (code !== null) this.bench.edit("Open the link", { cover }, "open a link");
    else project.replace({ cover });
  }

  /** Whether the link is to the very wire that is there: a person comes back to their own, with all that it came from. */
  private has(code: string, job: Job): boolean {
    return this.bench.doc.desks[job].made?.finished.code === code;
  }

  async file(file: File): Promise<void> {
    try {
      const bytes = new Uint8Array(await file.arrayBuffer());
      const finished = await this.bench.engine.call("open", { file: bytes, name: file.name });
      this.page.awaits();
      this.opened({ finished, source: "file", track: null, stopped: false, seconds: 0 }, this.bench.doc.job, `Open ${file.name}`);
    } catch (error) {
      this.bench.warn(explain(error, named(file.name)));
    }
  }

  /** What a job shows to those who have given it nothing yet. */
  async example(job: Job): Promise<void> {
    try {
      await { multiview: () => this.viewsExample(), stroke: () => this.strokeExample(), fill: () => this.fillExample() }[job]();
    } catch (error) {
      this.bench.warn(explain(error, "The example"));
    }
  }

  private async viewsExample(): Promise<void> {
    const { EXAMPLE_VIEWS, exampleCode, examplePapers } = await import("../../tasks/multiview/example");
    // Aside, as codes are; here where there is no worker.
    const read = (drawing: Blob) => this.bench.engine.call("sheet", { drawing }).catch(() => sheetOf(drawing));
    const [code, papers] = await Promise.all([exampleCode(), examplePapers(read)]);
    if (this.tooLate("multiview")) return;
    this.bench.project.amend((doc) => (untouched(doc, "multiview") ? { ...doc, papers } : doc));
    this.asItCame("multiview", papers);
    await this.code(code, "multiview", { source: "example", measured: EXAMPLE_VIEWS });
  }

  private async strokeExample(): Promise<void> {
    const { strokeExample } = await import("../../tasks/stroke/example");
    const { code, subject, measured } = await strokeExample();
    if (this.tooLate("stroke")) return;
    this.bench.project.amend((doc) => (untouched(doc, "stroke") ? { ...doc, subject } : doc));
    this.asItCame("stroke", subject);
    this.seeking(true);
    await this.code(code, "stroke", { source: "example", measured });
    await this.findIn(subject);
  }

  private async fillExample(): Promise<void> {
    const { FILL_COVER, fillCode } = await import("../../tasks/fill/example");
    const code = await fillCode();
    if (this.tooLate("fill")) return;
    // First, so that no curve is sought for what is about to have a wire.
    const showing = this.code(code, "fill", { source: "example", measured: [] });
    this.bench.project.amend((doc) => (untouched(doc, "fill") ? { ...doc, cover: FILL_COVER } : doc));
    this.asItCame("fill", FILL_COVER);
    await showing;
  }

  /** The object of the example's picture, for showing: it needs the core. */
  private async findIn(subject: Subject): Promise<void> {
    const { engine, project } = this.bench;
    const picture = await pixelsOf(subject.picture);
    // Where there is no core, that is said elsewhere.
    const found = await engine.call("find", { picture, object: 1 }).catch(() => null);
    // Whoever gave another picture meanwhile is waiting for that one.
    if (this.bench.doc.subject !== subject) return;
    this.seeking(false);
    if (!found || this.bench.busy) return;
    const shown = { ...subject, found };
    project.amend((doc) => (doc.subject === subject ? { ...doc, subject: shown } : doc));
    this.asItCame("stroke", shown);
  }

  /** Whether the object is being looked for, so that nobody hears it was not found. */
  private seeking(busy: boolean): void {
    const { store } = this.bench;
    store.set({ sitting: { ...store.get().sitting, busy } });
  }

  /** Whether the person was quicker. */
  private tooLate(job: Job): boolean {
    return this.bench.busy || !untouched(this.bench.doc, job);
  }

  private asItCame(job: Job, given: unknown): void {
    const { store } = this.bench;
    store.set({ examples: { ...store.get().examples, [job]: given } });
  }

  /** Shows the wire at once; the worker measures it when it comes to that. */
  private async code(code: string, job: Job, from: From): Promise<boolean> {
    this.opening = job;
    try {
      // Read aside, to keep nobody waiting; here where there is no worker, or to hear what is wrong.
      const { wire, views } = await this.bench.engine.call("peek", { code }).catch(() => openShareCode(code));
      if (this.ahead && !this.bench.busy) {
        this.page.wire(wire);
        this.bench.store.set({ ...NOTHING_TO_SEE, views });
      }
    } catch (error) {
      this.opening = null;
      if (!(error instanceof ShareCodeError)) throw error;
      this.bench.warn(asSentence(error.message));
      return false;
    }
    void this.adopt(code, job, from);
    return true;
  }

  private async adopt(code: string, job: Job, from: From): Promise<void> {
    try {
      await this.page.recalled();
      this.page.awaits();
      const before = this.bench.doc.desks[job].made;
      const finished = this.has(code, job) ? null : await this.bench.engine.call("open", { code });
      await whenIdle(this.bench.store);
      this.opening = null;
      // A wire that was made meanwhile is newer.
      if (!finished || this.bench.doc.desks[job].made !== before) {
        this.page.show();
        return;
      }
      const measures = from.source === "example" ? { ...finished.measures, views: from.measured } : finished.measures;
      // The code as it came: the same link again.
      const made: Made = { finished: { ...finished, code, measures }, source: from.source, track: null, stopped: false, seconds: 0 };
      this.opened(made, job, "Open the link");
    } catch (error) {
      // It is on the stage all the same.
      this.opening = null;
      if (!(error instanceof Problem)) console.error(error);
    }
  }

  private opened(made: Made, job: Job, label: string): void {
    const { busy, doc, project } = this.bench;
    if (busy) {
      this.bench.warn(DURING_A_RUN);
      return;
    }
    // With the shape of the link, if it names one, as one step.
    const kind = job === "fill" && made.source === "link" ? "open a link" : "";
    if (made.source !== "example") this.bench.edit(label, withDesk(doc, job, { made, loose: null }), kind);
    else project.amend((doc) => (doc.desks[job].made ? doc : { ...doc, ...withDesk(doc, job, { made }) }));
  }
}
