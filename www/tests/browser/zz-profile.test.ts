import { it } from "vitest";
import { example, openEngine } from "./engine";
const { made } = await openEngine();
const matePrelude = `
let t0 = 0, n = 0; const work = [0,0,0,0]; let idle = 0, last = performance.now();
self.addEventListener("message", () => { t0 = performance.now(); idle += t0 - last; });
const post = self.postMessage.bind(self);
self.postMessage = (m, t) => { const t1 = performance.now(); work[n++ % 3] += t1 - t0; last = t1; post(m, t); if (n % 300 === 0) { new BroadcastChannel("prof").postMessage({ who: "mate", n, idle, work: work.map(Math.round), bytes: m && m.length }); idle = 0; work.fill(0); } };
`;
const prelude = `
Object.defineProperty(navigator, "hardwareConcurrency", { value: 2 });
const W = self.Worker; const module = (text) => URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
const at = () => performance.now().toFixed(0);
const pm = self.postMessage.bind(self); self.postMessage = (m, t) => { if (m.news === "targets" || m.news === "place" || (m.news === "progress" && /Measur/.test(m.words))) console.log("engine " + m.news + " at " + at()); if (m.news === "frame" || m.news === "snapshot") { } pm(m, t); };
let n = 0;
self.Worker = class extends W {
  constructor(url, o) { super(url, o); console.log("engine starts mate at " + at()); let first = true;
    this.addEventListener("message", ({ data }) => { if (!data) console.log("engine hears ready at " + at()); else if (first) { first = false; console.log("engine first answer at " + at()); } });
  }
  postMessage(m, t) { if (m instanceof Uint8Array && n++ % 300 === 0) console.log("engine asks " + n + " at " + at()); super.postMessage(m, t); }
};
const ch = new BroadcastChannel("prof"); ch.onmessage = ({ data }) => console.log(JSON.stringify(data));
`;
it("profiles", { timeout: 300_000 }, async () => {
  const m = await made(example("multiview", { preset: process.env["ORDERS"] ?? "fast", backend: "cpu" }), prelude);
  console.log(m.fitS, m.workers);
});
