/** What people do with the mesh that a wire is to cover, and with the style of that wire. */

import { msg, str } from "@lit/localize";
import { Problem } from "../../engine/client";
import type { ExportArguments, Ink } from "../../engine/protocol";
import { DURING_A_RUN, explain } from "../../words/sentences";
import type { Bench } from "../../state/contract/bench";
import { givenFor, QUIET, type PadState, type TaskState } from "../../state/contract/state";
import type { Files, Taker } from "../../state/contract/task";
import { withGiven, type Made } from "../../state/keeping/document";
import { kept, readPicture } from "../../state/picture/picture";
import { Coverer, type CoverState } from "./coverer";
import { meshName, type Cover } from "./given";
import { Planning, type PlanState } from "./planning";
import type { Mesh, PatternName, ShapeName, Up } from "./protocol";

/** What is passing about the shape and its style, the curve over it, and the wire that is there. */
export interface Passing extends PadState, CoverState, PlanState {}

/** Of the pictures on the shelf. */
const PATTERN_PX = 160;
const MOST_FILE_BYTES = 200_000_000;

type Kind = "mesh" | "style";

export class CoverTaker implements Taker<Cover | null> {
  /** What was asked for last: what is read for earlier ones comes too late. */
  private readonly newest = { mesh: 0, style: 0 };

  private readonly patterns = new Map<PatternName, Promise<Ink>>();
  private readonly planning: Planning;

  constructor(
    private readonly bench: Bench,
    private readonly task: TaskState<Cover | null, Passing>,
  ) {
    const { engine, store } = bench;
    const coverer = new Coverer(
      {
        surface: (mesh) => engine.call("surface", { mesh }),
        curve: (work, settings) => engine.callEndable("curve", { work, settings }),
        cancel: () => engine.cancel(),
      },
      (state) => bench.pass(task, state),
    );
    engine.listen((news) => void (news.news === "share" && coverer.hear(news.share)));
    this.planning = new Planning(bench, task, coverer);
    store.watch(
      ({ doc, phase, tables, ahead }) => [doc, phase, tables, ahead],
      () => this.planning.follow(),
    );
  }

  async take({ pictures, meshes }: Files): Promise<void> {
    for (const file of meshes) await this.open(file, file.name || msg("the mesh"));
    for (const file of pictures) await this.picture(file, file.name || msg("the picture"));
  }

  awaits(): void {
    this.planning.awaits();
  }

  madeOf(made: Made): Cover | null {
    return this.planning.coverOf(made);
  }

  exportSeen(made: Made, how: ExportArguments): Promise<Uint8Array<ArrayBuffer>> | null {
    const mesh = this.bench.settings.value("hidden_lines") === "true" ? null : this.madeOf(made)?.mesh;
    return mesh ? this.bench.engine.call("exportBefore", { ...how, mesh }) : null;
  }

  /** The picture of a style by formula. */
  patternPicture(pattern: PatternName): Promise<Ink> {
    let picture = this.patterns.get(pattern);
    if (!picture) {
      picture = this.bench.engine.call("pattern", { pattern, sidePx: PATTERN_PX });
      picture.catch(() => this.patterns.delete(pattern));
      this.patterns.set(pattern, picture);
    }
    return picture;
  }

  shape(shape: ShapeName): void {
    this.instead("mesh");
    const { cover } = this;
    if (cover && "shape" in cover.mesh && cover.mesh.shape === shape) return;
    this.put({ shape });
  }

  /** A mesh from a file. A bad one leaves what was there. */
  async open(file: Blob, name: string): Promise<void> {
    await this.attempt("mesh", name, async () => {
      if (await this.bench.opens(file, name)) return { take: () => undefined };
      if (file.size === 0) throw new Problem(msg(str`${name} is empty. Choose another mesh.`));
      if (file.size > MOST_FILE_BYTES) {
        throw new Problem(msg(str`${name} is ${Math.round(file.size / 1e6)} MB large. Choose a mesh of at most ${MOST_FILE_BYTES / 1e6} MB, or thin it out first.`));
      }
      // The bytes as they are now: what is on the disc may be written anew by the program it comes from.
      const mesh = { key: crypto.randomUUID(), name, file: new Blob([await file.arrayBuffer()]), up: null };
      // Read for what is wrong with it, and what is up in it; the worker keeps it for whoever wants to see it.
      const { up } = await this.bench.engine.call("surface", { mesh });
      return { take: () => this.put({ ...mesh, up }) };
    });
  }

  /** Sets the mesh upright, or lays it down: another axis of its file points up. */
  turn(up: Up): void {
    this.instead("mesh");
    const { cover } = this;
    if (cover && !("shape" in cover.mesh)) this.put({ ...cover.mesh, key: crypto.randomUUID(), up }, msg("Turn"));
  }

  pattern(style: PatternName | null): void {
    this.instead("style");
    this.wear(style, style ? msg(str`Take the style ${style}`) : msg("Take no style"));
  }

  /** A picture whose look the wire takes on. */
  async picture(file: Blob, name: string): Promise<void> {
    await this.attempt("style", name, async () => {
      if (await this.bench.opens(file, name)) return { take: () => undefined };
      if (!this.cover) throw new Problem(msg(str`A style needs a shape. Choose one, then give ${name} again.`));
      const { note, ...pixels } = await readPicture(file, name);
      return { note, take: () => this.wear({ ...kept(pixels, name), key: crypto.randomUUID() }, msg(str`Take the style of ${name}`)) };
    });
  }

  clear(): void {
    this.instead("mesh");
    this.instead("style");
    if (this.cover) this.edit(msg("Take the shape away"), null);
  }

  private put(mesh: Mesh, what = msg("Take the shape")): void {
    const style = this.cover?.style ?? null;
    this.edit(`${what} ${meshName(mesh)}`, { mesh, style });
  }

  private wear(style: Cover["style"], label: string): void {
    const { cover } = this;
    if (cover && cover.style !== style) this.edit(label, { ...cover, style });
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

  private get cover(): Cover | null {
    return givenFor(this.bench.store.get(), this.task);
  }

  private edit(label: string, cover: Cover | null): void {
    this.bench.edit(label, withGiven(this.bench.doc, this.task.name, cover));
  }

  private show(pad: PadState): void {
    this.bench.pass(this.task, pad);
  }
}
