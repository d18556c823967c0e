#include "rock/cut/swept_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tdbd::rock {
namespace {

/// Slack for rounding at a facet's rim and at the strip's sides. A crossing that is found twice
/// does no harm; a crossing lost between two facets would.
constexpr double rim_slack = 1e-11;

struct Roots {
  std::array<double, 2> x{};
  int count = 0;
};

/// Roots of a x^2 + b x + c, computed without cancellation.
Roots quadratic_roots(double a, double b, double c) {
  const double discriminant = b * b - 4.0 * a * c;
  if (discriminant < 0.0) return {};
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  Roots roots;
  if (a != 0.0) roots.x[0] = q / a, roots.count = 1;
  if (q != 0.0) roots.x[at(roots.count++)] = c / q;
  return roots;
}

/// Length of the shortest vector between u and u + du.
double shortest(const Vec3& u, const Vec3& du) {
  const double length2 = du.squaredNorm();
  const double tau = length2 > 0.0 ? std::clamp(-u.dot(du) / length2, 0.0, 1.0) : 0.0;
  return (u + tau * du).norm();
}

}  // namespace

Strip::Strip(const RelativePath& p, const mesh::Box& box)
    : q_(p.q0_P), dq_(p.q1_P - p.q0_P), u_(p.u0_P), du_(p.u1_P - p.u0_P) {
  const Vec3 centre = 0.5 * (box.lo + box.hi);
  const double reach =
      0.5 * box.size().norm() + std::max((p.q0_P - centre).norm(), (p.q1_P - centre).norm());
  t_max_ = 1.001 * reach / shortest(u_, du_);
  middle_ = at(0.5, 0.0);
  inverse_ = (u_ + 0.5 * du_).cwiseInverse();
  half_width_ = 0.5 * (dq_.cwiseAbs() + t_max_ * du_.cwiseAbs());
}

Strip Strip::up_to(double t) const {
  Strip shorter = *this;
  shorter.t_max_ = std::min(t, t_max_);
  shorter.half_width_ = 0.5 * (dq_.cwiseAbs() + shorter.t_max_ * du_.cwiseAbs());
  return shorter;
}

bool Strip::meets(const mesh::Box& box) const {
  double enter = 0.0, leave = t_max_;
  for (int i = 0; i < 3; ++i) {
    const double slack = half_width_[i] + 1e-12 * (std::abs(box.lo[i]) + std::abs(box.hi[i]));
    const double lo = box.lo[i] - slack - middle_[i], hi = box.hi[i] + slack - middle_[i];
    if (std::isinf(inverse_[i])) {
      if (lo > 0.0 || hi < 0.0) return false;
      continue;
    }
    enter = std::max(enter, std::min(lo * inverse_[i], hi * inverse_[i]));
    leave = std::min(leave, std::max(lo * inverse_[i], hi * inverse_[i]));
  }
  return enter <= leave;
}

void Strip::add_side(const mesh::Facet& f, double tau, std::vector<double>& ends) const {
  const auto hit = mesh::meet(f, q_ + tau * dq_, u_ + tau * du_);
  if (hit && hit->margin >= -rim_slack) ends.push_back(hit->s);
}

/// a + s e = q(tau) + t u(tau): without s and t, (u(tau) x e) . (a - q(tau)) = 0.
void Strip::add_edge(const Vec3& a, const Vec3& b, std::vector<double>& ends) const {
  const Vec3 e = b - a, r = a - q_, u_x_e = u_.cross(e), du_x_e = du_.cross(e);
  const Roots roots =
      quadratic_roots(-du_x_e.dot(dq_), du_x_e.dot(r) - u_x_e.dot(dq_), u_x_e.dot(r));
  for (std::size_t k = 0; k < static_cast<std::size_t>(roots.count); ++k) {
    if (!(roots.x[k] >= -rim_slack && roots.x[k] <= 1.0 + rim_slack)) continue;
    const double tau = std::clamp(roots.x[k], 0.0, 1.0);
    const Vec3 u = u_ + tau * du_, n = u_x_e + tau * du_x_e, to_a = r - tau * dq_;
    const double n2 = n.squaredNorm();
    if (n2 == 0.0) continue;
    const double s = to_a.cross(u).dot(n) / n2;
    if (s >= -rim_slack && s <= 1.0 + rim_slack) ends.push_back(to_a.cross(e).dot(n) / n2);
  }
}

bool Strip::level_meets(const mesh::Facet& f, double t) const {
  const auto hit = mesh::meet(f, at(0.0, t), dq_ + t * du_);
  return hit && hit->margin >= -rim_slack && hit->s >= -rim_slack && hit->s <= 1.0 + rim_slack;
}

void Strip::levels_that_meet(const mesh::Facet& f, double same, std::vector<double>& ends,
                             std::vector<Levels>& intervals) const {
  ends.clear();
  add_side(f, 0.0, ends);
  add_side(f, 1.0, ends);
  add_edge(f.a, f.b, ends);
  add_edge(f.b, f.c, ends);
  add_edge(f.c, f.a, ends);
  if (ends.empty()) return;
  std::sort(ends.begin(), ends.end());
  ends.erase(
      std::unique(ends.begin(), ends.end(), [same](double s, double t) { return t - s <= same; }),
      ends.end());
  if (ends.size() <= 2) {
    intervals.push_back({ends.front(), ends.back()});
    return;
  }
  for (std::size_t k = 1; k < ends.size(); ++k)
    if (level_meets(f, 0.5 * (ends[k - 1] + ends[k]))) intervals.push_back({ends[k - 1], ends[k]});
}

namespace {

mesh::Box box_of(const RelativePath& p) {
  mesh::Box box;
  box.add(p.q0_P);
  box.add(p.q1_P);
  return box;
}

/// Sorted: 0, the tau in (0, 1) at which the path crosses facets, and 1.
void find_crossings(const mesh::TriangleTree& solid, const RelativePath& p,
                    std::vector<double>& taus) {
  const mesh::Box reach = box_of(p);
  const Vec3 d = p.q1_P - p.q0_P;
  taus.assign({0.0, 1.0});
  solid.visit([&](const mesh::Box& box) { return box.overlaps(reach); },
              [&](const mesh::Facet& f) {
                constexpr double rim = 1e-11;  // a crossing that is found twice does no harm
                const auto hit = mesh::meet(f, p.q0_P, d);
                if (hit && hit->margin >= -rim && hit->s > 0.0 && hit->s < 1.0)
                  taus.push_back(hit->s);
                return true;
              });
  std::sort(taus.begin(), taus.end());
}

bool is_deep(const mesh::TriangleTree& solid, const Vec3& x, double depth) {
  return !mesh::is_near(solid, x, depth) && mesh::inside(solid, x);
}

void find_levels(const mesh::TriangleTree& solid, const Strip& strip, double same, MeshScratch& w) {
  w.intervals.clear();
  solid.visit([&](const mesh::Box& box) { return strip.meets(box); },
              [&](const mesh::Facet& f) {
                strip.levels_that_meet(f, same, w.ends, w.intervals);
                return true;
              });
  std::ranges::sort(w.intervals, [](const Levels& a, const Levels& b) {
    return a.lo < b.lo || (a.lo == b.lo && a.hi < b.hi);
  });
}

/// The end of the connected set of sorted levels from t = 0 on.
double end_of_levels(const mesh::TriangleTree& solid, const Strip& strip, double depth,
                     const std::vector<Levels>& intervals) {
  double end = 0.0;
  for (const Levels& i : intervals) {
    if (i.hi < end) continue;
    const bool is_gap = i.lo > end + depth;
    if (is_gap && !mesh::inside(solid, strip.at(0.5, 0.5 * (end + i.lo)))) break;
    end = i.hi;
  }
  return end;
}

}  // namespace

bool is_swept(const mesh::TriangleTree& solid, const RelativePath& path, double depth,
              MeshScratch& scratch) {
  if (!solid.box().overlaps(box_of(path))) return false;
  const Vec3 d = path.q1_P - path.q0_P;
  std::vector<double>& taus = scratch.ends;
  find_crossings(solid, path, taus);
  for (std::size_t k = 1; k < taus.size(); ++k)
    if (is_deep(solid, path.q0_P + 0.5 * (taus[k - 1] + taus[k]) * d, depth)) return true;
  return taus.size() > 2 && is_deep(solid, path.q1_P, depth);
}

std::optional<double> exit_distance(const mesh::TriangleTree& solid, const RelativePath& path,
                                    double depth, MeshScratch& scratch) {
  if (!is_swept(solid, path, depth, scratch)) return std::nullopt;
  const Strip strip(path, solid.box());
  find_levels(solid, strip, depth, scratch);
  return end_of_levels(solid, strip, depth, scratch.intervals);
}

}  // namespace tdbd::rock
