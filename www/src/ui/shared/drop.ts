/** Files that a pad is given: chosen, or one picture dropped onto it; all else is for the page to see to. */

import { css, type ReactiveController, type ReactiveControllerHost } from "lit";

/** The file that was chosen, if any; the same one may be chosen again. */
export function chosenFile(event: Event): File | undefined {
  const input = event.target as HTMLInputElement;
  const file = input.files?.[0];
  input.value = "";
  return file;
}

/** A pad onto which one picture may be dropped; what comes with more is for the page to share out. */
export class Landing implements ReactiveController {
  /** Whether something is held over it. */
  over = false;

  constructor(
    private readonly host: ReactiveControllerHost,
    private readonly pad: { isLocked(): boolean; give(file: File): void },
  ) {
    host.addController(this);
  }

  /** Needed to be a controller. */
  hostConnected(): void {}

  readonly dragOver = (event: DragEvent): void => {
    if (this.pad.isLocked() || !event.dataTransfer?.types.includes("Files")) return;
    event.preventDefault();
    event.dataTransfer.dropEffect = "copy";
    this.show(true);
  };

  readonly dragLeave = (): void => this.show(false);

  readonly drop = (event: DragEvent): void => {
    this.show(false);
    const files = event.dataTransfer?.files;
    if (this.pad.isLocked() || files?.length !== 1 || !files[0]!.type.startsWith("image/")) return;
    // Nobody else gets it.
    event.preventDefault();
    event.stopPropagation();
    this.pad.give(files[0]!);
  };

  private show(over: boolean): void {
    this.over = over;
    this.host.requestUpdate();
  }
}

/** What was wrong with the last picture, over the lower part of its pad, with a button to close it. */
export const problemOver = css`
  .problem {
    position: absolute;
    inset-inline: 0;
    inset-block-end: 0;
    max-height: 100%;
    margin: 0;
    padding: 8px;
    padding-inline-end: 40px;
    overflow: auto;
    border-block-start: 2px solid var(--error);
    background: var(--raised);
    color: var(--error);
    overflow-wrap: anywhere;
  }
  .problem button {
    position: absolute;
    inset-block-start: 0;
    inset-inline-end: 0;
    min-height: 40px;
  }
`;
