#pragma once

#include <string>
#include <utility>
#include <vector>

#include "simulation/checkpoint/checkpoint.hpp"
#include "simulation/result/output_folder.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// Writes the rock as VTP frames with their collection rock.pvd, which ParaView plays, and of the rigid bit its mesh once
/// with its poses: bit_poses.csv, and as an animation bit.glb.
class Frames {
 public:
  explicit Frames(OutputFolder folder) : folder_(std::move(folder)) {}

  void add(const Case& c, const Simulation& s);

  /// The frames so far, and those of a run that goes on.
  const FrameList& rock_frames() const { return rock_; }
  const std::vector<bit::BodyPoses>& bit_frames() const { return bit_; }
  void set_frames(FrameList rock, std::vector<bit::BodyPoses> bit) {
    rock_ = std::move(rock);
    bit_ = std::move(bit);
  }

  /// frames/rock_final.vtp and rock_final.ply, frames/bit_final.vtp, the collections, and the poses.
  void write_final(const Case& c, const Simulation& s);

 private:
  void write_collection(const std::string& name, FrameList frames, double end) const;
  void write_motion(const Case& c, const Simulation& s) const;

  OutputFolder folder_;
  FrameList rock_;
  std::vector<bit::BodyPoses> bit_;
};

}  // namespace tdbd::simulation
