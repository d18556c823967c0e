#pragma once

#include <atomic>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "bit/profile/bit_analysis.hpp"
#include "core/types.hpp"
#include "simulation/case/case.hpp"
#include "simulation/step/simulation.hpp"
#include "sweep/design/design.hpp"

namespace tdbd::sweep {

/// A cache of values that several points need. It keeps the newest values up to a sum of weights; a
/// value that exceeds this alone is not kept. Several threads may use it at once.
template <class T>
class Kept {
 public:
  explicit Kept(double most) : most_(most) {}

  /// Returns the value of this key; calls make() if the cache does not contain it. The value of an
  /// empty key is never kept.
  template <class Make, class Weigh>
  std::shared_ptr<const T> get(const std::string& key, Make&& make, Weigh&& weigh) {
    if (auto found = find(key)) return found;
    auto made = std::make_shared<const T>(make());
    if (!key.empty()) keep({key, made, weigh(*made)});
    return made;
  }

 private:
  struct Entry {
    std::string key;
    std::shared_ptr<const T> value;
    double weight = 0.0;
  };

  std::shared_ptr<const T> find(const std::string& key) {
    const std::lock_guard hold(mutex_);
    for (const Entry& e : entries_)
      if (e.key == key) return e.value;
    return nullptr;
  }

  void keep(Entry entry) {
    if (entry.weight > most_) return;
    const std::lock_guard hold(mutex_);
    for (weight_ += entry.weight; weight_ > most_; entries_.pop_front())
      weight_ -= entries_.front().weight;
    entries_.push_back(std::move(entry));
  }

  double most_, weight_ = 0.0;
  std::mutex mutex_;
  std::deque<Entry> entries_;
};

/// Whether points use start values that other points made.
enum class Keeping { on, off };

/// What points require before their first step. Most points share bit and rock, and reading and
/// making these takes longer than everything else; therefore the newest ones are kept. Several
/// threads may use it at once.
struct Starts {
  explicit Starts(Keeping keeping);
  Kept<bit::BitFile> files;                 ///< by all arguments of the function that reads them
  Kept<rock::CuttingBit> bits;              ///< by Case::bit_hash
  Kept<simulation::StartSurface> surfaces;  ///< by start_surface_key
};

/// Does the same as simulation::read_case, for a sweep, during which files do not change.
simulation::Case read_case(const std::string& path, const std::vector<std::string>& overrides,
                           Starts& kept);

/// Does the same as simulation::start, with bitwise identical results. `reused_bit`: a bit that is
/// overwritten, so that its memory is reused.
simulation::Simulation start(const simulation::Case& c, Starts& kept, rock::CuttingBit reused_bit);

/// Whether a point succeeded.
enum class PointStatus { done, failed };

/// Whether the means of a run are steady; unknown for summaries that do not state it.
enum class Steady : signed char { no, yes, unknown };

/// "no", "yes" or "unknown".
const char* name_of(Steady steady);

/// The result of a point.
struct PointOutcome {
  PointStatus status = PointStatus::done;
  std::string case_hash;        ///< empty if the case could not be read
  std::string message;          ///< why the point failed
  std::vector<double> figures;  ///< those that the design lists; NaN if the point failed
  bool lacks_figures = false;   ///< the point failed because its summary lacks a listed figure
  Steady steady = Steady::unknown;
};

/// What a thread needs at each of its points.
struct PointSurroundings {
  std::filesystem::path cuts;  ///< folder in which a calibration keeps its cut runs
  const std::atomic<bool>* interrupted;
  Starts& starts;                    ///< shared by all threads
  rock::CuttingBit reused_bit = {};  ///< memory of the last point, to be reused
};

/// Runs the design's command on its case with these overrides, in memory. The figures are bitwise
/// identical to those of the summary that the command would write. The point fails if its case is
/// wrong, its run fails or its summary lacks a figure (`lacks_figures`). An interruption throws
/// Interrupted. Several threads may call this at once; calibrations take turns.
struct Interrupted {};
PointOutcome run_point(const Design& d, const std::vector<std::string>& overrides,
                       PointSurroundings& around);

/// What is known of a point before it runs.
struct PointInputs {
  std::vector<std::string> files;   ///< that it reads: case, bit, tables
  std::vector<std::string> doubts;  ///< about numbers without a unit, each with its place
};

/// Reads the inputs of a point. Throws InputError if its case is wrong.
PointInputs inputs_of(const Design& d, const std::vector<std::string>& overrides);

/// Returns the names of all numbers in the summary of a point, which a design may list as figures.
/// Throws whatever the command throws.
std::vector<std::string> figures_on_offer(const Design& d,
                                          const std::vector<std::string>& overrides,
                                          const std::filesystem::path& cuts);

/// Returns the numbers of a summary with these dotted names ("wob_mean_n",
/// "sections.0.mean_area_m2"). True and false count as 1 and 0, null as NaN. Throws InputError that
/// lists the names without a number, each with the nearest name that has one.
std::vector<double> summarize(const nlohmann::ordered_json& summary,
                              const std::vector<std::string>& names);

/// Returns the names of all numbers, in the order of the summary.
std::vector<std::string> figure_names(const nlohmann::ordered_json& summary);

/// The loads of a bit that drills steadily, by the planar model.
struct PlanarLoads {
  Vec3 force_B = Vec3::Zero();  ///< N, of the rock on the bit, bit frame
  double torque = 0.0;          ///< N m, about the bit's axis, against the rotation
};

/// Evaluates the force laws of a case for what each cutter cuts in the radial plane, sweep (1): its
/// face with the cut area and the engaged edge, and its chamfer with the contact behind that edge.
/// Law, rock and measures are those of `tdbd run` at the start of the case; area laws
/// ([forces.areas]) count. Wear flats, cutter bodies, gage pads and rubbing parts have no force
/// here. `indices`: the cutters of the engagement, as in bit::cutting_at_start. `advance`: m per
/// revolution, > 0. Requires a case with [forces] and a rotary speed > 0.
PlanarLoads planar_loads(const simulation::Case& c, const std::vector<int>& indices,
                         const bit::Engagement& e, double advance);

/// Evaluates the planar model for a case's bit at its advance per revolution, without drilling:
/// advance_m, imbalance (lateral force over the weight), imbalance_of_normal_ratio (the classical
/// model, in which the normal force is `normal_ratio` times the cutting force),
/// imbalance_of_unit_law, wob_n, tob_n_m, mean_redundancy, cut_area_m2, largest_cut_area_m2,
/// engaged_cutters. SI. `imbalance` is that of the case's force law (planar_loads). Without
/// [forces] it is imbalance_of_normal_ratio, and wob_n and tob_n_m are null. Throws InputError for
/// a bit without cutters or a motion without an advance.
nlohmann::ordered_json planar_summary(const simulation::Case& c, double normal_ratio);

}  // namespace tdbd::sweep
