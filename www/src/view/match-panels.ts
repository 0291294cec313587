import { css, html, type PropertyValues } from "lit";
import { customElement, property } from "lit/decorators.js";
import { Sampler, samplesPerSpan, type Samples, type WireShape } from "../embed/shape";
import type { Target, View } from "../engine/protocol";
import { percent } from "../state/words";
import { pageColours } from "./colours";
import { paintInk, paintWire, PLAIN } from "./paint";
import { Part } from "./part";

const SIZE_PX = 192;
/** How long a frame paints; a slow device may need as long again for what it began. */
const SLICE_MS = 4;
/** Wires that follow each other closely are not all painted. */
const REST_MS = 100;
/** Fewer than on the stage: these are small. */
const SAMPLES = 1600;

/** How well a view matches, 0 to 1: the drawing as bent, and as given where that is something else. */
export interface Match {
  readonly name: string;
  readonly share: number | null;
  readonly asDrawn: number | null;
}

const UNKNOWN: readonly Match[] = ["front", "side", "top"].map((name) => ({ name, share: null, asDrawn: null }));

/** One small picture a view: the drawing in copper, the wire over it. Copper that is left over is missing from the wire. */
@customElement("match-panels")
export class MatchPanels extends Part {
  @property({ attribute: false }) views: readonly View[] = [];
  @property({ attribute: false }) targets: readonly Target[] = [];
  @property({ attribute: false }) found: readonly Match[] = [];
  private readonly sampler = new Sampler();
  private wire: WireShape | null = null;
  private samples: Samples | null = null;
  /** Whether the samples are of an older wire; whether the last step made them. */
  private stale = false;
  private sampled = false;
  private readonly inks = new Map<string, HTMLCanvasElement>();
  /** What is being painted now, whose turn is next, and how many are left to paint. */
  private job: Generator<void, void> | null = null;
  private turn = 0;
  private left = 0;
  private waiting: ReturnType<typeof setTimeout> | null = null;
  private readonly aside = Object.assign(document.createElement("canvas"), { width: SIZE_PX, height: SIZE_PX });
  private frame = 0;

  static override styles = css`
    :host {
      display: grid;
      grid-template-columns: repeat(3, minmax(0, 1fr));
      gap: 8px;
    }
    figure {
      margin: 0;
      min-width: 0;
    }
    canvas {
      display: block;
      box-sizing: border-box;
      width: 100%;
      aspect-ratio: 1;
      border: 1px solid var(--line);
      border-radius: 6px;
      background: var(--raised);
    }
    figcaption {
      display: flex;
      flex-wrap: wrap;
      justify-content: space-between;
      gap: 0 4px;
      margin-top: 4px;
      font-size: 13px;
      line-height: 18px;
    }
    .name {
      flex: 1;
      min-width: 0;
      overflow: hidden;
      text-overflow: ellipsis;
      white-space: nowrap;
      text-transform: capitalize;
      color: var(--quiet);
    }
    .match {
      font-weight: 600;
    }
    /* Kept free, so that nothing moves when it is known. */
    .drawn {
      flex-basis: 100%;
      min-height: 18px;
      color: var(--quiet);
    }
  `;

  override render() {
    return this.shown().map(
      ({ name, share, asDrawn }) => html`<figure>
        <canvas width=${SIZE_PX} height=${SIZE_PX} role="img" aria-label=${inWords(name, share, asDrawn)}></canvas>
        <figcaption>
          <span class="name">${name}</span>
          <span class="match" data-view=${name}>${share === null ? "–" : percent(share)}</span>
          <span class="drawn">${asDrawn === null ? "" : `${percent(asDrawn)} as drawn`}</span>
        </figcaption>
      </figure>`,
    );
  }

  private shown(): readonly Match[] {
    if (this.views.length === 0) return UNKNOWN;
    return this.views.map(({ name }) => this.found.find((match) => match.name === name) ?? { name, share: null, asDrawn: null });
  }

  setWire(wire: WireShape | null): void {
    this.wire = wire;
    this.stale = true;
    this.waiting ??= setTimeout(() => {
      this.waiting = null;
      this.repaint();
    }, REST_MS);
  }

  /** A little a frame, so that no picture keeps the page from anything. */
  repaint(): void {
    this.left = Math.max(1, this.views.length);
    this.frame ||= requestAnimationFrame(this.paintOn);
  }

  protected override updated(changed: PropertyValues<this>): void {
    if (changed.has("targets") || changed.has("views")) {
      this.inks.clear();
      this.repaint();
    }
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    cancelAnimationFrame(this.frame);
    this.frame = 0;
  }

  private readonly paintOn = (): void => {
    this.frame = 0;
    const until = performance.now() + SLICE_MS;
    do {
      this.job ??= this.next();
      if (this.job.next().done) this.job = null;
    } while ((this.job || this.left > 0) && performance.now() < until);
    if (this.job || this.left > 0) this.frame = requestAnimationFrame(this.paintOn);
  };

  /** Paints one view, or samples the wire first if that is another: never twice in a row, or none would get painted. */
  private *next(): Generator<void, void> {
    if (this.stale && !this.sampled) {
      this.stale = false;
      this.sampled = true;
      this.samples = this.wire && this.sampler.sample(this.wire, samplesPerSpan(this.wire, SAMPLES, 1));
      return;
    }
    this.sampled = false;
    this.left--;
    const index = this.turn++ % Math.max(1, this.views.length);
    const view = this.views[index];
    const canvas = this.renderRoot.querySelectorAll("canvas")[index];
    if (!view || !canvas) return;
    // Aside, and shown when it is whole.
    const aside = this.aside.getContext("2d", PLAIN)!;
    const { ink: dark, copper } = pageColours();
    aside.clearRect(0, 0, SIZE_PX, SIZE_PX);
    const target = this.targets.find((target) => target.view.name === view.name);
    if (target) {
      let ink = this.inks.get(view.name);
      if (!ink) {
        ink = document.createElement("canvas");
        paintInk(ink, target, copper, 0.6);
        this.inks.set(view.name, ink);
        yield;
      }
      aside.drawImage(ink, 0, 0, SIZE_PX, SIZE_PX);
    }
    if (this.samples) yield* paintWire(aside, this.samples, view, SIZE_PX, dark);
    const context = canvas.getContext("2d", PLAIN)!;
    context.clearRect(0, 0, SIZE_PX, SIZE_PX);
    context.drawImage(this.aside, 0, 0);
  }

  /** The colours changed. */
  recolour(): void {
    this.inks.clear();
    this.repaint();
  }
}

function inWords(name: string, share: number | null, asDrawn: number | null): string {
  const known = share === null ? "" : `; ${percent(share)} match`;
  return `The wire seen from the ${name}, over its drawing${known}${asDrawn === null ? "" : `, ${percent(asDrawn)} with the drawing as it was before bending`}`;
}
