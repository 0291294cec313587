/** Which curve the shape should show: the finished wire's, or, after a change that moves the lines, how they would run now. */

import type { WireShape } from "../../embed/shape";
import { presetOf } from "../address/fragment";
import { deskOf, type Made } from "../keeping/document";
import type { Coverer } from "../run/coverer";
import type { Options } from "../settings/options";
import { tableOf, type Bench } from "../studio-state";
import { curveKey, solidKey } from "./cover";

export class Planning {
  /** The curves that wires were made of. One from elsewhere is of what was there when it came. */
  private readonly curves = new WeakMap<Made, { readonly solid: string; readonly curve: string }>();

  constructor(
    private readonly bench: Bench,
    private readonly options: Options,
    private readonly coverer: Pick<Coverer, "follow" | "forget">,
  ) {}

  /** To be called after every change. `ahead`: a wire is on the stage that is not in the document yet. */
  follow(ahead: boolean): void {
    const { doc, busy, store } = this.bench;
    const { cover } = doc;
    const { settings } = doc.desks.fill;
    if (!cover) this.coverer.forget();
    if (!cover || doc.job !== "fill" || !tableOf(store.get())) {
      if (cover) this.coverer.follow(null);
      this.plan(false);
      return;
    }
    const curve = curveKey(cover, (name) => this.options.value(name));
    const planned = !ahead && this.curveOf(curve)?.curve !== curve;
    this.plan(planned);
    this.coverer.follow(busy ? null : { cover, settings, curve: planned ? curve : null });
  }

  /** What stands on the stage for the finished wire. */
  standIn(made: WireShape | null): WireShape | null {
    const { doc, store } = this.bench;
    const { planned, curve } = store.get();
    if (doc.job !== "fill" || !planned) return made;
    const known = doc.desks.fill.made && this.curves.get(doc.desks.fill.made);
    return curve ?? (known && doc.cover && known.solid === solidKey(doc.cover.solid) ? made : null);
  }

  private plan(planned: boolean): void {
    const { store } = this.bench;
    if (planned !== store.get().planned) store.set({ planned });
  }

  /** Of the finished wire. */
  private curveOf(now: string): { readonly solid: string; readonly curve: string } | null {
    const { doc, store } = this.bench;
    const { made } = deskOf(doc);
    if (!made) return null;
    let known = this.curves.get(made);
    if (!known) {
      const { given, settings } = made.track ?? {};
      const table = tableOf(store.get())!;
      const cover = given?.job === "fill" ? given.cover : null;
      const value = (name: string): string => settings?.[name] ?? presetOf(settings ?? {}, table)[name] ?? "";
      known = { solid: solidKey((cover ?? doc.cover!).solid), curve: cover ? curveKey(cover, value) : now };
      this.curves.set(made, known);
    }
    return known;
  }
}
