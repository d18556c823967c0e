#include "reference/literature/surface/steady_drilling.hpp"

namespace tdbd::reference {

Pose pose_after(const SteadyDrilling& d, long steps) {
  const auto n = static_cast<double>(steps);
  return {Eigen::AngleAxisd(n * d.turn, Vec3::UnitZ()).toRotationMatrix(),
          Vec3(0.0, 0.0, n * d.advance)};
}

SteadyDrilling steady_drilling(const bit::Bit& bit, double turn, double advance, double reach) {
  SteadyDrilling d;
  d.turn = turn;
  d.advance = advance;
  d.tools = sweep_tools(cutter_hulls(bit), inverse(pose_after(d, 1)), reach);
  return d;
}

}  // namespace tdbd::reference
