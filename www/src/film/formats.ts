/** What a film can be saved as in this browser. */

import type { Size } from "#sculpture/film/darkroom";

export type FilmFormat = "mp4" | "webm" | "gif";

/** A format, and for a video the codec in it as browsers write it. */
export interface Choice {
  readonly format: FilmFormat;
  readonly codec: string;
}

export const GIF: Choice = { format: "gif", codec: "" };
export const VIDEO_FPS = 30;
/** A GIF counts in hundredths of a second. */
export const GIF_FPS = 20;
export const fpsOf = ({ format }: Choice): number => (format === "gif" ? GIF_FPS : VIDEO_FPS);

/** The longer side, pixels: what players take, and what a GIF can be without being larger than a film. */
const MOST_PX: Readonly<Record<FilmFormat, number>> = { mp4: 1920, webm: 1920, gif: 480 };

/** Bits for each pixel of each frame: thin lines before soft walls stay clean. */
const BITS_A_PIXEL = 0.12;

/** The size a film of that format has: no larger than it can be, in the same shape, and even, as codecs want it. */
export function sizeFor({ format }: Choice, { width, height }: Size): Size {
  const scale = Math.min(1, MOST_PX[format] / Math.max(width, height));
  const even = (px: number): number => Math.max(2, 2 * Math.round((px * scale) / 2));
  return { width: even(width), height: even(height) };
}

export function encoderConfig({ codec }: Choice, { width, height }: Size): VideoEncoderConfig {
  return { codec, width, height, framerate: VIDEO_FPS, bitrate: Math.round(BITS_A_PIXEL * width * height * VIDEO_FPS), latencyMode: "quality" };
}

/** From the one that plays everywhere to the one that few know; of each the lowest level that does for 1920 x 1920 at 30 a second. */
const VIDEOS: readonly Choice[] = [
  { format: "mp4", codec: "avc1.640032" },
  { format: "mp4", codec: "avc1.4d0032" },
  { format: "mp4", codec: "avc1.420032" },
  { format: "webm", codec: "vp09.00.50.08" },
  { format: "webm", codec: "av01.0.12M.08" },
  { format: "webm", codec: "vp8" },
];

/** The first that this browser makes of that size; GIF where it makes none. */
export async function bestChoice(size: Size): Promise<Choice> {
  if (typeof VideoEncoder !== "function") return GIF;
  for (const choice of VIDEOS) {
    try {
      if ((await VideoEncoder.isConfigSupported(encoderConfig(choice, sizeFor(choice, size)))).supported) return choice;
    } catch {
      // Never heard of: the same as not supported.
    }
  }
  return GIF;
}

/** Why it is that format, for people. */
export function formatWords({ format }: Choice, forced: boolean): string {
  if (format === "mp4") return "MP4: plays nearly everywhere.";
  if (format === "webm") return "WebM: this browser makes no MP4. It plays in browsers and in most apps.";
  return forced ? "GIF: moves wherever a picture can be put, at most 480 pixels and 256 colours." : "GIF: this browser makes no video. At most 480 pixels and 256 colours.";
}
