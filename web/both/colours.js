// The colours of the style sheet for what is drawn on canvases, and when they change.

const listeners = [];
const known = new Map();
let printing = false;

export function colour(name) {
  if (!known.has(name))
    known.set(name, getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim());
  return known.get(name);
}

export const isPrinting = () => printing;

export function onChange(listener) {
  listeners.push(listener);
}

function changed() {
  known.clear();
  for (const listener of listeners) listener();
}

// Paper is light, whatever the screen is.
function print(now) {
  if (printing === now) return;
  printing = now;
  document.documentElement.classList.toggle("printing", now);
  changed();
}

matchMedia("(prefers-color-scheme: dark)").addEventListener("change", changed);
matchMedia("print").addEventListener("change", (event) => print(event.matches));
addEventListener("beforeprint", () => print(true));
addEventListener("afterprint", () => print(false));
