// Mouse, fingers and keys move the eye; buttons and sliders do the rest.

const TURN = 0.12, STEP = 1.15;  // of one key: rad, factor of distance

// What a key does; `true` when it did something.
function pressed(key, {camera, changed, step, play, home, cut}) {
  const acts = {
    ArrowLeft: () => orbit(camera, TURN, 0), ArrowRight: () => orbit(camera, -TURN, 0),
    ArrowUp: () => orbit(camera, 0, TURN), ArrowDown: () => orbit(camera, 0, -TURN),
    "+": () => zoom(camera, 1 / STEP), "=": () => zoom(camera, 1 / STEP), "-": () => zoom(camera, STEP),
    ",": () => step(-1), ".": () => step(1), " ": play, Home: home, c: cut,
  };
  if (!Object.hasOwn(acts, key)) return false;
  acts[key]();
  changed();
  return true;
}

function listenToKeys(canvas, view) {
  canvas.addEventListener("keydown", event => {
    if (!event.ctrlKey && !event.metaKey && !event.altKey && pressed(event.key, view)) event.preventDefault();
  });
}

// One finger or button orbits; with Shift or the right button it pans; two fingers zoom.
const STILL = 4;  // pixels: a pointer that moved less has clicked

function listenToPointers(canvas, {camera, changed, click}) {
  const down = new Map();
  let moved = 0;
  const apart = () => { const [a, b] = [...down.values()]; return Math.hypot(a.x - b.x, a.y - b.y); };
  canvas.addEventListener("pointerdown", event => {
    canvas.setPointerCapture(event.pointerId);
    down.set(event.pointerId, {x: event.clientX, y: event.clientY});
    moved = 0;
  });
  canvas.addEventListener("pointermove", event => {
    const old = down.get(event.pointerId);
    if (!old) return;
    const [right, low] = [event.clientX - old.x, event.clientY - old.y].map(d => d / canvas.clientHeight);
    const before = down.size === 2 ? apart() : 0;
    moved += Math.abs(event.clientX - old.x) + Math.abs(event.clientY - old.y);
    down.set(event.pointerId, {x: event.clientX, y: event.clientY});
    if (before) zoom(camera, before / Math.max(apart(), 1));
    else if (event.shiftKey || event.buttons === 2) pan(camera, right, -low);
    else orbit(camera, 4 * right, 4 * low);
    changed();
  });
  canvas.addEventListener("pointerup", event => {
    const box = canvas.getBoundingClientRect();
    if (click && down.size === 1 && moved < STILL) click(2 * (event.clientX - box.x) / box.width - 1, 1 - 2 * (event.clientY - box.y) / box.height);
  });
  for (const kind of ["pointerup", "pointercancel"]) canvas.addEventListener(kind, event => down.delete(event.pointerId));
  canvas.addEventListener("contextmenu", event => event.preventDefault());
  canvas.addEventListener("wheel", event => {
    zoom(camera, Math.exp(event.deltaY * 1e-3));
    changed();
    event.preventDefault();
  }, {passive: false});
}
