#include "bit/report/assumption_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bit/cone/cone_measures.hpp"
#include "bit/cone/cone_rolling.hpp"

namespace tdbd::bit {
namespace {

struct ConeFigures {
  ConeMass mass;
  double ratio = 0.0;
  ConeAssumptions assumptions;
};

ConeFigures figures_of(const Bit& bit, int cone, double bit_speed) {
  const double ratio = rolling_ratio_of_gage_row(bit.cones[static_cast<std::size_t>(cone)]);
  return {cone_mass(bit, cone), ratio, cone_assumptions(bit, cone, bit_speed, ratio)};
}

}  // namespace

void add_assumptions(const Bit& bit, double bit_speed, nlohmann::ordered_json& file) {
  for (int k = 0; k < static_cast<int>(bit.cones.size()); ++k) {
    const auto [mass, ratio, a] = figures_of(bit, k, bit_speed);
    file["cones"][static_cast<std::size_t>(k)].update(
        {{"asymmetry", mass.asymmetry},
         {"centre_off_axis_m", mass.centre_off_axis},
         {"assumptions",
          {{"bit_speed_rad_per_s", bit_speed},
           {"cone_ratio", ratio},
           {"unbalance_force_N", a.unbalance_force},
           {"unbalance_share_of_weight", a.unbalance_share},
           {"gravity_torque_N_m", a.gravity_torque},
           {"inertia_modulation_once", a.modulation_once},
           {"inertia_modulation_twice", a.modulation_twice},
           {"cone_frequency_Hz", a.frequency},
           {"momentum_torque_error_N_m", a.torque_error},
           {"momentum_torque_error_over_Ic_speed2", a.torque_share}}}});
  }
}

std::string assumptions_text(const Bit& bit, double bit_speed) {
  std::string text;
  for (int k = 0; k < static_cast<int>(bit.cones.size()); ++k) {
    const ConeAssumptions a = figures_of(bit, k, bit_speed).assumptions;
    text += fmt::format(
        "{}: assumptions at {:.3f} rad/s of the bit, {:.3f} Hz of the cone: unbalance {:.3g} N "
        "({:.2g} of the weight), gravity {:.3g} N m, bit's inertia modulated by {:.2g} once and "
        "{:.2g} twice a turn, cone's momentum equation wrong by at most {:.3g} N m\n",
        bit.cones[static_cast<std::size_t>(k)].name, bit_speed, a.frequency, a.unbalance_force,
        a.unbalance_share, a.gravity_torque, a.modulation_once, a.modulation_twice, a.torque_error);
  }
  return text;
}

}  // namespace tdbd::bit
