#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "bit/report/bit_motion.hpp"
#include "simulation/case/case.hpp"
#include "simulation/checkpoint/history_window.hpp"
#include "simulation/step/energy_order.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// A file of frames and when it was taken, s.
using FrameList = std::vector<std::pair<double, std::string>>;

/// How far a run has come with what it writes.
struct WrittenSoFar {
  long rows = 0;  ///< of the history
  HistoryWindow window;
  FrameList rock_frames;
  std::vector<bit::BodyPoses> bit_frames;
  EnergyOrder order;      ///< as far as it was observed
  long profile_rows = 0;  ///< of a string on a chain
};

/// A run between two steps, as it was saved.
struct Checkpoint {
  State state;
  Statistics statistics;
  WrittenSoFar written;
};

/// Writes a checkpoint: complete, on the disk, or not at all. Throws RunError.
void write_checkpoint(const std::filesystem::path& path, const Case& c, const Simulation& s,
                      const WrittenSoFar& written);

/// Reads it. Throws like CaseTape.
Checkpoint read_checkpoint(const std::filesystem::path& path, const Case& c);

}  // namespace tdbd::simulation
