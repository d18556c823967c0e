// An eye on a sphere about what it looks at. Space has z down, as the hole; the picture has it down too.

const FIELD = 0.6;  // rad: of the picture's height

function homeCamera(box) {
  const middle = box.origin.map((o, k) => o + box.size[k] / 2);
  return {azimuth: 1.18, height: 0.62, distance: 0.82 * Math.hypot(...box.size) / (2 * Math.tan(FIELD / 2)), target: middle};
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

// Right, up and towards the eye, in space.
function cameraAxes(camera) {
  const [ca, sa, ch, sh] = [Math.cos(camera.azimuth), Math.sin(camera.azimuth), Math.cos(camera.height), Math.sin(camera.height)];
  return {right: [sa, -ca, 0], up: [-sh * ca, -sh * sa, -ch], toward: [ch * ca, ch * sa, -sh]};
}

// Column by column, as WebGL wants it: from space to the picture.
function viewMatrix(camera, aspect) {
  const {right, up, toward} = cameraAxes(camera);
  const f = 1 / Math.tan(FIELD / 2), near = camera.distance / 50, far = camera.distance * 20;
  const a = (far + near) / (near - far), b = 2 * far * near / (near - far);
  const x = -dot(right, camera.target), y = -dot(up, camera.target), z = -dot(toward, camera.target) - camera.distance;
  const matrix = [];
  for (let k = 0; k < 3; ++k) matrix.push(f / aspect * right[k], f * up[k], a * toward[k], -toward[k]);
  return [...matrix, f / aspect * x, f * y, a * z + b, -z];
}

function orbit(camera, right, up) {
  camera.azimuth += right;
  camera.height = Math.max(-1.57, Math.min(1.57, camera.height + up));
}

function zoom(camera, factor) {
  camera.distance = Math.max(1e-3, Math.min(20, camera.distance * factor));
}

// By shares of the picture's height.
function pan(camera, right, up) {
  const axes = cameraAxes(camera), reach = 2 * camera.distance * Math.tan(FIELD / 2);
  for (let k = 0; k < 3; ++k) camera.target[k] -= reach * (right * axes.right[k] + up * axes.up[k]);
}
