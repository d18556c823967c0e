#include "bit/report/bit_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bit/report/bit_output.hpp"
#include "bit/report/body_report.hpp"
#include "core/types.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bit {
namespace {

using Json = nlohmann::ordered_json;

constexpr double inch = 0.0254;

std::string plural(std::size_t n, const char* what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

/// Counts by value, "name 8, name 3", in the order in which the names first occur.
template <class Name>
std::string counts(const std::vector<Cutter>& cutters, const Name& name) {
  std::vector<std::pair<std::string, int>> all;
  for (const Cutter& c : cutters) {
    const std::string n = name(c);
    auto place = std::ranges::find(all, n, &std::pair<std::string, int>::first);
    if (place == all.end()) place = all.insert(all.end(), {n, 0});
    ++place->second;
  }
  constexpr std::size_t most = 12;
  std::string text;
  for (std::size_t k = 0; k < std::min(most, all.size()); ++k)
    text += fmt::format("{}{} {}", k == 0 ? "" : ", ", all[k].first, all[k].second);
  return text + (all.size() > most ? fmt::format(" and {} more", all.size() - most) : "");
}

/// A value without the rounding that makes it a tiny number or a negative zero: 0 if it is below
/// 1e-9 units.
double without_tiny(double value) {
  constexpr double tiny = 1e-9;
  return std::abs(value) < tiny ? 0.0 : value;
}

/// "12 to 25", or one number.
std::string range_text(const std::vector<Cutter>& cutters, double Cutter::*member, double unit) {
  const auto [low, high] = std::ranges::minmax(cutters, {}, member);
  const std::string from = fmt::format("{:.4g}", without_tiny(low.*member / unit)),
                    to = fmt::format("{:.4g}", without_tiny(high.*member / unit));
  return from == to ? from : from + " to " + to;
}

std::string head_text(const Bit& bit) {
  const double across = 2.0 * bit.gage_radius;
  std::string what = bit.cutters.empty() ? "" : plural(bit.cutters.size(), "cutter") + ", ";
  if (!bit.cones.empty()) what += plural(bit.cones.size(), "cone") + ", ";
  return fmt::format("{}: {}{}, {:.4g} in across, gage radius {:.3f} mm\n", bit.name, what,
                     plural(bit.parts.size(), "part"), across / inch, 1e3 * bit.gage_radius);
}

std::string layout_text(const Bit& bit) {
  const std::vector<Cutter>& all = bit.cutters;
  if (all.empty()) return "";
  constexpr double mm = 1e-3;
  const auto backups = static_cast<std::size_t>(
      std::ranges::count_if(all, [](const Cutter& c) { return c.under_exposure > 0.0; }));
  std::string text = fmt::format("cutters: diameter {} mm, back rake {} deg, side rake {} deg{}\n",
                                 range_text(all, &Cutter::diameter, mm),
                                 range_text(all, &Cutter::back_rake, degree),
                                 range_text(all, &Cutter::side_rake, degree),
                                 backups > 0 ? ", " + plural(backups, "back-up cutter") : "");
  std::vector<Cutter> by_blade = all;
  std::ranges::stable_sort(by_blade, {}, &Cutter::blade);
  text += fmt::format("blades (number, cutters): {}\n",
                      counts(by_blade, [](const Cutter& c) { return std::to_string(c.blade); }));
  const Cutter& lowest = std::ranges::min(all, {}, &Cutter::tip_height);
  text += fmt::format(
      "profile: tips at radius {} mm, height {} mm, profile angle {} deg; lowest at radius {:.4g} "
      "mm\n",
      range_text(all, &Cutter::tip_radius, mm), range_text(all, &Cutter::tip_height, mm),
      range_text(all, &Cutter::profile_angle, degree), lowest.tip_radius / mm);
  return text + fmt::format("zones (name, cutters): {}\n",
                            counts(all, [](const Cutter& c) { return c.zone; }));
}

std::string percent(double share) { return fmt::format("{:6.2f} %", 100.0 * share); }

std::string balance_text(const std::vector<Cutter>& cutters, const Engagement& e, double advance) {
  const PlanarBalance b = planar_balance(cutters, e.area, report_normal_ratio);
  if (!(b.weight > 0.0)) return "imbalance: unknown, no cutter carries weight\n";
  return fmt::format(
      "imbalance at {:.4g} mm per revolution: lateral force over the weight on bit, estimated from "
      "the cut areas\n"
      "  {}  of the normal forces, which act along the normals of the profile\n"
      "  {}  of the drag, which acts against the motion; normal force over drag is {:g}\n"
      "  {}  of both (planar model of Warren and Sinor, 1986): compare layouts by this value\n"
      "  The estimate ignores rakes, wear and the rock. A run (tdbd run) includes them.\n",
      1e3 * advance, percent(b.normal.norm() / b.weight), percent(b.drag.norm() / b.weight),
      report_normal_ratio, percent((b.normal + b.drag).norm() / b.weight));
}

std::string cut_text(const Bit& bit, const std::vector<Cutter>& cutting, const Engagement& e,
                     double advance) {
  const auto idle = static_cast<std::size_t>(std::ranges::count(e.area, 0.0));
  std::string text = fmt::format(
      "cutting at {:.4g} mm per revolution: {} of {} cutters cut; at each radius {:.2f} cutters "
      "cut, on average\n",
      1e3 * advance, cutting.size() - idle, bit.cutters.size(), mean_redundancy(e.cutting));
  constexpr double visible = 1e-3;  // m; a thinner core breaks
  const auto uncut = static_cast<std::size_t>(std::ranges::count(e.cutting, 0));
  const double width = e.column_width * static_cast<double>(uncut);
  if (width > visible)
    text += fmt::format("  no cutter cuts on {:.3g} mm of the radius\n", 1e3 * width);
  return text;
}

}  // namespace

Json balance_json(const std::vector<Cutter>& cutters, const Engagement& e) {
  const PlanarBalance b = planar_balance(cutters, e.area, report_normal_ratio);
  if (!(b.weight > 0.0)) return nullptr;
  const Vec3 normal = b.normal / b.weight, drag = b.drag / b.weight, both = normal + drag;
  return {{"normal_over_drag_force", report_normal_ratio},
          {"planar_over_weight", both.norm()},
          {"planar_vector_over_weight", vector_json(both)},
          {"normal_part_over_weight", normal.norm()},
          {"normal_part_vector_over_weight", vector_json(normal)},
          {"drag_part_over_weight", drag.norm()},
          {"drag_part_vector_over_weight", vector_json(drag)}};
}

std::string facts_text(const Bit& bit, double advance) {
  std::string text = head_text(bit) + layout_text(bit);
  const std::vector<Cutter> cutting = cutters_at(bit, cutting_at_start(bit));
  if (!cutting.empty()) {
    const Engagement e = engagement(cutting, advance, report_column_width);
    text += cut_text(bit, cutting, e, advance) + balance_text(cutting, e, advance);
  }
  return text + body_text(bit, advance);
}

std::string cutters_text(const Bit& bit) {
  std::string text =
      fmt::format("{:>7} {:>5} {:>9} {:>9} {:>9} {:>9} {:>8} {:>6} {:>6} {:>8}\n", "cutter",
                  "blade", "zone", "r mm", "phi deg", "h mm", "prof deg", "back", "side", "dia mm");
  for (const Cutter& c : bit.cutters)
    text += fmt::format(
        "{:>7} {:>5} {:>9} {:>9.3f} {:>9.3f} {:>9.3f} {:>8.2f} {:>6.1f} {:>6.1f} {:>8.2f}\n", c.id,
        c.blade, c.zone, 1e3 * c.tip_radius, without_tiny(c.azimuth / degree),
        without_tiny(1e3 * c.tip_height), without_tiny(c.profile_angle / degree),
        without_tiny(c.back_rake / degree), without_tiny(c.side_rake / degree), 1e3 * c.diameter);
  return text;
}

std::string parts_text(const Bit& bit) {
  std::string text = fmt::format("{:<24} {:>12} {:>6} {:>9} {:>12} {:>10}\n", "part", "kind",
                                 "cuts", "triangles", "volume mm3", "mass g");
  for (const Part& p : bit.parts) {
    const double volume = mesh::enclosed_volume(p.mesh_P);
    text += fmt::format("{:<24} {:>12} {:>6} {:>9} {:>12.3f} {:>10.3f}\n", p.name,
                        kind_name(p.kind), cutting_name(final_cutting(p)),
                        p.mesh_P.triangles.size(), 1e9 * volume, 1e3 * p.density * volume);
  }
  return text;
}

}  // namespace tdbd::bit
