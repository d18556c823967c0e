#pragma once

#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bit/report/bit_output.hpp"
#include "io/checkpoint.hpp"
#include "simulation/result/chain_record.hpp"
#include "simulation/result/history.hpp"
#include "simulation/result/summary.hpp"
#include "simulation/step/energy_order.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// Times (s) and files of frames.
using FrameList = std::vector<std::pair<double, std::string>>;

/// How much of its records a run has written.
struct WrittenSoFar {
  long rows = 0;  ///< of the history
  HistoryWindow window;
  FrameList rock_frames;
  std::vector<bit::BodyPoses> bit_frames;
  EnergyOrder order;      ///< as far as it is observed
  long profile_rows = 0;  ///< for a string on a chain

  template <class Archive>
  void serialize(Archive& a) {
    a(rows, window, rock_frames, bit_frames, order, profile_rows);
  }
};

/// The saved state of a run between two steps.
struct Checkpoint {
  State state;
  Statistics statistics;
  WrittenSoFar written;

  long steps_done() const { return state.steps_done; }
};

/// Writes a checkpoint completely and forces it to the disk, or leaves no file. Throws RunError.
void write_checkpoint(const std::filesystem::path& path, const Case& c, const Simulation& s,
                      const WrittenSoFar& written);

/// Reads a checkpoint. Throws like tdbd::read_checkpoint.
Checkpoint read_checkpoint(const std::filesystem::path& path, const Case& c);

/// Writes the rock as VTP frames and as the collection rock.pvd for ParaView. Of the rigid bit,
/// writes the mesh once and its poses as bit_poses.csv and as an animation bit.glb.
class Frames {
 public:
  explicit Frames(OutputFolder folder) : folder_(std::move(folder)) {}

  void add(const Case& c, const Simulation& s);

  /// The frames so far, including those of a resumed run.
  const FrameList& rock_frames() const { return rock_; }
  const std::vector<bit::BodyPoses>& bit_frames() const { return bit_; }
  void set_frames(FrameList rock, std::vector<bit::BodyPoses> bit) {
    rock_ = std::move(rock);
    bit_ = std::move(bit);
  }

  /// Writes frames/rock_final.vtp and rock_final.ply, frames/bit_final.vtp, the collections, and
  /// the poses.
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
  /// Creates `.partial` files. `order` is saved in checkpoints. The arguments must outlive the
  /// recorder.
  DrillingRecorder(const Case& c, const Simulation& s, EnergyOrder& order,
                   const OutputFolder& folder, const CheckpointKeeper::Warn& warn);

  /// Must be called once, before anything else. Writes again the records of the run that is
  /// resumed.
  void restore(const WrittenSoFar& written);
  void begin() { record_profile(); }
  void record();
  void close(RunStatus status);
  /// Closes the records after a failure, as far as they can be written. If the bit is worn out,
  /// also writes a checkpoint.
  void keep_so_far(const std::exception& failure);

 private:
  void write_row();
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
