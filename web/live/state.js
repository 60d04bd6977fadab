// What the page shows, as plain data that a link can hold: the case with its tables as written, the pads that are
// compared, and what was chosen beside it.

const largestLink = 60000;

const isText = (value, most = 200) => typeof value === "string" && value.length <= most;
const isTable = (value) => value !== null && typeof value === "object" && !Array.isArray(value);

const deepest = 12;
const isShallow = (value, depth = 0) =>
  value === null || typeof value !== "object" || (depth < deepest && Object.values(value).every((each) => isShallow(each, depth + 1)));

// Whether a value of a stranger is such data; what is in the case the engine judges.
function isState(state) {
  return (
    isTable(state) && isShallow(state) && isTable(state.case) && Array.isArray(state.pads) && state.pads.length >= 1 && state.pads.length <= 4 &&
    state.pads.every(isTable) && Number.isInteger(state.active) && state.active >= 0 && state.active < state.pads.length &&
    (state.cards === undefined || (isTable(state.cards) && Object.entries(state.cards).every(([name, text]) => /^[\w-]{1,60}$/.test(name) && isText(text, 20000)))) &&
    isText(state.standard) && ["si", "us", "engineering-metric"].includes(state.units) && isTable(state.user) &&
    Object.entries(state.user).every(([key, value]) => ["mass", "radius", "speed"].includes(key) && (Number.isFinite(value) || isText(value)))
  );
}

function linkOf(state) {
  const bytes = new TextEncoder().encode(JSON.stringify(state));
  return `#${btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join("")).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "")}`;
}

// The state behind #; null if there is none, or none that is sound.
function stateOf(hash) {
  if (hash.length < 2 || hash.length > largestLink) return null;
  try {
    const letters = atob(hash.slice(1).replace(/-/g, "+").replace(/_/g, "/"));
    const state = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(Uint8Array.from(letters, (letter) => letter.charCodeAt(0))));
    return isState(state) ? state : null;
  } catch {
    return null;
  }
}

// The case with one of the pads.
const caseOf = (state, pad = state.active) => ({ ...state.case, pad: state.pads[pad] });

// Of the numbers of an impactor those that say how it strikes, or those of its nose.
const partOf = (impactor, isMotion) =>
  Object.fromEntries(Object.entries(impactor).filter(([key]) => ["mass", "weight", "speed", "drop_height", "gravity"].includes(key) === isMotion));

// Noses and supports on offer, beside those of the case, with sizes to begin from.
function nosesOf(impactor, size) {
  const radius = impactor.radius ?? size;
  return { sphere: { nose: "sphere", radius }, "flat-disc": { nose: "flat-disc", radius }, cylinder: { nose: "cylinder", radius, length: radius } };
}
const supportsOnOffer = { rigid: { type: "rigid" }, linear: { type: "linear", stiffness: "100 N/mm" } };
