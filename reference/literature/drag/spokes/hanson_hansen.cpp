#include "reference/literature/drag/spokes/hanson_hansen.hpp"

namespace tdbd::reference {

void string_and_rock_rates(const DrillStringAndRock& s, double time, const HansonHansenState& y,
                           const HansonHansenLoad& load, HansonHansenState& rates) {
  const Vec3 c(y[0], y[1], y[2]), v(y[3], y[4], y[5]), top(0.0, 0.0, s.top_z + s.rate * time);
  const Vec3 a = (load.force_W - s.damping * v - s.stiffness * (c - top)) / s.mass;
  for (std::size_t i = 0; i < 3; ++i) {
    rates[i] = y[i + 3];
    rates[i + 3] = a[static_cast<Eigen::Index>(i)];
  }
  rates[6] = y[7];
  rates[7] = (load.torque - s.turn_damping * y[7] -
              s.turn_stiffness * (y[6] - s.top_angle - s.speed * time)) /
             s.inertia;
  const double push = s.sign == RockSign::newton ? -load.force_W.z() : load.force_W.z();
  const bool moves = s.rock_mass > 0.0;
  rates[8] = moves ? y[9] : 0.0;
  rates[9] = moves ? (push - s.rock_damping * y[9] - s.rock_stiffness * y[8]) / s.rock_mass : 0.0;
}

BitPlace place_in_rock(const HansonHansenState& y) { return {Vec3(y[0], y[1], y[2] - y[8]), y[6]}; }

double axial_momentum(const DrillStringAndRock& s, const HansonHansenState& y) {
  return s.mass * y[5] + s.rock_mass * y[9];
}

}  // namespace tdbd::reference
