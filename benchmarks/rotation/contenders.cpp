#include "benchmarks/rotation/method.hpp"

namespace tdbd::bench {

std::vector<Contender> all_contenders() { return {tdbd(), gsl(), simbody(), mujoco()}; }

Mat3 cone_inertia(const dynamics::Cone& cone) {
  // The transverse inertia of the flattest possible cone is half its axial inertia. A slightly
  // larger value avoids rounding errors.
  constexpr double across = 0.55;
  const Mat3 along = cone.axis_B * cone.axis_B.transpose();
  return cone.axial_inertia * (along + across * (Mat3::Identity() - along));
}

Mat3 inertia_without_cones(const dynamics::Gyrostat& g) {
  Mat3 I = g.inertia_B;
  for (const dynamics::Cone& cone : g.cones) I -= cone_inertia(cone);
  return I;
}

#ifndef TDBD_HAS_GSL
Contender gsl() { return {"GSL", "libgsl-dev is not installed", {}}; }
#endif

#ifndef TDBD_HAS_SIMBODY
Contender simbody() { return {"Simbody", "libsimbody-dev is not installed", {}}; }
#endif

#ifndef TDBD_HAS_MUJOCO
Contender mujoco() { return {"MuJoCo", "libmujoco-dev is not installed", {}}; }
#endif

}  // namespace tdbd::bench
