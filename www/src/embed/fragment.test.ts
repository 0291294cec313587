import { describe, expect, it } from "vitest";
import { readEmbed, readOrigin } from "./fragment";

const BASE = "https://example.org/wire/embed.html";
const read = (hash: string) => readEmbed(hash, BASE);

describe("readEmbed", () => {
  it("gives the element its attributes", () => {
    expect(read("#w=AbC-_9&look=steel&color=%23123456&shadow&auto-rotate=on&view=side&camera-orbit=35deg%2020deg%20105%25")).toEqual({
      code: "AbC-_9", look: "steel", color: "#123456", shadow: "", "auto-rotate": "", view: "side", "camera-orbit": "35deg 20deg 105%", "camera-controls": "",
    });
  });

  it("switches off what is said to be off", () => {
    for (const off of ["off", "false", "0", "no"]) expect(read(`#shadow=${off}&camera-controls=${off}`)).toEqual({});
  });

  it("takes files from here and from elsewhere, and nothing else by an address", () => {
    expect(read("#src=works/bird.glb")["src"]).toBe("https://example.org/wire/works/bird.glb");
    expect(read("#src=https://elsewhere.example/bird.glb")["src"]).toBe("https://elsewhere.example/bird.glb");
    for (const bad of ["javascript:alert(1)", "data:text/html,<b>", "file:///etc/passwd", "blob:https://example.org/x", "https://me:secret@example.org/", "https://", ""]) {
      expect(read(`#src=${encodeURIComponent(bad)}&poster=${encodeURIComponent(bad)}`)).toEqual({ "camera-controls": "" });
    }
  });

  it("leaves out what it does not know, and what is endless", () => {
    expect(read("#onload=alert(1)&style=color:red&class=x&__proto__=y&constructor=z&innerHTML=%3Cb%3E&w=A")).toEqual({ code: "A", "camera-controls": "" });
    expect(read(`#alt=${"a".repeat(5000)}&w=${"A".repeat(2 ** 20 + 1)}`)).toEqual({ "camera-controls": "" });
    for (const odd of ["", "#", "#&&=&%", "#%E0%A4%A", "#w", "#=w"]) expect(() => read(odd)).not.toThrow();
  });
});

describe("readOrigin", () => {
  it("takes one whole origin", () => {
    expect(readOrigin("?origin=https://example.org")).toBe("https://example.org");
    expect(readOrigin("?origin=http%3A%2F%2F127.0.0.1%3A8080")).toBe("http://127.0.0.1:8080");
  });

  it("takes nothing less, and nothing more", () => {
    for (const bad of ["", "?origin=", "?origin=*", "?origin=null", "?origin=example.org", "?origin=https://example.org/", "?origin=https://a@example.org", "?origin=file://", "?origin=javascript:1"]) {
      expect(readOrigin(bad)).toBeNull();
    }
  });
});
