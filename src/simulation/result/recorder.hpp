#pragma once

#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bit/report/bit_motion.hpp"
#include "io/checkpoint.hpp"
#include "simulation/result/chain_record.hpp"
#include "simulation/result/history.hpp"
#include "simulation/result/summary.hpp"
#include "simulation/step/energy_order.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// A file of frames and its time, s.
using FrameList = std::vector<std::pair<double, std::string>>;

/// How much of its records a run has written.
struct WrittenSoFar {
  long rows = 0;  ///< of the history
  HistoryWindow window;
  FrameList rock_frames;
  std::vector<bit::BodyPoses> bit_frames;
  EnergyOrder order;      ///< as far as it was observed
  long profile_rows = 0;  ///< of a string on a chain

  template <class Archive>
  void serialize(Archive& a) {
    a(rows, window, rock_frames, bit_frames, order, profile_rows);
  }
};

/// A run between two steps, as it was saved.
struct Checkpoint {
  State state;
  Statistics statistics;
  WrittenSoFar written;

  long steps_done() const { return state.steps_done; }
};

/// Writes a checkpoint: complete and forced to the disk, or not at all. Throws RunError.
void write_checkpoint(const std::filesystem::path& path, const Case& c, const Simulation& s,
                      const WrittenSoFar& written);

/// Reads it. Throws as tdbd::read_checkpoint does.
Checkpoint read_checkpoint(const std::filesystem::path& path, const Case& c);

/// Writes the rock as VTP frames with their collection rock.pvd, which ParaView plays, and of the
/// rigid bit its mesh once with its poses: bit_poses.csv, and as an animation bit.glb.
class Frames {
 public:
  explicit Frames(OutputFolder folder) : folder_(std::move(folder)) {}

  void add(const Case& c, const Simulation& s);

  /// The frames so far, and those of a run that is resumed.
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

/// Records a run in its folder: history, profiles of a string on a chain, frames, checkpoints.
class DrillingRecorder {
 public:
  /// Creates `.partial` files. `order` is saved in checkpoints. The arguments must outlive it.
  DrillingRecorder(const Case& c, const Simulation& s, EnergyOrder& order,
                   const OutputFolder& folder, const CheckpointKeeper::Warn& warn);

  /// To be called once, before all else: writes again what a run had written that is resumed.
  void restore(const WrittenSoFar& written);
  void begin() { record_profile(); }
  void record();
  void close(RunStatus status);
  /// After a failure, as far as it can be written; a bit that is worn out leaves a checkpoint.
  void keep_so_far(const std::exception& failure);

 private:
  void record_profile();
  void keep_checkpoint();

  const Case& c_;
  const Simulation& s_;
  EnergyOrder& order_;
  History history_;
  std::optional<ChainProfiles> profiles_;  ///< of a string on a chain
  Frames frames_;
  CheckpointKeeper keeper_;
};

}  // namespace tdbd::simulation
