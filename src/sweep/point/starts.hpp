#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "simulation/step/simulation.hpp"

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

}  // namespace tdbd::sweep
