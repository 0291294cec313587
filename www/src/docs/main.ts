/** A copy button for every snippet: without this script the page is all there. */

const SAID_MS = 2_000;

for (const snippet of document.querySelectorAll<HTMLElement>(".snippet")) {
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = "Copy";
  button.addEventListener("click", () => void copy(snippet.querySelector("code")!, button));
  snippet.append(button);
  snippet.querySelector("pre")!.tabIndex = 0;
}

const live = document.body.appendChild(document.createElement("p"));
live.className = "unseen";
live.setAttribute("role", "status");

async function copy(code: HTMLElement, button: HTMLButtonElement): Promise<void> {
  let said = "Copied";
  try {
    await navigator.clipboard.writeText(code.textContent);
  } catch {
    // Marked, so that the keys for copying do it.
    getSelection()!.selectAllChildren(code);
    said = "Marked: copy it with Ctrl or ⌘ and C";
  }
  button.textContent = said;
  live.textContent = said;
  setTimeout(() => {
    button.textContent = "Copy";
    live.textContent = "";
  }, SAID_MS);
}
