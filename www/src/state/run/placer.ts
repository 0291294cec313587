/** Where runs are computed: what is asked for, what the core makes of it, and what becomes of that on the way. */

import { msg } from "@lit/localize";
import type { Backend, Place } from "../../engine/protocol";
import { asSentence, explain } from "../../words/sentences";
import { ANYWHERE, type Whereabouts } from "../contract/state";

export class Placer {
  private where = ANYWHERE;
  /** What the address asks for. */
  private address: Backend | null = null;
  private question: Promise<void> | null = null;
  /** Whether the run under way has told where it is, and whether it has moved since. */
  private run: "none" | "untold" | "told" | "moved" = "none";

  constructor(
    private readonly ask: (backend: Backend) => Promise<Place>,
    private readonly show: (where: Whereabouts) => void,
    /** What a person should hear of at once. */
    private readonly notice: (words: string) => void,
  ) {}

  obey(address: Backend): void {
    this.address = address;
    this.set({ asked: address, byAddress: true });
  }

  /** To be called with the setting whenever it may have changed. */
  follow(setting: Backend): void {
    const asked = this.address ?? setting;
    if (this.question && asked === this.where.asked) return;
    this.set({ asked, place: null, refusal: "" });
    this.look();
  }

  /** A run begins: the word that it is to take. */
  async begin(setting: Backend): Promise<Backend> {
    this.follow(setting);
    this.run = "untold";
    // Elsewhere nothing can be refused, so that nothing need be waited for.
    if (this.where.asked === "gpu") await this.question;
    const { asked, refusal } = this.where;
    if (!refusal) return asked;
    // Unless it was called off meanwhile.
    if (this.run === "untold") this.notice(`${refusal} ${INSTEAD}`);
    return "cpu";
  }

  /** What the run under way says. */
  hear(place: Place): void {
    const before = this.where.place;
    const elsewhere = before !== null && (before.backend !== place.backend || before.device !== place.device);
    const moved = elsewhere || (this.run !== "untold" && before?.why !== place.why);
    this.set({ place });
    if (moved) this.notice(asSentence(place.why));
    this.run = this.run !== "untold" && moved ? "moved" : "told";
  }

  /** The run is over. What happened to its device, or kept it from beginning, counts for the next one. */
  end(failed: boolean): void {
    if (failed || this.run === "moved") this.look();
    this.run = "none";
  }

  private look(): void {
    const question = (this.question = this.find(this.where.asked).then((found) => {
      const telling = this.run === "told" || this.run === "moved";
      if (this.question === question && !telling) this.set(found);
    }));
  }

  private async find(asked: Backend): Promise<Pick<Whereabouts, "place" | "refusal">> {
    try {
      return { place: await this.ask(asked), refusal: "" };
    } catch (error) {
      // What else fails is told where it is in the way.
      if (asked !== "gpu") return { place: null, refusal: "" };
      return { ...(await this.find("cpu")), refusal: explain(error, msg("The graphics card")) };
    }
  }

  private set(change: Partial<Whereabouts>): void {
    this.where = { ...this.where, ...change };
    this.show(this.where);
  }
}

export const INSTEAD = msg("The processor is used instead.");
