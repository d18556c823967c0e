// Puts the page together: the form gives orders to the Worker, and what it sends is drawn.

const constants = JSON.parse(place("constants").textContent);
const live = {worker: null, scene: null, run: null, facts: null, groups: null, bars: null, depths: null, changed: () => {},
  choice: null, files: null, last: null, pace: [], depths_m: [], shown: 0, state: "loading", traces: [], table: null};

const number = id => place(id).value.trim();

// What the form shows.
function choice() {
  return {bit: place("bit-choice").value, table: live.table, gage: number("gage"), chamfer: number("chamfer"), chamferAngle: number("chamfer-angle"),
    cutterLength: number("cutter-length"), diamond: number("diamond"), rock: place("rock").value, pressure: number("pressure"), law: place("law").value,
    energy: number("energy"), drive: place("drive").value, weight: number("weight"), speed: number("speed"), rate: number("rate"), edge: number("edge"),
    revolutions: number("revolutions"), whirls: place("whirls").checked && place("drive").value === "rate", whirlRadius: number("whirl-radius"),
    whirlTimes: number("whirl-times"), whirlSense: place("whirl-sense").value};
}

function say(state, words) {
  live.state = state;
  place("status").textContent = words;
  place("pause").textContent = state === "paused" ? "Resume" : "Pause";
  place("pause").disabled = state !== "drilling" && state !== "paused";
  for (const id of ["surface", "volumes-csv", "traces-csv", "case-zip"]) place(id).disabled = !live.facts;
}

function complain(words) {
  place("problem").hidden = !words;
  place("problem").textContent = words;
}

function begin() {
  complain("");
  const wanted = choice();
  if (wanted.bit === "own" && !wanted.table) {
    complain("Drop a table of cutters (CSV) on the page, or choose its file.");
    return;
  }
  say("starting", "Building the rock …");
  live.worker.postMessage({order: "start", files: caseFiles(wanted, constants.bits), wanted});
}

function pauseOrResume() {
  if (live.state !== "drilling" && live.state !== "paused") return;
  const order = live.state === "drilling" ? "pause" : "resume";
  live.worker.postMessage({order});
  if (order === "resume") say("drilling", "Drilling …");
}

// Simulated over real seconds, of the last five real ones.
function pace(look) {
  const now = performance.now();
  live.pace.push({now, time: look.time_s});
  while (live.pace.length > 2 && now - live.pace[0].now > 5000) live.pace.shift();
  const first = live.pace[0];
  return now > first.now + 200 ? 1000 * (look.time_s - first.time) / (now - first.now) : NaN;
}

// The mean rate of penetration of the last simulated second, m/h.
function rateNow(look) {
  live.depths_m.push({time: look.time_s, z: look.poses[0][11]});
  while (live.depths_m.length > 2 && look.time_s - live.depths_m[0].time > 1) live.depths_m.shift();
  const first = live.depths_m[0];
  return look.time_s > first.time ? 3600 * (look.poses[0][11] - first.z) / (look.time_s - first.time) : NaN;
}

function wordsOf(look, kind) {
  const speed = kind === "drilled" ? pace(look) : NaN, what = {drilled: "Drilling", paused: "Paused", ended: "The end", started: "Started"}[kind];
  const parts = [`${what}: ${look.time_s.toFixed(2)} s`, `${look.revolutions.toFixed(2)} revolutions`, `${look.triangles} triangles`,
    `${(1e6 * look.removed_m3).toFixed(1)} cm³ of rock`];
  if (look.wob_n !== null) parts.push(`WOB ${(1e-3 * look.wob_n).toFixed(1)} kN`, `TOB ${look.tob_n_m.toFixed(0)} N m`);
  const rate = rateNow(look);
  if (live.choice && live.choice.drive === "weight" && Number.isFinite(rate)) parts.push(`ROP ${rate.toFixed(1)} m/h`);
  if (Number.isFinite(speed)) parts.push(`${speed.toFixed(1)} times real time`);
  return parts.join(", ");
}

function takeSamples({time, wob, tob}) {
  addSamples(live.traces[0], time, wob);
  addSamples(live.traces[1], time, tob);
}

// Traces and bars need no 60 pictures a second.
function drawNumbers(look, always) {
  const now = performance.now();
  if (!always && now - live.shown < 250) return;
  live.shown = now;
  live.bars(sums(look.removed_by_part_m3, live.groups, live.run.colours.part.names.length));
  drawLiveTraces(place("traces"), live.traces);
  showLegend(place("legend"), live.run.colours, live.scene ? live.scene.state.mode : "depth");
}

// How far the bit went down since the last look: the eye goes with it.
const deeper = look => look.poses[0][11] - (live.last ? live.last.poses[0][11] : look.poses[0][11]);

function showRock(message) {
  const frame = takeRock(live.run, live.depths, message.rock, message.look);
  if (live.scene) live.scene.camera.target[2] += deeper(message.look);
  live.last = message.look;
  takeSamples(message.samples);
  if (live.scene) {
    live.scene.frames = [frame];
    fillRock(live.scene);
    live.changed();
  }
  drawNumbers(message.look, message.kind !== "drilled");
  requestAnimationFrame(() => live.worker.postMessage({order: "drawn"}));
}

function showStart(message) {
  const pieces = bitPieces(message.bit, message.facts.parts, constants.looks);
  Object.assign(live, {facts: message.facts, groups: message.groups, depths: cuttingDepths(message.bit, pieces), pace: [], depths_m: [], shown: 0, last: null,
    choice: message.wanted, files: caseFiles(message.wanted, constants.bits),
    run: liveRun(message.facts, pieces.run, message.names, constants.looks), traces: [emptyTrace("WOB", "kN", 1e-3), emptyTrace("TOB", "N m", 1)]});
  live.bars = volumeBars(place("bars"), message.names);
  const frame = takeRock(live.run, live.depths, message.rock, message.look), radius = Math.ceil(1000 * message.facts.gage_radius_m);
  Object.assign(place("cut-move"), {min: -radius, max: radius});
  place("warnings").replaceChildren(...message.facts.warnings.map(w => Object.assign(document.createElement("li"), {textContent: w.replaceAll("/case/", "")})));
  place("case-text").textContent = live.files["case.toml"];
  openScene(frame, pieces.mesh);
}

function openScene(frame, bit) {
  const canvas = place("view"), gl = live.scene ? live.scene.gl : canvas.getContext("webgl2", {antialias: true, preserveDrawingBuffer: true});
  if (!gl) {
    place("why").textContent = "This browser cannot draw in 3-D: it has no WebGL 2. The page drills and shows numbers; the picture shows an earlier hole.";
    return;
  }
  place("still").hidden = true;
  place("three").hidden = false;
  if (live.scene) {
    showRun(live.scene, live.run, [frame], bit);
    return;
  }
  live.scene = newScene(gl, canvas, live.run, [frame], bit);
  live.changed = drawer(live.scene, () => {});
  listenToView();
}

function listenToView() {
  const {scene, changed} = live;
  const home = () => { Object.assign(scene.camera, homeCamera(live.run.box)); changed(); };
  const cut = () => { place("cut").checked = !place("cut").checked; place("cut").dispatchEvent(new Event("change")); };
  const view = {camera: scene.camera, changed, step: () => {}, play: pauseOrResume, home, cut};
  listenToKeys(scene.canvas, view);
  listenToPointers(scene.canvas, view);
  place("home").addEventListener("click", home);
  listenToChoices(scene, changed, () => fillRock(scene));
  new ResizeObserver(changed).observe(scene.canvas);
}

const heard = {
  loaded: begin,
  started(message) { showStart(message); showRock(message); say("drilling", wordsOf(message.look, "started")); },
  drilled(message) { showRock(message); if (live.state === "drilling") say("drilling", wordsOf(message.look, "drilled")); },
  paused(message) { showRock(message); say("paused", wordsOf(message.look, "paused")); },
  ended(message) { showRock(message); say("ended", wordsOf(message.look, "ended")); },
  refused({text}) { complain(text); say("refused", "The case is refused; what is shown is the last one."); },
  failed({text}) { complain(text); say("failed", "The drilling failed."); },
  surface({bytes}) { save("rock.ply", bytes, "application/octet-stream"); },
};

function save(name, content, type) {
  const link = Object.assign(document.createElement("a"), {download: name, href: URL.createObjectURL(new Blob([content], {type}))});
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

function volumesCsv() {
  return ["part,removed_m3", ...live.facts.parts.map((p, k) => `${p.name},${live.last.removed_by_part_m3[k]}`), ""].join("\n");
}

const caseZip = wanted => zipOf(zipFiles(wanted, constants.bits, place("made-by").textContent));

async function takeTable(file) {
  if (!file) return;
  live.table = {name: file.name, text: await file.text()};
  const gage = gageOf(live.table.text);
  if (gage > 0) place("gage").value = (Math.ceil(10 * gage - 0.5) / 10).toFixed(1);  // the program allows 0.1 mm
  place("bit-choice").value = "own";
  showChoices();
  begin();
}

// The options of a selection; keeps the selected one if it is still there.
function offer(id, options) {
  const old = place(id).value;
  if (Object.keys(options).join() === Array.from(place(id).options, o => o.value).join()) return;
  place(id).replaceChildren(...Object.entries(options).map(([value, words]) => Object.assign(document.createElement("option"), {value, textContent: words})));
  if (Object.hasOwn(options, old)) place(id).value = old;
}

function showChoices() {
  offer("law", Object.fromEntries(Object.entries(lawsOf(place("bit-choice").value)).map(([name, law]) => [name, law.words])));
  const wanted = choice(), isWeight = wanted.drive === "weight";
  place("own-bit").hidden = wanted.bit !== "own";
  place("energy-is").hidden = wanted.law !== "detournay";
  place("weight-is").hidden = !isWeight;
  place("whirls-is").hidden = isWeight;
  place("whirl-is").hidden = !wanted.whirls;
  place("rate-words").textContent = isWeight ? "Expected rate" : "Rate of penetration";
  const words = wanted.bit === "own" && !wanted.table ? ["Choose a table of cutters first."] : assumptions(wanted);
  place("assumptions").replaceChildren(...words.map(textContent => Object.assign(document.createElement("li"), {textContent})));
}

function listenToForm() {
  place("form").addEventListener("submit", event => { event.preventDefault(); begin(); });
  for (const event of ["change", "input"]) place("form").addEventListener(event, showChoices);
  place("pause").addEventListener("click", pauseOrResume);
  place("surface").addEventListener("click", () => live.worker.postMessage({order: "surface"}));
  place("volumes-csv").addEventListener("click", () => save("volumes.csv", volumesCsv(), "text/csv"));
  place("traces-csv").addEventListener("click", () => save("traces.csv", tracesCsv(live.traces), "text/csv"));
  place("case-zip").addEventListener("click", () => save(`${folderOf(live.choice)}.zip`, caseZip(live.choice), "application/zip"));
  place("template").addEventListener("click", () => save("cutters.csv", templateCsv(constants.bits["bit-b.csv"]), "text/csv"));
  place("table").addEventListener("change", event => takeTable(event.target.files[0]));
  document.addEventListener("dragover", event => event.preventDefault());
  document.addEventListener("drop", event => { event.preventDefault(); takeTable(event.dataTransfer.files[0]); });
}

async function load() {
  offer("rock", ROCKS);
  showChoices();
  listenToForm();
  if (typeof WebAssembly !== "object" || typeof Worker !== "function") throw new Error("it has no WebAssembly in Workers");
  const program = (await inflate(place("program").textContent)).buffer;
  const source = [place("glue").textContent, place("worker").textContent].join("\n");
  live.worker = new Worker(URL.createObjectURL(new Blob([source], {type: "text/javascript"})));
  live.worker.onmessage = ({data}) => heard[data.kind](data);
  live.worker.onerror = event => heard.failed({text: event.message || "the Worker ended"});
  live.worker.postMessage({order: "load", program}, [program]);
}

load().catch(error => {
  complain(`This browser cannot drill: ${error.message}.`);
  say("failed", "Nothing drills.");
});
