// Lines over time, with a mark at the frame that is shown.

const SVG = "http://www.w3.org/2000/svg", WIDE = 600, TALL = 90;

function element(name, attributes) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

const brief = x => String(Number(x.toPrecision(3)));

function rangeOf(trace) {
  const low = Math.min(...trace.low), high = Math.max(...trace.high);
  return high > low ? [low, high] : [low - 1, high + 1];
}

// A band between the least and the greatest value of each piece of time.
function bandOf(trace, end, [low, high]) {
  const x = t => WIDE * t / end, y = v => TALL - TALL * (v - low) / (high - low);
  const there = trace.time.map((t, k) => `${x(t).toFixed(1)} ${y(trace.high[k]).toFixed(1)}`);
  const back = trace.time.map((t, k) => `${x(t).toFixed(1)} ${y(trace.low[k]).toFixed(1)}`).reverse();
  return `M${there.join("L")}L${back.join("L")}Z`;
}

function drawTrace(trace, end) {
  const range = rangeOf(trace), figure = document.createElement("figure"), caption = document.createElement("figcaption");
  const ends = [Math.min(...trace.low), Math.max(...trace.high)].map(brief);
  const words = `${trace.name}: ${ends[0] === ends[1] ? ends[0] : ends.join(" to ")} ${trace.unit}`;
  const picture = element("svg", {viewBox: `0 0 ${WIDE} ${TALL}`, preserveAspectRatio: "none", role: "img", "aria-label": `${words}, from 0 to ${brief(end)} s`});
  const mark = element("line", {y1: 0, y2: TALL, class: "mark"});
  picture.append(element("path", {d: bandOf(trace, end, range), class: "band"}), mark);
  caption.textContent = words;
  figure.append(caption, picture);
  return {figure, show: time => { for (const side of ["x1", "x2"]) mark.setAttribute(side, WIDE * time / end); }};
}

// Draws all; returns what moves their marks.
function drawTraces(place, traces, end) {
  const drawn = traces.map(trace => drawTrace(trace, end));
  place.append(...drawn.map(d => d.figure));
  return time => drawn.forEach(d => d.show(time));
}
