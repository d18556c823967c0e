// What the colours mean, in words beside the picture.

function chip(colour, text) {
  const item = document.createElement("li"), square = document.createElement("span");
  square.className = "chip";
  square.style.background = colour;
  item.append(square, text);
  return item;
}

function list(items) {
  const found = document.createElement("ul");
  found.append(...items);
  return found;
}

function depthLegend({ramp, range_mm: [low, high]}) {
  const bar = document.createElement("div"), ends = document.createElement("p");
  bar.className = "ramp";
  bar.style.background = `linear-gradient(to right, ${ramp.filter((_, k) => k % 15 === 0).join(", ")})`;
  ends.className = "ends";
  ends.append(...[`${low.toFixed(1)} mm and less`, `${high.toFixed(1)} mm`].map(text => Object.assign(document.createElement("span"), {textContent: text})));
  return [bar, ends];
}

function qualityLegend({steps, colours}) {
  return [list(colours.map((c, k) => chip(c, `${steps[k]} to ${steps[k + 1]}`)))];
}

function partLegend({names, colours}) {
  return [list(names.map((name, k) => chip(colours[k], name)))];
}

function showLegend(place, colours, mode) {
  const words = {depth: "Depth z, down from the bit's start", part: "What cut last", quality: "Shape of triangles, 1: equilateral"};
  const title = Object.assign(document.createElement("p"), {textContent: words[mode]});
  place.replaceChildren(title, ...{depth: depthLegend, part: partLegend, quality: qualityLegend}[mode](colours[mode]));
}

// The colours of the bit: of its kinds of part, or of its areas.
function showBitLegend(place, bit, mode) {
  const title = Object.assign(document.createElement("p"), {textContent: mode === "areas" ? "Areas of the bit" : "Parts of the bit"});
  place.replaceChildren(title, ...partLegend(mode === "areas" ? bit.areas : bit));
}
