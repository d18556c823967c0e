// Puts the page together: reads the data, shows a frame, plays, and draws when something changed.

const PLAYED = 6;  // s for all frames

// In words what the picture shows, for those who hear the page.
function wordsOf(run, state) {
  const f = run.frames[state.frame], turns = (f.time_s * run.revolutions_per_s).toFixed(2);
  const shown = run.frames.length, left = shown < run.listed ? `, of which this page has ${shown}` : "";
  return `Frame ${f.number} of ${run.listed}${left}: ${Number(f.time_s.toPrecision(4))} s, ${turns} revolutions, ${f.triangles} triangles`;
}

function connect(scene, changed) {
  const {state, run} = scene, slider = place("time");
  const show = frame => {
    state.frame = frame;
    slider.value = frame;
    slider.setAttribute("aria-valuetext", place("now").textContent = wordsOf(run, state));
    fillRock(scene);
    changed();
  };
  const step = by => show((state.frame + by + run.frames.length) % run.frames.length);
  const play = () => {
    state.plays = !state.plays && run.frames.length > 1;
    place("play").textContent = state.plays ? "Pause" : "Play";
    clearInterval(state.clock);
    if (state.plays) state.clock = setInterval(() => step(1), 1000 * PLAYED / run.frames.length);
  };
  const home = () => { Object.assign(scene.camera, homeCamera(run.box)); changed(); };
  const cut = () => { place("cut").checked = !place("cut").checked; place("cut").dispatchEvent(new Event("change")); };
  partListeners.push(part => {
    state.selected = part;
    fillBit(scene);
    changed();
  });
  const click = (x, y) => selectPart(run.parts, pickedPart(scene, x, y));
  const view = {camera: scene.camera, changed, step, play, home, cut, click};
  listenToKeys(scene.canvas, view);
  listenToPointers(scene.canvas, view);
  slider.addEventListener("input", () => show(Number(slider.value)));
  place("play").addEventListener("click", play);
  place("home").addEventListener("click", home);
  listenToChoices(scene, changed, () => show(state.frame));
  show(state.frame);
}

async function start() {
  const run = JSON.parse(place("run").textContent), canvas = place("view");
  const end = Math.max(...run.frames.map(f => f.time_s), ...run.traces.map(t => t.time.at(-1)), 1e-9);
  const showTime = drawTraces(place("traces"), run.traces, end);
  showTime(run.frames.at(-1).time_s);
  listenToParts(run.parts);
  const gl = canvas.getContext("webgl2", {antialias: true});
  if (!gl) throw new Error("it has no WebGL 2");
  const read = arrayReader(await inflate(place("data").textContent));
  const frames = unpackFrames(run.frames, read), bit = unpackBit(run.bit, read);
  place("three").hidden = false;
  const scene = newScene(gl, canvas, run, frames, bit), changed = drawer(scene, showTime);
  connect(scene, changed);
  new ResizeObserver(changed).observe(canvas);
  place("still").hidden = true;
  return scene;
}

// The scene, for tests; null where the browser cannot draw.
const started = start().catch(error => {
  place("three").hidden = true;
  place("why").textContent = `This browser cannot draw the run in 3-D: ${error.message}. The picture shows its end.`;
  return null;
});
