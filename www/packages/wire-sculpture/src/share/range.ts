/**
 * Reads an adaptive binary range code. Twin of the reading half of `src/export/share/range.rs`: same names, same order,
 * and 32-bit arithmetic done in doubles, which hold every product of it exactly.
 */

/** The code says something no wire has. */
export class Nonsense extends Error {}

/** A model never moves by less than about 1 in this many. */
const SLOWEST = 40;
const LEAST_RANGE = 2 ** 24;

/** Probabilities that bits are 1, in 65536ths, learned as they go; the first bits seen count most. */
export class Models {
  readonly one: Uint16Array;
  readonly seen: Uint8Array;

  constructor(count: number) {
    this.one = new Uint16Array(count).fill(1 << 15);
    this.seen = new Uint8Array(count);
  }
}

/** Where the parts of a number lie among its models: a tree of lengths, three high bits for each length, the sign. */
const HIGH = 32;
const SIGN = HIGH + 3 * 32;
export const numberModels = (): Models => new Models(SIGN + 1);

/** Anything that is no code gives nonsense but never fails. */
export class RangeDecoder {
  private next = 0;
  private code = 0;
  private range = 0xffffffff;

  constructor(private readonly bytes: Uint8Array) {
    for (let i = 0; i < 4; i++) this.shift();
  }

  /** A bit whose probability is learned. */
  bit(models: Models, index: number): boolean {
    const one = models.one[index]!;
    const seen = models.seen[index]!;
    const bit = this.split(Math.max(24, Math.min(4096 - 24, one >> 4)), 12);
    const step = ((((bit ? 65_535 : 0) - one) * 2) / (2 * seen + 3)) | 0;
    models.one[index] = Math.max(0, Math.min(65_535, one + step));
    models.seen[index] = Math.min(SLOWEST, seen + 1);
    return bit;
  }

  /** A bit as likely as not. */
  flag(): boolean {
    return this.split(2048, 12);
  }

  /** `count` bits, all as likely as not; at most 53. */
  bits(count: number): number {
    let read = 0;
    for (let k = 0; k < count; k++) read = read * 2 + (this.flag() ? 1 : 0);
    return read;
  }

  /** Any whole number, its length first. */
  whole(): bigint {
    const length = Math.min(64, this.bits(7));
    const high = Math.max(0, length - 32);
    return (BigInt(this.bits(high)) << 32n) + BigInt(this.bits(Math.min(32, length)));
  }

  /** A number that is often small; `models` learn how small. Its magnitude stays below 2^31. */
  number(models: Models): number {
    let node = 1;
    for (let k = 0; k < 5; k++) node = (node << 1) | (this.bit(models, node) ? 1 : 0);
    const length = node & 31;
    if (length === 0) return 0;
    const high = HIGH + 3 * length;
    let read = 1;
    for (let k = 0; k < length - 1; k++) {
      // The two bits after the leading one still have a shape; what follows is noise.
      const bit = k === 0 ? this.bit(models, high) : k === 1 ? this.bit(models, high + 1 + (read & 1)) : this.flag();
      read = (read << 1) | (bit ? 1 : 0);
    }
    return this.bit(models, SIGN) ? -read : read;
  }

  /** Whether more was read than there is: zeros at the end were left out, so a few more are no proof. */
  get exhausted(): boolean {
    return this.next > this.bytes.length + 64;
  }

  /** A bit that is 1 with a probability of `one` in 2^`precision`. */
  split(one: number, precision: number): boolean {
    const bound = (this.range >>> precision) * one;
    const bit = this.code < bound;
    if (bit) {
      this.range = bound;
    } else {
      this.code -= bound;
      this.range -= bound;
    }
    while (this.range < LEAST_RANGE) {
      this.range *= 256;
      this.shift();
    }
    return bit;
  }

  private shift(): void {
    this.code = ((this.code << 8) | (this.bytes[this.next++] ?? 0)) >>> 0;
  }
}
