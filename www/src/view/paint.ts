/** Flat pictures on a 2D canvas: ink, and a wire as one view shows it. */

import type { Samples } from "#sculpture/scene/shape";
import type { Ink, View } from "../engine/protocol";
import { project } from "./project";

/** Of small pictures: drawn by the processor, which is done before a graphics card has been asked. */
export const PLAIN: CanvasRenderingContext2DSettings = { willReadFrequently: true };

/** Ink as opacity of one colour, at the ink's own size. */
export function paintInk(canvas: HTMLCanvasElement, ink: Ink, colour: string, strength = 1): void {
  canvas.width = ink.width;
  canvas.height = ink.height;
  const context = canvas.getContext("2d", PLAIN)!;
  const pixels = context.createImageData(ink.width, ink.height);
  const { data } = pixels;
  for (let i = 0; i < ink.ink.length; i++) data[4 * i + 3] = strength * ink.ink[i]!;
  context.putImageData(pixels, 0, 0);
  context.globalCompositeOperation = "source-in";
  context.fillStyle = colour;
  context.fillRect(0, 0, ink.width, ink.height);
  context.globalCompositeOperation = "source-over";
}

/** Samples between two rests. */
const AT_ONCE = 300;

/**
 * The wire in a view, over what is on the canvas already, a little at a time: it may rest at every `yield`. Pieces of
 * about the same width share one stroke.
 */
export function* paintWire(context: CanvasRenderingContext2D, samples: Samples, view: View, height_px: number, colour: string): Generator<void, void> {
  const pixels = project(samples, view, height_px);
  context.strokeStyle = colour;
  context.lineCap = "round";
  context.lineJoin = "round";
  for (const { first, last, closed } of samples.strips) {
    let width = -1;
    const count = closed ? last - first + 1 : last - first;
    for (let i = 0; i < count; i++) {
      const a = 3 * (first + i);
      const b = 3 * (i === last - first ? first : first + i + 1);
      const here = Math.max(0.5, pixels[a + 2]! + pixels[b + 2]!);
      if (Math.abs(here - width) > 0.12 * width || i % AT_ONCE === 0) {
        if (i > 0) context.stroke();
        if (i > 0 && i % AT_ONCE === 0) yield;
        width = here;
        context.lineWidth = width;
        context.beginPath();
        context.moveTo(pixels[a]!, pixels[a + 1]!);
      }
      context.lineTo(pixels[b]!, pixels[b + 1]!);
    }
    if (count > 0) context.stroke();
  }
}
