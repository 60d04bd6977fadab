// All there is to see is there without this script; it makes plots answer to pointer and keys. What listens beyond the
// plots themselves stops with `signal`. Returns the slider for the time of a page of one impact.
function enliven(signal) {
  const plots = [...document.querySelectorAll("svg.dp-plot")];
  const panels = plots.flatMap(panelsOf);
  unitSwitch(panels);
  const time = document.querySelector("[data-one-impact]") ? new TimeSlider(new Moments(panels), signal) : null;
  if (plots.length === 0) return time;
  const hint = textElement(
    "p",
    "Point at a curve for its values, or follow it with the arrow keys. Drag to zoom in, double-click to zoom out. Click the name of a curve to hide or show it.",
  );
  hint.className = "hint";
  const further = document.querySelector("main .plots");
  if (further) further.before(hint);
  else document.querySelector(".pictures").append(hint);
  return time;
}
