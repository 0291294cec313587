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

it("counts the file, a copy, and the weights unpacked", () => {
  expect(memoryOf({ bytes: 100, weights: "fp32" })).toBe(300);
  expect(memoryOf({ bytes: 100, weights: "int8" })).toBe(600);
});

it("refuses what a device cannot hold", () => {
  // ViT-B/32 on a phone, in each precision.
  for (const [bytes, weights] of [[351e6, "fp32"], [176e6, "fp16"], [88e6, "int8"]] as const) expect(fault(bytes, weights, 4)).toBe("");
  expect(fault(351e6, "fp32", 1)).toBe("“x.onnx” needs about 1.1 GB of memory to be opened, and this device can spare about 537 MB. Take a smaller model, or a device with more memory.");
  expect(fault(1.7e9, "fp16", 4)).toMatch(/^“x\.onnx” needs about 6\.8 GB/);
  expect(fault(1.7e9, "fp16", 64)).toMatch(/more than a browser can give/);
  expect(fault(1.2e9, "fp32", 8)).toBe("");
});
