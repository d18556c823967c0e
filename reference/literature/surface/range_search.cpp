#include "reference/literature/surface/range_search.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace tdbd::reference {
namespace {

constexpr std::size_t most_open = 64;  // more levels than the range of int allows

bool inside(const SearchBox& box, const Vec3& x) {
  return (x.array() >= box.lo.array()).all() && (x.array() <= box.hi.array()).all();
}

bool meet(const SearchBox& a, const SearchBox& b) {
  return (a.lo.array() <= b.hi.array()).all() && (a.hi.array() >= b.lo.array()).all();
}

bool holds(const SearchBox& outer, const SearchBox& inner) {
  return inside(outer, inner.lo) && inside(outer, inner.hi);
}

SearchBox box_around(const std::vector<Vec3>& positions, const std::vector<int>& numbers, int first,
                     int last) {
  SearchBox box{positions[at(numbers[at(first)])], positions[at(numbers[at(first)])]};
  for (int i = first + 1; i < last; ++i) {
    box.lo = box.lo.cwiseMin(positions[at(numbers[at(i)])]);
    box.hi = box.hi.cwiseMax(positions[at(numbers[at(i)])]);
  }
  return box;
}

int longest_side(const SearchBox& box) {
  int axis = 0;
  (box.hi - box.lo).maxCoeff(&axis);
  return axis;
}

}  // namespace

RangeSearch::RangeSearch(const std::vector<Vec3>& positions)
    : numbers_(positions.size()), points_(positions.size()) {
  std::iota(numbers_.begin(), numbers_.end(), 0);
  if (!positions.empty()) split(positions, 0, static_cast<int>(positions.size()));
  refit(positions);
}

int RangeSearch::split(const std::vector<Vec3>& positions, int first, int last) {
  const auto node = static_cast<int>(nodes_.size());
  nodes_.push_back({box_around(positions, numbers_, first, last), first, last, 0, 0});
  if (last - first <= leaf_size) return node;
  const int axis = longest_side(nodes_.back().around), middle = first + (last - first) / 2;
  const auto begin = numbers_.begin();
  std::nth_element(begin + first, begin + middle, begin + last,
                   [&](int a, int b) { return positions[at(a)][axis] < positions[at(b)][axis]; });
  const int near = split(positions, first, middle), far = split(positions, middle, last);
  nodes_[at(node)].near = near;
  nodes_[at(node)].far = far;
  return node;
}

void RangeSearch::surround(Node& node) const {
  if (node.near > 0) {
    const SearchBox &a = nodes_[at(node.near)].around, &b = nodes_[at(node.far)].around;
    node.around = {a.lo.cwiseMin(b.lo), a.hi.cwiseMax(b.hi)};
    return;
  }
  node.around = {points_[at(node.first)], points_[at(node.first)]};
  for (int i = node.first + 1; i < node.last; ++i) {
    node.around.lo = node.around.lo.cwiseMin(points_[at(i)]);
    node.around.hi = node.around.hi.cwiseMax(points_[at(i)]);
  }
}

void RangeSearch::refit(const std::vector<Vec3>& positions) {
  for (std::size_t i = 0; i < numbers_.size(); ++i) points_[i] = positions[at(numbers_[i])];
  for (std::size_t n = nodes_.size(); n > 0; --n) surround(nodes_[n - 1]);
}

void RangeSearch::find(const SearchBox& box, std::vector<int>& found) const {
  found.clear();
  std::array<int, most_open> open{};
  std::size_t waiting = nodes_.empty() ? 0 : 1;
  while (waiting > 0) {
    const Node& node = nodes_[at(open[--waiting])];
    if (!meet(node.around, box)) continue;
    if (holds(box, node.around)) {
      found.insert(found.end(), numbers_.begin() + node.first, numbers_.begin() + node.last);
    } else if (node.near > 0) {
      open[waiting++] = node.far;
      open[waiting++] = node.near;
    } else {
      for (int i = node.first; i < node.last; ++i)
        if (inside(box, points_[at(i)])) found.push_back(numbers_[at(i)]);
    }
  }
}

}  // namespace tdbd::reference
