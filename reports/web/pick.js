// Which part of the bit is under a point of the picture.

// The ray from the eye through a point of the picture, which goes from -1 to 1 in both directions.
function rayThrough(camera, aspect, x, y) {
  const {right, up, toward} = cameraAxes(camera), half = Math.tan(FIELD / 2);
  return {from: camera.target.map((c, k) => c + camera.distance * toward[k]),
    along: [0, 1, 2].map(k => -toward[k] + half * (x * aspect * right[k] + y * up[k]))};
}

// The same ray as a body has it whose pose is three rows of four.
function rayInBody({from, along}, pose) {
  const moved = [0, 1, 2].map(k => from[k] - pose[4 * k + 3]);
  const turned = v => [0, 1, 2].map(k => pose[k] * v[0] + pose[4 + k] * v[1] + pose[8 + k] * v[2]);
  return {from: turned(moved), along: turned(along)};
}

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const crossed = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

// How far along the ray it meets a triangle (Moeller and Trumbore); Infinity where it does not.
function distanceTo({from, along}, a, b, c) {
  const e = minus(b, a), f = minus(c, a), p = crossed(along, f), volume = dot(e, p);
  if (Math.abs(volume) < 1e-18) return Infinity;
  const s = minus(from, a), u = dot(s, p) / volume, q = crossed(s, e), v = dot(along, q) / volume, far = dot(f, q) / volume;
  return u >= 0 && v >= 0 && u + v <= 1 && far > 0 ? far : Infinity;
}

// The number of the nearest shown part of the bit, -1 where there is none. Rock does not hide the bit from the ray.
function pickedPart(scene, x, y) {
  const {canvas, camera, state, run, bitMesh} = scene, {origin, size} = run.bit.box, entry = run.frames[state.frame];
  const ray = rayThrough(camera, canvas.clientWidth / canvas.clientHeight, x, y);
  const at = v => [0, 1, 2].map(k => origin[k] + size[k] * bitMesh.points[k][v] / 65535);
  let first = 0, nearest = Infinity, part = -1;
  for (const piece of run.bit.pieces) {
    const end = first + piece.triangles;
    if (isPieceShown(state, piece)) {
      const own = rayInBody(ray, entry.poses[piece.body]);
      for (let t = first; t < end; ++t) {
        const far = distanceTo(own, ...bitMesh.corners.map(column => at(column[t])));
        if (far < nearest) [nearest, part] = [far, bitMesh.part[t]];
      }
    }
    first = end;
  }
  return part;
}
