/** The wire taken along: as a file, as a link, in the address. */

import { msg } from "@lit/localize";
import type { ExportFormat } from "../../engine/protocol";
import { addressed } from "../address/address";
import { writeFragment } from "../address/fragment";
import { forOthers } from "../address/renderer";
import { explain } from "../../words/sentences";
import type { Bench } from "../contract/bench";
import { showsExample } from "../contract/state";
import type { Taker, Task } from "../contract/task";
import { deskOf, type Made } from "../keeping/document";

const MIME: Readonly<Record<ExportFormat, string>> = {
  glb: "model/gltf-binary",
  stl: "model/stl",
  obj: "model/obj",
  svg: "image/svg+xml",
  "lines.svg": "image/svg+xml",
  "wire.json": "application/json",
  "bend.csv": "text/csv",
};

export class Saver {
  constructor(
    private readonly bench: Bench,
    private readonly tasks: readonly Task[],
    private readonly taker: (task: string) => Taker,
  ) {}

  /** The wire as a file; `view` is the one an SVG draws. Null where there is none, or it could not be made. */
  async export(format: ExportFormat, view = "front"): Promise<Blob | null> {
    const { made } = this;
    if (!made) return null;
    try {
      const how = { file: await this.packed(made), format, view };
      const seen = format.endsWith("svg") ? this.here.exportSeen?.(made, how) : null;
      const bytes = await (seen ?? this.bench.engine.call("export", how));
      return new Blob([bytes as Uint8Array<ArrayBuffer>], { type: MIME[format] });
    } catch (error) {
      this.bench.warn(explain(error, msg("The file")));
      return null;
    }
  }

  /** A PNG picture of the wire, which opens again; as it is, where that does not work out. */
  async carrying(picture: Blob): Promise<Blob> {
    const { made } = this;
    if (!made) return picture;
    try {
      const file = await this.packed(made);
      const bytes = await this.bench.engine.call("carry", { picture: new Uint8Array(await picture.arrayBuffer()), file });
      return new Blob([bytes], { type: "image/png" });
    } catch (error) {
      console.error(error);
      return picture;
    }
  }

  /** The wire.json with what the wire was made of, as far as that is known. */
  private async packed(made: Made): Promise<Uint8Array<ArrayBuffer>> {
    const { file } = made.finished;
    const { doc, store } = this.bench;
    const asExample = showsExample(store.get()) ? doc.given[doc.task] : null;
    const given = made.track ? made.track.given : (asExample ?? null);
    const { isPacked, packedInto } = await import("../carrying/wire-file");
    if (given === null || isPacked(file)) return file;
    const task = this.tasks.find(({ name }) => name === doc.task)!;
    return packedInto(file, await (await task.packing()).pack(given));
  }

  /** A link that carries the whole wire and the settings. */
  link(page: string): string | null {
    const { made } = this;
    return made && forOthers(page) + this.address(writeFragment(this.bench.doc.task, made.finished.code, {}, {}, this.tasks));
  }

  /** What should stand in the address in place of `hash`. */
  address(hash: string): string {
    const { made } = this;
    return addressed(hash, this.bench.doc, this.tasks, made && (this.here.madeOf?.(made) ?? null));
  }

  private get here(): Taker {
    return this.taker(this.bench.doc.task);
  }

  private get made(): Made | null {
    return deskOf(this.bench.doc).made;
  }
}
