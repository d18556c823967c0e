// Triangles as WebGL draws them: three corners each, with their place and the number of a colour.

const WORDS = 4;  // of 16 bits a corner: x, y, z of the grid, colour

function corners(points, triangles, colourOf) {
  const count = triangles[0].length, words = new Uint16Array(3 * count * WORDS);
  for (let t = 0, w = 0; t < count; ++t) {
    const colour = colourOf(t);
    for (let k = 0; k < 3; ++k, w += WORDS) {
      const v = triangles[k][t];
      words[w] = points[0][v], words[w + 1] = points[1][v], words[w + 2] = points[2][v], words[w + 3] = colour;
    }
  }
  return words;
}

// Of a triangle: the group that cut two of its corners last, or else the first.
function lastOf(frame, t) {
  const [a, b, c] = frame.corners.map(column => frame.last[0][column[t]]);
  return b === c ? b : a;
}

// 1 for an equilateral triangle, 0 for a flat one: 4 sqrt(3) area / sum of the squares of its sides, as the program has it.
function qualityOf(frame, box, t) {
  const p = frame.corners.map(column => frame.points.map((x, k) => x[column[t]] * box.size[k] / 65535));
  const minus = (a, b) => a.map((x, k) => x - b[k]);
  const [u, v, w] = [minus(p[1], p[0]), minus(p[2], p[0]), minus(p[2], p[1])];
  const cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const squares = dot(u, u) + dot(v, v) + dot(w, w);
  return squares > 0 ? 2 * Math.sqrt(3 * dot(cross, cross)) / squares : 0;
}

function stepOf(value, steps) {
  let k = 0;
  while (k < steps.length - 2 && value >= steps[k + 1]) ++k;
  return k;
}

// What colours a triangle of the rock.
function rockColour(run, frame, mode) {
  if (mode === "part") return t => lastOf(frame, t);
  if (mode === "quality") return t => stepOf(qualityOf(frame, run.box, t), run.colours.quality.steps);
  return () => 0;
}

function newMesh(gl) {
  const mesh = {array: gl.createVertexArray(), buffer: gl.createBuffer()};
  gl.bindVertexArray(mesh.array);
  gl.bindBuffer(gl.ARRAY_BUFFER, mesh.buffer);
  gl.enableVertexAttribArray(0);
  gl.enableVertexAttribArray(1);
  gl.vertexAttribPointer(0, 3, gl.UNSIGNED_SHORT, true, 2 * WORDS, 0);
  gl.vertexAttribPointer(1, 1, gl.UNSIGNED_SHORT, true, 2 * WORDS, 6);
  return mesh;
}

function fill(gl, mesh, words) {
  gl.bindBuffer(gl.ARRAY_BUFFER, mesh.buffer);
  gl.bufferData(gl.ARRAY_BUFFER, words, gl.DYNAMIC_DRAW);
  mesh.corners = words.length / WORDS;
}

// A list of colours as a texture, 256 to a row.
function colourTexture(gl, list) {
  const rows = Math.ceil(list.length / 256), bytes = new Uint8Array(4 * 256 * rows);
  list.forEach((hex, k) => bytes.set([1, 3, 5].map(i => parseInt(hex.slice(i, i + 2), 16)).concat(255), 4 * k));
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 256, rows, 0, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  return texture;
}
