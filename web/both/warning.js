import { element } from "./text.js";

// "EXTRAPOLATED: strain reaches ..." with its first words, in capitals, set apart.
export function warning(text) {
  const flag = /^[A-Z ]+[A-Z]/.exec(text)?.[0] ?? "";
  return element("li", {}, element("strong", { text: flag }), text.slice(flag.length));
}
