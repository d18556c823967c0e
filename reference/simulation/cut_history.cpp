#include "reference/simulation/cut_history.hpp"

#include <algorithm>
#include <cmath>

#include "core/types.hpp"

namespace tdbd::reference {
namespace {

constexpr double never = -1.0;  ///< m: the other cutter never passes here

/// A rim in a half-plane through the axis.
struct MeridianPoint {
  double r = 0.0, z = 0.0, azimuth = 0.0;
};

struct Rim {
  std::vector<MeridianPoint> points;
  double nearest = 0.0, farthest = 0.0;  ///< m, from the axis
};

Rim meridian(const RoundCutter& c, int points) {
  Rim rim;
  for (int i = 0; i <= points; ++i) {
    const Vec3 x = rim_point(c, full_turn * i / points, 0.0);
    rim.points.push_back({std::hypot(x.x(), x.y()), x.z(), std::atan2(x.y(), x.x())});
  }
  const auto by_r = [](const MeridianPoint& a, const MeridianPoint& b) { return a.r < b.r; };
  rim.nearest = std::ranges::min_element(rim.points, by_r)->r;
  rim.farthest = std::ranges::max_element(rim.points, by_r)->r;
  return rim;
}

/// The lowest point of a rim at a radius. Returns false if the rim does not reach it.
bool lowest_at(const Rim& rim, double r, MeridianPoint& lowest) {
  bool found = false;
  if (r < rim.nearest || r > rim.farthest) return false;
  for (std::size_t i = 1; i < rim.points.size(); ++i) {
    const MeridianPoint &a = rim.points[i - 1], &b = rim.points[i];
    if ((a.r - r) * (b.r - r) > 0.0 || a.r == b.r) continue;
    const double w = (r - a.r) / (b.r - a.r), z = a.z + w * (b.z - a.z);
    if (found && z <= lowest.z) continue;
    found = true;
    lowest = {r, z, a.azimuth + w * std::remainder(b.azimuth - a.azimuth, full_turn)};
  }
  return found;
}

/// Rotation of the bit, rad, since `other` was at the azimuth of `own`.
double lag_of(double own, double other, bool is_itself) {
  double lag = std::remainder(other - own, full_turn);
  if (is_itself) return full_turn + lag;
  return lag > 0.0 ? lag : lag + full_turn;
}

/// Empty if the other cutter removes nothing of this column.
Left remaining_rock_of(const RoundCutter& own, double at, const Rim& other, bool is_itself,
                       const std::vector<double>& marks) {
  Left left;
  double highest = never;
  for (const double up : marks) {
    const Vec3 x = rim_point(own, at, up);
    MeridianPoint lowest;
    if (lowest_at(other, std::hypot(x.x(), x.y()), lowest)) {
      if (highest == never) left.lag = lag_of(std::atan2(x.y(), x.x()), lowest.azimuth, is_itself);
      highest = std::max(highest, lowest.z - x.z());
    }
    left.needed.push_back(highest);
  }
  // A cutter that is higher than this has no effect in drilling.
  constexpr double farthest = 0.02;
  if (highest == never || left.needed.back() < -farthest) {
    left.needed.clear();
    return left;
  }
  left.least = left.needed.front();
  left.largest = left.needed.back();
  return left;
}

}  // namespace

HeightHistory::HeightHistory(int bins_per_turn) : width_(full_turn / bins_per_turn) {}

void HeightHistory::pass(double turned, double height) {
  while (static_cast<double>(heights_.size()) * width_ <= turned) {
    const double to = static_cast<double>(heights_.size()) * width_;
    const double w = (to - last_turned_) / (turned - last_turned_);
    heights_.push_back(last_height_ + w * (height - last_height_));
  }
  if (turned <= last_turned_) return;
  last_turned_ = turned;
  last_height_ = height;
}

double HeightHistory::at(double turned, double now_turned, double now_height) const {
  if (turned <= 0.0) return 0.0;
  const double bin = turned / width_;
  const auto i = static_cast<std::size_t>(bin);
  if (i + 1 < heights_.size())
    return heights_[i] + (bin - static_cast<double>(i)) * (heights_[i + 1] - heights_[i]);
  const double known = static_cast<double>(heights_.size() - 1) * width_;
  if (now_turned <= known) return heights_.back();
  return heights_.back() + (turned - known) / (now_turned - known) * (now_height - heights_.back());
}

Columns make_columns(std::vector<RoundCutter> cutters, int per_cutter, double spacing,
                     double highest) {
  constexpr int rim_points = 256;
  Columns c;
  c.cutters = std::move(cutters);
  for (double up = 0.0; up <= highest; up += spacing) c.marks.push_back(up);
  std::vector<Rim> rims;
  for (const RoundCutter& cutter : c.cutters) rims.push_back(meridian(cutter, rim_points));
  for (std::size_t k = 0; k < c.cutters.size(); ++k) {
    const RoundCutter& cutter = c.cutters[k];
    c.columns.emplace_back();
    for (int i = 0; i <= per_cutter; ++i) {
      Column column;
      column.at = pi * i / per_cutter - right_angle;
      column.y = rim_radius(cutter, column.at) * std::sin(column.at);
      column.chord = 2.0 * rim_radius(cutter, column.at) * std::cos(column.at);
      column.foot_B = rim_point(cutter, column.at, 0.0);
      for (std::size_t other = 0; other < rims.size(); ++other) {
        Left left = remaining_rock_of(cutter, column.at, rims[other], other == k, c.marks);
        if (!left.needed.empty()) column.left.push_back(std::move(left));
      }
      c.columns.back().push_back(std::move(column));
    }
  }
  return c;
}

RockInColumn rock_in_column(const Column& column, const std::vector<double>& marks,
                            const HeightHistory& history, double turned, double height) {
  constexpr double deepest = 1e-3;  // m: larger values have no effect
  RockInColumn rock{column.chord, deepest};
  std::size_t top = marks.size() - 1;  // index of a mark at or above `up`; initially the last
  for (const Left& left : column.left) {
    const double down = height - history.at(turned - left.lag, turned, height);
    rock.deep = std::min(rock.deep, down - left.least);
    if (left.largest < down) continue;      // it left all of the rock; nearly all others end here
    if (left.needed[top] < down) continue;  // it left all of the rock up to this mark
    const auto first = left.needed.begin();
    const auto beyond = std::lower_bound(first, first + static_cast<std::ptrdiff_t>(top), down);
    top = static_cast<std::size_t>(beyond - first);
    if (top == 0) {
      rock.up = 0.0;
      continue;
    }
    const double below = left.needed[top - 1], above = left.needed[top];
    const double w = (down - below) / (above - below);
    rock.up = std::min(rock.up, marks[top - 1] + w * (marks[top] - marks[top - 1]));
  }
  return rock;
}

}  // namespace tdbd::reference
