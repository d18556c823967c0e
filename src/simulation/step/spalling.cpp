#include "simulation/step/spalling.hpp"

#include "bit/cutter/cutter_frame.hpp"

namespace tdbd::simulation {
namespace {

bool breaks_at(const Case& c, const Vec3& x_W) {
  if (c.forces.forces == Forces::off) return true;
  return c.spalling.beds[forces::layer_at(c.forces.rock, x_W)] != 0;
}

}  // namespace

std::optional<SpallingState> start_spalling(const SpallingPlan& plan) {
  if (!spalls(plan)) return std::nullopt;
  SpallingState s;
  s.ends.resize(plan.rules.size());
  s.broken_out.resize(plan.rules.size());
  return s;
}

std::vector<rock::Breakout> breakouts_of(const Case& c, const bit::Bit& bit,
                                         const MeasuredFaces& faces, rock::CuttingBit& cutting) {
  if (!spalls(c.spalling)) return {};
  std::vector<rock::FaceOutline> outlines;
  for (const rock::SectionFace& face : faces.faces) outlines.push_back(face.outline);
  const double beyond_sections = list_margins_for(c.measure, c.rock.edge_length).ahead;
  return rock::add_breakouts(bit, {c.spalling.rules, outlines, beyond_sections}, c.update.cutting,
                             cutting);
}

void place_breakouts(const Case& c, const Pose& X_WB, const std::vector<rock::Breakout>& breakouts,
                     const SpallingState& state, rock::CuttingBit& cutting) {
  for (const rock::Breakout& b : breakouts) {
    const bool breaks = breaks_at(c, X_WB * bit::tip_B(c.bit.cutters[at(b.cutter)]));
    rock::place_breakout(b, breaks ? state.ends[at(b.cutter)] : rock::EngagedEnds{}, cutting);
  }
}

void follow_breakouts(const bit::Bit& bit, const rock::CutReport& cut, const Measures& measures,
                      SpallingState& state) {
  state.ends = measures.ends;
  for (std::size_t p = 0; p < cut.broken_out_by_part.size(); ++p)
    if (cut.broken_out_by_part[p] != 0.0)
      state.broken_out[at(bit.parts[p].cutter)].add(cut.broken_out_by_part[p]);
}

}  // namespace tdbd::simulation
