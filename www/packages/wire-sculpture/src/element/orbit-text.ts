/** `camera-orbit`: "35deg 20deg 105%", which is azimuth, elevation and distance, as a share of where all is seen. */

import type { Heading } from "../scene/directions";

const ANGLE = /^(-?\d*\.?\d+)(deg|rad)?$/;
const SHARE = /^(\d*\.?\d+)%$/;

/** Null for what is none. */
export function orbitOf(text: string): Heading | null {
  const [azimuth, elevation, distance = "auto"] = text.trim().toLowerCase().split(/\s+/);
  const [azimuthRad, elevationRad] = [angle(azimuth), angle(elevation)];
  const share = SHARE.exec(distance)?.[1];
  if (azimuthRad === null || elevationRad === null || !(share || distance === "auto")) return null;
  const away = share ? Math.max(0.1, Math.min(5, Number(share) / 100)) : 1;
  return { azimuthRad, elevationRad: Math.max(-1.45, Math.min(Math.PI / 2, elevationRad)), away, wide: true };
}

function angle(text = ""): number | null {
  const [, number, unit] = ANGLE.exec(text) ?? [];
  return number === undefined ? null : Number(number) * (unit === "rad" ? 1 : Math.PI / 180);
}
