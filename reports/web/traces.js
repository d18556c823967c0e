// Lines over time on axes with ticks and units, with a mark at the frame that is shown.

const SVG = "http://www.w3.org/2000/svg", WIDE = 600, TALL = 170;
const PLOT = {left: 62, right: 592, top: 8, bottom: 140};  // of the axes, in the units of the picture

function element(name, attributes, text) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  return made;
}

const brief = x => String(Number(x.toPrecision(3)));

// Round numbers from low to high, about `count` of them: 1, 2 or 5 times a power of ten apart.
function ticksOf(low, high, count) {
  const rough = (high - low) / count, power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find(s => s * power >= rough * (1 - 1e-9)), first = Math.ceil(low / step - 1e-9);
  return Array.from({length: Math.floor(high / step + 1e-9) - first + 1}, (_, k) => Number(((first + k) * step).toPrecision(12)));
}

// The range of an axis. Values that differ by less than a millionth are a constant, drawn in the middle.
function rangeOf(trace) {
  const low = Math.min(...trace.low), high = Math.max(...trace.high), size = Math.max(Math.abs(low), Math.abs(high));
  if (high - low > 1e-6 * size) return [low, high];
  const half = size > 0 ? 0.1 * size : 1;
  return [low - half, high + half];
}

// A place on an axis of the picture.
const scaleOf = ([low, high], start, end) => value => start + (end - start) * (value - low) / (high - low);

// Frame, ticks and units of a picture; `x` has no ticks where it has no scale.
function axesOf({x, xTicks, xLabel, y, yTicks, unit}) {
  const parts = [element("rect", {x: PLOT.left, y: PLOT.top, width: PLOT.right - PLOT.left, height: PLOT.bottom - PLOT.top, class: "frame"})];
  for (const t of yTicks) {
    parts.push(element("line", {x1: PLOT.left, x2: PLOT.right, y1: y(t), y2: y(t), class: "grid"}));
    parts.push(element("text", {x: PLOT.left - 5, y: y(t) + 4, class: "tick", "text-anchor": "end"}, String(t)));
  }
  for (const t of xTicks) {
    parts.push(element("line", {x1: x(t), x2: x(t), y1: PLOT.bottom, y2: PLOT.bottom + 4, class: "grid"}));
    parts.push(element("text", {x: x(t), y: PLOT.bottom + 15, class: "tick", "text-anchor": "middle"}, String(t)));
  }
  parts.push(element("text", {x: (PLOT.left + PLOT.right) / 2, y: TALL - 2, class: "tick", "text-anchor": "middle"}, xLabel));
  parts.push(element("text", {x: 12, y: (PLOT.top + PLOT.bottom) / 2, class: "tick", "text-anchor": "middle",
    transform: `rotate(-90 12 ${(PLOT.top + PLOT.bottom) / 2})`}, unit));
  return parts;
}

// A band between the least and the greatest value of each piece of time.
function bandOf(trace, x, y) {
  const there = trace.time.map((t, k) => `${x(t).toFixed(1)} ${y(trace.high[k]).toFixed(1)}`);
  const back = trace.time.map((t, k) => `${x(t).toFixed(1)} ${y(trace.low[k]).toFixed(1)}`).reverse();
  return `M${there.join("L")}L${back.join("L")}Z`;
}

function drawTrace(trace, end) {
  const range = rangeOf(trace), figure = document.createElement("figure"), caption = document.createElement("figcaption");
  const ends = [Math.min(...trace.low), Math.max(...trace.high)].map(brief);
  const words = `${trace.name}: ${ends[0] === ends[1] ? ends[0] : ends.join(" to ")} ${trace.unit}`;
  const x = scaleOf([0, end], PLOT.left, PLOT.right), y = scaleOf(range, PLOT.bottom - 4, PLOT.top + 4);
  const picture = element("svg", {viewBox: `0 0 ${WIDE} ${TALL}`, role: "img", "aria-label": `${words}, from 0 to ${brief(end)} s`});
  const mark = element("line", {y1: PLOT.top, y2: PLOT.bottom, class: "mark", visibility: "hidden"});
  picture.append(...axesOf({x, xTicks: ticksOf(0, end, 6), xLabel: "time, s", y, yTicks: ticksOf(...range, 4), unit: trace.unit}),
    element("path", {d: bandOf(trace, x, y), class: "band"}), mark);
  caption.textContent = words;
  figure.append(caption, picture);
  return {figure, show: time => {
    for (const side of ["x1", "x2"]) mark.setAttribute(side, x(Math.min(time, end)));
    mark.setAttribute("visibility", "visible");
  }};
}

// Draws all; returns what moves their marks.
function drawTraces(place, traces, end) {
  const drawn = traces.map(trace => drawTrace(trace, end));
  place.append(...drawn.map(d => d.figure));
  return time => drawn.forEach(d => d.show(time));
}
