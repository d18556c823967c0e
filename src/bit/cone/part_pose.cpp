#include "bit/cone/part_pose.hpp"

#include "bit/cone/cone_frame.hpp"

namespace tdbd::bit {

Pose part_pose(const Bit& bit, const Part& part, const std::vector<double>& cone_angles) {
  if (part.cone < 0) return part.X_BP;
  const auto k = static_cast<std::size_t>(part.cone);
  return cone_pose(bit.cones[k], cone_angles.at(k)) * (inverse(bit.cones[k].X_BK) * part.X_BP);
}

Bit turned(Bit bit, const std::vector<double>& cone_angles) {
  for (Part& part : bit.parts) part.X_BP = part_pose(bit, part, cone_angles);
  return bit;
}

}  // namespace tdbd::bit
