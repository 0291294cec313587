/** The small diffusion model that comes with the page, where the page was built with it. Fetched when somebody wants it; then it stays. */

import { DENOISER_FILES } from "./denoiser-files";
import { diffuserOf } from "./diffusers";
import { GuidanceError } from "./fault";
import { once, opened } from "./shipped";

export const denoiser = once(async (progress) => {
  if (!DENOISER_FILES) throw new GuidanceError("", "This page came without a diffusion model. Choose the networks that know icons.");
  return diffuserOf(await opened({ kind: "eps-v1", name: "iconnet-denoiser", prefer: "wasm", ...DENOISER_FILES }, progress), null, null);
});
