#include "bit/cutter/table_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>

#include "core/types.hpp"

namespace tdbd::bit {
namespace {

using Cutters = std::vector<Cutter>;
using Doubts = std::vector<TableDoubt>;

constexpr double inch = 0.0254;
constexpr std::size_t fewest = 8, most = 400;

/// Doubts that most cutters share describe a design, not mistakes.
Doubts if_few(Doubts doubts, std::size_t cutters) {
  constexpr std::size_t share = 5, always = 3;
  if (doubts.size() > std::max(always, cutters / share)) doubts.clear();
  return doubts;
}

template <class Value>
double median(const Cutters& cutters, const Value& value) {
  std::vector<double> all;
  for (const Cutter& c : cutters) all.push_back(value(c));
  std::ranges::nth_element(all, all.begin() + std::ssize(all) / 2);
  return all[all.size() / 2];
}

template <class Value>
double largest(const Cutters& cutters, const Value& value) {
  double x = 0.0;
  for (const Cutter& c : cutters) x = std::max(x, value(c));
  return x;
}

/// A column whose values fit in another unit.
TableDoubt whole_column(const Cutters& cutters, const char* column, std::string found,
                        std::string expected, Severity severity) {
  return {cutters.front().line, column, std::move(found), std::move(expected), severity};
}

/// Angles of a column that were probably written in rad.
Doubts radian_doubts(const Cutters& cutters) {
  constexpr double turn_in_rad = 6.3 * degree, largest_rake_in_rad = 1.1 * degree;
  Doubts doubts;
  const double azimuth = largest(cutters, [](const Cutter& c) { return std::abs(c.azimuth); });
  const double back = largest(cutters, [](const Cutter& c) { return std::abs(c.back_rake); });
  if (azimuth > 0.0 && azimuth < turn_in_rad)
    doubts.push_back(whole_column(
        cutters, "phi_deg", fmt::format("azimuths of at most {:.3g} deg", azimuth / degree),
        "cutters around the axis; are angles in rad (phi_rad)?", Severity::impossible));
  if (back > 0.0 && back < largest_rake_in_rad)
    doubts.push_back(whole_column(
        cutters, "back_rake_deg", fmt::format("back rakes of at most {:.3g} deg", back / degree),
        "usually 5 to 30 deg; are angles in rad (back_rake_rad)?", Severity::doubtful));
  return doubts;
}

Doubts swapped_rakes(const Cutters& cutters) {
  constexpr double tilted = 8.0 * degree, upright = 6.0 * degree, much_less = 0.5;
  const double back = median(cutters, [](const Cutter& c) { return std::abs(c.back_rake); });
  const double side = median(cutters, [](const Cutter& c) { return std::abs(c.side_rake); });
  if (side < tilted || back > std::max(upright, much_less * side)) return {};
  return {whole_column(
      cutters, "back_rake_deg, side_rake_deg",
      fmt::format("side rakes of about {:.3g} deg and back rakes of about {:.3g} deg",
                  side / degree, back / degree),
      "back rakes larger than side rakes; are the columns swapped?", Severity::doubtful)};
}

/// Side rakes of which none is positive: the faces would send cuttings to the middle of the bit.
Doubts inward_side_rakes(const Cutters& cutters) {
  constexpr double visible = 1.5 * degree;
  const auto [least, greatest] = std::ranges::minmax(cutters, {}, &Cutter::side_rake);
  if (greatest.side_rake > 0.0 || least.side_rake > -visible) return {};
  return {whole_column(cutters, "side_rake_deg",
                       fmt::format("side rakes of {:.3g} to {:.3g} deg", least.side_rake / degree,
                                   greatest.side_rake / degree + 0.0),  // no -0
                       "usually 0 to 10 deg, which send cuttings outwards; is the sign of the "
                       "column wrong?",
                       Severity::doubtful)};
}

/// Bits are wider than the tips are high. Two changes with the same effect differ in it.
enum class Shape { any, wide, tall };

/// A change of a whole column that may make the table consistent.
struct Change {
  const char* column;
  const char* found;
  const char* expected;
  std::function<void(Cutter&)> apply;
  Shape shape = Shape::any;
};

constexpr const char* diameters_and_radii = "dia_mm, r_tip_mm";

std::vector<Change> whole_changes() {
  return {
      {"h_tip_mm", "heights that decrease towards the gage",
       "heights above the nose, positive towards the shank: change the sign of the column",
       [](Cutter& c) { c.tip_height = -c.tip_height; }},
      {"profile_angle_deg", "angles of the opposite sign of the profile's slope",
       "negative angles in the cone, 90 on the gage: change the sign of the column",
       [](Cutter& c) { c.profile_angle = -c.profile_angle; }},
      {"profile_angle_deg", "angles that fit the profile in rad",
       "deg, or the name profile_angle_rad", [](Cutter& c) { c.profile_angle /= degree; }},
      {"profile_angle_deg", "angles that fit the profile if they are from the bit's axis",
       "0 on the nose, negative in the cone, 90 on the gage: 90 minus these",
       [](Cutter& c) { c.profile_angle = right_angle - c.profile_angle; }, Shape::wide},
      {"r_tip_mm", "values that fit the profile as diameters", "radii: half of these",
       [](Cutter& c) { c.tip_radius *= 0.5; }},
      {"r_tip_mm", "values that fit the profile in inches", "mm, or the name r_tip_in",
       [](Cutter& c) { c.tip_radius *= inch / 1e-3; }},
      {"h_tip_mm", "values that fit the profile in inches", "mm, or the name h_tip_in",
       [](Cutter& c) { c.tip_height *= inch / 1e-3; }},
      {"r_tip_mm, h_tip_mm", "values that fit the profile when swapped",
       "the radius in r_tip_mm, the height in h_tip_mm",
       [](Cutter& c) { std::swap(c.tip_radius, c.tip_height); }, Shape::tall},
      {diameters_and_radii, "values that fit the profile when swapped",
       "the diameter of the cutter in dia_mm, the radius of its tip in r_tip_mm",
       [](Cutter& c) { std::swap(c.tip_radius, c.diameter); }},
      {"profile_angle_deg, back_rake_deg", "values that fit the profile when swapped",
       "the angle of the profile in profile_angle_deg",
       [](Cutter& c) { std::swap(c.profile_angle, c.back_rake); }},
      {"profile_angle_deg, phi_deg", "values that fit the profile when swapped",
       "the angle of the profile in profile_angle_deg",
       [](Cutter& c) { std::swap(c.profile_angle, c.azimuth); }},
  };
}

std::size_t misfits_of(const Cutters& cutters) { return misfits(tips_along_profile(cutters)); }

/// Doubts of a table in which many cutters do not fit. Empty if few do not.
Doubts column_doubts(const Cutters& cutters, std::size_t faces) {
  const std::size_t wrong = misfits_of(cutters);
  if (wrong <= std::max<std::size_t>(3, faces / 3)) return {};
  const Change* best = nullptr;
  std::size_t fewest_wrong = faces / 8;
  const std::vector<Change> changes = whole_changes();
  const bool is_tall = largest(cutters, [](const Cutter& c) { return c.tip_height; }) >
                       largest(cutters, [](const Cutter& c) { return c.tip_radius; });
  for (const Change& change : changes) {
    if (change.shape != Shape::any && (change.shape == Shape::tall) != is_tall) continue;
    Cutters changed = cutters;
    std::ranges::for_each(changed, change.apply);
    const std::size_t left = misfits_of(changed);
    if (left < fewest_wrong || (left == fewest_wrong && !best)) {
      fewest_wrong = left;
      best = &change;
    }
  }
  if (best)
    return {whole_column(cutters, best->column, best->found, best->expected, Severity::impossible)};
  return {whole_column(
      cutters, "r_tip_mm, h_tip_mm, profile_angle_deg",
      fmt::format("{} of {} cutters off a smooth profile through their neighbours", wrong, faces),
      "tips on one profile whose slope agrees with the profile angles: 0 on the nose, negative in "
      "the cone, 90 on the gage",
      Severity::doubtful)};
}

/// Neighbours of a cutter in a sequence.
struct Between {
  const Cutter *before, *cutter, *after;
};

/// Every cutter of a sequence with its two nearest neighbours in it.
std::vector<Between> triples(const std::vector<const Cutter*>& sequence) {
  std::vector<Between> all;
  const std::size_t n = sequence.size();
  for (std::size_t i = 0; n >= 3 && i < n; ++i)
    all.push_back({sequence[i == 0 ? 1 : i - 1], sequence[i],
                   sequence[i == 0       ? 2
                            : i + 1 == n ? n - 3
                                         : i + 1]});
  return all;
}

std::vector<const Cutter*> along_profile(const Cutters& cutters) {
  std::vector<const Cutter*> sequence;
  for (const ProfileTip& t : tips_along_profile(cutters)) sequence.push_back(&cutters[t.index]);
  return sequence;
}

Doubts rake_doubts(const Cutters& cutters) {
  constexpr double jump = 8.0 * degree, visible = 1.5 * degree;
  Doubts doubts;
  for (const auto& [a, c, b] : triples(along_profile(cutters))) {
    const auto [low, high] = std::minmax(a->back_rake, b->back_rake);
    if (c->back_rake < low - jump || c->back_rake > high + jump)
      doubts.push_back({c->line, "back_rake_deg",
                        fmt::format("{:.4g} deg of cutter {}", c->back_rake / degree, c->id),
                        fmt::format("about {:.3g} deg, like its neighbours on the profile, cutters "
                                    "{} and {}",
                                    0.5 * (low + high) / degree, a->id, b->id)});
    const double mean = 0.5 * (a->side_rake + b->side_rake);
    const bool alike = std::abs(a->side_rake - b->side_rake) < degree + 0.3 * std::abs(mean);
    const bool opposite = std::abs(mean + c->side_rake) < degree + 0.3 * std::abs(mean);
    if (alike && opposite && std::abs(c->side_rake) > visible && std::abs(mean) > visible)
      doubts.push_back({c->line, "side_rake_deg",
                        fmt::format("{:.4g} deg of cutter {}", c->side_rake / degree, c->id),
                        fmt::format("about {:.3g} deg (is the sign wrong?), like its neighbours on "
                                    "the profile, cutters {} and {}",
                                    mean / degree, a->id, b->id)});
  }
  return if_few(std::move(doubts), cutters.size());
}

double wrapped(double angle) { return std::remainder(angle, full_turn); }

Doubts azimuth_doubts(const Cutters& cutters) {
  constexpr double far = 45.0 * degree, near = 40.0 * degree, blades_meet = 0.2;
  const double gage = largest(cutters, [](const Cutter& c) { return c.tip_radius; });
  std::map<int, std::vector<const Cutter*>> blades;
  for (const Cutter* c : along_profile(cutters)) blades[c->blade].push_back(c);
  Doubts doubts;
  for (const auto& [blade, sequence] : blades)
    for (const auto& [a, c, b] : triples(sequence)) {
      const double bend = wrapped(b->azimuth - a->azimuth);
      const double mean = a->azimuth + 0.5 * bend;
      if (c->tip_radius < blades_meet * gage || std::abs(bend) > near ||
          std::abs(wrapped(c->azimuth - mean)) < far)
        continue;
      const double expected = mean - full_turn * std::floor(mean / full_turn);
      doubts.push_back(
          {c->line, "phi_deg", fmt::format("{:.4g} deg of cutter {}", c->azimuth / degree, c->id),
           fmt::format("about {:.0f} deg, like cutters {} and {} of its blade {}; or another blade",
                       expected / degree, a->id, b->id, blade)});
    }
  return if_few(std::move(doubts), cutters.size());
}

/// Rows that are missing: a gap in the numbers and on the profile, or a ring that no cutter covers.
Doubts gap_doubts(const Cutters& cutters) {
  constexpr double wide = 1.5, steep = 75.0 * degree;
  const std::vector<const Cutter*> tips = along_profile(cutters);
  const auto gap = [&](std::size_t k) {
    return std::hypot(tips[k + 1]->tip_radius - tips[k]->tip_radius,
                      tips[k + 1]->tip_height - tips[k]->tip_height);
  };
  Doubts doubts;
  for (std::size_t k = 0; k + 1 < tips.size(); ++k) {
    const Cutter &a = *tips[k], &b = *tips[k + 1];
    if (std::max(a.profile_angle, b.profile_angle) > steep) continue;
    const double others =
        std::max(k > 0 ? gap(k - 1) : 0.0, k + 2 < tips.size() ? gap(k + 1) : 0.0);
    const int between = b.id - a.id - 1;
    const bool unnumbered = between > 0 && std::ranges::none_of(cutters, [&](const Cutter& c) {
                              return c.id > a.id && c.id < b.id;
                            });
    const bool uncovered = gap(k) > 0.5 * (a.diameter + b.diameter);
    if (!(unnumbered && gap(k) > wide * others) && !uncovered) continue;
    doubts.push_back({b.line, "r_tip_mm",
                      fmt::format("a gap of {:.3g} mm on the profile between cutters {} and {}",
                                  1e3 * gap(k), a.id, b.id),
                      unnumbered
                          ? fmt::format("cutter {} between them; is its row missing?", a.id + 1)
                          : std::string("a cutter between them: the rock there is not cut")});
  }
  return if_few(std::move(doubts), cutters.size());
}

/// A row whose radius is out of the order of the table, which no other check may notice on a flat
/// nose.
Doubts order_doubts(const Cutters& cutters) {
  constexpr double slack = 1e-3;  // m
  std::vector<const Cutter*> rows;
  for (const Cutter& c : cutters)
    if (c.under_exposure == 0.0) rows.push_back(&c);
  const auto place = [](const Cutter* c) { return c->tip_radius + c->tip_height; };
  Doubts doubts;
  for (std::size_t k = 1; k + 1 < rows.size(); ++k) {
    const double before = place(rows[k - 1]), here = place(rows[k]), after = place(rows[k + 1]);
    if (before > after || (here > before - slack && here < after + slack)) continue;
    doubts.push_back(
        {rows[k]->line, "r_tip_mm",
         fmt::format("{:.6g} mm of cutter {}", 1e3 * rows[k]->tip_radius, rows[k]->id),
         fmt::format("a place between cutters {} and {}, as the order of the table suggests",
                     rows[k - 1]->id, rows[k + 1]->id)});
  }
  return if_few(std::move(doubts), cutters.size() / 2);
}

/// Adds the doubts about rows that have none; of one row, all of them or the first.
enum class OfRow { all, first };
void add_more(Doubts more, Doubts& doubts, OfRow of_row = OfRow::first) {
  const Doubts before = of_row == OfRow::all ? doubts : Doubts{};
  const Doubts& known = of_row == OfRow::all ? before : doubts;
  for (TableDoubt& d : more)
    if (std::ranges::count(known, d.line, &TableDoubt::line) == 0) doubts.push_back(std::move(d));
}

}  // namespace

std::vector<TableDoubt> table_doubts(const std::vector<Cutter>& cutters) {
  const std::size_t faces = tips_along_profile(cutters).size();
  if (faces < fewest || faces > most) return size_doubts(cutters);
  if (Doubts sizes = size_doubts(cutters); !sizes.empty()) {
    Doubts columns = column_doubts(cutters, faces);
    const bool swapped = !columns.empty() && columns.front().column == diameters_and_radii;
    return swapped ? columns : sizes;
  }
  Doubts doubts = height_sign_doubts(cutters);
  if (doubts.empty()) doubts = column_doubts(cutters, faces);
  if (doubts.empty()) {
    doubts = profile_doubts(cutters);
    // A tip that is off the profile also leaves a gap and the order.
    if (doubts.empty()) doubts = order_doubts(cutters);
    if (doubts.empty()) doubts = gap_doubts(cutters);
  }
  const std::size_t about_profile = doubts.size();
  for (Doubts& more :
       std::array{radian_doubts(cutters), swapped_rakes(cutters), inward_side_rakes(cutters)})
    std::ranges::move(more, std::back_inserter(doubts));
  const bool whole_columns = doubts.size() > about_profile;
  add_more(feature_doubts(cutters), doubts, OfRow::all);
  add_more(rake_doubts(cutters), doubts);
  if (!whole_columns) add_more(azimuth_doubts(cutters), doubts);
  std::ranges::stable_sort(doubts, {}, &TableDoubt::line);
  return doubts;
}

std::string doubt_text(const std::string& file, const TableDoubt& d) {
  return fmt::format("{}:{}: {}: found {}, expected {}", file, d.line, d.column, d.found,
                     d.expected);
}

}  // namespace tdbd::bit
