// All there is to see is there without this script; it makes plots answer to pointer and keys.

const plots = [...document.querySelectorAll("svg.dp-plot")];
const panels = plots.flatMap(panelsOf);
unitSwitch(panels);
if (document.querySelector("[data-one-impact]")) new TimeSlider(new Moments(panels));
if (plots.length > 0) {
  const hint = textElement(
    "p",
    "Point at a curve for its values, or follow it with the arrow keys. Drag to zoom in, double-click to zoom out. Click the name of a curve to hide or show it.",
  );
  hint.className = "hint";
  const further = document.querySelector("main .plots");
  if (further) further.before(hint);
  else document.querySelector(".pictures").append(hint);
}
