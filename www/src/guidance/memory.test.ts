import { expect, it } from "vitest";
import { memoryOf, refuseTooLarge } from "./memory";

const fault = (bytes: number, weights: "fp32" | "fp16" | "int8", gib: number): string => {
  try {
    refuseTooLarge("x.onnx", { bytes, weights }, gib);
    return "";
  } catch (error) {
    return (error as Error).message;
  }
};

it("counts the file and what the runtime makes of it", () => {
  // Measured in Chromium, the file in MB and the runtime's memory in MiB, from a vision transformer of 59 M numbers.
  for (const [bytes, weights, runtimeMib] of [[237.9e6, "fp32", 980], [59.8e6, "int8", 993]] as const) {
    const measured = bytes + runtimeMib * 2 ** 20;
    expect(memoryOf({ bytes, weights })).toBeGreaterThan(0.95 * measured);
    expect(memoryOf({ bytes, weights })).toBeLessThan(1.2 * measured);
  }
});

it("refuses what a device cannot hold", () => {
  // ViT-B/32 on a device of 4 GiB, in each precision.
  for (const [bytes, weights] of [[351e6, "fp32"], [176e6, "fp16"], [88e6, "int8"]] as const) expect(fault(bytes, weights, 4)).toBe("");
  expect(fault(351e6, "fp32", 2)).toBe("“x.onnx” needs about 1.9 GB of memory to be opened, and this device can spare about 1.1 GB. Take a smaller model, or a device with more memory.");
  // A diffusion model's denoiser.
  expect(fault(1.7e9, "fp16", 64)).toMatch(/^“x\.onnx” needs about 17 GB .* more than a browser can give/);
  expect(fault(0.4e9, "fp16", 8)).toBe("");
});
