/** The part of the package that the tests use; it brings no types of its own. */
declare module "gltf-validator" {
  interface Report {
    issues: { numErrors: number; messages: { code: string; message: string; severity: number }[] };
    info?: { totalTriangleCount?: number };
  }
  export function validateBytes(bytes: Uint8Array, options?: { maxIssues?: number }): Promise<Report>;
}
