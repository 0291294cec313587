/** A few pictures to begin with, drawn by formula on white paper: nothing to load, the same everywhere. */

import { msg } from "@lit/localize";

export interface Sample {
  readonly name: string;
  /** Paints onto a square of one unit, x right, y down. */
  readonly paint: (context: OffscreenCanvasRenderingContext2D) => void;
}

/** Side of a sample, px. */
const SIDE_PX = 512;
const DARK = "#262220";

export const SAMPLES: readonly Sample[] = [
  { name: msg("Ball"), paint: ball },
  { name: msg("Cat"), paint: cat },
  { name: msg("Pear"), paint: pear },
  { name: msg("Mug"), paint: mug },
  { name: msg("Key"), paint: key },
];

/** A sample at some size, to be shown. */
export function paintSample({ paint }: Sample, side = SIDE_PX): OffscreenCanvas {
  const canvas = new OffscreenCanvas(side, side);
  const context = canvas.getContext("2d", { willReadFrequently: true })!;
  context.fillStyle = "#fff";
  context.fillRect(0, 0, side, side);
  context.scale(side, side);
  context.lineCap = "round";
  context.lineJoin = "round";
  paint(context);
  return canvas;
}

/** A sample as a file, as if it had been chosen. */
export function sampleFile(sample: Sample): Promise<Blob> {
  return paintSample(sample).convertToBlob({ type: "image/png" });
}

type Context = OffscreenCanvasRenderingContext2D;

function disc(context: Context, x: number, y: number, across: number, down = across): void {
  context.beginPath();
  context.ellipse(x, y, across, down, 0, 0, 2 * Math.PI);
}

/** Light from the upper left, dark towards the rim. */
function lit(context: Context, x: number, y: number, radius: number, stops: readonly (readonly [number, string])[]): CanvasGradient {
  const gradient = context.createRadialGradient(x - 0.35 * radius, y - 0.4 * radius, 0.05 * radius, x, y, 1.05 * radius);
  for (const [offset, colour] of stops) gradient.addColorStop(offset, colour);
  return gradient;
}

function ball(context: Context): void {
  context.fillStyle = lit(context, 0.5, 0.5, 0.38, [[0, "#e8e1d6"], [0.35, "#a99d8c"], [0.8, "#4a423a"], [1, "#2a2522"]]);
  disc(context, 0.5, 0.5, 0.38);
  context.fill();
}

/** Sitting, seen from behind its tail: one silhouette, its face and a leg as gaps. */
function cat(context: Context): void {
  context.fillStyle = context.strokeStyle = DARK;
  context.lineWidth = 0.075;
  context.beginPath();
  context.moveTo(0.62, 0.85);
  context.bezierCurveTo(0.9, 0.88, 0.95, 0.66, 0.84, 0.56);
  context.stroke();
  context.beginPath();
  context.moveTo(0.27, 0.89);
  context.bezierCurveTo(0.22, 0.68, 0.3, 0.6, 0.33, 0.44);
  context.lineTo(0.56, 0.44);
  context.bezierCurveTo(0.64, 0.55, 0.76, 0.66, 0.72, 0.89);
  context.closePath();
  context.fill();
  disc(context, 0.42, 0.33, 0.19, 0.165);
  context.fill();
  for (const [left, tip, right] of [[0.25, 0.25, 0.4], [0.44, 0.59, 0.59]] as const) {
    context.beginPath();
    context.moveTo(left, 0.3);
    context.lineTo(tip, 0.08);
    context.lineTo(right, 0.28);
    context.closePath();
    context.fill();
  }
  context.fillStyle = context.strokeStyle = "#fff";
  for (const x of [0.35, 0.49]) {
    disc(context, x, 0.32, 0.026, 0.034);
    context.fill();
  }
  context.lineWidth = 0.016;
  context.beginPath();
  context.moveTo(0.38, 0.415);
  context.quadraticCurveTo(0.4, 0.44, 0.42, 0.405);
  context.quadraticCurveTo(0.44, 0.44, 0.46, 0.415);
  context.moveTo(0.4, 0.86);
  context.bezierCurveTo(0.41, 0.76, 0.4, 0.68, 0.37, 0.6);
  context.moveTo(0.58, 0.86);
  context.bezierCurveTo(0.5, 0.8, 0.52, 0.68, 0.62, 0.69);
  context.stroke();
}

function pear(context: Context): void {
  context.strokeStyle = "#4b3621";
  context.lineWidth = 0.035;
  context.beginPath();
  context.moveTo(0.5, 0.22);
  context.quadraticCurveTo(0.5, 0.13, 0.56, 0.08);
  context.stroke();
  context.fillStyle = "#57712c";
  context.beginPath();
  context.moveTo(0.52, 0.18);
  context.bezierCurveTo(0.58, 0.06, 0.74, 0.06, 0.8, 0.14);
  context.bezierCurveTo(0.72, 0.24, 0.6, 0.24, 0.52, 0.18);
  context.fill();
  context.fillStyle = lit(context, 0.5, 0.62, 0.42, [[0, "#eee08e"], [0.4, "#c3b342"], [0.85, "#71741f"], [1, "#4c5016"]]);
  context.beginPath();
  context.moveTo(0.5, 0.19);
  context.bezierCurveTo(0.67, 0.19, 0.62, 0.4, 0.7, 0.5);
  context.bezierCurveTo(0.88, 0.72, 0.74, 0.94, 0.5, 0.93);
  context.bezierCurveTo(0.26, 0.94, 0.12, 0.72, 0.3, 0.5);
  context.bezierCurveTo(0.38, 0.4, 0.33, 0.19, 0.5, 0.19);
  context.fill();
}

/** Its handle is a hole that one looks through. */
function mug(context: Context): void {
  context.strokeStyle = "#8e3b22";
  context.lineWidth = 0.075;
  context.beginPath();
  context.moveTo(0.64, 0.36);
  context.bezierCurveTo(0.94, 0.3, 0.94, 0.72, 0.63, 0.68);
  context.stroke();
  const side = context.createLinearGradient(0.16, 0, 0.68, 0);
  for (const [offset, colour] of [[0, "#a84a2c"], [0.3, "#e08a63"], [0.6, "#b9532f"], [1, "#6d2a16"]] as const) side.addColorStop(offset, colour);
  context.fillStyle = side;
  context.beginPath();
  context.moveTo(0.16, 0.24);
  context.lineTo(0.19, 0.78);
  context.bezierCurveTo(0.2, 0.9, 0.64, 0.9, 0.65, 0.78);
  context.lineTo(0.68, 0.24);
  context.closePath();
  context.fill();
  context.fillStyle = "#c8704b";
  disc(context, 0.42, 0.24, 0.26, 0.085);
  context.fill();
  context.fillStyle = "#3a2015";
  disc(context, 0.42, 0.25, 0.215, 0.058);
  context.fill();
}

/** Flat and thin: a sign rather than a thing. */
function key(context: Context): void {
  context.translate(0.5, 0.5);
  context.rotate(-Math.PI / 4);
  context.translate(-0.5, -0.5);
  context.strokeStyle = DARK;
  context.lineWidth = 0.085;
  disc(context, 0.2, 0.5, 0.14);
  context.stroke();
  context.lineCap = "butt";
  context.beginPath();
  context.moveTo(0.34, 0.5);
  context.lineTo(0.95, 0.5);
  context.moveTo(0.74, 0.5);
  context.lineTo(0.74, 0.66);
  context.moveTo(0.9, 0.5);
  context.lineTo(0.9, 0.69);
  context.stroke();
}
