#pragma once

#include <array>
#include <map>
#include <vector>

#include "core/types.hpp"

namespace tdbd::mesh {

/// Appends points to a list and stores equal points once. Coordinates must be finite.
class MergedPoints {
 public:
  explicit MergedPoints(std::vector<Vec3>& all) : all_(all) {}

  /// Returns the index of x in the list.
  int add(const Vec3& x) {
    const auto [place, is_new] =
        number_.try_emplace({x.x(), x.y(), x.z()}, static_cast<int>(all_.size()));
    if (is_new) all_.push_back(x);
    return place->second;
  }

 private:
  std::vector<Vec3>& all_;
  std::map<std::array<double, 3>, int> number_;
};

}  // namespace tdbd::mesh
