/** The Khronos glTF validator, and what it says in short. */

import { validateBytes } from "gltf-validator";

export interface GlbReport {
  readonly errors: number;
  /** Errors and warnings. */
  readonly messages: readonly string[];
  readonly triangles: number;
}

export async function validateGlb(bytes: Uint8Array): Promise<GlbReport> {
  const report = await validateBytes(new Uint8Array(bytes), { maxIssues: 20 });
  return {
    errors: report.issues.numErrors,
    messages: report.issues.messages.filter(({ severity }) => severity <= 1).map(({ code, message }) => `${code}: ${message}`),
    triangles: report.info?.totalTriangleCount ?? 0,
  };
}
