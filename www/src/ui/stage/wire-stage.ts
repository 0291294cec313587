import { msg, str } from "@lit/localize";
import { customElement } from "lit/decorators.js";
import { startWorker } from "#sculpture/scene/aside";
import { WireSculpture } from "#sculpture/element/element";
import type { Mat4 } from "#sculpture/scene/matrix";
import { cameraOf } from "#sculpture/scene/orbit";
import type { WireShape } from "#sculpture/scene/shape";
import type { Vantage } from "#sculpture/scene/stage";
import type { Heading } from "../../view/heading";
import { viewWords } from "../../view/heading";
import { elementWords } from "../../words/element";
import type { StageWords } from "../shared/page-task";
import { wireStageStyle } from "./wire-stage-style";

/** Of the processor's time, for pictures while a run needs it. */
const RUN_SHARE = 0.1;

const DEGREE = Math.PI / 180;

function from({ azimuth, elevation }: Heading): Vantage {
  return { azimuthRad: azimuth * DEGREE, elevationRad: elevation * DEGREE };
}

/**
 * The sculpture as the page's stage. Tells `look-change` with `{ look, room }` when a person changes how the wire looks,
 * and `see-through` when they want to see the far side, or no more.
 */
@customElement("wire-stage")
export class WireStage extends WireSculpture {
  static override startWorker = startWorker;
  private stageWords: StageWords | null = null;
  private seesThrough = false;
  private share = 1;
  private isCovered = false;

  constructor() {
    super();
    this.viewKeys = { 1: "front", 2: "side", 3: "top", f: "room" };
    this.shadowRoot!.adoptedStyleSheets.push(wireStageStyle.styleSheet!);
  }

  /** What there is to see of the wire. */
  set words(words: StageWords) {
    if (words === this.stageWords) return;
    this.stageWords = words;
    const views = Object.keys(words.views);
    this.views = views.join(" ");
    const seen = Object.entries(words.views).map(([name, text]) => [`seen${name[0]!.toUpperCase()}${name.slice(1)}`, text]);
    const side = views.includes("side") ? "side" : "right";
    this.labels = JSON.stringify({
      ...elementWords(),
      ...Object.fromEntries(seen),
      keys: msg(str`Arrow keys turn it, with shift they move it, plus and minus zoom, 1, 2 and 3 show the front, the ${viewWords(side)} and the top, F the whole room.`),
      flat: msg("This browser cannot draw in 3D here: WebGL 2 is missing or switched off. Everything else works; this is a drawing of the wire."),
    });
    this.through = this.seesThrough;
  }

  /** Off: the wire alone. */
  set room(room: boolean) {
    this.shadow = room;
  }

  /** Whether the wire is seen through what it covers. */
  override set through(through: boolean) {
    this.seesThrough = through;
    super.through = this.stageWords?.farSide ? through : null;
  }

  /** Whether a run needs the processor, if that draws. */
  set busy(busy: boolean) {
    this.share = busy ? RUN_SHARE : 1;
    this.stage?.ration(this.share);
  }

  /** Whether something else lies over all of it. */
  set covered(covered: boolean) {
    this.isCovered = covered;
    this.rouse();
  }

  override wake(): void {
    super.wake();
    this.stage?.ration(this.share);
  }

  protected override get isSeen(): boolean {
    return super.isSeen && !this.isCovered;
  }

  setWire(wire: WireShape | null): void {
    this.wire = wire;
  }

  /** Lays a canvas over the picture. */
  lay(over: HTMLCanvasElement): void {
    over.classList.add("over");
    this.shadowRoot!.querySelector(".view")!.append(over);
  }

  /** World to clip space, as the picture of that size has it now; null before there is one. A `camera-change` tells of another. */
  clipFromWorld(width: number, height: number): Mat4 | null {
    const { camera } = this.getState();
    if (!camera || !(width > 0 && height > 0)) return null;
    const { azimuth, elevation, reach, lens, target } = camera;
    return cameraOf({ azimuthRad: azimuth * DEGREE, elevationRad: elevation * DEGREE, reach, fovYRad: lens * DEGREE, target }, width, height).clipFromWorld;
  }

  /** To where no button leads. */
  lookFrom(heading: Heading): void {
    this.flyTo(from(heading));
  }

  /** Shows a wire that is done from all there is to see of it, and goes back to the room; ends when somebody takes hold. */
  tour(): void {
    this.stage?.tour((this.stageWords?.tour ?? []).map((stop) => (typeof stop === "string" ? stop : from(stop))));
  }

  /** A PNG of what the stage shows. */
  picture(width: number, height: number): Promise<Blob> {
    return this.toBlob({ width, height });
  }

  override connectedCallback(): void {
    [this.cameraControls, this.controls, this.touchAction, this.interactionPrompt] = [true, true, "none", "none"];
    super.connectedCallback();
    addEventListener("theme-change", this.relook);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    removeEventListener("theme-change", this.relook);
  }

  /** To and fro, while nobody holds it. */
  protected override get moves() {
    return { on: true, round: false };
  }

  private readonly relook = (): void => this.recolour();
}
