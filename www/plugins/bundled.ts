/** A script and all it imports as one text. */

import { build } from "vite";

export async function bundled(entry: string, define: Readonly<Record<string, string>> = {}): Promise<string> {
  const built = await build({
    configFile: false,
    logLevel: "error",
    publicDir: false,
    define,
    build: { write: false, target: "es2022", minify: true, rolldownOptions: { input: entry, output: { codeSplitting: false } }, modulePreload: false },
  });
  const { output } = (Array.isArray(built) ? built[0]! : built) as { output: { type: string; code?: string; fileName: string }[] };
  const [chunk, ...more] = output;
  if (chunk?.code === undefined || more.length > 0) throw new Error(`${entry} must be one script; it came as ${output.map(({ fileName }) => fileName).join(", ")}`);
  return chunk.code;
}
