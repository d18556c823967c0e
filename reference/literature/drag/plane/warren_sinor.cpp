#include "reference/literature/drag/plane/warren_sinor.hpp"

#include <cmath>
#include <sstream>

#include "core/error.hpp"
#include "reference/literature/drag/drag_input.hpp"

namespace tdbd::reference {
namespace {

const std::string sinor_name = "Warren and Sinor";

void require_sinor(const std::vector<bit::Cutter>& cutters, const DragRock& rock,
                   const WarrenSinorOptions& options) {
  require_cutters(sinor_name, cutters);
  require_positive(sinor_name, "specific energy of the rock (Pa)", rock.specific_energy);
  require_one_each(sinor_name, "normal ratios", options.normal_ratio.size(), cutters.size());
  require_one_each(sinor_name, "areas of flats", options.flat_area.size(), cutters.size());
}

/// Adds the forces of one cutter to the loads of the whole bit.
void add_cutter(const bit::Cutter& c, const CutterForce& sharp, const CutterForce& flat,
                WarrenSinorCutter& own, WarrenSinorLoad& load) {
  own.force = {sharp.cutting + flat.cutting, sharp.normal + flat.normal};
  const Eigen::Vector2d out(std::cos(c.azimuth), std::sin(c.azimuth)), t(-out.y(), out.x());
  load.weight += own.force.normal * std::cos(c.profile_angle);
  load.torque += sharp.cutting * own.arm + flat.cutting * c.tip_radius;
  load.volume += own.volume;
  load.radial_B -= own.force.normal * std::sin(c.profile_angle) * out;
  load.circumferential_B -= own.force.cutting * t;
}

std::string no_advance(double weight, double at_least, double at_most, const AdvanceBracket& b) {
  std::ostringstream text;
  text << sinor_name << ": no advance from " << b.least << " to " << b.most
       << " m per revolution carries the weight: found " << weight << " N, expected from "
       << at_least << " to " << at_most << " N";
  return text.str();
}

}  // namespace

void warren_sinor(const std::vector<bit::Cutter>& cutters, const RadialOutlines& outlines,
                  double advance, const DragRock& rock, const WarrenSinorOptions& options,
                  PlanarCut& cut, WarrenSinorLoad& load) {
  planar_cut(outlines, advance, cut);
  load.advance = advance;
  load.weight = load.torque = load.volume = 0.0;
  load.radial_B.setZero();
  load.circumferential_B.setZero();
  load.cutters.resize(cutters.size());
  for (std::size_t i = 0; i < cutters.size(); ++i) {
    WarrenSinorCutter& own = load.cutters[i];
    own = {cut.area[i], cut.volume[i], cut.arm(i), {}};
    if (own.area == 0.0) continue;
    const double ratio = options.normal_ratio.empty() ? rock.normal_ratio : options.normal_ratio[i];
    const double flat = options.flat_area.empty() ? 0.0 : options.flat_area[i];
    add_cutter(cutters[i], sharp_force(rock, ratio, own.area), flat_force(rock, flat), own, load);
  }
}

WarrenSinorLoad warren_sinor(const std::vector<bit::Cutter>& cutters, double advance,
                             const DragRock& rock, const WarrenSinorOptions& options) {
  require_sinor(cutters, rock, options);
  require_positive(sinor_name, "advance (m per revolution)", advance);
  PlanarCut cut;
  WarrenSinorLoad load;
  warren_sinor(cutters, radial_outlines(cutters, options.form, options.column), advance, rock,
               options, cut, load);
  return load;
}

WarrenSinorLoad warren_sinor_at_weight(const std::vector<bit::Cutter>& cutters, double weight,
                                       const DragRock& rock, const WarrenSinorOptions& options,
                                       const AdvanceBracket& bracket) {
  require_sinor(cutters, rock, options);
  const RadialOutlines outlines = radial_outlines(cutters, options.form, options.column);
  PlanarCut cut;
  WarrenSinorLoad load;
  const auto weight_at = [&](double advance) {
    warren_sinor(cutters, outlines, advance, rock, options, cut, load);
    return load.weight;
  };
  const double at_least = weight_at(bracket.least), at_most = weight_at(bracket.most);
  double lo = bracket.least, hi = bracket.most, middle = 0.5 * (lo + hi);
  if (weight >= at_least && weight <= at_most) {
    for (; lo < middle && middle < hi; middle = 0.5 * (lo + hi))
      (weight_at(middle) < weight ? lo : hi) = middle;
    constexpr double carried = 1e-9;  // a weight that is discontinuous in the advance has no root
    if (std::abs(weight_at(hi) - weight) <= carried * weight) return load;
  }
  throw InputError(no_advance(weight, at_least, at_most, bracket));
}

}  // namespace tdbd::reference
