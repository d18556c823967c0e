#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/temporary_file.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/force_settings.hpp"
#include "simulation/chain/chain_run.hpp"
#include "simulation/rotate/rotate_case.hpp"

/// Cases that together give every declared key.
namespace tdbd::simulation::keys_test {

/// A case that was read, and its resolved text.
struct ReadCase {
  std::string command, path, resolved;
};

inline const std::vector<std::string> part_kinds{"face",     "chamfer",  "cse",  "cutter_body",
                                                 "gage_pad", "bit_body", "cone", "tooth"};

inline std::string write(const std::string& name, const std::string& text) {
  const std::string path = temporary_folder() + name;
  std::ofstream(path) << text;
  return path;
}

/// A small bit, so that many cases read fast.
inline std::string small_bit() {
  write("keys_bit.csv",
        "bit,cutter,blade,zone,dia_mm,r_tip_mm,phi_deg,h_tip_mm,profile_angle_deg,back_rake_deg,"
        "side_rake_deg\nS,1,1,cone,16,5,0,6,-15,15,0\nS,2,2,nose,16,25,10,1,0,15,0\n"
        "S,3,2,shoulder,16,47,200,11,70,15,0\n");
  return write("keys_bit.toml",
               "name = \"small\"\ntable = \"keys_bit.csv\"\n[mesh]\nrim_segments = 24\n");
}

/// A run of the small bit; `more` follows its tables.
inline ReadCase small_run(const std::string& motion, const std::string& more,
                          const std::vector<std::string>& settings) {
  const std::string text = "[bit]\nfile = \"" + small_bit() +
                           "\"\n[rock]\nedge_length = \"4 mm\"\n[time]\nstep = \"0.1 ms\"\n" +
                           (motion.find("table") == std::string::npos ? "duration = 0.1\n" : "") +
                           "[motion]\n" + motion + more;
  const std::string path = write_temporary(".toml", text);
  return {"run", path, read_case(path, settings).resolved};
}

inline constexpr const char* steady = "rotary_speed = 1\nrate_of_penetration = 0.001\n";

inline std::vector<ReadCase> motions_and_rocks() {
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
inline ReadCase drilling() {
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
inline ReadCase on_chain(const std::string& tables, const std::string& speed) {
  return small_run("kind = \"drilling\"\n" + speed,
                   "[forces]\nlaw = \"detournay\"\neps = 3e7\nzeta = 0.6\n[string]\nmodel = "
                   "\"chain\"\nmass = 10\ntorsional_inertia = 10\nbending_inertia = 100\n"
                   "element_length = 10\nhole_diameter = 0.2\n"
                   "[[string.sections]]\nlength = 100\nouter_diameter = 0.1\n" +
                       tables + "[output]\nstring_depths = [0]\nstring_profile_every = 1e-3\n",
                   {"rock.material=berea-sandstone"});
}

/// [string.top.log] with these keys beside its file.
inline std::string rig_log(const std::string& keys) {
  const std::string file = write(
      "keys_rig.csv", "t [s],RPM [rpm],ROP [m/h],HL [kN]\n0,10,1,200\n1,12,1,200\n2,12,1,200\n");
  return "[string.top.log]\nfile = \"" + file + "\"\ntime = \"t\"\n" + keys;
}

inline std::vector<ReadCase> on_chains() {
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
inline double some_value(const forces::LawField& field) {
  for (const double x : {field.fallback.value_or(1.0), 1.0, 0.5 * field.range.hi, field.range.lo})
    if (std::isfinite(x) && field.range.contains(x)) return x;
  return 0.0;
}

/// The settings that give a force law, its coefficients beside it, to a table.
inline std::vector<std::string> law_in(const std::string& table, std::string_view name) {
  forces::Law law = forces::law_named(name);
  std::vector<std::string> settings{table + ".law=" + std::string(name)};
  for (const forces::LawField& field : forces::law_fields(law))
    settings.push_back(table + "." + std::string(field.key) + "=" +
                       std::to_string(some_value(field)));
  return settings;
}

/// Each force law, for the whole bit or else for the first kind of part that it knows.
inline std::vector<ReadCase> laws() {
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

inline std::vector<ReadCase> fits() {
  const std::string name(LawChoice::fit_names().front());
  return {small_run(steady, "",
                    {"forces.coefficients=" + name, "forces.face.coefficients=" + name,
                     "rock.material=berea-sandstone"})};
}

/// Every wear law, and every criterion of an area that wears.
inline std::vector<ReadCase> wears() {
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
inline std::vector<ReadCase> spallings() {
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
inline std::vector<ReadCase> areas() {
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

inline ReadCase rotation(const std::string& body) {
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

inline std::vector<ReadCase> rotations() {
  const std::string box = write("keys_box.off",
                                "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n"
                                "3 1 2 3\n3 0 3 2\n");
  return {rotation("inertia = [[2, 0, 0], [0, 2.6, 0], [0, 0, 3]]\n"),
          rotation("mesh = \"" + box +
                   "\"\ndensity = 7800\nunit = 1\n"
                   "attitude = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n")};
}

/// The string case with these tables in place of others of its kind.
inline ReadCase string_case(const std::string& tables, const std::string& motion) {
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

inline std::vector<ReadCase> strings() {
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

}  // namespace tdbd::simulation::keys_test
