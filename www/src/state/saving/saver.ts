/** The wire taken along: as a file, as a link, in the address. */

import type { ExportFormat } from "../../engine/protocol";
import { addressed } from "../address/address";
import { writeFragment } from "../address/fragment";
import { forOthers } from "../address/renderer";
import { explain } from "../common/words";
import type { Bench } from "../contract/bench";
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
      const how = { file: made.finished.file, format, view };
      const seen = format.endsWith("svg") ? this.here.exportSeen?.(made, how) : null;
      const bytes = await (seen ?? this.bench.engine.call("export", how));
      return new Blob([bytes as Uint8Array<ArrayBuffer>], { type: MIME[format] });
    } catch (error) {
      this.bench.warn(explain(error, "The file"));
      return null;
    }
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
