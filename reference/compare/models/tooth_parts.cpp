#include "reference/compare/models/tooth_parts.hpp"

#include <fmt/format.h>

namespace tdbd::reference {

std::string tooth_name(const std::string& cone, std::size_t row, std::size_t tooth) {
  return fmt::format("{}/tooth-{}", row_name(cone, row), tooth + 1);
}

std::vector<double> over(std::vector<double> teeth, double count) {
  for (double& x : teeth) x /= count;
  return teeth;
}

void say_rows(const CompareCase& c, const RollerBit& bit, PartQuantity q,
              const std::vector<double>& teeth, Findings& f) {
  std::size_t next = 0;
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    for (std::size_t r = 0; r < bit.cones[k].rows.size(); ++r) {
      const RollerRow& row = bit.cones[k].rows[r];
      double sum = 0.0;
      for (std::size_t i = 0; i < row.angles.size(); ++i) sum += teeth[next++];
      f.parts.push_back(
          {row_name(c.ours.bit.cones[k].name, r), ring_radius(bit.cones[k], row), q, sum});
    }
}

void say_teeth(const CompareCase& c, const RollerBit& bit, PartQuantity q,
               const std::vector<double>& teeth, Findings& f) {
  std::size_t next = 0;
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    for (std::size_t r = 0; r < bit.cones[k].rows.size(); ++r) {
      const RollerRow& row = bit.cones[k].rows[r];
      for (std::size_t i = 0; i < row.angles.size(); ++i)
        f.parts.push_back({tooth_name(c.ours.bit.cones[k].name, r, i),
                           ring_radius(bit.cones[k], row), q, teeth[next++]});
    }
}

}  // namespace tdbd::reference
