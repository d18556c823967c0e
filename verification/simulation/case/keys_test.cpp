#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "bit/files/bit_file.hpp"
#include "core/error.hpp"
#include "core/temporary_file.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/case_kind.hpp"
#include "simulation/case/force_keys.hpp"
#include "simulation/case/key_tables.hpp"
#include "simulation/chain/chain_case.hpp"
#include "simulation/rotate/rotate_case.hpp"

/// The declared keys against the cases that are read with them.
namespace tdbd::simulation::keys_test {

namespace fs = std::filesystem;

const std::vector<std::string> part_kinds{"face",     "chamfer",  "cse",  "cutter_body",
                                          "gage_pad", "bit_body", "cone", "tooth"};

/// One line of a resolved file: the table as it is declared, and its place in the file.
struct Resolved {
  std::string table, place, key, value, unit;
};

/// Where tables of a file stand, line for line: the second [[legs]] at "legs[1]", [legs.grading]
/// after it at "legs[1].grading".
class Places {
 public:
  std::string of(const std::string& header) {
    const bool repeats = header.starts_with("[[");
    const std::string table = header.substr(repeats ? 2 : 1, header.find(']') - (repeats ? 2 : 1));
    if (repeats) ++count_[table];
    for (const auto& [name, count] : count_)
      if (table == name || table.starts_with(name + "."))
        return name + "[" + std::to_string(count - 1) + "]" + table.substr(name.size());
    return table;
  }

 private:
  std::map<std::string, int> count_;
};

/// Every key of a resolved file.
std::vector<Resolved> lines_of(const std::string& resolved) {
  std::vector<Resolved> lines;
  std::istringstream in(resolved);
  Places places;
  std::string table, place;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    if (line.front() == '[') {
      const std::size_t first = line.find_first_not_of('[');
      table = line.substr(first, line.find(']') - first);
      place = places.of(line);
      continue;
    }
    const std::size_t equals = line.find(" = "), unit = line.rfind("  # ");
    lines.push_back({table, place, line.substr(0, equals),
                     line.substr(equals + 3, unit == std::string::npos ? unit : unit - equals - 3),
                     unit == std::string::npos ? "" : line.substr(unit + 4)});
  }
  return lines;
}

/// The tables in which a table of a file is declared.
std::vector<std::string> declared_as(const std::string& table) {
  if (table == "rock.layers.material") return {"rock.material"};
  if (table == "cones.rows") return {"cones.rows", "teeth"};
  for (const std::string& kind : part_kinds)
    if (table == "forces." + kind) return {"forces.KIND", "forces"};
  if (table.starts_with("forces.areas.")) return {"forces.areas.NAME", "forces"};
  if (table.starts_with("wear.areas.")) return {"wear.areas.NAME"};
  if (table.starts_with("spalling.areas.")) return {"spalling.areas.NAME"};
  for (const char* key : {"rotary_speed", "rate_of_penetration", "weight_on_bit"})
    if (table == std::string("motion.") + key) return {"motion.KEY"};
  if (table.starts_with("bit.set")) return {"bit.set"};
  return {table};
}

/// The declarations of a line's key: of one in several force laws there are several.
std::vector<KeyRow> rows_of(const std::string& command, const Resolved& line) {
  std::vector<KeyRow> rows;
  const std::vector<std::string> names = declared_as(line.table);
  for (const KeyTable& table : all_tables())
    if (table.command == command && std::ranges::count(names, table.name) > 0)
      for (const KeyRow& row : table.rows)
        if (row.name == line.key || row.name == "KEY")
          rows.push_back(row);  // KEY: any of the bit's
  return rows;
}

bool has_unit(const KeyRow& row, const std::string& unit) {
  if (unit.empty() || row.kind.ends_with("KEY's unit")) return true;
  return row.kind.ends_with(unit == "1" ? "number" : unit);
}

/// A case that was read, and what it says by itself.
struct ReadCase {
  std::string command, path, resolved;
};

/// Every key is declared, with its unit and, where the case leaves it out, with its default.
void expect_declared(const ReadCase& c) {
  const Config file = Config::read_file(c.path, {});
  for (const Resolved& line : lines_of(c.resolved)) {
    const std::string key = line.place.empty() ? line.key : line.place + "." + line.key;
    // Cones and their rows have the values of [journal] and [teeth] unless they give their own.
    const bool given = file.has(key) || file.has(line.place + ".coefficients") ||
                       (c.command == "bit" && line.table.starts_with("cones"));
    const auto agrees = [&](const KeyRow& row) {
      return has_unit(row, line.unit) && (given || row.toml.empty() || row.toml == line.value);
    };
    EXPECT_TRUE(std::ranges::any_of(rows_of(c.command, line), agrees))
        << c.path << ": " << key << " = " << line.value << " # " << line.unit;
  }
}

/// The resolved file gives every key, each with its default or its given value: it must be the same
/// case.
std::string read_again(const ReadCase& c) {
  const std::string path = write_temporary("_again.toml", c.resolved);
  if (c.command == "string") return read_chain_case(path, {}).resolved;
  return c.command == "run" ? read_case(path, {}).resolved : read_rotate_case(path, {}).resolved;
}

std::vector<fs::path> shipped() {
  std::vector<fs::path> paths;
  for (const char* folder : {"/cases", "/cases/free-rotation"})
    for (const auto& entry : fs::directory_iterator(std::string(TDBD_SOURCE_DIR) + folder))
      if (entry.path().extension() == ".toml") paths.push_back(entry.path());
  std::ranges::sort(paths);
  return paths;
}

ReadCase read_shipped(const fs::path& path) {
  if (is_rotate_case(path)) return {"rotate", path, read_rotate_case(path, {}).resolved};
  if (kind_of(path, {}) == CaseKind::string)
    return {"string", path, read_chain_case(path, {}).resolved};
  return {"run", path, read_case(path, {}).resolved};
}

TEST(Keys, of_every_shipped_case_are_declared) {
  const std::vector<fs::path> paths = shipped();
  ASSERT_GT(paths.size(), 30u);
  for (const fs::path& path : paths) expect_declared(read_shipped(path));
}

TEST(Keys, of_every_shipped_bit_are_declared) {
  for (const auto& entry : fs::directory_iterator(TDBD_SOURCE_DIR "/cases/bits")) {
    const fs::path& path = entry.path();
    if (path.extension() != ".toml") continue;
    const bit::BitFile file =
        bit::read_bit(path, bit::DirectionRule::hybrid, bit::InsideRule::down);
    expect_declared({"bit", path, file.fingerprint});
  }
}

std::string write(const std::string& name, const std::string& text) {
  const std::string path = temporary_folder() + name;
  std::ofstream(path) << text;
  return path;
}

/// A small bit, so that many cases read fast.
std::string small_bit() {
  write("keys_bit.csv",
        "bit,cutter,blade,zone,dia_mm,r_tip_mm,phi_deg,h_tip_mm,profile_angle_deg,back_rake_deg,"
        "side_rake_deg\nS,1,1,cone,16,5,0,6,-15,15,0\nS,2,2,nose,16,25,10,1,0,15,0\n"
        "S,3,2,shoulder,16,47,200,11,70,15,0\n");
  return write("keys_bit.toml",
               "name = \"small\"\ntable = \"keys_bit.csv\"\n[mesh]\nrim_segments = 24\n");
}

/// A run of the small bit; `more` follows its tables.
ReadCase small_run(const std::string& motion, const std::string& more,
                   const std::vector<std::string>& settings) {
  const std::string text = "[bit]\nfile = \"" + small_bit() +
                           "\"\n[rock]\nedge_length = \"4 mm\"\n[time]\nstep = \"0.1 ms\"\n" +
                           (motion.find("table") == std::string::npos ? "duration = 0.1\n" : "") +
                           "[motion]\n" + motion + more;
  const std::string path = write_temporary(".toml", text);
  return {"run", path, read_case(path, settings).resolved};
}

constexpr const char* steady = "rotary_speed = 1\nrate_of_penetration = 0.001\n";

std::vector<ReadCase> motions_and_rocks() {
  const std::string path = write(
      "keys_path.csv", "time_s,x_m,y_m,z_m,rx_rad,ry_rad,rz_rad\n0,0,0,0,0,0,0\n1,0,0,0,0,0,1\n");
  const std::string layers =
      "[forces]\nlaw = \"detournay\"\neps = 3e7\nzeta = 0.6\n[rock.material]\nunconfined_strength "
      "= 3e7\n"
      "friction_angle = 0.5\n[[rock.layers]]\ntop = 0.1\nmaterial = \"berea-sandstone\"\n";
  return {small_run(steady, "[motion.tilt]\nangle = 0.1\n", {"rock.shape=flat"}),
          small_run("kind = \"whirl\"\n" + std::string(steady),
                    "[motion.whirl]\nradius = 0.001\nfrequency = 1\n",
                    {"rock.shape=rough", "rock.amplitude=0.001", "rock.correlation_length=0.01"}),
          small_run("kind = \"legs\"\n[[motion.legs]]\nduration = 0.2\n", "",
                    {"rock.shape=profile", "rock.profile=[[0, 0], [0.07, 0]]"}),
          small_run("kind = \"table\"\nfile = \"" + path + "\"\n", "",
                    {"rock.shape=file", "rock.file=" + path}),
          small_run(steady, layers, {})};
}

/// The small bit on a string, everything moving; times given.
ReadCase drilling() {
  return small_run(
      "kind = \"drilling\"\nweight_at_start = 10\ntorque_at_start = 1\n"
      "[motion.rotary_speed]\ntimes = [0, 1]\nvalues = [1, 2]\n"
      "[motion.weight_on_bit]\ntimes = [0, 1]\nvalues = [10, 20]\nbetween = \"linear\"\n",
      "[forces]\nlaw = \"detournay\"\neps = 3e7\nzeta = 0.6\n[string]\nmass = "
      "1000\ntorsional_inertia = "
      "10\n"
      "bending_inertia = 100\naxial_stiffness = 1e5\ntorsional_stiffness = 100\n"
      "[wall]\nstiffness = 1e6\nclearance = 0.001\n[rock_mount]\nmass = 1000\n",
      {"rock.material=berea-sandstone"});
}

/// The small bit at the end of a chain with these tables.
ReadCase on_chain(const std::string& tables, const std::string& speed) {
  return small_run("kind = \"drilling\"\n" + speed,
                   "[forces]\nlaw = \"detournay\"\neps = 3e7\nzeta = 0.6\n[string]\nmodel = "
                   "\"chain\"\nmass = 10\ntorsional_inertia = 10\nbending_inertia = 100\n"
                   "element_length = 10\nhole_diameter = 0.2\n"
                   "[[string.sections]]\nlength = 100\nouter_diameter = 0.1\n" +
                       tables + "[output]\nstring_depths = [0]\nstring_profile_every = 1e-3\n",
                   {"rock.material=berea-sandstone"});
}

/// [string.top.log] with these keys beside its file.
std::string rig_log(const std::string& keys) {
  const std::string file = write(
      "keys_rig.csv", "t [s],RPM [rpm],ROP [m/h],HL [kN]\n0,10,1,200\n1,12,1,200\n2,12,1,200\n");
  return "[string.top.log]\nfile = \"" + file + "\"\ntime = \"t\"\n" + keys;
}

std::vector<ReadCase> on_chains() {
  const std::string survey = write("keys_well.csv", "md_m,inc_deg,azi_deg\n0,0,0\n300,5,0\n");
  const std::string products =
      "[[string.sections]]\nlength = 10\naxial_rigidity = 1e9\ntorsional_rigidity = 1e6\n"
      "mass_per_length = 30\ninertia_per_length = 0.1\nweight_per_length = 200\n"
      "contact_diameter = 0.15\n";
  return {on_chain("linear_mass = 60\n" + products + "[string.survey]\nfile = \"" + survey +
                       "\"\n[string.top]\ntorsion = \"soft-torque\"\ninertia = 100\n"
                       "torque_limit = 1e4\naxial = \"hook-load\"\n" +
                       rig_log("hook_load = \"HL\"\nstart = 1\n"),
                   "rotary_speed = 1\nrate_of_penetration = 1e-3\n"),
          on_chain("[string.top]\naxial = \"hook-load\"\nhook_load = 1e4\n",
                   "rotary_speed = 1\nrate_of_penetration = 1e-3\n"),
          on_chain("[string.survey]\nmeasured_depth = [0, 300]\ninclination = [0, 0.1]\n"
                   "azimuth = [0, 0]\n[string.friction]\nstatic = 0.2\n"
                   "[[string.friction.above]]\ndepth = 50\nstatic = 0.1\n"
                   "[string.top]\ntorsion = \"z-torque\"\ninertia = 100\nintegral = 10\n"
                   "axial = \"autodriller\"\ngain = 1e-6\nintegral_gain = 1e-7\n",
                   "rotary_speed = 1\nweight_on_bit = 1e3\nexpected_rate = 1e-3\n"),
          on_chain("[string.top]\ntorsion = \"pi\"\ninertia = 100\nproportional = 10\n"
                   "integral = 10\n" +
                       rig_log("rotary_speed = \"RPM\"\nblock_speed = \"ROP\"\n"),
                   "")};
}

/// A value that the range allows.
double some_value(const forces::LawField& field) {
  for (const double x : {field.fallback.value_or(1.0), 1.0, 0.5 * field.range.hi, field.range.lo})
    if (std::isfinite(x) && field.range.contains(x)) return x;
  return 0.0;
}

/// The settings that give a force law, its coefficients beside it, to a table.
std::vector<std::string> law_in(const std::string& table, std::string_view name) {
  forces::Law law = forces::law_named(name);
  std::vector<std::string> settings{table + ".law=" + std::string(name)};
  for (const forces::LawField& field : forces::law_fields(law))
    settings.push_back(table + "." + std::string(field.key) + "=" +
                       std::to_string(some_value(field)));
  return settings;
}

/// Each force law, for the whole bit or else for the first kind of part that it knows.
std::vector<ReadCase> laws() {
  std::vector<std::string> tables{"forces"};
  for (const std::string& kind : part_kinds) tables.push_back("forces." + kind);
  std::vector<ReadCase> cases;
  for (const std::string_view name : forces::law_names())
    for (const std::string& table : tables) {
      std::vector<std::string> settings = law_in(table, name);
      settings.emplace_back("rock.material=berea-sandstone");
      if (table != "forces")
        for (const char* common : {"forces.law=detournay", "forces.eps=3e7", "forces.zeta=0.6"})
          settings.emplace_back(common);
      try {
        cases.push_back(small_run(steady, "", settings));
        break;
      } catch (const InputError&) {  // a law that knows no such part
      }
    }
  return cases;
}

std::vector<ReadCase> fits() {
  const std::string name(force_keys::fit_names().front());
  return {small_run(steady, "",
                    {"forces.coefficients=" + name, "forces.face.coefficients=" + name,
                     "rock.material=berea-sandstone"})};
}

/// Every wear law, and every criterion of an area that wears.
std::vector<ReadCase> wears() {
  const std::string path = std::string(TDBD_SOURCE_DIR) + "/cases/wear-bit-b.toml";
  const auto read = [&](const std::vector<std::string>& settings) {
    return ReadCase{"run", path, read_case(path, settings).resolved};
  };
  const std::string of_table = "law='table', temperatures=[300, 400], rates=[0, 1e-15]",
                    thermal = "law='thermal', coefficient=1e-5, hardness=5e10, threshold=700";
  return {read({"wear={" + of_table + "}", "forces.flat_contact='triangles'"}),
          read({"wear.areas.a={kind='chamfer', zone='nose', blade=1, names='cutter-*', " +
                    of_table + "}",
                "wear.areas.b={part='cutter-1/body', growth=20, " + thermal + "}"})};
}

/// Every key of spalling, and every criterion of an area of it.
std::vector<ReadCase> spallings() {
  const std::string path = std::string(TDBD_SOURCE_DIR) + "/cases/bit-b-3000psi.toml";
  const std::string area =
      "={kind='face', zone='nose', blade=1, names='cutter-*', angle=1, "
      "depth_share=0.5, ahead_share=0.1}";
  return {{"run", path,
           read_case(path, {"rock.pressure=0", "spalling={angle=1, material='mancos-shale'}",
                            "spalling.areas.a" + area,
                            "spalling.areas.b={part='cutter-1/face', angle=1}"})
               .resolved}};
}

/// Every criterion of an area of forces; bit R has cones.
std::vector<ReadCase> areas() {
  const std::string bit_b = std::string(TDBD_SOURCE_DIR) + "/cases/bit-b-3000psi.toml",
                    bit_r = std::string(TDBD_SOURCE_DIR) + "/cases/drill-bit-r.toml";
  const auto read = [](const std::string& path, const std::vector<std::string>& settings) {
    return ReadCase{"run", path, read_case(path, settings).resolved};
  };
  return {
      read(bit_b, {"forces.areas.a={kind='face', zone='nose', blade=1, names='cutter-*', A1=2}",
                   "forces.areas.b={part='cutter-1/face', coefficients='hanson-hansen-sharp'}"}),
      read(bit_r, {"forces.areas.a={cone=1, row=1, mu=0.2}"})};
}

ReadCase rotation(const std::string& body) {
  write("keys_torque.csv", "time_s,x,y,z\n0,1,2,3\n1,4,5,6\n");
  const std::string path = write_temporary(
      ".toml",
      "[body]\n" + body +
          "[[cones]]\naxis = [0, 0, 1]\naxial_inertia = 0.1\n"
          "[[load.harmonics]]\namplitude = [0, 1, 0]\n"
          "[[load.samples]]\nfile = \"" +
          temporary_folder() +
          "keys_torque.csv\"\n[time]\nstep = 0.1\nduration = 1\n[output]\ncheckpoint_every = 5\n");
  return {"rotate", path, read_rotate_case(path, {}).resolved};
}

std::vector<ReadCase> rotations() {
  const std::string box = write("keys_box.off",
                                "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n"
                                "3 1 2 3\n3 0 3 2\n");
  return {rotation("inertia = [[2, 0, 0], [0, 2.6, 0], [0, 0, 3]]\n"),
          rotation("mesh = \"" + box +
                   "\"\ndensity = 7800\nunit = 1\n"
                   "attitude = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n")};
}

/// The string case with these tables in place of others of its kind.
ReadCase string_case(const std::string& tables, const std::string& motion) {
  const std::string path = write_temporary(
      ".toml",
      "[string]\nmodel = \"chain\"\nelement_length = 10\nhole_diameter = 0.2\nmass = 10\n"
      "torsional_inertia = 1\n"
      "[[string.sections]]\nlength = 100\nouter_diameter = 0.1\n" +
          tables + "[motion]\n" + motion +
          "[time]\nstep = 1e-4\nduration = 1e-3\n[output]\n"
          "string_depths = [0]\nstring_profile_every = 1e-3\n");
  return {"string", path, read_chain_case(path, {}).resolved};
}

std::vector<ReadCase> strings() {
  const std::string survey = write("keys_survey.csv", "md_m,inc_deg,azi_deg\n0,0,0\n300,5,0\n");
  const std::string products =
      "[[string.sections]]\nlength = 10\naxial_rigidity = 1e9\ntorsional_rigidity = 1e6\n"
      "mass_per_length = 30\ninertia_per_length = 0.1\nweight_per_length = 200\n"
      "contact_diameter = 0.15\n";
  return {
      string_case("linear_mass = 60\n" + products + "[string.survey]\nfile = \"" + survey +
                      "\"\n[string.top]\ntorsion = \"soft-torque\"\ninertia = 100\n"
                      "torque_limit = 1e4\naxial = \"hook-load\"\nhook_load = 1e4\n"
                      "[string.bit]\nlaw = \"two-level\"\nstatic = 2\ndynamic = 1\n",
                  "rotary_speed = 1\nrate_of_penetration = 0\n"),
      string_case("[string.survey]\nmeasured_depth = [0, 300]\ninclination = [0, 0.1]\n"
                  "azimuth = [0, 0]\n[string.friction]\nstatic = 0.2\n"
                  "[[string.friction.above]]\ndepth = 50\nstatic = 0.1\n"
                  "[string.top]\ntorsion = \"z-torque\"\ninertia = 100\nintegral = 10\n"
                  "axial = \"autodriller\"\ngain = 1e-6\nintegral_gain = 1e-7\n"
                  "[string.bit]\nlaw = \"regenerative\"\naxial_stiffness = 1e6\n"
                  "torsional_stiffness = 1e3\npitch = 1\n",
                  "rotary_speed = 1\nweight_on_bit = 1e4\nweight_at_start = 1\n"
                  "torque_at_start = 1\n"),
      string_case("[string.top]\ntorsion = \"pi\"\ninertia = 100\nproportional = 10\n"
                  "integral = 10\n" +
                      rig_log("rotary_speed = \"RPM\"\nblock_speed = \"ROP\"\nstart = 1\n"),
                  ""),
      string_case("[string.top]\naxial = \"hook-load\"\n" + rig_log("hook_load = \"HL\"\n"), "")};
}

TEST(Keys, that_are_declared_can_be_read_and_given_with_their_defaults) {
  std::vector<ReadCase> cases{drilling()};
  for (const auto& more : {motions_and_rocks(), laws(), fits(), areas(), wears(), spallings(),
                           rotations(), strings(), on_chains()})
    cases.insert(cases.end(), more.begin(), more.end());
  for (const char* name : {"bit-r-rolling", "bit-r-steady", "drill-bit-r", "laboratory"})
    cases.push_back(read_shipped(std::string(TDBD_SOURCE_DIR) + "/cases/" + name + ".toml"));
  cases.push_back(read_shipped(std::string(TDBD_SOURCE_DIR) + "/cases/drill-bit-b.toml"));
  cases.push_back(small_run(steady, "", {"output.checkpoint_every=100", "title=a case"}));
  cases.push_back(small_run(steady, "", {"bit.set.adjust.back_rake=1 deg"}));
  std::set<std::string> read;
  for (const ReadCase& c : cases) {
    for (const Resolved& line : lines_of(c.resolved))
      for (const std::string& table : declared_as(line.table))
        read.insert(c.command + " " + table + " " +
                    (table == bit_keys::changes.name ? std::string(bit_keys::any.name) : line.key));
    EXPECT_EQ(read_again(c), c.resolved);
  }
  for (const KeyTable& table : all_tables())
    for (const KeyRow& row : table.rows)
      EXPECT_TRUE(table.command == "bit" ||
                  read.contains(table.command + " " + table.name + " " + row.name))
          << table.command << " " << table.name << " " << row.name;
}

TEST(Keys, stand_once_in_their_table) {
  std::set<std::string> seen;
  for (const KeyTable& table : all_tables())
    for (const KeyRow& row : table.rows) {
      EXPECT_FALSE(row.meaning.empty()) << table.name << " " << row.name;
      EXPECT_TRUE(
          seen.insert(table.command + table.name + table.meaning + row.name + row.kind).second)
          << table.name << " " << row.name;
    }
}

}  // namespace tdbd::simulation::keys_test
