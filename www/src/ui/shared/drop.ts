/** Files that a pad is given: chosen, or one picture dropped onto it; all else is for the page to see to. */

import { css } from "lit";

/** The file that was chosen, if any; the same one may be chosen again. */
export function chosenFile(event: Event): File | undefined {
  const input = event.target as HTMLInputElement;
  const file = input.files?.[0];
  input.value = "";
  return file;
}

/** Whether something that can be dropped is held over a part that takes it; says so to the browser. */
export function isDropOver(event: DragEvent): boolean {
  if (!event.dataTransfer?.types.includes("Files")) return false;
  event.preventDefault();
  event.dataTransfer.dropEffect = "copy";
  return true;
}

/** The picture, if one was dropped and nothing with it; then nobody else gets it. */
export function droppedPicture(event: DragEvent): File | null {
  const files = event.dataTransfer?.files;
  if (files?.length !== 1 || !files[0]!.type.startsWith("image/")) return null;
  event.preventDefault();
  event.stopPropagation();
  return files[0]!;
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
