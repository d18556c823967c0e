#include "bit/cone/tooth_faults.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tdbd::bit {
namespace {

std::string mm(double x) { return fmt::format("{:.6g} mm", 1e3 * x); }

void demand_positive(const ToothShape& t, std::vector<ConeFault>& faults) {
  const auto demand = [&](const char* key, double value) {
    if (!(value > 0.0)) faults.push_back({-1, key, mm(value), "a length above 0"});
  };
  demand("diameter", t.diameter);
  demand("protrusion", t.protrusion);
  demand("embedding", t.embedding);
  if (t.kind == ToothKind::conical) demand("tip_radius", t.tip_radius);
  if (t.kind == ToothKind::milled_chisel) demand("width", t.width);
  if (t.kind == ToothKind::milled_chisel || t.kind == ToothKind::chisel) {
    demand("crest_length", t.crest_length);
    demand("crest_width", t.crest_width);
  }
}

void demand_at_most(const char* key, double value, double most, std::vector<ConeFault>& faults) {
  if (value > most) faults.push_back({-1, key, mm(value), "at most " + mm(most)});
}

void check_crest(const ToothShape& t, std::vector<ConeFault>& faults) {
  const double across = t.kind == ToothKind::milled_chisel ? t.width : t.crest_length;
  demand_at_most("crest_length", t.crest_length, t.diameter, faults);
  demand_at_most("crest_width", t.crest_width, across, faults);
}

/// Above the shank's rim the conical flank begins; it must not begin below the insert's end.
void check_cone(const ToothShape& t, std::vector<ConeFault>& faults) {
  const double at_tangent = t.tip_radius * std::cos(t.half_angle);
  demand_at_most("tip_radius", at_tangent, 0.5 * t.diameter, faults);
  const double flank = t.tip_radius * (1.0 - std::sin(t.half_angle)) +
                       (0.5 * t.diameter - at_tangent) / std::tan(t.half_angle);
  if (flank >= t.protrusion + t.embedding)
    faults.push_back({-1, "half_angle",
                      fmt::format("{:.4g} rad, a flank {} high", t.half_angle, mm(flank)),
                      "a flank lower than protrusion and embedding together, " +
                          mm(t.protrusion + t.embedding)});
}

}  // namespace

std::vector<ConeFault> tooth_faults(const ToothShape& t) {
  std::vector<ConeFault> faults;
  demand_positive(t, faults);
  if (!faults.empty()) return faults;
  if (t.kind == ToothKind::chisel || t.kind == ToothKind::milled_chisel) check_crest(t, faults);
  if (t.kind == ToothKind::conical) check_cone(t, faults);
  if (t.kind == ToothKind::hemispherical && t.protrusion + t.embedding <= 0.5 * t.diameter)
    faults.push_back({-1, "embedding", mm(t.embedding),
                      "more than the half-ball reaches below the shell, " +
                          mm(0.5 * t.diameter - t.protrusion)});
  return faults;
}

}  // namespace tdbd::bit
