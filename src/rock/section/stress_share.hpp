#pragma once

#include "rock/section/contact_end.hpp"

namespace tdbd::rock {

/// The share of the full stress at x_P, where the part's outward normal is n_P: ContactPatch. A part
/// that stands has all of it.
double stress_share(const PressingPart& part, const Vec3& x_P, const Vec3& n_P);

/// Outward normal of the part's surface nearest to x_P; of several that are equally near the one that
/// moves most into the rock.
Vec3 nearest_normal(const PressingPart& part, const Vec3& x_P);

}  // namespace tdbd::rock
