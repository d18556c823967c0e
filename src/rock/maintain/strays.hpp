#pragma once

#include <algorithm>
#include <vector>

namespace tdbd::rock {

/// How far the operations of one maintenance have moved the surface at most, per vertex, m: a
/// triangle strays no farther from the surface before than the largest of its vertices' figures
/// (M6 of formulation 3). An operation takes the largest around it and adds its own.
class Strays {
 public:
  double of(int v) const {
    return static_cast<std::size_t>(v) < by_vertex_.size() ? by_vertex_[static_cast<std::size_t>(v)]
                                                           : 0.0;
  }

  void note(int v, double distance) {
    if (distance <= 0.0) return;
    const auto i = static_cast<std::size_t>(v);
    if (i >= by_vertex_.size()) by_vertex_.resize(i + 1 + i / 8, 0.0);
    if (by_vertex_[i] == 0.0) listed_.push_back(v);
    by_vertex_[i] = std::max(by_vertex_[i], distance);
  }

  void clear() {
    for (const int v : listed_) by_vertex_[static_cast<std::size_t>(v)] = 0.0;
    listed_.clear();
  }

 private:
  std::vector<double> by_vertex_;
  std::vector<int> listed_;
};

}  // namespace tdbd::rock
