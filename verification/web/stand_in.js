// In place of the program for browsers: one cutter and a body of one triangle each, a rock of one triangle, ten steps. It reads no case;
// one with a rotary speed of 13 rpm is refused.

async function createTdbd() {
  const files = {}, heap = new ArrayBuffer(4096), parts = [{name: "cutter-1/face", kind: "face", body: 0}, {name: "body", kind: "bit-body", body: 0}];
  new Float64Array(heap, 0, 18).set([0, 0, 0, 0.05, 0, 0, 0, 0.05, 0.01, 0, 0, 0.02, 0.05, 0, 0.03, 0, 0.05, 0.02]);
  new Int32Array(heap, 1024, 6).set([0, 1, 2, 3, 4, 5]);
  let steps = 0, shown = {};
  const pose = () => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0.001 * steps];
  const answers = {
    tdbd_start: () => { steps = 0; return files["/case/case.toml"].includes('"13 rpm"') ? -1 : 0; },
    tdbd_text: () => "case.toml: found 13 rpm, expected another speed",
    tdbd_facts: () => JSON.stringify({title: "stand-in", warnings: [], gage_radius_m: 0.1, parts}),
    tdbd_look: () => JSON.stringify({steps, done: steps >= 10, time_s: 0.1 * steps, revolutions: 0.2 * steps, removed_m3: 1e-6 * steps,
      removed_by_part_m3: [1e-6 * steps, 0], wob_n: 30000, tob_n_m: 2000, triangles: 1, poses: [pose()]}),
    tdbd_step: () => steps < 10 ? (++steps, 1) : 0,
    tdbd_time: () => 0.1 * steps, tdbd_wob: () => 30000, tdbd_tob: () => 2000,
    tdbd_show_rock: () => { shown = {vertices: 3, triangles: 1, numbers: [0, 0, 0]}; },
    tdbd_show_bit: () => { shown = {vertices: 6, triangles: 2, numbers: [0, 1]}; },
    tdbd_vertex_count: () => shown.vertices, tdbd_triangle_count: () => shown.triangles,
    tdbd_positions: () => 0, tdbd_triangles: () => 1024,
    tdbd_numbers: () => { new Int32Array(heap, 2048, shown.numbers.length).set(shown.numbers); return 2048; },
    tdbd_write_rock: () => 0,
  };
  return {HEAPU8: new Uint8Array(heap), ccall: name => answers[name](),
    FS: {mkdirTree() {}, writeFile(path, text) { files[path] = text; }, readFile: () => new Uint8Array(4)}};
}
