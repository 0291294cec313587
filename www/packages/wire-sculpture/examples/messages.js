// The frame's address says who may talk to it: embed.html?origin=https://my-site.example#w=…
const frame = document.querySelector("iframe");
const home = new URL(frame.src).origin;

addEventListener("message", ({ origin, source, data }) => {
  if (origin !== home || source !== frame.contentWindow || data.from !== "wire-sculpture") return;
  if (data.event === "load") frame.contentWindow.postMessage({ to: "wire-sculpture", call: "flyTo", view: "side", id: 1 }, home);
  if (data.id === 1) console.log(data.problem ?? "It flies.");
});
