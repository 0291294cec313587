/** What is used here of the element. */

import type { Picture } from "./messages";

export interface Sculpture extends HTMLElement {
  getState(): unknown;
  setState(state: object): void;
  flyTo(view: string): void;
  play(): void;
  pause(): void;
  toBlob(picture: Picture): Promise<Blob>;
}
