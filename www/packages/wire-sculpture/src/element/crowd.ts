/**
 * Sculptures that are drawn at the same time. A browser gives a page about sixteen contexts for drawing in 3D and then
 * takes the oldest away, so only a few have one; the others show the last that was seen of them.
 */

const MOST = 8;

export interface Member {
  /** Whether it is on the screen. */
  readonly seen: boolean;
  /** Whether it has been drawn, and nobody holds it: then it may rest. */
  readonly rests: boolean;
  /** To take a context. */
  wake(): void;
  /** To give it back; resolves when it has. */
  rest(): Promise<void>;
}

/** The longest there first. */
const awake: Member[] = [];
const waiting: Member[] = [];
let leaving = 0;

/** Wakes it as soon as there is room. One that is awake counts as just come. */
export function join(member: Member): void {
  const at = awake.indexOf(member);
  if (at >= 0) awake.push(...awake.splice(at, 1));
  else if (!waiting.includes(member)) waiting.push(member);
  settle();
}

/** It wants none any more, or has given its own back. */
export function leave(member: Member): void {
  for (const list of [awake, waiting]) {
    const at = list.indexOf(member);
    if (at >= 0) list.splice(at, 1);
  }
  settle();
}

/** To be called when a member may rest that could not before. */
export function settle(): void {
  while (waiting.length > 0 && awake.length + leaving < MOST) {
    const next = waiting.shift()!;
    awake.push(next);
    next.wake();
  }
  for (let missing = waiting.length - leaving; missing > 0; missing--) {
    const last = awake.find(({ seen, rests }) => rests && !seen) ?? awake.find(({ rests }) => rests);
    if (!last) return;
    awake.splice(awake.indexOf(last), 1);
    leaving++;
    void last.rest().finally(() => {
      leaving--;
      settle();
    });
  }
}
