// The colours of the style sheet for what is drawn on canvases, and when they change.

const names = ["text", "grid", "band", "band-2", "line-0", "line-1", "line-2", "line-3"];
const listeners = [];
let known = null;
let printing = false;

export function colour(name) {
  if (!known) {
    const style = getComputedStyle(document.documentElement);
    known = Object.fromEntries(names.map((each) => [each, style.getPropertyValue(`--${each}`).trim()]));
  }
  return known[name];
}

export const isPrinting = () => printing;

export function onChange(listener) {
  listeners.push(listener);
}

function changed() {
  known = null;
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
