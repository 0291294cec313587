import { afterEach, describe, expect, it, vi } from "vitest";
import { bestChoice, encoderConfig, formatWords, fpsOf, GIF, sizeFor } from "./formats";

const WIDE = { width: 1920, height: 1080 };
/** A browser that makes videos of these codecs, or throws at what it never heard of. */
function encoding(known: readonly string[], throws = false): void {
  vi.stubGlobal(
    "VideoEncoder",
    class {
      static async isConfigSupported(config: VideoEncoderConfig): Promise<{ supported: boolean }> {
        const supported = known.some((codec) => config.codec.startsWith(codec));
        if (!supported && throws) throw new TypeError("unknown codec");
        return { supported };
      }
    },
  );
}
afterEach(() => void vi.unstubAllGlobals());

describe("the format of a film", () => {
  it("is an MP4 where there is H.264, else a WebM, and a GIF where there is nothing", async () => {
    encoding(["avc1", "vp09"]);
    expect((await bestChoice(WIDE)).format).toBe("mp4");
    encoding(["vp09", "vp8"]);
    expect(await bestChoice(WIDE)).toMatchObject({ format: "webm", codec: "vp09.00.50.08" });
    encoding(["av01"], true);
    expect(await bestChoice(WIDE)).toMatchObject({ format: "webm", codec: "av01.0.12M.08" });
    encoding([], true);
    expect(await bestChoice(WIDE)).toBe(GIF);
    vi.unstubAllGlobals();
    expect(await bestChoice(WIDE)).toBe(GIF);
  });

  it("says why in a sentence", () => {
    expect(formatWords({ format: "mp4", codec: "" }, false)).toMatch(/MP4/);
    expect(formatWords({ format: "webm", codec: "" }, false)).toMatch(/no MP4/);
    expect(formatWords(GIF, false)).toMatch(/makes no video/);
    expect(formatWords(GIF, true)).not.toMatch(/makes no video/);
  });

  it("keeps the shape and has even sides, no larger than it can be", () => {
    const mp4 = { format: "mp4", codec: "avc1.640032" } as const;
    expect(sizeFor(mp4, WIDE)).toEqual(WIDE);
    expect(sizeFor(mp4, { width: 1081, height: 333 })).toEqual({ width: 1082, height: 334 });
    expect(sizeFor(mp4, { width: 4096, height: 64 })).toEqual({ width: 1920, height: 30 });
    expect(sizeFor(GIF, { width: 1080, height: 1920 })).toEqual({ width: 270, height: 480 });
    expect(encoderConfig(mp4, WIDE).bitrate).toBeLessThan(10e6);
    // A hundredth of a second is the least a GIF can count.
    expect(Number.isInteger(100 / fpsOf(GIF))).toBe(true);
  });
});
