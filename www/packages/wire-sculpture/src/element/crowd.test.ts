import { expect, it } from "vitest";
import { join, leave, settle, type Member } from "./crowd";

class Visitor implements Member {
  seen = true;
  rests = false;
  awake = false;
  wake(): void {
    this.awake = true;
  }
  async rest(): Promise<void> {
    await Promise.resolve();
    this.awake = false;
  }
}

it("never has more than eight awake, lets those rest first that nobody sees, and wakes everybody once", async () => {
  const visitors = Array.from({ length: 12 }, () => new Visitor());
  const awake = (): number => visitors.filter((visitor) => visitor.awake).length;
  visitors.forEach(join);
  expect(visitors.map((visitor) => visitor.awake)).toEqual([...Array<boolean>(8).fill(true), ...Array<boolean>(4).fill(false)]);
  // Nobody gives way before it has been drawn.
  settle();
  expect(visitors[8]!.awake).toBe(false);
  visitors[3]!.seen = false;
  for (const visitor of visitors) visitor.rests = true;
  const woken = new Set(visitors.filter((visitor) => visitor.awake));
  settle();
  for (let turn = 0; turn < 10; turn++) {
    await Promise.resolve();
    visitors.filter((visitor) => visitor.awake).forEach((visitor) => woken.add(visitor));
    expect(awake()).toBeLessThanOrEqual(8);
  }
  expect(woken.size).toBe(12);
  expect(visitors[3]!.awake).toBe(false);
  // Who leaves makes room.
  join(visitors[3]!);
  leave(visitors[11]!);
  await new Promise((done) => setTimeout(done));
  expect(visitors[3]!.awake).toBe(true);
  visitors.forEach(leave);
});
