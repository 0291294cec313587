/** English in disguise: marks on the letters, and a third longer, as other languages are. */

const PLAIN = "aceinouyACEINOUY";
const MARKED = "áçéíñóúýÁÇÉÍÑÓÚÝ";

/** What is put into a text, `{0}`, stays as it is. */
export function pseudo(text: string): string {
  const marked = text
    .split(/(\{\d+\})/)
    .map((part, i) => (i % 2 ? part : part.replace(/\p{L}/gu, (letter) => MARKED[PLAIN.indexOf(letter)] ?? letter)))
    .join("");
  return `[${marked}${"·".repeat(Math.ceil(text.replace(/\{\d+\}/g, "").length / 3))}]`;
}
