// Undoes page3d_pack.py: inflates, puts planes of bytes together, adds differences up.

async function inflate(base64) {
  const bytes = Uint8Array.from(atob(base64), c => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// A reader of one array after another: differences from rows of old columns, or, where there is none, from the row before.
function arrayReader(bytes) {
  let place = 0;
  return (rows, columns, old, continued) => {
    const count = rows * columns;
    const plane = k => bytes.subarray(place + k * count, place + (k + 1) * count);
    const [a, b, c, d] = [plane(0), plane(1), plane(2), plane(3)];
    place += 4 * count;
    if (d.length !== count) throw new Error("the data end too soon");
    return Array.from({length: columns}, (_, column) => {
      const values = new Int32Array(rows);
      for (let i = 0, j = column * rows; i < rows; ++i, ++j) {
        const word = a[j] | b[j] << 8 | c[j] << 16 | d[j] << 24;
        const from = old && continued[i] >= 0 ? old[column][continued[i]] : i ? values[i - 1] : 0;
        values[i] = ((word >>> 1) ^ -(word & 1)) + from;
      }
      return values;
    });
  };
}

const BLOCK = 64;  // rows with one shift

// Of each row: the row of the frame before that it continues, as page3d_pack.py has it; -1 for a new one.
function rowsBefore(count, oldCount, read) {
  const shifts = read(Math.ceil(count / BLOCK), 1)[0];
  return Int32Array.from({length: count}, (_, i) => {
    const row = i + shifts[Math.floor(i / BLOCK)];
    return row < oldCount ? Math.max(row, -1) : -1;
  });
}

// Of each point of the frame before: its number now; of one that is gone, that of the last before it that is not.
function namesNow(rows, oldCount) {
  const now = new Int32Array(oldCount).fill(-1);
  for (let i = rows.length - 1; i >= 0; --i) if (rows[i] >= 0) now[rows[i]] = i;
  for (let v = 0; v < oldCount; ++v) if (now[v] < 0) now[v] = v ? now[v - 1] : 0;
  return now;
}

function unpackOverTime(entry, before, read) {
  const oldPoints = before.points[0].length, oldTriangles = before.corners[0].length;
  const rows = rowsBefore(entry.points, oldPoints, read);
  const points = read(entry.points, 3, before.points, rows), last = read(entry.points, 1, before.last, rows);
  const same = rowsBefore(entry.triangles, oldTriangles, read), now = namesNow(rows, oldPoints);
  const named = before.corners.map(column => column.map(v => now[v]));
  return {points, last, corners: read(entry.triangles, 3, named, same)};
}

// Columns of numbers: points on their grid, the group that cut each last, corners of triangles.
function unpackFrames(entries, read) {
  let before = null;
  return entries.map(entry => before = entry.over_time
    ? unpackOverTime(entry, before, read)
    : {points: read(entry.points, 3), last: read(entry.points, 1), corners: read(entry.triangles, 3)});
}

function unpackBit(entry, read) {
  const bit = {points: read(entry.points, 3), corners: read(entry.triangles, 3), colour: read(entry.triangles, 1)[0], part: read(entry.triangles, 1)[0]};
  return entry.areas ? {...bit, area: read(entry.triangles, 1)[0]} : bit;
}
