/** Where the small diffusion model lies, if the page is built with it. */

const [model] = Object.values(import.meta.glob<string>("../../../tools/iconnet/weights/iconnet-denoiser.onnx", { query: "?url", import: "default", eager: true }));
const [sidecar] = Object.values(import.meta.glob<string>("../../../tools/iconnet/weights/iconnet-denoiser.json", { query: "?url", import: "default", eager: true }));
const [bytes] = Object.values(import.meta.glob<number>("../../../tools/iconnet/weights/iconnet-denoiser.json", { import: "bytes", eager: true }));

/** Null where it is not. */
export const DENOISER_FILES = model && sidecar && bytes ? { model, sidecar, bytes } : null;
