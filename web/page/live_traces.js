// WOB and TOB while they grow: the least and the greatest of each piece of time.

const PIECES = 300;

const emptyTrace = (name, unit, factor) => ({name, unit, factor, time: [], value: []});

function addSamples(trace, times, values) {
  values.forEach((v, k) => {
    if (!Number.isFinite(v)) return;
    trace.time.push(times[k]);
    trace.value.push(trace.factor * v);
  });
}

// As traces.js draws it.
function pieced(trace) {
  const size = Math.max(1, Math.ceil(trace.value.length / PIECES)), made = {name: trace.name, unit: trace.unit, time: [], low: [], high: []};
  for (let first = 0; first < trace.value.length; first += size) {
    const piece = trace.value.slice(first, first + size);
    made.time.push(trace.time[first]);
    made.low.push(Math.min(...piece));
    made.high.push(Math.max(...piece));
  }
  return made;
}

function drawLiveTraces(place, traces) {
  const there = traces.filter(t => t.value.length > 0);
  place.replaceChildren();
  drawTraces(place, there.map(pieced), Math.max(...there.map(t => t.time.at(-1)), 1e-9));
}

// A table of every step, for a spreadsheet.
function tracesCsv(traces) {
  const rows = traces[0].time.map((t, k) => [t, ...traces.map(trace => trace.value[k])].join(","));
  return ["time_s," + traces.map(t => `${t.name.toLowerCase()}_${t.unit.replace(" ", "_")}`).join(","), ...rows, ""].join("\n");
}
