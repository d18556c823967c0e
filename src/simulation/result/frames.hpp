#pragma once

#include <string>
#include <utility>
#include <vector>

#include "simulation/checkpoint/checkpoint.hpp"
#include "simulation/result/output_folder.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// Writes the rock and the bit as VTP frames with their collections rock.pvd and bit.pvd, which
/// ParaView plays.
class Frames {
 public:
  explicit Frames(OutputFolder folder) : folder_(std::move(folder)) {}

  void add(const Case& c, const Simulation& s);

  /// The frames so far, and those of a run that goes on.
  const FrameList& rock_frames() const { return rock_; }
  const FrameList& bit_frames() const { return bit_; }
  void set_frames(FrameList rock, FrameList bit) {
    rock_ = std::move(rock);
    bit_ = std::move(bit);
  }

  /// frames/rock_final.vtp and rock_final.ply, and the collections.
  void write_final(const Case& c, const Simulation& s);

 private:
  void write_collection(const std::string& name, FrameList frames, double end) const;

  OutputFolder folder_;
  FrameList rock_, bit_;
};

}  // namespace tdbd::simulation
