#include "rock/cut/swept_whole.hpp"

namespace tdbd::rock {
namespace {

Vec3 place_on_strip(const RelativePath& p, double tau, double t) {
  return p.q0_P + tau * (p.q1_P - p.q0_P) + t * (p.u0_P + tau * (p.u1_P - p.u0_P));
}

}  // namespace

std::optional<WholeExit> whole_exit(const CuttingWhole& whole, const RelativePath& path,
                                    const Crossing& x) {
  if (x.t <= 0.0) return std::nullopt;
  const int owner = owner_at(whole.claims, x.plane, place_on_strip(path, x.tau, x.t));
  return WholeExit{at(owner), x.t};
}

std::optional<WholeExit> prepared_whole_exit(const CuttingWhole& whole, const RelativePath& path,
                                             const SweptScratch& scratch) {
  const auto x = prepared_exit(whole.solid, path, scratch);
  return x ? whole_exit(whole, path, *x) : std::nullopt;
}

}  // namespace tdbd::rock
