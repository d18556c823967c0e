#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

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

}  // namespace tdbd::sweep
