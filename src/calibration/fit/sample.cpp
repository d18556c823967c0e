#include "calibration/fit/sample.hpp"

#include <cmath>

#include "core/pose.hpp"
#include "simulation/case/case_forces.hpp"

namespace tdbd::calibration {
namespace {

/// Velocity of the tool: a bit rotates about z and moves along it; a cutter moves along x without
/// rotation.
simulation::BitVelocity velocity_of(const Record& record) {
  simulation::BitVelocity v;
  if (record.rate > 0.0) {
    v.v_W = record.rate * Vec3::UnitZ();
    v.w_W = record.speed * Vec3::UnitZ();
  } else {
    v.v_W = record.speed * Vec3::UnitX();
  }
  return v;
}

/// Adds the loads of a force on the tool: opposite to z, and opposite to the rotation about z.
void add(const forces::PartForce& f, Loads& loads) {
  loads[axial] -= f.force.z();
  loads[turning] -= f.point.x() * f.force.y() - f.point.y() * f.force.x();
}

bool follows(const forces::Law& law, const forces::PartCut& cut) {
  return simulation::follows_the_run(cut.kind) &&
         forces::law_problem(law, cut.kind, cut.diameter).empty();
}

const forces::Law& law_of(Laws laws, const Sample& sample, std::size_t cut) {
  return laws[sample.mix.empty() ? 0 : at(sample.mix[cut])];
}

}  // namespace

Sample sample_of(const CutRun& run, const Record& record, const forces::Strength& strength,
                 const forces::Law& law, std::span<const int> mix_of_part) {
  static const bit::Bit without_cones;
  constexpr double instant = 1.0;  // s; only PartCut::path depends on it
  const simulation::BitVelocity motion = velocity_of(record);
  Sample sample;
  for (const simulation::CutOfPart& mean : run.cuts) {
    forces::PartCut cut = simulation::cut_at(without_cones, Pose{}, motion, instant, mean);
    cut.strength = strength;
    if (follows(law, cut)) {
      sample.cuts.push_back(cut);
      if (!mix_of_part.empty()) sample.mix.push_back(mix_of_part[at(mean.part)]);
    } else
      add(forces::force(simulation::own_law_of(cut.kind), cut), sample.others);
  }
  return sample;
}

Loads mean_loads(Laws laws, const Sample& sample) {
  Loads loads = sample.others;
  for (std::size_t i = 0; i < sample.cuts.size(); ++i)
    add(forces::force(law_of(laws, sample, i), sample.cuts[i]), loads);
  return loads;
}

Loads loads_of(Laws laws, const Sample& sample, const Kinds& kinds) {
  Loads loads{};
  for (std::size_t i = 0; i < sample.cuts.size(); ++i)
    if (kinds[static_cast<std::size_t>(sample.cuts[i].kind)])
      add(forces::force(law_of(laws, sample, i), sample.cuts[i]), loads);
  return loads;
}

Loads depth_slopes(Laws laws, const Sample& sample) {
  constexpr double step = 1e-4;
  const auto scaled = [&](double factor) {
    Sample s = sample;
    for (forces::PartCut& cut : s.cuts) {
      cut.cut_area *= factor;
      cut.depth *= factor;
    }
    return mean_loads(laws, s);
  };
  const Loads more = scaled(1.0 + step), less = scaled(1.0 - step);
  Loads slopes{};
  for (const std::size_t k : {axial, turning})
    if (more[k] > 0.0 && less[k] > 0.0) slopes[k] = std::log(more[k] / less[k]) / (2.0 * step);
  return slopes;
}

}  // namespace tdbd::calibration
