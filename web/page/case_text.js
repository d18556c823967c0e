// The case that the choices of the form describe: texts that `tdbd run` accepts.

const STEPS_PER_REVOLUTION = {rate: 200, weight: 500};  // forces that move the bit need shorter steps
const CONES = new Set(["r", "m"]);  // bits whose cones roll
const ROCKS = {"mancos-shale": "Mancos shale", "catoosa-shale": "Catoosa shale", "berea-sandstone": "Berea sandstone",
  "crab-orchard-sandstone": "Crab Orchard sandstone", "indiana-limestone": "Indiana limestone", "carthage-marble": "Carthage marble",
  "texas-granite": "Texas granite", "sierra-white-granite": "Sierra White granite", "forge-granitoid": "FORGE granitoid"};

// The laws of each kind of bit: the words of the form, the lines of [forces], and what they assume.
const CUTTER_LAWS = {
  "hanson-hansen": {words: "Hanson and Hansen", lines: () => ["A1 = 1.0", "A2 = 0.3", 'A3 = "18 deg"', "A4 = 0.5", "A5 = 1.0", "A6 = 0.3"],
    assumes: () => "The force law hanson-hansen is reconstructed. Its coefficients are starting values, not calibrated. Forces grow with the strength of the rock."},
  "detournay": {words: "Detournay", lines: choice => [`eps = ${quoted(`${choice.energy} MPa`)}`, "zeta = 0.8"],
    assumes: choice => `The force law detournay has an intrinsic specific energy of ${choice.energy} MPa, normal forces of 0.8 times the cutting force, and no `
      + "friction of wear flats. It ignores the strength of the rock and the pressure: choose the specific energy for your rock."},
  "thin-cut": {words: "Miedema, thin cuts", lines: () => [],
    assumes: () => "The force law thin-cut has its default coefficients. It computes the forces of faces alone; forces grow with the strength of the rock."},
};
const CONE_LAWS = {
  "indentation": {words: "indentation", lines: () => [],
    assumes: () => "The force law indentation has its default coefficients: teeth press with the confined strength of the rock, with a friction of 0.3. It is not calibrated."},
};

const lawsOf = bit => CONES.has(bit) ? CONE_LAWS : CUTTER_LAWS;
const lawOf = choice => Object.hasOwn(lawsOf(choice.bit), choice.law) ? choice.law : Object.keys(lawsOf(choice.bit))[0];

// Names that a TOML text and a path may contain.
const plainName = name => name.replace(/\.[^.]*$/, "").replace(/[^A-Za-z0-9_-]+/g, "-") || "dropped";

const quoted = words => `"${String(words).trim()}"`;

const wallHeight = choice => CONES.has(choice.bit) ? "90 mm" : "30 mm";

function rockLines(choice) {
  return ["[rock]", 'shape = "conforming"', `edge_length = ${quoted(`${choice.edge} mm`)}`, `wall = "${wallHeight(choice)}"`,
    `material = ${quoted(choice.rock)}`, `pressure = ${quoted(`${choice.pressure} MPa`)}`];
}

// The motion at a set rate: steady or whirling.
function rateLines(choice) {
  const lines = ["[motion]", `kind = "${choice.whirls ? "whirl" : "steady"}"`, `rotary_speed = ${quoted(`${choice.speed} rpm`)}`,
    `rate_of_penetration = ${quoted(`${choice.rate} m/h`)}`];
  if (CONES.has(choice.bit)) lines.push('cone_speeds = "rolling"');
  if (choice.whirls)
    lines.push("", "[motion.whirl]", `radius = ${quoted(`${choice.whirlRadius} mm`)}`, `frequency = ${quoted(`${choice.whirlTimes * choice.speed} rpm`)}`,
      `sense = "${choice.whirlSense}"`);
  return lines;
}

const TORQUE_PER_WEIGHT = 87;  // N m per kN of a PDC bit: that of cases/drill-bit-b.toml

const startTorque = choice => CONES.has(choice.bit) ? 0 : Math.round(TORQUE_PER_WEIGHT * Number(choice.weight));

// The string of cases/drill-bit-b.toml, or of cases/drill-bit-r.toml for roller cones.
const STRINGS = {
  cutters: {lateral_stiffness: "5e7 N/m", lateral_damping: "2e5 N s/m", axial_damping: "2e5 N s/m"},
  cones: {lateral_stiffness: "1e7 N/m", lateral_damping: "1e4 N s/m", axial_damping: "2e4 N s/m"},
  both: {mass: "1000 kg", torsional_inertia: "10 kg m2", bending_inertia: "10 kg m2", torsional_stiffness: "5000 N m/rad",
    torsional_damping: "50 N m s/rad", bending_stiffness: "1e6 N m/rad", bending_damping: "1e3 N m s/rad"},
};

// The motion under a set weight: forces move the bit at the end of a short string.
function weightLines(choice) {
  const string = {...STRINGS.both, ...STRINGS[CONES.has(choice.bit) ? "cones" : "cutters"]};
  const lines = ["[motion]", 'kind = "drilling"', `rotary_speed = ${quoted(`${choice.speed} rpm`)}`, `weight_on_bit = ${quoted(`${choice.weight} kN`)}`,
    `expected_rate = ${quoted(`${choice.rate} m/h`)}`];
  if (startTorque(choice)) lines.push(`torque_at_start = ${quoted(`${startTorque(choice)} N m`)}`);
  return [...lines, "", "[string]", ...Object.entries(string).map(([key, value]) => `${key} = ${quoted(value)}`), "attachment_height = 0  # the nose"];
}

const motionLines = choice => choice.drive === "weight" ? weightLines(choice) : rateLines(choice);

function lawLines(choice) {
  const law = lawOf(choice);
  return ["[forces]", `law = "${law}"`, ...lawsOf(choice.bit)[law].lines(choice)];
}

function stepOf_s(choice) {
  const step = 60 / (STEPS_PER_REVOLUTION[choice.drive] * Number(choice.speed));
  return Number.isFinite(step) ? step : 0;
}

function caseText(choice) {
  return ["# From the page that drills in a browser. README.txt of the ZIP file lists what this case assumes.", "",
    "[bit]", `file = "bits/${bitFile(choice)}"`, "", ...rockLines(choice), "", ...motionLines(choice), "",
    "[time]", `step = ${quoted(`${stepOf_s(choice)} s`)}`, `revolutions = ${choice.revolutions}`, "", ...lawLines(choice), ""].join("\n");
}

const bitFile = choice => choice.bit === "own" ? `${plainName(choice.table.name)}.toml` : `bit-${choice.bit}.toml`;

// A bit file around a table of cutters. It has what the form shows, and nothing else.
function ownBitText(choice) {
  const name = plainName(choice.table.name);
  return [`# Cutters from ${choice.table.name.replace(/[^ -~]+/g, " ")}. The values of [cutters] apply where the table has no column for them.`,
    `name = "${name}"`, `table = "${name}.csv"`, `gage_diameter = ${quoted(`${choice.gage} mm`)}`, "", "[cutters]",
    `chamfer = ${quoted(`${choice.chamfer} mm`)}`, `chamfer_angle = ${quoted(`${choice.chamferAngle} deg`)}`, `length = ${quoted(`${choice.cutterLength} mm`)}`,
    `table_thickness = ${quoted(`${choice.diamond} mm`)}`, "", "[mesh]", 'grading = "graded"', "rim_segments = 64", ""].join("\n");
}

// {path: text} of the bit that the case needs.
function bitFiles(choice, shipped) {
  if (choice.bit === "own") return {[`bits/${bitFile(choice)}`]: ownBitText(choice), [`bits/${plainName(choice.table.name)}.csv`]: choice.table.text};
  const names = [bitFile(choice), bitFile(choice).replace(".toml", ".csv")];
  return Object.fromEntries(names.filter(name => name in shipped).map(name => [`bits/${name}`, shipped[name]]));
}

// {path: text} of all that the case needs, the case itself as case.toml.
const caseFiles = (choice, shipped) => ({...bitFiles(choice, shipped), "case.toml": caseText(choice)});
