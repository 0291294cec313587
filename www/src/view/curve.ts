/** A falling loss as the path of an SVG. */

/**
 * Logarithmic upwards; at most one point every other unit of width, however long the run. The whole width is
 * `iterations` long, so that the curve grows to the right and does not shrink as it comes.
 */
export function curve(
  losses: readonly (readonly [iteration: number, loss: number])[],
  iterations: number,
  width: number,
  height: number,
): string {
  const every = Math.max(1, Math.ceil(losses.length / (width / 2)));
  const kept = losses.filter((_, i) => i % every === 0 || i === losses.length - 1);
  const logs = kept.map(([, loss]) => Math.log10(Math.max(loss, 1e-9)));
  const [low, high] = [Math.min(...logs), Math.max(...logs)];
  return kept
    .map(([iteration], i) => {
      const x = (iteration / Math.max(1, iterations)) * width;
      const y = 3 + (1 - (logs[i]! - low) / Math.max(1e-6, high - low)) * (height - 8);
      return `${i ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`;
    })
    .join("");
}
