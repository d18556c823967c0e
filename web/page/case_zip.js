// What a user takes away of a case: its assumptions in words, a ZIP file that `tdbd run` accepts as unpacked, and a template of a cutter table.

// What an own bit assumes beside its table.
function bitAssumptions(choice) {
  if (choice.bit !== "own") return [`The bit is bits/${bitFile(choice)}: representative, not a copy of a real bit.`];
  const sharp = Number(choice.chamfer) === 0;
  return [
    sharp ? "Cutters are sharp, unless the table has a column chamfer_mm." :
      `Cutters have a chamfer of ${choice.chamfer} mm at ${choice.chamferAngle} degrees, unless the table has the columns chamfer_mm and chamfer_deg. A chamfer takes weight; 0 is a sharp edge.`,
    `Cutters are ${choice.cutterLength} mm long with a diamond table of ${choice.diamond} mm, unless the table has the columns length_mm and table_mm.`,
    `The gage diameter is ${choice.gage} mm: no cutter may reach outside it.`,
    "The bit has cutters alone: no blades, no gage pads and no body that could touch the rock.",
  ];
}

function motionAssumptions(choice) {
  if (choice.drive !== "weight")
    return [`The bit keeps a rate of penetration of ${choice.rate} m/h${choice.whirls ? " and its whirl" : ""}, however large the forces become. WOB and TOB are results.`];
  const torque = startTorque(choice) ? ` and a torque of ${startTorque(choice)} N m` : "";
  return [`The weight on bit is ${choice.weight} kN; the rate of penetration is a result. The run starts at the expected rate of ${choice.rate} m/h${torque}, and needs about a second to forget this start.`,
    `A short string turns the bit: 1000 kg, as in cases/drill-bit-${CONES.has(choice.bit) ? "r" : "b"}.toml. Its stiffness and damping are chosen, not measured.`];
}

// All that the case assumes and the user may want to know, in sentences.
function assumptions(choice) {
  return [...bitAssumptions(choice),
    `The rock is ${ROCKS[choice.rock]} under a mud pressure of ${choice.pressure} MPa. The pore pressure and the overburden are 0.`,
    lawsOf(choice.bit)[lawOf(choice)].assumes(choice),
    ...motionAssumptions(choice),
    `The hole starts with the shape of the bit and a wall of ${wallHeight(choice)}. Its triangles have edges of ${choice.edge} mm; finer ones change forces, and take longer.`,
    `A time step is ${Number(stepOf_s(choice).toPrecision(3))} s. Cutters do not wear, and no rock breaks out beside them.`];
}

const folderOf = choice => choice.bit === "own" ? plainName(choice.table.name) : `bit-${choice.bit}`;

function readmeText(choice, paths, program) {
  return ["A case of TDBD, made by its page for browsers.", `Program: TDBD ${program}`, "", "In this folder:", "",
    "    tdbd check case.toml", "    tdbd run case.toml -o result", "", "Files:", ...paths.map(path => `- ${path}`), "", "The case assumes:",
    ...assumptions(choice).map(words => `- ${words}`), ""].join("\n");
}

// {path: text} of the ZIP file, in a folder of its own. `program`: version and commit, in words.
function zipFiles(choice, shipped, program) {
  const files = caseFiles(choice, shipped), all = {"README.txt": readmeText(choice, Object.keys(files), program), ...files};
  return Object.fromEntries(Object.entries(all).map(([path, text]) => [`${folderOf(choice)}/${path}`, text]));
}

const CRC_TABLE = Uint32Array.from({length: 256}, (_, n) => {
  let c = n;
  for (let k = 0; k < 8; ++k) c = c & 1 ? 0xEDB88320 ^ (c >>> 1) : c >>> 1;
  return c;
});

function crc32(bytes) {
  let c = 0xFFFFFFFF;
  for (const b of bytes) c = CRC_TABLE[(c ^ b) & 0xFF] ^ (c >>> 8);
  return (c ^ 0xFFFFFFFF) >>> 0;
}

// Numbers of 2 (h) or 4 (w) bytes, the lowest byte first.
function packed(layout, ...numbers) {
  const bytes = [];
  numbers.forEach((n, k) => { for (let i = 0; i < (layout[k] === "w" ? 4 : 2); ++i) bytes.push(Math.floor(n / 256 ** i) & 0xFF); });
  return bytes;
}

const ZIP_VERSION = 20, UTF8 = 0x0800, STORED = 0, MADE_BY_UNIX = 3 << 8, FILE_MODE = 0o100644 * 65536;
const NEW_YEAR_1980 = [0, 0x0021];  // time and date of every entry, so that the same case gives the same bytes

// A ZIP file of {path: text}, its entries not compressed.
function zipOf(files) {
  const encoder = new TextEncoder(), bytes = [], directory = [];
  const append = (to, from) => { for (const b of from) to.push(b); };
  let count = 0;
  for (const [path, text] of Object.entries(files)) {
    const name = encoder.encode(path), content = encoder.encode(text), start = bytes.length;
    const common = [UTF8, STORED, ...NEW_YEAR_1980, crc32(content), content.length, content.length, name.length, 0];
    append(bytes, packed("whhhhhwwwhh", 0x04034B50, ZIP_VERSION, ...common));
    append(bytes, name);
    append(bytes, content);
    append(directory, packed("whhhhhhwwwhhhhhww", 0x02014B50, MADE_BY_UNIX + ZIP_VERSION, ZIP_VERSION, ...common, 0, 0, 0, FILE_MODE, start));
    append(directory, name);
    ++count;
  }
  const end = packed("whhhhwwh", 0x06054B50, 0, 0, count, count, directory.length, bytes.length, 0);
  append(bytes, directory);
  append(bytes, end);
  return Uint8Array.from(bytes);
}

const COLUMNS = [
  "Cutter table of TDBD. Lines that begin with # are skipped. Replace the rows with your cutters: one row per cutter.",
  "bit: any name. cutter: its number. blade: from 1. zone: cone nose shoulder gage or any word.",
  "dia_mm: diameter. r_tip_mm: distance of the tip from the axis of the bit. phi_deg: azimuth of the tip. h_tip_mm: height of the tip above the lowest point of the profile.",
  "profile_angle_deg: between the normal of the profile and the axis. Negative in the cone and 0 at the nose and 90 at the gage. back_rake_deg and side_rake_deg: rakes of the face.",
  "Optional columns: chamfer_mm chamfer_deg length_mm table_mm wear_mm under_exposure_mm.",
];

// A cutter table to fill in: the columns in words, and the rows of a shipped bit as an example. Spreadsheets would split words at commas.
const templateCsv = example => [...COLUMNS.map(words => `# ${words}`), ...example.trimEnd().split("\n"), ""].join("\n");

// The rows of a table as cells: lists separated by commas, semicolons or tabs, with decimal points or commas.
function cellsOf(text) {
  const rows = text.split(/\r?\n/).map(r => r.trim()).filter(r => r && !r.startsWith("#"));
  const mark = [";", "\t", ","].find(m => rows.length && rows[0].includes(m)) || ",";
  return rows.map(r => r.split(mark).map(c => c.trim()));
}

// The widest reach of a table's tips, mm across; NaN without a column of radii: the program then reports what is wrong.
function gageOf(text) {
  const rows = cellsOf(text), heads = rows.length ? rows[0].map(h => h.toLowerCase()) : [];
  const column = heads.findIndex(h => h === "r_tip_mm" || h === "r_tip_in"), unit = heads[column] === "r_tip_in" ? 25.4 : 1;
  return column < 0 ? NaN : 2 * unit * Math.max(...rows.slice(1).map(r => Number((r[column] || "").replace(",", "."))));
}
