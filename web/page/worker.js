// Drills in a Worker: hears the page's orders between slices of steps, and shows the rock as often as the page can draw it.

const SLICE = 20;  // ms of steps
const GRID = 65535;
let tdbd = null, runs = false, canDraw = true, groups = null, samples = emptySamples();

function emptySamples() {
  return {time: [], wob: [], tob: []};
}

const call = (name, type, ...given) => tdbd.ccall(`tdbd_${name}`, type, given.map(g => typeof g), given);
const told = name => JSON.parse(call(name, "string"));

function gridBox(x) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0, k = 0; i < x.length; ++i, k = k === 2 ? 0 : k + 1) {
    if (x[i] < low[k]) low[k] = x[i];
    if (x[i] > high[k]) high[k] = x[i];
  }
  return {origin: low, size: high.map((h, k) => Math.max(h - low[k], 1e-9))};
}

const column = (from, k, count, of) => Int32Array.from({length: count}, (_, i) => of(from[3 * i + k]));

// The mesh that the program shows, as the drawing has it: columns on the grid of a box, corners, and what numberOf makes of the
// number of each point or triangle.
function shownMesh(numbered, numberOf = n => n) {
  const points = call("vertex_count", "number"), count = call("triangle_count", "number");
  const at = (name, Kind, length) => new Kind(tdbd.HEAPU8.buffer, call(name, "number"), length);
  const x = at("positions", Float64Array, 3 * points), t = at("triangles", Int32Array, 3 * count), box = gridBox(x);
  const numbers = at("numbers", Int32Array, numbered === "points" ? points : count);
  const corners = [0, 1, 2].map(k => column(t, k, count, v => v));
  return {box, points: box.origin.map((o, k) => column(x, k, points, v => Math.round(GRID * (v - o) / box.size[k]))), corners,
    numbers: Int32Array.from(numbers, numberOf)};
}

const buffersOf = mesh => [...mesh.points, ...mesh.corners, mesh.numbers].map(a => a.buffer);

function sendRock(kind, more = {}) {
  call("show_rock", null);
  const rock = shownMesh("points", part => part < 0 ? 0 : groups[part]), look = told("look");
  postMessage({kind, look, rock, samples, ...more}, buffersOf(rock));
  samples = emptySamples();
  canDraw = false;
}

function stop(kind, text) {
  runs = false;
  postMessage({kind, text});
}

// One step, and what its forces were. False at the end, or when it failed.
function made() {
  const steps = call("step", "number", 1);
  if (steps < 0) stop("failed", call("text", "string"));
  if (steps < 1) return false;
  for (const name of ["time", "wob", "tob"]) samples[name].push(call(name, "number"));
  return true;
}

const turn = new MessageChannel();  // timers of a Worker wait 4 ms
turn.port1.onmessage = () => {
  if (!runs) return;
  const until = performance.now() + SLICE;
  let goes = true;
  while (goes && performance.now() < until) goes = made();
  if (!runs) return;
  if (!goes) {
    runs = false;
    sendRock("ended");
    return;
  }
  if (canDraw) sendRock("drilled");
  turn.port2.postMessage(null);
};

function writeFiles(files) {
  for (const [path, text] of Object.entries(files)) {
    tdbd.FS.mkdirTree(`/case/${path}`.replace(/\/[^/]*$/, ""));
    tdbd.FS.writeFile(`/case/${path}`, text);
  }
}

// Cutters, teeth of a row: the name before the stroke.
function groupsOf(parts) {
  const names = ["not cut", ...new Set(parts.map(p => p.name.replace(/\/[^/]*$/, "")))];
  return {names, numbers: parts.map(p => names.indexOf(p.name.replace(/\/[^/]*$/, "")))};
}

const orders = {
  async load({program}) {
    tdbd = await createTdbd({wasmBinary: program});
    postMessage({kind: "loaded"});
  },
  start({files, wanted}) {
    runs = false;
    samples = emptySamples();
    writeFiles(files);
    if (call("start", "number", "/case/case.toml") < 0) {
      stop("refused", call("text", "string").replaceAll("/case/", ""));
      return;
    }
    const facts = told("facts"), found = groupsOf(facts.parts);
    groups = found.numbers;
    call("show_bit", null);
    const bit = shownMesh("triangles");
    sendRock("started", {facts, bit, names: found.names, groups, wanted});
    runs = true;
    turn.port2.postMessage(null);
  },
  pause() {
    runs = false;
    sendRock("paused");
  },
  resume() {
    runs = true;
    turn.port2.postMessage(null);
  },
  drawn() {
    canDraw = true;
  },
  surface() {
    if (call("write_rock", "number", "/rock.ply") < 0) stop("failed", call("text", "string"));
    else postMessage({kind: "surface", bytes: tdbd.FS.readFile("/rock.ply")});
  },
};

onmessage = ({data}) => Promise.resolve(orders[data.order](data)).catch(error => stop("failed", String(error)));
