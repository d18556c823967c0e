#include "reference/literature/roller/bands/sheppard_lesage.hpp"

#include <fmt/format.h>

#include <numbers>

#include "core/error.hpp"
#include "reference/compare/models/answers.hpp"
#include "reference/compare/models/roller_case.hpp"

namespace tdbd::reference {
namespace {

/// The rows of a bit that are bands, and their indices in its cones. A tooth on a journal is not a
/// band.
struct Bands {
  RollerBit bit;
  std::vector<std::vector<std::size_t>> rows;
  std::size_t left_out = 0;
};

Bands bands_of(const RollerBit& bit) {
  constexpr double on_the_journal = 1e-9;  // m
  Bands bands;
  for (RollerCone cone : bit.cones) {
    std::vector<RollerRow> rows;
    bands.rows.emplace_back();
    for (std::size_t r = 0; r < cone.rows.size(); ++r) {
      if (cone.rows[r].radius < on_the_journal) continue;
      rows.push_back(cone.rows[r]);
      bands.rows.back().push_back(r);
    }
    bands.left_out += cone.rows.size() - rows.size();
    cone.rows = rows;
    bands.bit.cones.push_back(cone);
  }
  return bands;
}

void say_cones_of_bands(const CompareCase& c, const Bands& bands, const SheppardLesage& found,
                        Findings& f) {
  double sum = 0.0;
  for (std::size_t k = 0; k < found.cones.size(); ++k) {
    const BandCone& cone = found.cones[k];
    const std::string name = c.ours.bit.cones[k].name;
    f.parts.push_back({name, 0.0, PartQuantity::cone_speed_ratio, cone.ratio});
    sum += cone.ratio;
    for (std::size_t r = 0; r < cone.rows.size(); ++r) {
      const double turns = c.ours.motion.rotary_speed / (2.0 * std::numbers::pi);
      const double radius = ring_radius(bands.bit.cones[k], bands.bit.cones[k].rows[r]);
      const std::string row = row_name(name, bands.rows[k][r]);
      f.parts.push_back(
          {row, radius, PartQuantity::volume_per_revolution, cone.rows[r].volume_rate / turns});
      f.parts.push_back({row, radius, PartQuantity::force_into_rock, -cone.rows[r].force.z()});
    }
  }
  say(f, Quantity::cone_speed_ratio, sum / static_cast<double>(found.cones.size()));
}

}  // namespace

Findings run_sheppard_lesage_model(const Question& q) {
  const CompareCase& c = q.asked;
  const RollerSettings& s = c.options.roller;
  const Bands bands = bands_of(roller_bit_of(c.ours.bit, "Sheppard and Lesage"));
  const RollerBit& bit = bands.bit;
  BandOptions options;
  options.half_angle = s.half_angle;
  Findings f;
  BandRock rock{s.specific_energy.value_or(1.0), s.normal_ratio};
  SheppardLesage found = sheppard_lesage(bit, rock, c.ours.motion.rotary_speed, c.advance, options);
  if (!s.specific_energy) {
    if (q.weight <= 0.0)
      throw InputError(
          "Sheppard and Lesage: found no specific energy, needs "
          "compare.roller.specific_energy, or a weight to find it from");
    rock.specific_energy = q.weight / found.weight;
    found = sheppard_lesage(bit, rock, c.ours.motion.rotary_speed, c.advance, options);
    f.notes.push_back(fmt::format(
        "its specific energy, {:.4g} MPa, is that at which it needs the reference weight: weight "
        "and rate are no predictions",
        1e-6 * rock.specific_energy));
  }
  set_steady_load_quantities(f, found.weight, found.torque, c.advance);
  say(f, Quantity::removed_per_revolution,
      found.volume_rate * 2.0 * std::numbers::pi / c.ours.motion.rotary_speed);
  say_cones_of_bands(c, bands, found, f);
  if (bands.left_out > 0)
    f.notes.push_back(
        fmt::format("rows left out, whose teeth are on the journal's axis: {}", bands.left_out));
  if (q.weight > 0.0) {
    const SheppardLesage under =
        sheppard_lesage_under(bit, rock, c.ours.motion.rotary_speed, q.weight, options);
    say(f, Quantity::rate_at_weight, under.rate);
    say(f, Quantity::torque_at_weight, under.torque);
  }
  set_missing(f, of_weight, no_weight);
  set_missing(f, lateral, "thesis 2.2 does not mention lateral forces");
  set_missing(f, {Quantity::teeth_in_contact, Quantity::teeth_in_contact_variance},
              "rows are smooth bands: it has no teeth");
  set_missing(f, Quantity::resolution_at_gage, "it keeps no bottom");
  set_missing(f, Quantity::share_moved_backwards, no_cutters);
  set_missing(f, flats, no_wear);
  return f;
}

}  // namespace tdbd::reference
