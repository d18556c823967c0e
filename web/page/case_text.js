// The case that a choice of the form means: a text that `tdbd run` takes too.

const STEPS_PER_REVOLUTION = 200;
const CONES = new Set(["r", "m"]);  // bits whose cones roll

// Names that stand in a TOML text and in a path.
const plainName = name => name.replace(/\.[^.]*$/, "").replace(/[^A-Za-z0-9_-]+/g, "-") || "dropped";

const quoted = words => `"${String(words).trim()}"`;

function rockLines(choice) {
  return ["[rock]", 'shape = "conforming"', `edge_length = ${quoted(`${choice.edge} mm`)}`, `wall = "${CONES.has(choice.bit) ? 90 : 30} mm"`,
    'material = "mancos-shale"', 'pressure = "3000 psi"'];
}

function motionLines(choice) {
  const lines = ["[motion]", `kind = "${choice.whirls ? "whirl" : "steady"}"`, `rotary_speed = ${quoted(`${choice.speed} rpm`)}`,
    `rate_of_penetration = ${quoted(`${choice.rate} m/h`)}`];
  if (CONES.has(choice.bit)) lines.push('cone_speeds = "rolling"');
  if (choice.whirls)
    lines.push("", "[motion.whirl]", `radius = ${quoted(`${choice.whirlRadius} mm`)}`, `frequency = ${quoted(`${choice.whirlTimes * choice.speed} rpm`)}`,
      `sense = "${choice.whirlSense}"`);
  return lines;
}

function lawLines(choice) {
  if (CONES.has(choice.bit)) return ["[forces]", 'law = "indentation"'];
  return ["[forces]", 'law = "hanson-hansen"', "A1 = 1.0", "A2 = 0.3", 'A3 = "18 deg"', "A4 = 0.5", "A5 = 1.0", "A6 = 0.3"];
}

function caseText(choice) {
  const step = 60 / (STEPS_PER_REVOLUTION * Number(choice.speed));
  return ["# From the page that drills in a browser. The force law is reconstructed, its coefficients are starting values, not calibrated.", "",
    "[bit]", `file = "bits/${bitFile(choice)}"`, "", ...rockLines(choice), "", ...motionLines(choice), "",
    "[time]", `step = ${quoted(`${Number.isFinite(step) ? step : 0} s`)}`, `revolutions = ${choice.revolutions}`, "", ...lawLines(choice), ""].join("\n");
}

const bitFile = choice => choice.bit === "own" ? `${plainName(choice.table.name)}.toml` : `bit-${choice.bit}.toml`;

// A bit file around a table of cutters, with the cutters of the shipped bits.
function ownBitText(choice) {
  return [`# Cutters from ${choice.table.name}; the rest as in bit B.`, `name = "${plainName(choice.table.name)}"`, `table = "${plainName(choice.table.name)}.csv"`,
    `gage_diameter = ${quoted(`${choice.gage} mm`)}`, "", "[cutters]", 'chamfer = "0.3 mm"', 'chamfer_angle = "45 deg"', 'length = "13 mm"',
    'table_thickness = "2 mm"', "", "[mesh]", 'grading = "graded"', "rim_segments = 64", ""].join("\n");
}

// {path: text} of all that the case needs, the case itself as case.toml.
function caseFiles(choice, shipped) {
  const files = Object.fromEntries(Object.entries(shipped).map(([name, text]) => [`bits/${name}`, text]));
  if (choice.bit === "own") {
    files[`bits/${bitFile(choice)}`] = ownBitText(choice);
    files[`bits/${plainName(choice.table.name)}.csv`] = choice.table.text;
  }
  return {...files, "case.toml": caseText(choice)};
}

// The widest reach of a table's tips, mm across; NaN where it has no such column: the program then says what is wrong.
function gageOf(text) {
  const rows = text.split(/\r?\n/).map(r => r.trim()).filter(r => r && !r.startsWith("#")).map(r => r.split(",").map(c => c.trim()));
  const column = rows.length ? rows[0].indexOf("r_tip_mm") : -1;
  return column < 0 ? NaN : 2 * Math.max(...rows.slice(1).map(r => Number(r[column])));
}
