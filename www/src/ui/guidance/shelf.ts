/** A person's networks: what this browser keeps, and one that is being brought. */

import type { EngineClient } from "../../engine/client";
import type { Facts } from "../../guidance/model";
import type { Kept } from "../../guidance/shelf";
import { explain } from "../../state/common/words";

export class Shelf {
  kept: readonly Kept[] = [];
  /** What was brought and is not open yet. */
  facts: Facts | null = null;
  busy = false;
  words = "";
  failed = false;
  private files: readonly File[] = [];

  constructor(
    private readonly engine: Pick<EngineClient, "call" | "listen">,
    private readonly changed: () => void,
  ) {
    engine.listen((news) => {
      if (news.news === "guidance" && this.busy) this.tell(`${news.words} ${Math.round(100 * news.share)}%`);
    });
  }

  async look(): Promise<void> {
    await this.trying(async () => void (this.kept = await this.guiding(null)));
  }

  async bring(files: readonly File[]): Promise<void> {
    this.facts = null;
    await this.trying(async () => {
      this.files = files;
      this.facts = await this.engine.call("lookAtGuidance", { from: { files } });
      this.tell("");
    });
  }

  /** Its checksum; null if it could not be opened. */
  async open(): Promise<string | null> {
    let sha256: string | null = null;
    await this.trying(async () => {
      const opened = await this.engine.call("openGuidance", { from: { files: this.files }, prefer: "webgpu", keep: true });
      this.tell([opened.kind === "guidance-v1" ? "Ready." : "Ready, for words of the network that guides.", opened.note, opened.unkept].filter(Boolean).join(" "));
      this.kept = await this.guiding(null);
      this.facts = null;
      if (opened.kind === "guidance-v1") ({ sha256 } = opened);
    });
    return sha256;
  }

  async drop(sha256: string): Promise<void> {
    await this.trying(async () => void (this.kept = await this.guiding(sha256)));
  }

  giveUp(): void {
    void this.engine.call("closeGuidance", {});
  }

  private async guiding(drop: string | null): Promise<Kept[]> {
    return (await this.engine.call("guidanceShelf", { drop })).filter(({ kind }) => kind === "guidance-v1");
  }

  private async trying(work: () => Promise<void>): Promise<void> {
    this.busy = true;
    this.failed = false;
    try {
      await work();
    } catch (error) {
      this.tell(explain(error, "The network"));
      this.failed = true;
    } finally {
      this.busy = false;
      this.changed();
    }
  }

  private tell(words: string): void {
    this.words = words;
    this.changed();
  }
}
