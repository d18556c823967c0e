#pragma once

#include <string>
#include <utility>
#include <vector>

#include "simulation/result/output_folder.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// Writes the rock and the bit as VTP frames with their collections rock.pvd and bit.pvd, which
/// ParaView plays.
class Frames {
 public:
  explicit Frames(OutputFolder folder) : folder_(std::move(folder)) {}

  void add(const Case& c, const Simulation& s);

  /// frames/rock_final.vtp and rock_final.ply, and the collections.
  void write_final(const Case& c, const Simulation& s);

 private:
  using Collection = std::vector<std::pair<double, std::string>>;  ///< time, file
  void write_collection(const std::string& name, Collection frames, double end) const;

  OutputFolder folder_;
  Collection rock_, bit_;
};

}  // namespace tdbd::simulation
