#include "reference/compare/models/tooth_parts.hpp"

#include <fmt/format.h>

namespace tdbd::reference {
namespace {

/// Calls visit(cone, row, ring radius, index of its first tooth) for each row.
template <typename Visit>
void for_each_row(const RollerBit& bit, Visit&& visit) {
  std::size_t next = 0;
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    for (std::size_t r = 0; r < bit.cones[k].rows.size(); ++r) {
      const RollerRow& row = bit.cones[k].rows[r];
      visit(k, r, ring_radius(bit.cones[k], row), next);
      next += row.angles.size();
    }
}

/// Rows and cones are summed tooth by tooth, in their order.
void say_sums(const CompareCase& c, const RollerBit& bit, PartQuantity q,
              const std::vector<double>& teeth, Findings& f) {
  std::vector<double> cones(bit.cones.size());
  for_each_row(bit, [&](std::size_t k, std::size_t r, double radius, std::size_t first) {
    double sum = 0.0;
    for (std::size_t i = 0; i < bit.cones[k].rows[r].angles.size(); ++i) sum += teeth[first + i];
    f.parts.push_back({row_name(c.ours.bit.cones[k].name, r), radius, q, sum});
    cones[k] += sum;
  });
  for (std::size_t k = 0; k < cones.size(); ++k)
    f.parts.push_back({c.ours.bit.cones[k].name, 0.0, q, cones[k]});
}

}  // namespace

std::string tooth_name(const std::string& cone, std::size_t row, std::size_t tooth) {
  return fmt::format("{}/tooth-{}", row_name(cone, row), tooth + 1);
}

std::vector<double> over(std::vector<double> teeth, double count) {
  for (double& x : teeth) x /= count;
  return teeth;
}

void set_tooth_values(const CompareCase& c, const RollerBit& bit, PartQuantity q,
                      const std::vector<double>& teeth, Findings& f) {
  for_each_row(bit, [&](std::size_t k, std::size_t r, double radius, std::size_t first) {
    for (std::size_t i = 0; i < bit.cones[k].rows[r].angles.size(); ++i)
      f.parts.push_back({tooth_name(c.ours.bit.cones[k].name, r, i), radius, q, teeth[first + i]});
  });
}

void set_tooth_values_and_sums(const CompareCase& c, const RollerBit& bit, PartQuantity q,
                               const std::vector<double>& teeth, Findings& f) {
  say_sums(c, bit, q, teeth, f);
  set_tooth_values(c, bit, q, teeth, f);
}

void set_tooth_quantities(const CompareCase& c, const RollerBit& bit, const ToothNumbers& teeth,
                          Findings& f) {
  set_tooth_values_and_sums(c, bit, PartQuantity::force_into_rock, teeth.force, f);
  set_tooth_values_and_sums(c, bit, PartQuantity::weight, teeth.force, f);
  set_tooth_values(c, bit, PartQuantity::largest_weight, teeth.largest, f);
  set_tooth_values_and_sums(c, bit, PartQuantity::teeth_in_contact, teeth.contacts, f);
  set_tooth_values_and_sums(c, bit, PartQuantity::volume_per_revolution, teeth.volume, f);
}

}  // namespace tdbd::reference
