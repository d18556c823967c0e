// Undoes page3d_pack.py: inflates, puts planes of bytes together, adds differences up.

async function inflate(base64) {
  const bytes = Uint8Array.from(atob(base64), c => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// A reader of one array after another.
function arrayReader(bytes) {
  let place = 0;
  return (rows, columns, before) => {
    const count = rows * columns;
    const plane = k => bytes.subarray(place + k * count, place + (k + 1) * count);
    const [a, b, c, d] = [plane(0), plane(1), plane(2), plane(3)];
    place += 4 * count;
    if (d.length !== count) throw new Error("the data end too soon");
    return Array.from({length: columns}, (_, column) => {
      const values = new Int32Array(rows), old = before ? before[column] : [];
      for (let i = 0, j = column * rows; i < rows; ++i, ++j) {
        const word = a[j] | b[j] << 8 | c[j] << 16 | d[j] << 24;
        values[i] = ((word >>> 1) ^ -(word & 1)) + (i < old.length ? old[i] : i ? values[i - 1] : 0);
      }
      return values;
    });
  };
}

// Columns of numbers: points on their grid, corners of triangles, the group that cut each point last.
function unpackFrames(entries, read) {
  let before = {};
  return entries.map(entry => {
    const old = (k, name) => entry.changes[k] ? before[name] : null;
    before = {
      points: read(entry.points, 3, old(0, "points")),
      corners: read(entry.triangles, 3, old(1, "corners")),
      last: read(entry.points, 1, old(2, "last")),
    };
    return before;
  });
}

function unpackBit(entry, read) {
  return {points: read(entry.points, 3), corners: read(entry.triangles, 3), colour: read(entry.triangles, 1)[0]};
}
