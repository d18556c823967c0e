// Draws the rock and the bit of one frame as the eye sees them.

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

const isPieceShown = (state, piece) => state.bit === "all" || (state.bit === "cutting" && !piece.hull);

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
  drawMesh(gl, at, run.bit.box, NOWHERE, [0, 0], scene.textures[state.bitColour === "areas" ? "areas" : "bit"], false);
  drawPieces(gl, at, scene.bit, run.bit.pieces.map(p => (
    {pose: entry.poses[p.body], count: 3 * p.triangles, isShown: isPieceShown(state, p)})));
}
