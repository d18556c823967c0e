#pragma once

#include <numbers>
#include <string>

#include "verification/simulation/mesh_bit.hpp"

namespace tdbd::simulation {

/// A bit of one cone with one row of teeth, its journal level and without offset: a toothed wheel
/// that rolls about the bit's axis, R its tips' distance from that axis, rho from the journal.
struct Wheel {
  double R = 60e-3;    ///< m
  double rho = 30e-3;  ///< m
  int teeth = 16;

  double ratio() const { return R / rho; }
};

inline std::string write_wheel(const std::filesystem::path& folder, const Wheel& wheel) {
  const double shell = wheel.rho - 7e-3;
  const auto text = [](double x) { return std::to_string(x); };
  return write_file(
      folder / "wheel.toml",
      "name = \"wheel\"\n[journal]\nangle = 0\noffset = 0\nskew = 0\napex = " + text(-wheel.R) +
          "\n[teeth]\nkind = \"hemispherical\"\ndiameter = 0.006\nprotrusion = 0.007\n"
          "embedding = 0.003\n[mesh]\nfacets = 12\n[[cones]]\nazimuth = 0.3\nshell = [[-0.004, " +
          text(shell) + "], [0.004, " + text(shell) +
          "]]\n[[cones.rows]]\ns = 0\nteeth = " + std::to_string(wheel.teeth) + "\n");
}

/// A case in which the wheel rolls on a flat bottom; `more` are lines of its [motion].
inline std::string write_wheel_case(const std::filesystem::path& folder, const Wheel& wheel,
                                    const std::string& more, const std::string& time) {
  write_wheel(folder, wheel);
  return write_file(folder / "case.toml",
                    "[bit]\nfile = \"wheel.toml\"\n[rock]\nshape = \"flat\"\nedge_length = "
                    "\"2 mm\"\nwall = \"30 mm\"\nradius = \"80 mm\"\n[motion]\n"
                    "cone_speeds = \"rolling\"\n" +
                        more + "\n[time]\n" + time + "\n");
}

inline const std::string wheel_motion =
    "rotary_speed = \"60 rpm\"\nrate_of_penetration = \"1.5 mm/s\"\n";

}  // namespace tdbd::simulation
