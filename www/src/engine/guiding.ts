/** Lays words over a run: each view's, as networks know them. */

import type { WireShape } from "#sculpture/scene/shape";
import { GuidanceError } from "../guidance/fault";
import type { Diffuser } from "../guidance/diffusers";
import type { Readers } from "../guidance/readers";
import type { CoreRun, WordsOptions } from "./core";
import { DENOISER, ICONS, type Guide } from "./protocol";
import type { Ears } from "./task-engine";

/** Who guides, when, and how a person hears of it. */
interface Guided extends Pick<Ears, "tell"> {
  readonly run: CoreRun;
  readonly guide: Guide;
  /** The run's first wire, where the run is resumed. */
  readonly first: WireShape | null;
  notice(words: string): void;
  service(): Promise<typeof import("../guidance/service")>;
}

/** A GuidanceError where nothing can guide: no network, or none of its words. */
export async function guideByWords({ run, guide, first, tell, notice, service }: Guided): Promise<void> {
  const { words, weight, by, likePicture = false } = guide;
  const views = run.pads();
  const wanted = views.map((view) => words[view]?.trim() ?? "");
  if (weight <= 0 || !(likePicture || wanted.some(Boolean))) return;
  const progress = (share: number): void => tell("Fetching what knows words…", share);
  const knowing = await (by === ICONS ? icons(progress) : by === DENOISER ? denoiser(progress) : (await service()).guiding(by, progress));
  const vectors = await Promise.all(wanted.map((word) => (word ? knowing.vector(word) : null)));
  wanted.forEach((word, view) => {
    if (word && !vectors[view]) notice(`“${word}” (${views[view]}) is no word that guides here. ${knowing.instead(word)}`);
  });
  // A diffusion model compares no pictures.
  if (!vectors.some(Boolean) && (!likePicture || "denoiser" in knowing)) throw new GuidanceError("", "None of the words could guide the wire.");
  if ("denoiser" in knowing) run.guideByDiffusion(weight, knowing, vectors);
  else run.guideByWords(weight, knowing.networks, knowing.networks.map(() => vectors), { ...(await how(guide, knowing, first ?? run.frame().wire)), likePicture });
}

const icons = async (progress: (share: number) => void): Promise<Readers> => (await import("../guidance/icons")).icons(progress);
const denoiser = async (progress: (share: number) => void): Promise<Diffuser> => (await import("../guidance/denoiser")).denoiser(progress);

/** By patches, where that is asked of a network of one's own: each departs from the first wire as the words do from neutral ones. */
async function how({ by, look, neutral = "" }: Guide, { networks, vector, instead }: Readers, from: WireShape): Promise<WordsOptions> {
  if (by === ICONS || look !== "patches") return {};
  if (!neutral.trim()) return { look };
  const vectorOfNone = await vector(neutral.trim());
  if (!vectorOfNone) throw new GuidanceError("", `“${neutral}”, which the words are to differ from, is no word that guides here. ${instead(neutral)}`);
  const wire = { closed: from.closed, knots: Float64Array.from(from.knots), controlPoints: Float32Array.from(from.controlPoints) };
  return { look, neutral: networks.map(() => vectorOfNone), from: wire };
}
