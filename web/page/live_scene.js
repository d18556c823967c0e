// The rock and the bit of now, as the 3-D page draws one frame of a run.

const HULL = "bit-body";  // what hides the bottom
const HIGH = 0.06;  // m over the lowest point: gage pads reach far up the wall

// Pieces of one body each, the hull last; triangles in their order.
function bitPieces(bit, parts, looks) {
  const keyOf = part => `${parts[part].kind === HULL ? 1 : 0} ${parts[part].body}`;
  const order = Array.from(bit.numbers.keys()).sort((a, b) => {
    const [ka, kb] = [keyOf(bit.numbers[a]), keyOf(bit.numbers[b])];
    return ka < kb ? -1 : ka > kb ? 1 : a - b;
  });
  const pieces = [], names = [...new Set(parts.map(p => wordsOfPart(p, looks)))], named = new Map(parts.map(p => [wordsOfPart(p, looks), colourOf(p, looks)]));
  let last = null;
  for (const t of order) {
    const key = keyOf(bit.numbers[t]);
    if (key !== last) pieces.push({hull: key[0] === "1", body: Number(key.slice(2)), triangles: 0});
    ++pieces.at(-1).triangles;
    last = key;
  }
  const colour = order.map(t => names.indexOf(wordsOfPart(parts[bit.numbers[t]], looks)));
  return {run: {box: bit.box, pieces, names, colours: names.map(name => named.get(name))}, mesh: {points: bit.points, corners: bit.corners.map(c => order.map(t => c[t])), colour}};
}

function colourOf(part, looks) {
  const cone = part.body - 1;
  if (cone >= 0 && part.kind === "tooth") return looks.cones[cone % looks.cones.length];
  return looks.kinds[part.kind] || looks.other;
}

// What the legend calls the parts of one colour.
function wordsOfPart(part, looks) {
  return part.kind === "tooth" && part.body > 0 ? `teeth of cone ${part.body}` : looks.words[part.kind] || "other parts";
}

// As many hues, neighbours far apart: steps of the golden section.
function groupColours(count) {
  const hex = (h, l, s) => {
    const f = n => { const k = (n + h * 12) % 12; return Math.round(255 * (l - s * Math.min(l, 1 - l) * Math.max(-1, Math.min(k - 3, 9 - k, 1)))); };
    return "#" + [f(0), f(8), f(4)].map(v => v.toString(16).padStart(2, "0")).join("");
  };
  return Array.from({length: count}, (_, k) => hex((0.618034 * k) % 1, [0.42, 0.58, 0.70][k % 3], 0.62));
}

// The header of a run with one frame.
function liveRun(facts, bitRun, names, looks) {
  return {title: facts.title, box: null, frames: [{}], bit: bitRun,
    colours: {depth: {ramp: looks.ramp, range_mm: [0, 1]}, part: {names, colours: [looks.uncut, ...groupColours(names.length - 1)]}, quality: looks.quality}};
}

// Depths of what cuts, over the bit's origin, mm: its colours go down with it.
function cuttingDepths(bit, pieces) {
  let low = Infinity, high = -Infinity, first = 0;
  const z = i => bit.box.origin[2] + bit.box.size[2] * bit.points[2][i] / 65535;
  for (const piece of pieces.run.pieces) {
    for (let t = first; t < first + piece.triangles && !piece.hull; ++t)
      for (const corner of pieces.mesh.corners) {
        low = Math.min(low, z(corner[t]));
        high = Math.max(high, z(corner[t]));
      }
    first += piece.triangles;
  }
  return [Math.max(low, high - HIGH), high].map(d => 1e3 * d);
}

// Puts the rock of now into the run and its one frame.
function takeRock(run, depths, rock, look) {
  run.box = rock.box;
  run.frames[0] = {number: 1, time_s: look.time_s, poses: look.poses, triangles: look.triangles};
  const z = 1e3 * look.poses[0][11];
  run.colours.depth.range_mm = depths.map(d => d + z);
  return {points: rock.points, corners: rock.corners, last: [rock.numbers]};
}
