/** What a file should answer to inputs made by a formula: a runtime that is off by more than the tolerance must not be used for it. */

import { count, type Contract, type Port } from "./contract";
import { cosine, norm, signed, sketch, uniform, unitRows } from "./noise";
import type { Case, Expected, Fill, Selftest } from "./sidecar";

export type Numbers = Float32Array<ArrayBuffer> | Int32Array<ArrayBuffer>;

/** All inputs of a case. */
export function feedsOf({ inputs }: Case, contract: Contract, batch: number): Record<string, Numbers> {
  return Object.fromEntries(contract.inputs.map((port) => [port.name, filled(inputs[port.name]!, port, batch)]));
}

function filled(how: Fill, { shape, dtype }: Port, batch: number): Numbers {
  const [length, width] = [count(shape, batch), count(shape.slice(-1), batch)];
  const values = (): Float32Array<ArrayBuffer> => {
    switch (how.fill) {
      case "uniform":
        return uniform(how.seed, length);
      case "signed":
        return signed(how.seed, length);
      case "unit":
        return unitRows(how.seed, length, width);
      case "constant":
        return new Float32Array(length).fill(how.value);
      case "count":
        return Float32Array.from({ length }, (_, i) => how.first + (i % width));
    }
  };
  return dtype === "int32" ? Int32Array.from(values()) : values();
}

/** What is off in the first output that is, as a sentence; null if the runtime behind `run` may be used. */
export async function selftestFault(
  { cases, batch, tolerance }: Selftest,
  contract: Contract,
  run: (feeds: Record<string, Numbers>) => Promise<Readonly<Record<string, Numbers>>>,
): Promise<string | null> {
  for (const one of cases) {
    const answers = await run(feedsOf(one, contract, batch));
    for (const { name } of contract.outputs) {
      const fault = off(one.outputs[name]!, answers[name]!, tolerance);
      if (fault) return `in the case “${one.name}” ${name} ${fault}`;
    }
  }
  return null;
}

function off(expected: Expected, answer: Numbers, tolerance: Selftest["tolerance"]): string | null {
  if (!isFinite(answer)) return "has numbers that are not finite";
  if ("values" in expected) {
    const { values } = expected;
    const most = values.reduce((most, value, i) => Math.max(most, Math.abs(value - answer[i]!)), 0);
    const allowed = tolerance.absolute + tolerance.relative * values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
    return most <= allowed ? null : `is off by ${most.toPrecision(3)}, and ${allowed.toPrecision(3)} is allowed`;
  }
  const length = norm(answer);
  if (!(Math.abs(length - expected.l2) <= tolerance.relative * expected.l2)) return `has length ${length.toPrecision(4)} and should have ${expected.l2.toPrecision(4)}`;
  const alike = cosine(sketch(answer), expected.sketch);
  return alike >= tolerance.cosine ? null : `points elsewhere (cosine ${alike.toFixed(5)}, and ${tolerance.cosine} is the least)`;
}

export function isFinite(numbers: Numbers): boolean {
  return numbers.every((value: number) => Number.isFinite(value));
}
