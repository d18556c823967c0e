#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "simulation/step/simulation.hpp"

namespace tdbd::sweep {

/// Values that several points need, the newest of them, up to a sum of weights: one that alone weighs
/// more is made for its point only. Threads may call it at once.
template <class T>
class Kept {
 public:
  explicit Kept(double most) : most_(most) {}

  /// The value of this key, from make() unless it is there. An empty key is that of no other.
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

/// Whether points begin with what others made.
enum class Keeping { on, off };

/// What points need before their first step. Most share bit and rock, and to read and make these
/// takes longer than all else; so the newest few stay. Threads may use it at once.
struct Starts {
  explicit Starts(Keeping keeping);
  Kept<bit::BitFile> files;                 ///< by all arguments of their reader
  Kept<rock::CuttingBit> bits;              ///< by Case::bit_hash
  Kept<simulation::StartSurface> surfaces;  ///< by start_surface_key
};

/// simulation::read_case of a sweep, during which files do not change.
simulation::Case read_case(const std::string& path, const std::vector<std::string>& overrides,
                           Starts& kept);

/// simulation::start of the case, to the bit. `room` is a bit to be overwritten: its memory serves
/// again.
simulation::Simulation start(const simulation::Case& c, Starts& kept, rock::CuttingBit room);

}  // namespace tdbd::sweep
