/** What people drop, paste or follow: brought to whoever takes it. */

import { msg, str } from "@lit/localize";
import { fragmentIn } from "../address/pasted";
import { DURING_A_RUN, explain } from "../../words/sentences";
import type { Bench } from "../contract/bench";
import type { Taker, Task } from "../contract/task";
import { sortFiles } from "./files";
import type { Opener } from "./opener";

/** Whether an address names files that lie beside the page. */
export const namesBeside = (hash: string): boolean => /[#&]open=/.test(hash);

export class Receiver {
  constructor(
    private readonly bench: Bench,
    private readonly tasks: readonly Task[],
    private readonly opener: Opener,
    private readonly taker: (task: string) => Taker,
    /** Follows an address that asks for a lesson; false where it asks for none. */
    private readonly teach: (hash: string) => Promise<boolean>,
  ) {}

  /** Pictures to where the task wants them, a mesh to a task that takes it, a wire onto the stage. `folders` names what is no file. */
  async files(files: readonly File[], folders: readonly string[] = []): Promise<void> {
    if (this.bench.busy || files.length === 0) return;
    if (await this.opens(files)) return;
    const { takes } = this.task;
    const { meshes, pictures, wire, note } = sortFiles(files, folders, takes.pictures, takes.meshes);
    this.bench.warn(note);
    if (wire && pictures.length === 0 && meshes.length === 0) await this.opener.file(wire);
    const elsewhere = meshes.length && !takes.meshes ? this.tasks.find(({ takes }) => takes.meshes) : undefined;
    if (elsewhere) this.opener.turnTo(elsewhere.name);
    await this.taker(this.bench.doc.task).take({ meshes, pictures: elsewhere ? [] : pictures });
  }

  /** Pictures and models that carry a wire, where there is nothing else: one wire at a time. */
  private async opens([first, ...more]: readonly File[]): Promise<boolean> {
    if (/\.json$/i.test(first!.name) || !(await this.opener.opens(first!, first!.name))) return false;
    if (more.length) this.bench.warn(msg(str`One wire at a time: ${first!.name} was opened.`));
    return true;
  }

  /** A link is opened, for any other text there is a better place. */
  text(text: string): void {
    if (this.bench.busy || !text.trim()) return;
    const hash = fragmentIn(text);
    if (hash) void this.fragment(hash);
    else this.bench.warn(this.task.words.text);
  }

  /** Shows what an address asks for. */
  async fragment(hash: string): Promise<void> {
    if (await this.teach(hash)) return;
    if (this.bench.busy) this.bench.warn(DURING_A_RUN);
    else if (!(await this.opener.fragment(hash)) && !(await this.beside(hash))) await this.opener.example();
  }

  /** Opens what an address names of the gallery; false where it names nothing. */
  async beside(hash: string): Promise<boolean> {
    if (!namesBeside(hash)) return false;
    try {
      const { filesBeside } = await import("./beside");
      for (const file of await filesBeside(hash)) await this.files([file]);
    } catch (error) {
      this.bench.warn(explain(error, msg("The work")));
    }
    return true;
  }

  private get task(): Task {
    return this.tasks.find(({ name }) => name === this.bench.doc.task)!;
  }
}
