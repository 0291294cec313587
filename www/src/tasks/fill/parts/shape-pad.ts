import { msg, str } from "@lit/localize";
import { html, nothing, type PropertyValues } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { givenFor, passingOf } from "../../../state/contract/state";
import { meshKey, meshName } from "../given";
import { SHAPES, type Up } from "../protocol";
import { fill } from "../task";
import type { Studio, StudioState } from "../../../state/studio";
import { asSentence } from "../../../words/sentences";
import { count } from "../../../words/numbers";
import { Part } from "../../../view/part";
import { chosenFile } from "../../../ui/shared/drop";
import { icons } from "../../../ui/shared/icons";
import { controls } from "../../../ui/shared/shared";
import { shapeIcon } from "./shape-icons";
import { tiles, tilesStyle } from "./tiles";
import { shapePadStyle } from "./shape-pad-style";

/** What browsers should offer; whatever else is chosen, the core says what is wrong with it. */
const MESH_FILES = ".obj,.stl,.ply,.3mf,.glb,.gltf";

/** What is up in a file, by where that is usual. */
const UPS = { z: msg("Z, as for printing"), y: msg("Y, as on screens") } as const;

/** The shape that a wire covers: one by formula, or a mesh from a file. */
@customElement("shape-pad")
export class ShapePad extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;
  /** The problem somebody has read and closed. */
  @state() private readProblem = "";
  @query("#mesh") private file!: HTMLInputElement;

  static override styles = [controls, tilesStyle, shapePadStyle];

  protected override willUpdate(changed: PropertyValues<this>): void {
    const before = changed.get("state") as StudioState | undefined;
    // The same may go wrong twice.
    if (!before) return;
    const [was, is] = [passingOf(before, fill), passingOf(this.state, fill)];
    if (was.busy !== is.busy || was.problem !== is.problem || was.coverProblem !== is.coverProblem) this.readProblem = "";
  }

  override render() {
    const { busy, problem: padProblem, coverProblem } = passingOf(this.state, fill);
    const mesh = givenFor(this.state, fill)?.mesh ?? null;
    const locked = this.state.phase !== "idle";
    const own = mesh && !("shape" in mesh);
    const problem = padProblem || coverProblem;
    return html`
      <h2 id="shape">${msg("Shape")}</h2>
      <fieldset class="tiles" aria-labelledby="shape" aria-busy=${busy}>
        ${tiles(
          "shape",
          SHAPES.map((value) => ({ value, words: meshName({ shape: value }), picture: shapeIcon(value) })),
          mesh && meshKey(mesh),
          locked,
          (value) => this.studio.taker(fill).shape(value as (typeof SHAPES)[number]),
        )}
        <button id="open" class=${own ? "chosen" : ""} title=${own ? msg(str`${mesh.name}. Open another mesh`) : msg("Open a mesh: OBJ, STL, PLY, 3MF, GLB or glTF")} ?disabled=${locked} @click=${this.openFile}>
          <span class="picture">${icons.open}</span><span class="words"><span class="unseen">${msg("Open a mesh:")} </span>${own ? mesh.name : msg("Your mesh…")}</span>
        </button>
      </fieldset>
      ${own ? this.upright(mesh.up ?? "y", locked) : nothing}
      ${problem && problem !== this.readProblem
        ? html`<div class="problem small" role="alert">
            <span>${problem}</span>
            <button class="plain square" aria-label=${msg("Close this message")} @click=${() => (this.readProblem = problem)}>${icons.close}</button>
          </div>`
        : html`<p class="line small quiet" role="status">${this.line()}</p>`}
      <input id="mesh" type="file" accept=${MESH_FILES} hidden tabindex="-1" aria-label=${msg("Mesh")} @change=${this.chosen} />
    `;
  }

  /** For a person who wants to choose a file. */
  openFile(): void {
    this.file.click();
  }

  /** Few files say what is up in them. */
  private upright(up: Up, locked: boolean) {
    return html`<label class="up small">
      ${msg("Up in this file")}
      <select ?disabled=${locked} @change=${(event: Event) => this.studio.taker(fill).turn((event.target as HTMLSelectElement).value as Up)}>
        ${Object.entries(UPS).map(([value, words]) => html`<option value=${value} .selected=${value === up}>${words}</option>`)}
      </select>
    </label>`;
  }

  /** One line or two, always there: nothing jumps when they are filled. */
  private line() {
    const { busy, surface } = passingOf(this.state, fill);
    if (busy) return "Reading…";
    if (!givenFor(this.state, fill)) return msg("Choose one, or drop a mesh: OBJ, STL, PLY, 3MF, GLB or glTF.");
    if (!surface) return nothing;
    const { triangles, notes } = surface;
    const words = [msg(str`${count(triangles)} triangles.`), ...notes.map(asSentence)].join(" ");
    return html`<span title=${words}>${words}</span>`;
  }

  private readonly chosen = (event: Event): void => {
    const file = chosenFile(event);
    if (file) void this.studio.taker(fill).open(file, file.name || msg("the mesh"));
  };
}
