#include "reference/literature/drag/wear/glowka_cutter.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::reference {

double at_depth(const DepthLaw& law, double depth) {
  if (law.value == 0.0 || depth <= 0.0) return 0.0;
  return law.value * std::pow(depth / law.reference_depth, law.power);
}

double segment_area(double face_radius, double height) {
  const double a = face_radius, y = std::clamp(height, 0.0, 2.0 * a);
  return a * a * std::acos(1.0 - y / a) - (a - y) * std::sqrt(y * (2.0 * a - y));
}

double virgin_area(const GlowkaFace& face, double depth) {
  const double cosine = std::cos(face.back_rake);
  return segment_area(face.radius, depth / cosine) * cosine;
}

double effective_depth(const GlowkaFace& face, double area) {
  constexpr int halvings = 40;
  double low = 0.0, high = 2.0 * face.radius * std::cos(face.back_rake);
  if (area <= 0.0) return low;
  if (area >= virgin_area(face, high)) return high;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (virgin_area(face, middle) < area ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

GlowkaForces glowka_forces(const GlowkaLaw& law, double depth, double flat_area) {
  GlowkaForces f{.normal = at_depth(law.normal, depth), .drag = at_depth(law.drag, depth)};
  f.flat_normal = flat_area * at_depth(law.flat_stress, depth);
  f.flat_drag = law.flat_friction * f.flat_normal;
  return f;
}

}  // namespace tdbd::reference
