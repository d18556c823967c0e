#include "bit/report/bit_motion.hpp"

#include <fmt/format.h>

#include "bit/cone/cone_frame.hpp"
#include "io/whole_file.hpp"

namespace tdbd::bit {

BodyPoses body_poses(const Bit& bit, const Pose& X_WB, const std::vector<double>& cone_angles,
                     double time) {
  BodyPoses poses{time, {X_WB}};
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    poses.X_WB.push_back(X_WB *
                         (cone_pose(bit.cones[k], cone_angles.at(k)) * inverse(bit.cones[k].X_BK)));
  return poses;
}

void write_bit_poses(const std::filesystem::path& path, const Bit& bit,
                     const std::vector<BodyPoses>& frames) {
  std::string text = "time [s],body,x [m],y [m],z [m],xx,xy,xz,yx,yy,yz,zx,zy,zz\n";
  for (const BodyPoses& frame : frames)
    for (std::size_t body = 0; body < frame.X_WB.size(); ++body) {
      const Pose& X = frame.X_WB[body];
      text += fmt::format("{},{},{},{},{}", frame.time,
                          body == 0 ? "bit" : bit.cones[body - 1].name, X.p.x(), X.p.y(), X.p.z());
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) text += fmt::format(",{}", X.R(i, k));
      text += '\n';
    }
  write_text(path, text);
}

}  // namespace tdbd::bit
