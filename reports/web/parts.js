// The parts of the bit in words and bars: the forces of each cutter, and the facts of the selected one.

const FORCES = [["normal_n", "normal force", "normal"], ["tangential_n", "drag", "drag"]];
const partListeners = [];  // called with the number of the selected part, -1: none

function selectPart(parts, part) {
  place("part").value = part;
  const rows = part < 0 ? [] : parts[part].facts.flatMap(([what, value]) => [["dt", what], ["dd", value]]);
  place("part-facts").replaceChildren(...rows.map(([tag, textContent]) => Object.assign(document.createElement(tag), {textContent})));
  for (const bar of document.querySelectorAll("#forces rect[data-part]")) bar.classList.toggle("selected", Number(bar.dataset.part) === part);
  partListeners.forEach(act => act(part));
}

// "12" of cutter-12, "2.3" of row 3 of cone 2; the whole name of other parts.
const shortName = name => name.replace(/^cutter-/, "").replace(/^cone-(\d+)\/row-/, "$1.");

function barsOf(shown, width, y, parts) {
  return shown.flatMap(({part, k}) => FORCES.map(([key, words, look], side) => {
    const value = 1e-3 * part[key], top = y(value);
    const bar = element("rect", {x: (PLOT.left + width * (k + 0.12 + 0.38 * side)).toFixed(2), width: (0.38 * width).toFixed(2), y: top.toFixed(2),
      height: Math.max(PLOT.bottom - top, 0.5).toFixed(2), class: `force ${look}`, "data-part": parts.indexOf(part)});
    bar.append(element("title", {}, `${part.name}: ${words} ${brief(value)} kN`));
    bar.addEventListener("click", () => selectPart(parts, parts.indexOf(part)));
    return bar;
  }));
}

function drawForces(parts) {
  const loaded = parts.filter(p => p.normal_n !== null && (p.normal_n > 0 || p.tangential_n > 0));
  if (!loaded.length) return;
  const most = 1e-3 * Math.max(...loaded.flatMap(p => FORCES.map(([key]) => p[key]))), width = (PLOT.right - PLOT.left) / loaded.length;
  const y = scaleOf([0, most], PLOT.bottom, PLOT.top + 4), every = Math.ceil(loaded.length * Math.max(...loaded.map(p => shortName(p.name).length)) / 62);
  const picture = element("svg", {viewBox: `0 0 ${WIDE} ${TALL}`, role: "img",
    "aria-label": `Mean forces of ${loaded.length} parts, up to ${brief(most)} kN. The list of parts beside the picture has their numbers.`});
  picture.append(...axesOf({x: null, xTicks: [], xLabel: loaded.some(p => p.name.startsWith("cone-")) ? "cone and row" : "cutter", y, yTicks: ticksOf(0, most, 4), unit: "kN"}),
    ...barsOf(loaded.map((part, k) => ({part, k})), width, y, parts));
  loaded.forEach((part, k) => {
    if (k % every === 0) picture.append(element("text", {x: PLOT.left + width * (k + 0.5), y: PLOT.bottom + 14, class: "tick", "text-anchor": "middle"}, shortName(part.name)));
  });
  place("forces").append(picture);
}

function listenToParts(parts) {
  if (place("forces")) drawForces(parts);
  place("part").addEventListener("change", () => selectPart(parts, Number(place("part").value)));
}
