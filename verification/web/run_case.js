// node run_case.js TDBD_JS FOLDER CASE STEPS OUT.ply: drills a case by the program for browsers, its files taken from FOLDER;
// prints the last look as JSON and writes the surface. Exit code 2: the case is refused.

delete globalThis.fetch;  // emscripten would fetch the program with it, which takes no paths
const fs = require("fs"), path = require("path");
const [program, folder, name, steps, out] = process.argv.slice(2);

function copyIn(FS, from, to) {
  FS.mkdirTree(to);
  for (const entry of fs.readdirSync(from, {withFileTypes: true})) {
    const [a, b] = [path.join(from, entry.name), `${to}/${entry.name}`];
    if (entry.isDirectory()) copyIn(FS, a, b);
    else FS.writeFile(b, fs.readFileSync(a));
  }
}

require(path.resolve(program))().then(tdbd => {
  copyIn(tdbd.FS, folder, "/cases");
  const call = (what, type, ...given) => tdbd.ccall(what, type, given.map(g => typeof g), given);
  const demand = answer => {
    if (answer < 0) {
      console.error(call("tdbd_text", "string"));
      process.exit(2);
    }
    return answer;
  };
  demand(call("tdbd_start", "number", `/cases/${name}`));
  const facts = JSON.parse(call("tdbd_facts", "string"));
  const before = performance.now();
  demand(call("tdbd_step", "number", Number(steps)));
  const seconds = 1e-3 * (performance.now() - before);
  const look = JSON.parse(call("tdbd_look", "string"));
  demand(call("tdbd_write_rock", "number", "/rock.ply"));
  fs.writeFileSync(out, tdbd.FS.readFile("/rock.ply"));
  console.log(JSON.stringify({...look, case_hash: facts.case_hash, commit: facts.commit, parts: facts.parts.map(p => p.name), seconds}));
});
