#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// A case of the repository with what makes it short: every kind of state that a restart must keep.
struct RestartedCase {
  std::string name, file;
  std::vector<std::string> settings;
  std::string length;  ///< a setting: of about 90 steps
};

inline void PrintTo(const RestartedCase& c, std::ostream* out) { *out << c.name; }

inline std::vector<RestartedCase> restarted_cases() {
  return {
      {"steady", "bit-b-steady", {}, "time.revolutions=0.18"},
      {"renumbered", "bit-b-steady", {"maintenance.renumber_every=7"}, "time.revolutions=0.18"},
      {"steady_with_forces", "bit-b-3000psi", {"output.means_from='0 s'"}, "time.revolutions=0.18"},
      {"spalling",
       "bit-b-3000psi",
       {"rock.pressure=0", "spalling={angle='70 deg', ahead_share=0.3}", "output.means_from='0 s'"},
       "time.revolutions=0.18"},
      {"sections_in_turn",
       "bit-b-3000psi",
       {"measure.section_every=4", "output.means_from='0 s'"},
       "time.revolutions=0.18"},
      {"rolling_cones",
       "bit-r-rolling",
       {"motion.rate_of_penetration='100 m/h'"},
       "time.revolutions=0.24"},
      {"drilling", "drill-bit-b", {"output.means_from='0 s'"}, "time.duration='90 ms'"},
      {"drilling_with_a_top_that_follows",
       "drill-bit-b",
       {"motion.expected_rate=0", "motion.rate_memory='50 ms'", "output.means_from='0 s'"},
       "time.duration='90 ms'"},
      {"drilling_with_cones", "drill-bit-r", {"output.means_from='0 s'"}, "time.duration='90 ms'"},
      {"drilling_on_a_chain",
       "string-drill-bit-b",
       {"output.means_from='0 s'", "string.friction.static=0.2", "string.friction.dynamic=0.1",
        "string.survey={measured_depth=[0, 2500], inclination=[0, 1], azimuth=[0, 0]}",
        "output.string_depths=['0 m', '2500 m']", "output.string_profile_every='7 ms'"},
       "time.duration='90 ms'"},
      {"standing",
       "stick-slip",
       {"motion.rotary_speed='0 rpm'", "motion.torque_at_start=0", "output.means_from='0 s'"},
       "time.duration='180 ms'"},
      {"trimmed",
       "core",
       {"time.step='2 ms'", "rock.trim='80 mm'", "rock.wall='120 mm'",
        "motion.rate_of_penetration='100 m/h'"},
       "time.revolutions=0.36"}};
}

/// Coarse; with more settings.
inline Case restarted_case(const RestartedCase& c, std::vector<std::string> more = {}) {
  more.insert(more.begin(), c.settings.begin(), c.settings.end());
  more.emplace_back("rock.edge_length='4 mm'");
  return read_case(TDBD_SOURCE_DIR "/cases/" + c.file + ".toml", more);
}

}  // namespace tdbd::simulation
