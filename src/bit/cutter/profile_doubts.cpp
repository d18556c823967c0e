#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>

#include "bit/cutter/table_doubts.hpp"
#include "core/types.hpp"

namespace tdbd::bit {
namespace {

using Tips = std::vector<ProfileTip>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double same_place = 0.5e-3;  // m: tips closer than this are twins

double place_of(const ProfileTip& t) { return t.r + t.h; }

double distance(const ProfileTip& a, const ProfileTip& b) {
  return std::hypot(b.r - a.r, b.h - a.h);
}

double chord_angle(const ProfileTip& a, const ProfileTip& b) {
  return std::atan2(b.h - a.h, b.r - a.r);
}

/// Distance of b from the straight line through a at the mean of both angles, over its tolerance.
double link_misfit(const ProfileTip& a, const ProfileTip& b) {
  constexpr double rounding = 0.4e-3, bend_share = 0.25;
  const double mean = 0.5 * (a.angle + b.angle);
  const double off = std::cos(mean) * (b.h - a.h) - std::sin(mean) * (b.r - a.r);
  return std::abs(off) / (rounding + bend_share * distance(a, b) * std::abs(b.angle - a.angle));
}

/// The nearest tip before (step -1) or after (+1) that is no twin; i if there is none.
std::size_t neighbour(const Tips& tips, std::size_t i, int step) {
  std::size_t k = i;
  while (step < 0 ? k > 0 : k + 1 < tips.size()) {
    k = step < 0 ? k - 1 : k + 1;
    if (distance(tips[i], tips[k]) > same_place) return k;
  }
  return i;
}

double smallest(double a, double b) { return std::min(std::abs(a), std::abs(b)); }

/// Two estimates of a profile angle between neighbours: from their angles, and from the chords.
std::array<double, 2> angle_estimates(const ProfileTip& before, const ProfileTip& t,
                                      const ProfileTip& after) {
  const double left = distance(before, t), right = distance(t, after), all = left + right;
  return {std::lerp(before.angle, after.angle, left / all),
          (chord_angle(before, t) * right + chord_angle(t, after) * left) / all};
}

/// Whether both estimates agree with the opposite sign and contradict the sign that is given.
bool has_wrong_sign(double angle, const std::array<double, 2>& estimates) {
  constexpr double visible = 2.5 * degree;
  return std::abs(angle) > visible && std::ranges::all_of(estimates, [&](double e) {
           return std::abs(e + angle) < degree + 0.25 * std::abs(angle) &&
                  std::abs(e - angle) > std::abs(angle);
         });
}

double angle_misfit(const Tips& tips, std::size_t i) {
  constexpr double tolerance = 3.5 * degree, tolerance_at_end = 12.0 * degree;
  constexpr double bend_share = 0.03, just_wrong = 1.01;
  const ProfileTip& t = tips[i];
  double twin = infinity;
  for (const std::size_t k : {i - 1, i + 1})
    if (k < tips.size() && distance(tips[k], t) <= same_place)
      twin = std::min(twin, std::abs(tips[k].angle - t.angle));
  const std::size_t a = neighbour(tips, i, -1), b = neighbour(tips, i, 1);
  if (a == i || b == i) {
    if (std::isfinite(twin)) return twin / tolerance;
    const ProfileTip& other = tips[a == i ? b : a];
    const double chord = a == i ? chord_angle(t, other) : chord_angle(other, t);
    return smallest(t.angle - other.angle, t.angle - (2.0 * chord - other.angle)) /
           tolerance_at_end;
  }
  const std::array<double, 2> e = angle_estimates(tips[a], t, tips[b]);
  const double off = std::min(twin, smallest(t.angle - e[0], t.angle - e[1]));
  const double found = off / (tolerance + bend_share * std::abs(tips[b].angle - tips[a].angle));
  return has_wrong_sign(t.angle, e) && off < twin ? std::max(found, just_wrong) : found;
}

}  // namespace

std::vector<ProfileTip> tips_along_profile(const std::vector<Cutter>& cutters) {
  Tips tips;
  for (std::size_t i = 0; i < cutters.size(); ++i) {
    const Cutter& c = cutters[i];
    if (c.under_exposure == 0.0)
      tips.push_back({c.tip_radius, c.tip_height, c.profile_angle, c.diameter, i});
  }
  std::ranges::stable_sort(tips, {}, place_of);
  return tips;
}

Misfit misfit_at(const Tips& tips, std::size_t i) {
  if (tips.size() < 3) return {};
  const std::size_t last = tips.size() - 1;
  const std::size_t a = i == 0 ? 1 : i - 1, b = i == 0 ? 2 : i == last ? last - 2 : i + 1;
  const auto link = [&](std::size_t k) {
    return k < i ? link_misfit(tips[k], tips[i]) : link_misfit(tips[i], tips[k]);
  };
  return {std::min(link(a), link(b)), angle_misfit(tips, i)};
}

std::size_t misfits(const Tips& tips) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < tips.size(); ++i) n += misfit_at(tips, i).worst() > 1.0;
  return n;
}

namespace {

/// Points of a smooth curve through the tips, which continues straight beyond both ends.
Tips curve_through(const Tips& tips) {
  constexpr int steps = 16;
  Tips curve;
  const auto beyond = [](ProfileTip t, double length) {
    t.r += length * std::cos(t.angle);
    t.h += length * std::sin(t.angle);
    return t;
  };
  curve.push_back(beyond(tips.front(), -2.0 * tips.front().diameter));
  for (std::size_t k = 0; k + 1 < tips.size(); ++k) {
    const ProfileTip &a = tips[k], &b = tips[k + 1];
    const double length = distance(a, b);
    for (int j = 0; j < steps; ++j) {
      const double s = static_cast<double>(j) / steps;  // cubic Hermite interpolation
      const double p = s * s * (3.0 - 2.0 * s), u = s * (1.0 - s) * (1.0 - s),
                   v = s * s * (s - 1.0);
      ProfileTip t = a;
      t.r = std::lerp(a.r, b.r, p) + length * (u * std::cos(a.angle) + v * std::cos(b.angle));
      t.h = std::lerp(a.h, b.h, p) + length * (u * std::sin(a.angle) + v * std::sin(b.angle));
      t.angle = std::lerp(a.angle, b.angle, s);
      curve.push_back(t);
    }
  }
  curve.push_back(tips.back());
  curve.push_back(beyond(tips.back(), 2.0 * tips.back().diameter));
  return curve;
}

/// Where the curve has this value of one coordinate: the place that is most like `t` in another.
double crossing(const Tips& curve, double ProfileTip::*given, double ProfileTip::*wanted,
                double ProfileTip::*similar, const ProfileTip& t) {
  double best = infinity, found = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
    const ProfileTip &a = curve[k], &b = curve[k + 1];
    const double from = a.*given - t.*given, to = b.*given - t.*given;
    if (from * to > 0.0 || from == to) continue;
    const double s = from / (from - to);
    const double difference = std::abs(std::lerp(a.*similar, b.*similar, s) - t.*similar);
    if (difference < best) {
      best = difference;
      found = std::lerp(a.*wanted, b.*wanted, s);
    }
  }
  return found;
}

double nearest_angle(const Tips& curve, const ProfileTip& t) {
  return std::ranges::min(curve, {}, [&](const ProfileTip& p) { return distance(p, t); }).angle;
}

/// A correction of one coordinate and how well the tip fits with it.
struct Correction {
  double ProfileTip::*member = nullptr;
  double value = 0.0, misfit = infinity, unevenness = 1.0;
  bool sign_only = false, in_order = true;
};

/// The ratio of the distances of a tip from its two neighbours, larger over smaller, in steps of a
/// quarter; 1 at the ends. Neighbours of a tip at a wrong place are unevenly far.
double unevenness(const Tips& others, const ProfileTip& t) {
  constexpr double step = 0.25;
  const auto after = std::ranges::upper_bound(others, place_of(t), {}, place_of);
  if (after == others.begin() || after == others.end()) return 1.0;
  const auto [low, high] = std::minmax({distance(*std::prev(after), t), distance(t, *after)});
  return step * std::round(high / std::max(low, same_place) / step);
}

/// Puts a tip among others.
Misfit misfit_among(const Tips& others, const ProfileTip& t) {
  Tips all = others;
  const auto place = std::ranges::upper_bound(all, place_of(t), {}, place_of);
  const auto i = static_cast<std::size_t>(place - all.begin());
  all.insert(place, t);
  return misfit_at(all, i);
}

/// Whether the tip lies between its neighbours in the file, if these are in the profile's order.
bool fits_order(const Tips& others, const ProfileTip& t) {
  constexpr double slack = 1e-3;  // m
  const ProfileTip *before = nullptr, *after = nullptr;
  for (const ProfileTip& o : others) {
    if (o.index < t.index && (!before || o.index > before->index)) before = &o;
    if (o.index > t.index && (!after || o.index < after->index)) after = &o;
  }
  if (before && after && place_of(*before) > place_of(*after)) return true;  // not sorted
  return (!before || place_of(t) > place_of(*before) - slack) &&
         (!after || place_of(t) < place_of(*after) + slack);
}

Correction best_correction(const Tips& others, const ProfileTip& t) {
  using P = ProfileTip;
  constexpr double good_fit = 0.5;  // consistent tables have at most 0.33
  const Tips curve = curve_through(others);
  std::array<Correction, 6> all{{
      {.member = &P::angle, .value = -t.angle, .sign_only = true},
      {.member = &P::h, .value = -t.h, .sign_only = true},
      {.member = &P::angle, .value = nearest_angle(curve, t)},
      {.member = &P::h, .value = crossing(curve, &P::r, &P::h, &P::angle, t)},
      {.member = &P::r, .value = crossing(curve, &P::h, &P::r, &P::angle, t)},
      {.member = &P::r, .value = crossing(curve, &P::angle, &P::r, &P::h, t)},
  }};
  for (Correction& c : all) {
    if (!std::isfinite(c.value)) continue;
    ProfileTip corrected = t;
    corrected.*c.member = c.value;
    c.misfit = misfit_among(others, corrected).worst();
    c.in_order = fits_order(others, corrected);
    c.unevenness = unevenness(others, corrected);
    if (c.sign_only && c.misfit < good_fit) return c;
  }
  const auto rank = [&](const Correction& c) {
    return std::tuple(c.misfit > good_fit ? c.misfit : 0.0, !c.in_order, c.unevenness);
  };
  return std::ranges::min(all, {}, rank);
}

std::string neighbours_text(const std::vector<Cutter>& cutters, const Tips& others,
                            const ProfileTip& t) {
  const auto place = std::ranges::upper_bound(others, place_of(t), {}, place_of);
  const auto i = static_cast<std::size_t>(place - others.begin());
  const auto id = [&](std::size_t k) { return cutters[others[k].index].id; };
  if (i == 0) return fmt::format("next to cutter {}", id(0));
  if (i == others.size()) return fmt::format("next to cutter {}", id(i - 1));
  return fmt::format("between cutters {} and {} of the profile", id(i - 1), id(i));
}

/// How far a tip is outside a place of the profile, along its normal, m.
double outside(const ProfileTip& t, const ProfileTip& profile) {
  return std::sin(profile.angle) * (t.r - profile.r) - std::cos(profile.angle) * (t.h - profile.h);
}

/// A tip this far outside the others (over its diameter) cuts alone: no bit is made so.
constexpr double largest_outside = 0.45;

/// A tip that no change of one column corrects.
TableDoubt unexplained(const std::vector<Cutter>& cutters, const Tips& others,
                       const ProfileTip& t) {
  const Tips curve = curve_through(others);
  const ProfileTip& nearest =
      std::ranges::min(curve, {}, [&](const ProfileTip& p) { return distance(p, t); });
  const Cutter& c = cutters[t.index];
  return {
      c.line, "r_tip_mm, h_tip_mm, profile_angle_deg",
      fmt::format("the tip of cutter {} {:.3g} mm off the profile of the others, with a profile "
                  "angle of {:.4g} deg",
                  c.id, 1e3 * distance(nearest, t), t.angle / degree),
      fmt::format("a tip on it, {}; under_exposure_mm marks back-up cutters",
                  neighbours_text(cutters, others, t)),
      outside(t, nearest) > largest_outside * t.diameter ? Severity::impossible
                                                         : Severity::doubtful};
}

TableDoubt explained(const std::vector<Cutter>& cutters, const Tips& others, const ProfileTip& t,
                     const Correction& by) {
  constexpr double largest_turn = 45.0 * degree;
  const bool is_angle = by.member == &ProfileTip::angle;
  const double si = is_angle ? degree : 1e-3, found = t.*by.member;
  const char* unit = is_angle ? "deg" : "mm";
  ProfileTip corrected = t;
  corrected.*by.member = by.value;
  // With a wrong angle the edge points away from the rock.
  const bool impossible = is_angle ? std::abs(found - by.value) > largest_turn
                                   : outside(t, corrected) > largest_outside * t.diameter;
  const Cutter& c = cutters[t.index];
  return {c.line,
          is_angle                      ? "profile_angle_deg"
          : by.member == &ProfileTip::h ? "h_tip_mm"
                                        : "r_tip_mm",
          fmt::format("{:.6g} {} of cutter {}", found / si, unit, c.id),
          fmt::format("about {:.3g} {}{}, {}", by.value / si, unit,
                      by.sign_only ? " (is the sign wrong?)" : "",
                      neighbours_text(cutters, others, corrected)),
          impossible ? Severity::impossible : Severity::doubtful};
}

}  // namespace

std::vector<TableDoubt> profile_doubts(const std::vector<Cutter>& cutters) {
  constexpr std::size_t most = 10, fewest_tips = 5;
  Tips tips = tips_along_profile(cutters);
  std::vector<ProfileTip> wrong;
  while (wrong.size() < most && tips.size() > fewest_tips) {
    std::size_t worst = 0;
    double misfit = 0.0;
    for (std::size_t i = 0; i < tips.size(); ++i)
      if (const double m = misfit_at(tips, i).worst(); m > misfit) {
        misfit = m;
        worst = i;
      }
    if (misfit <= 1.0) break;
    wrong.push_back(tips[worst]);
    tips.erase(tips.begin() + static_cast<std::ptrdiff_t>(worst));
  }
  std::vector<TableDoubt> doubts;
  for (const ProfileTip& t : wrong) {
    if (misfit_among(tips, t).worst() <= 1.0) continue;  // only its neighbour was wrong
    const Correction by = best_correction(tips, t);
    doubts.push_back(by.misfit <= 1.0 ? explained(cutters, tips, t, by)
                                      : unexplained(cutters, tips, t));
  }
  return doubts;
}

std::vector<TableDoubt> height_sign_doubts(const std::vector<Cutter>& cutters) {
  constexpr double visible = 1e-3;  // m
  constexpr std::size_t fewest = 2, most_share = 2, good_share = 8;
  std::vector<Cutter> turned = cutters;
  std::size_t count = 0;
  for (Cutter& c : turned)
    if (c.under_exposure == 0.0 && c.tip_height < -visible) {
      c.tip_height = -c.tip_height;
      ++count;
    }
  const Tips right = tips_along_profile(turned);
  const std::size_t left = misfits(right);
  if (count < fewest || count * most_share > right.size() || left * good_share > right.size() ||
      left >= misfits(tips_along_profile(cutters)))
    return {};
  std::vector<TableDoubt> doubts = profile_doubts(turned);
  for (const ProfileTip& good : right) {
    if (turned[good.index].tip_height == cutters[good.index].tip_height) continue;
    Tips others = right;
    std::erase_if(others, [&](const ProfileTip& o) { return o.index == good.index; });
    ProfileTip t = good;
    t.h = -t.h;
    doubts.push_back(explained(cutters, others, t,
                               {.member = &ProfileTip::h, .value = good.h, .sign_only = true}));
  }
  return doubts;
}

}  // namespace tdbd::bit
