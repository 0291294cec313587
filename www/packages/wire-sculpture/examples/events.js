const sculpture = document.querySelector("wire-sculpture");

sculpture.addEventListener("view-change", ({ detail }) => console.log("Now from", detail.view));
sculpture.addEventListener("error", ({ detail }) => console.log(detail.sentence));

sculpture.flyTo("side");
const picture = await sculpture.toBlob({ width: 1200, height: 900, transparent: true });
