// What is drawn, and the choices of how: colours, bit, lines, section.

const place = id => document.getElementById(id);

// Takes another run into a scene: its colours, its bit, and an eye that sees all of its first rock.
function showRun(scene, run, frames, bit) {
  const {gl} = scene, old = Object.values(scene.textures || {});
  const textures = {bit: colourTexture(gl, [...run.bit.colours, SELECTED]), depth: colourTexture(gl, run.colours.depth.ramp)};
  if (run.bit.areas) textures.areas = colourTexture(gl, [...run.bit.areas.colours, SELECTED]);
  for (const mode of ["part", "quality"]) textures[mode] = colourTexture(gl, run.colours[mode].colours);
  old.forEach(texture => gl.deleteTexture(texture));
  Object.assign(scene, {run, frames, textures, bitMesh: bit});
  scene.state.frame = frames.length - 1;
  Object.assign(scene.camera, homeCamera(run.box));
  fillBit(scene);
  showBitLegend(place("bit-legend"), run.bit, scene.state.bitColour);
}

const SELECTED = "#ff2fd0";  // of the part that is selected: no other colour of the page is near

// In the colours of its kinds of part, or of its areas; the selected part in its own.
function fillBit(scene) {
  const {gl, bitMesh, state, run} = scene, isAreas = state.bitColour === "areas", colour = isAreas ? bitMesh.area : bitMesh.colour;
  const own = (isAreas ? run.bit.areas : run.bit).colours.length, part = bitMesh.part;
  fill(gl, scene.bit, corners(bitMesh.points, bitMesh.corners, t => part && part[t] === state.selected ? own : colour[t]));
}

function newScene(gl, canvas, run, frames, bit) {
  const {program, at} = drawingProgram(gl);
  gl.useProgram(program);
  gl.enable(gl.DEPTH_TEST);
  const state = {frame: 0, mode: "depth", bit: "cutting", bitColour: "kind", selected: -1, lines: false, cuts: false, cutAngle: 68, cutMove: 0, plays: false};
  const scene = {gl, at, canvas, state, camera: {}, rock: newMesh(gl), bit: newMesh(gl)};
  showRun(scene, run, frames, bit);
  return scene;
}

function fillRock(scene) {
  const {gl, run, state} = scene, frame = scene.frames[state.frame];
  fill(gl, scene.rock, corners(frame.points, frame.corners, rockColour(run, frame, state.mode)));
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

// Colours, bit, lines and section.
function listenToChoices(scene, changed, refill) {
  const {state} = scene;
  const choice = (id, event, act) => place(id).addEventListener(event, () => { act(place(id)); changed(); });
  const colour = () => { state.mode = place("colour").value; showLegend(place("legend"), scene.run.colours, state.mode); refill(); };
  place("colour").addEventListener("change", colour);
  showLegend(place("legend"), scene.run.colours, state.mode);
  choice("bit", "change", c => { state.bit = c.value; });
  if (place("bit-colour")) choice("bit-colour", "change", c => {
    state.bitColour = c.value;
    fillBit(scene);
    showBitLegend(place("bit-legend"), scene.run.bit, c.value);
  });
  choice("lines", "change", c => { state.lines = c.checked; });
  choice("cut", "change", c => { state.cuts = c.checked; place("cut-where").hidden = !c.checked; });
  choice("cut-angle", "input", c => { state.cutAngle = Number(place("cut-angle-is").value = c.value); });
  choice("cut-move", "input", c => { state.cutMove = Number(place("cut-move-is").value = c.value); });
}
