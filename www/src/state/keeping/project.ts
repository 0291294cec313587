/** The document, its undo, and its keeping: every change of what a person makes goes through here. */

import { differingTask, type Doc } from "./document";
import { Edits } from "./edits";
import { Keep, tenancy, type Forms } from "./keep";
import type { Snapshot } from "../../engine/protocol";
import type { Track } from "./track";

export interface ProjectState {
  readonly doc: Doc;
  /** What undo and redo would do, in words. */
  readonly undo: string | null;
  readonly redo: string | null;
  /** Whether work is kept in this browser: by this tab, by another one, or not at all. */
  readonly keeping: "here" | "elsewhere" | "off";
}

const SAVE_AFTER_MS = 300;

export class Project {
  private edits: Edits<Doc>;
  private keeping: ProjectState["keeping"] = "here";
  private keep: Keep | null = null;
  private takeOver: () => void = () => undefined;
  /** Whether there is anything of the person's own to keep. */
  private touched = false;
  private saving: ReturnType<typeof setTimeout> | undefined;
  /** The person's own, while something else is shown. */
  private aside: Edits<Doc> | null = null;

  constructor(
    first: Doc,
    private readonly forms: Forms,
    private readonly show: (state: ProjectState) => void,
  ) {
    this.edits = new Edits(first);
  }

  get doc(): Doc {
    return this.edits.present;
  }

  /** Brings back what was kept; the run that came to no end, if there is one. */
  async recall(): Promise<Track | null> {
    const keep = await Keep.open(this.forms, () => this.keeps("off"));
    const kept = await keep?.load().catch(() => null);
    if (!keep || !kept) {
      this.keeps("off");
      return null;
    }
    this.keep = keep;
    this.takeOver = tenancy((here) => this.keeping === "off" || this.keeps(here ? "here" : "elsewhere"));
    if (kept.doc) this.replace(kept.doc);
    return kept.run;
  }

  /** A step that can be taken back; steps of one non-empty `kind` in close succession become one. */
  edit(label: string, change: Partial<Doc>, kind = ""): void {
    this.touched ||= !this.aside;
    this.edits.apply(label, { ...this.doc, ...change }, kind);
    this.changed();
  }

  /** A change that nobody made, and no step. */
  replace(change: Partial<Doc>): void {
    this.edits.replace({ ...this.doc, ...change });
    this.changed();
  }

  /** The same in every step: no undo takes it away. */
  amend(how: (doc: Doc) => Doc): void {
    this.edits.amend(how);
    this.changed();
  }

  undo(): void {
    this.travel(() => this.edits.undo());
  }

  redo(): void {
    this.travel(() => this.edits.redo());
  }

  /** People see what they took back, also where it is of another task; which one they looked at is no step. */
  private travel(go: () => Doc): void {
    const before = this.doc;
    const task = differingTask(before, go()) ?? before.task;
    this.replace({ task });
  }

  /** Shows something else, which is kept nowhere and whose steps begin here; the project waits, with its steps. */
  setAside(shown: Doc): void {
    if (!this.aside) {
      this.save();
      this.aside = this.edits;
    }
    this.edits = new Edits(shown);
    this.tell();
  }

  bringBack(): void {
    if (!this.aside) return;
    this.edits = this.aside;
    this.aside = null;
    this.tell();
  }

  /** This tab keeps the project from now on. */
  keepHere(): void {
    this.touched = true;
    this.takeOver();
  }

  beginRun(track: Track): void {
    void this.writer?.beginRun(track);
  }

  addSnapshot(snapshot: Snapshot): void {
    void this.writer?.addSnapshot(snapshot);
  }

  endRun(): void {
    void this.writer?.endRun();
  }

  /** Writes now what would be written in a moment: the page may be about to go. */
  save(): void {
    clearTimeout(this.saving);
    // The example is at hand anyway, and what nobody touched is no project.
    if (this.touched) void this.writer?.saveDoc(this.doc);
  }

  private get writer(): Keep | null {
    return this.keeping === "here" && !this.aside ? this.keep : null;
  }

  private keeps(keeping: ProjectState["keeping"]): void {
    this.keeping = keeping;
    this.tell();
    this.save();
  }

  private changed(): void {
    this.tell();
    clearTimeout(this.saving);
    this.saving = setTimeout(() => this.save(), SAVE_AFTER_MS);
  }

  private tell(): void {
    const { doc, edits, keeping } = this;
    this.show({ doc, undo: edits.undoes, redo: edits.redoes, keeping });
  }
}
