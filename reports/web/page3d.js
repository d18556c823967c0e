// Puts the page together: reads the data, draws when something changed, plays.

const PLAYED = 6;  // s for all frames
const place = id => document.getElementById(id);
const NOWHERE = [0, 0, 0, 0];  // a plane that cuts nothing
const AT_REST = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];

// Three rows of four, as WebGL wants them.
const columns = p => [p[0], p[4], p[8], 0, p[1], p[5], p[9], 0, p[2], p[6], p[10], 0, p[3], p[7], p[11], 1];

// The cut stands upright at an angle, moved from the axis by `move` (m).
function sectionPlane(state) {
  if (!state.cuts) return NOWHERE;
  const angle = state.cutAngle * Math.PI / 180;
  return [Math.cos(angle), Math.sin(angle), 0, state.cutMove * 1e-3];
}

function drawPieces(gl, at, mesh, pieces) {
  gl.bindVertexArray(mesh.array);
  let first = 0;
  for (const {pose, count, isShown} of pieces) {
    gl.uniformMatrix4fv(at.pose, false, columns(pose));
    if (isShown) gl.drawArrays(gl.TRIANGLES, first, count);
    first += count;
  }
}

function drawMesh(gl, at, box, plane, depths, texture, lines) {
  gl.uniform3fv(at.origin, box.origin);
  gl.uniform3fv(at.size, box.size);
  gl.uniform4fv(at.plane, plane);
  gl.uniform2fv(at.depths, depths);
  gl.uniform1i(at.lines, lines);
  gl.bindTexture(gl.TEXTURE_2D, texture);
}

function draw(scene) {
  const {gl, at, run, state, canvas} = scene, entry = run.frames[state.frame];
  const scale = window.devicePixelRatio || 1;
  canvas.width = Math.max(1, Math.round(canvas.clientWidth * scale));
  canvas.height = Math.max(1, Math.round(canvas.clientHeight * scale));
  gl.viewport(0, 0, canvas.width, canvas.height);
  gl.clearColor(0, 0, 0, 0);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.uniformMatrix4fv(at.view, false, viewMatrix(scene.camera, canvas.width / canvas.height));
  const axes = cameraAxes(scene.camera);
  for (const name of ["right", "up", "toward"]) gl.uniform3fv(at[name], axes[name]);
  const depths = state.mode === "depth" ? run.colours.depth.range_mm.map(z => 1e-3 * z) : [0, 0];
  if (!state.cuts) gl.enable(gl.CULL_FACE);  // the nearer wall, seen from the rock, is left out
  drawMesh(gl, at, run.box, sectionPlane(state), depths, scene.textures[state.mode], state.lines);
  drawPieces(gl, at, scene.rock, [{pose: AT_REST, count: scene.rock.corners, isShown: true}]);
  gl.disable(gl.CULL_FACE);
  drawMesh(gl, at, run.bit.box, NOWHERE, [0, 0], scene.textures.bit, false);
  drawPieces(gl, at, scene.bit, run.bit.pieces.map(p => (
    {pose: entry.poses[p.body], count: 3 * p.triangles, isShown: state.bit === "all" || (state.bit === "cutting" && !p.hull)})));
}

function newScene(gl, canvas, run, frames, bit) {
  const {program, at} = drawingProgram(gl);
  gl.useProgram(program);
  gl.enable(gl.DEPTH_TEST);
  const textures = {bit: colourTexture(gl, run.bit.colours), depth: colourTexture(gl, run.colours.depth.ramp)};
  for (const mode of ["part", "quality"]) textures[mode] = colourTexture(gl, run.colours[mode].colours);
  const state = {frame: frames.length - 1, mode: "depth", bit: "cutting", lines: false, cuts: false, cutAngle: 68, cutMove: 0, plays: false};
  const scene = {gl, at, canvas, run, frames, textures, state, camera: homeCamera(run.box), rock: newMesh(gl), bit: newMesh(gl)};
  fill(gl, scene.bit, corners(bit.points, bit.corners, t => bit.colour[t]));
  return scene;
}

function fillRock(scene) {
  const {gl, run, state} = scene, frame = scene.frames[state.frame];
  fill(gl, scene.rock, corners(frame.points, frame.corners, rockColour(run, frame, state.mode)));
}

// In words what the picture shows, for those who hear the page.
function wordsOf(run, state) {
  const f = run.frames[state.frame], turns = (f.time_s * run.revolutions_per_s).toFixed(2);
  return `Frame ${f.number} of ${run.frames.length + run.missing.length}: ${Number(f.time_s.toPrecision(4))} s, ${turns} revolutions, ${f.triangles} triangles`;
}

// Draws at most once for each picture of the screen.
function drawer(scene, showTime) {
  let waits = false;
  return () => {
    if (waits) return;
    waits = true;
    requestAnimationFrame(() => {
      waits = false;
      draw(scene);
      showTime(scene.run.frames[scene.state.frame].time_s);
    });
  };
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
  const view = {camera: scene.camera, changed, step, play, home, cut};
  listenToKeys(scene.canvas, view);
  listenToPointers(scene.canvas, view);
  slider.addEventListener("input", () => show(Number(slider.value)));
  place("play").addEventListener("click", play);
  place("home").addEventListener("click", home);
  listenToChoices(scene, changed, () => show(state.frame));
  show(state.frame);
}

// Colours, bit, lines and section.
function listenToChoices(scene, changed, refill) {
  const {state, run} = scene;
  const choice = (id, event, act) => place(id).addEventListener(event, () => { act(place(id)); changed(); });
  const colour = () => { state.mode = place("colour").value; showLegend(place("legend"), run.colours, state.mode); refill(); };
  place("colour").addEventListener("change", colour);
  showLegend(place("legend"), run.colours, state.mode);
  choice("bit", "change", c => { state.bit = c.value; });
  choice("lines", "change", c => { state.lines = c.checked; });
  choice("cut", "change", c => { state.cuts = c.checked; place("cut-where").hidden = !c.checked; });
  choice("cut-angle", "input", c => { state.cutAngle = Number(place("cut-angle-is").value = c.value); });
  choice("cut-move", "input", c => { state.cutMove = Number(place("cut-move-is").value = c.value); });
}

async function start() {
  const run = JSON.parse(place("run").textContent), canvas = place("view");
  const end = Math.max(...run.frames.map(f => f.time_s), ...run.traces.map(t => t.time.at(-1)), 1e-9);
  const showTime = drawTraces(place("traces"), run.traces, end);
  showTime(run.frames.at(-1).time_s);
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
