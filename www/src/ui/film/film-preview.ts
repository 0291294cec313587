import { css, html } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import type { Size } from "#sculpture/film/darkroom";
import { Part } from "../../view/part";
import { GivenUp, type Filmer } from "../../film/filmer";
import { secondsOf, type FilmName, type StillOrder } from "../../film/orders";

/** Either; in the shape that it will have. */
export type Previewed = Omit<StillOrder, "make"> | { readonly film: FilmName; readonly size: Size };

/** The longer side, in CSS pixels, and how many of its own there are to one: thin lines want them, and what moves has no time for them. */
const LONGEST = 320;
const DENSITY = 2;
/** Between two pictures: so often they come at most, and a slow machine has time for others. */
const BREATH_MS = 45;
/** How long a film that does not loop shows its end. */
const END_S = 1;

/** A small moving picture of what would be made. */
@customElement("film-preview")
export class FilmPreview extends Part {
  @property({ attribute: false }) filmer!: Filmer;
  @property({ attribute: false }) of!: Previewed;
  /** Counts up when what stands before the camera has changed. */
  @property({ type: Number }) version = 0;
  /** Nothing is drawn meanwhile, and what was drawn last stays. */
  @property({ type: Boolean }) rests = false;
  @property() label = "";
  @query("canvas") private canvas!: HTMLCanvasElement;
  /** The loop that goes; others end. */
  private loop = 0;

  static override styles = css`
    :host {
      display: grid;
      place-items: center;
      min-width: 0;
      height: 320px;
    }
    canvas {
      display: block;
      border-radius: 4px;
    }
    canvas.clear {
      background: repeating-conic-gradient(color-mix(in srgb, var(--ink) 9%, var(--raised)) 0 25%, var(--raised) 0 50%) 0 0 / 16px 16px;
    }
    @media (max-width: 719px) {
      :host {
        height: min(208px, 30dvh);
      }
    }
  `;

  override render() {
    const clear = "from" in this.of && this.of.ground === "transparent";
    return html`<canvas class=${clear ? "clear" : ""} role="img" aria-label=${this.label} width="1" height="1"></canvas>`;
  }

  protected override updated(): void {
    const loop = ++this.loop;
    if (!this.rests) void this.play(loop);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.loop++;
  }

  private async play(loop: number): Promise<void> {
    const { of } = this;
    const still = !("film" in of) || matchMedia("(prefers-reduced-motion: reduce)").matches;
    const startMs = performance.now();
    do {
      if (!document.hidden) {
        try {
          this.show(await this.filmer.preview(this.moment((performance.now() - startMs) / 1000, still)));
        } catch (error) {
          // What cannot be drawn small is told when somebody wants it large.
          if (!(error instanceof GivenUp)) console.warn(error);
          return;
        }
      }
      await new Promise((resolve) => setTimeout(resolve, BREATH_MS));
    } while (!still && loop === this.loop && this.isConnected);
  }

  private moment(second: number, still: boolean) {
    const { of } = this;
    const size = this.small(of.size, still ? DENSITY : Math.min(DENSITY, devicePixelRatio || 1));
    if (!("film" in of)) return { ...of, size };
    const seconds = secondsOf(of.film);
    const share = of.film === "turntable" ? (second / seconds) % 1 : Math.min(1, (second % (seconds + END_S)) / seconds);
    return { film: of.film, size, share: still ? (of.film === "turntable" ? 0 : 1) : share };
  }

  private small({ width, height }: Size, density: number): Size {
    const scale = (LONGEST * density) / Math.max(width, height);
    return { width: Math.max(1, Math.round(width * scale)), height: Math.max(1, Math.round(height * scale)) };
  }

  private show(bitmap: ImageBitmap): void {
    const { canvas } = this;
    const scale = Math.min(this.clientWidth / bitmap.width, this.clientHeight / bitmap.height);
    [canvas.width, canvas.height] = [bitmap.width, bitmap.height];
    [canvas.style.width, canvas.style.height] = [`${bitmap.width * scale}px`, `${bitmap.height * scale}px`];
    canvas.getContext("bitmaprenderer")!.transferFromImageBitmap(bitmap);
  }
}
