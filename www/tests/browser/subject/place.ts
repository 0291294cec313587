/** A place for the elements of one picture, with as much of an app round them as they need. */

import { html, render } from "lit";
import type { Pixels } from "../../../src/engine/protocol";
import type { FoundObject } from "../../../src/tasks/stroke/protocol";
import { readPicture } from "../../../src/state/picture/picture";
import type { Box, MaskStroke, Subject } from "../../../src/tasks/stroke/given";
import { hintsWithBox, hintsWithMark } from "../../../src/tasks/stroke/hints";
import "../../../src/styles.css";
import { startTheme } from "../../../src/ui/shared/theme";
import "../../../src/tasks/stroke/parts/mask-editor";
import type { Brought } from "../../../src/tasks/stroke/parts/subject-events";
import "../../../src/tasks/stroke/parts/subject-pad";
import "./place.css";

interface Doc {
  readonly subject: Subject | null;
}

/** Test's end of it: the document now, and every event that came. */
const place = { subject: null as Subject | null, events: [] as { kind: string; detail: unknown }[], locked: false, busy: false, draw };
Object.assign(window, { place });

const undone: Doc[] = [];
const done: Doc[] = [];
let problem = "";
let editing = false;

function edit(subject: Subject | null): void {
  done.push({ subject: place.subject });
  undone.length = 0;
  place.subject = subject;
}

function step(from: Doc[], to: Doc[]): void {
  const doc = from.pop();
  if (!doc) return;
  to.push({ subject: place.subject });
  place.subject = doc.subject;
}

async function give({ file, name }: Brought): Promise<void> {
  problem = "";
  place.busy = true;
  draw();
  try {
    const { width, height, rgba } = await readPicture(file, name);
    edit({ picture: { name, width, height, rgba: new Blob([rgba]) }, object: 1, strokes: [], found: find({ width, height, rgba }, 1), depth: null });
  } catch (error) {
    problem = (error as Error).message;
  }
  place.busy = false;
}

async function seek(object: number): Promise<void> {
  const { picture } = place.subject!;
  const rgba = new Uint8ClampedArray(await picture.rgba.arrayBuffer());
  edit({ ...place.subject!, object, found: find({ ...picture, rgba }, object) });
}

/** What is not white, in parts that hang together; at half the picture's size. */
function find({ width: fullWidth, height: fullHeight, rgba }: Pixels, object: number): FoundObject | null {
  const [width, height] = [fullWidth >> 1, fullHeight >> 1];
  const dark = (i: number): boolean => {
    const p = 4 * (2 * Math.floor(i / width) * fullWidth + 2 * (i % width));
    return rgba[p + 3]! > 128 && Math.min(rgba[p]!, rgba[p + 1]!, rgba[p + 2]!) < 235;
  };
  const part = new Int32Array(width * height);
  const parts: number[][] = [];
  for (let seed = 0; seed < part.length; seed++) {
    if (part[seed] || !dark(seed)) continue;
    const open = [seed];
    const pixels: number[] = [];
    part[seed] = parts.length + 1;
    for (let i = open.pop(); i !== undefined; i = open.pop()) {
      pixels.push(i);
      const x = i % width;
      for (const n of [x > 0 ? i - 1 : i, x + 1 < width ? i + 1 : i, i - width, i + width]) {
        if (n < 0 || n >= part.length || part[n] || !dark(n)) continue;
        part[n] = parts.length + 1;
        open.push(n);
      }
    }
    if (pixels.length > 60) parts.push(pixels);
  }
  if (parts.length === 0) return null;
  const labels = new Uint8Array(width * height);
  const mask = new Uint8Array(width * height);
  for (const [k, pixels] of parts.sort((a, b) => b.length - a.length).entries()) {
    for (const i of pixels) {
      labels[i] = k + 1;
      mask[i] = k + 1 === object ? 255 : 0;
    }
  }
  return { width, height, mask, labels, count: parts.length, notes: [] };
}

const acts: Readonly<Record<string, (detail: never) => unknown>> = {
  give,
  "give-depth": async ({ file, name }: Brought) => {
    const { width, height, rgba } = await readPicture(file, name);
    edit({ ...place.subject!, depth: { name, width, height, rgba: new Blob([rgba]) } });
  },
  "clear-depth": () => edit({ ...place.subject!, depth: null }),
  "clear-subject": () => edit(null),
  "choose-object": ({ object }: { object: number }) => seek(object),
  "give-box": ({ box }: { box: Box | null }) => edit({ ...place.subject!, ...hintsWithBox(place.subject!, box) }),
  mark: ({ mark }: { mark: MaskStroke }) => edit({ ...place.subject!, ...hintsWithMark(place.subject!, mark) }),
  "clear-marks": () => edit({ ...place.subject!, marks: [] }),
  paint: ({ strokes }: { strokes: readonly MaskStroke[] }) => edit({ ...place.subject!, strokes }),
  "open-brush": () => (editing = true),
  "close-editor": () => (editing = false),
  undo: () => step(done, undone),
  redo: () => step(undone, done),
};
for (const [kind, act] of Object.entries(acts)) {
  addEventListener(kind, async (event) => {
    const { detail } = event as CustomEvent<never>;
    place.events.push({ kind, detail });
    await act(detail);
    draw();
  });
}

function draw(): void {
  const { subject, locked, busy } = place;
  render(
    html`<main><subject-pad .subject=${subject} .busy=${busy} .problem=${problem} ?locked=${locked}></subject-pad></main>
      ${editing && subject
        ? html`<mask-editor .subject=${subject} .undo=${done.length ? "the last change" : null} .redo=${undone.length ? "the last change" : null}></mask-editor>`
        : null}`,
    document.body,
  );
}

startTheme();
draw();
