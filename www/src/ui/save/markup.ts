/** Text, and scripts, in HTML. */

const ENTITIES: Readonly<Record<string, string>> = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;" };

/** Never markup, in elements as in quoted attributes. */
export const escaped = (text: string): string => text.replace(/[&<>"']/g, (sign) => ENTITIES[sign]!);

export type Attributes = readonly (readonly [name: string, value: string | true])[];

/** With a space before each. */
export const written = (attributes: Attributes): string => attributes.map(([name, value]) => (value === true ? ` ${name}` : ` ${name}="${escaped(value)}"`)).join("");

/** The same script, with nothing in it that an HTML parser takes for the script's end. Only strings and regular expressions have such things. */
export const inScript = (module: string): string => module.replace(/<(?=\/script|!--)/gi, "\\x3c");
