/** The element's buttons. */

import { h, icon, setAttribute, type Child, type ICONS } from "./dom";
import { LOOK_NAMES, type LookName } from "../scene/looks";
import type { Words } from "./words";

const TURN_RAD = Math.PI / 8;
const ZOOM = 1.25;

/** What there are buttons for. */
export interface BarParts {
  readonly words: Words;
  /** Names of views. */
  readonly views: readonly string[];
  /** Whether one can turn, zoom and choose a look by buttons. */
  readonly controls: boolean;
  /** Whether something may hide lines. */
  readonly farSide: boolean;
}

export interface BarState {
  readonly view: string | null;
  readonly look: LookName;
  readonly room: boolean;
  readonly through: boolean;
}

export interface BarDoings {
  view(name: string): void;
  step(turnRad: number, zoom: number): void;
  look(name: LookName): void;
  room(): void;
  through(): void;
}

export class Bar {
  readonly element = h("div", { class: "bar", part: "bar" });
  private made = "";
  private state: BarState | null = null;
  private open = false;

  constructor(private readonly doings: BarDoings) {}

  /** Makes the buttons anew only where there are to be others. `rest` comes behind them. */
  show(parts: BarParts, state: BarState, rest: Child): void {
    const wanted = JSON.stringify(parts);
    if (wanted !== this.made) {
      this.made = wanted;
      this.element.replaceChildren();
      this.element.append(...this.groups(parts));
    }
    if (rest && rest !== this.element.lastChild) this.element.append(rest as Node);
    this.state = state;
    this.refresh();
  }

  private groups({ words, views, controls, farSide }: BarParts): Node[] {
    const { doings } = this;
    const square = (name: keyof typeof ICONS, label: string, press: () => void, more: Readonly<Record<string, unknown>> = {}) =>
      h("button", { type: "button", class: "square", part: "button", "aria-label": label, title: label, onclick: press, ...more }, icon(name));
    const group = (label: string | null, kind: string, ...children: readonly Child[]) =>
      h("div", { class: `group ${kind}`, part: "group", role: label && "group", "aria-label": label }, ...children);
    const groups: Node[] = [];
    if (views.length > 0) {
      const buttons = views.map((name) =>
        h("button", { type: "button", part: "button", "data-vantage": name, onclick: () => doings.view(name) }, (words as Partial<Record<string, string>>)[name] ?? name),
      );
      groups.push(group(words.lookFrom, views.length > 4 ? "views many" : "views", ...buttons));
    }
    if (!controls) return groups;
    const toggle = (): void => {
      this.open = !this.open;
      this.refresh();
    };
    const looks = LOOK_NAMES.map((name) => h("option", { value: name }, words[name]));
    const choose = (event: Event): void => doings.look((event.target as HTMLSelectElement).value as LookName);
    groups.push(
      group(null, "toggle", square("more", words.more, toggle, { "aria-controls": "more" })),
      h(
        "div",
        { id: "more", class: "more" },
        group(
          words.turnAndZoom,
          "",
          square("left", words.turnLeft, () => doings.step(-TURN_RAD, 1)),
          square("right", words.turnRight, () => doings.step(TURN_RAD, 1)),
          square("further", words.zoomOut, () => doings.step(0, ZOOM)),
          square("closer", words.zoomIn, () => doings.step(0, 1 / ZOOM)),
        ),
        group(
          words.look,
          "",
          h("select", { part: "select", "aria-label": words.lookOfWire, title: words.lookOfWire, onchange: choose }, ...looks),
          square("room", words.shadows, () => doings.room(), { "data-state": "room" }),
          farSide && square("far", words.farSide, () => doings.through(), { "data-state": "through" }),
        ),
      ),
    );
    return groups;
  }

  private refresh(): void {
    const { element, state, open } = this;
    if (!state) return;
    for (const button of element.querySelectorAll<HTMLElement>("[data-vantage]")) setAttribute(button, "aria-pressed", button.dataset["vantage"] === state.view);
    for (const name of ["room", "through"] as const) {
      const button = element.querySelector(`[data-state=${name}]`);
      if (button) setAttribute(button, "aria-pressed", state[name]);
    }
    const select = element.querySelector("select");
    if (select) select.value = state.look;
    element.querySelector(".more")?.classList.toggle("open", open);
    const toggle = element.querySelector(".toggle button");
    if (toggle) setAttribute(toggle, "aria-expanded", open);
  }
}
