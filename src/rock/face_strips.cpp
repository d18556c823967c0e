#include "rock/face_strips.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace tdbd::rock {
namespace {

constexpr double ratio = 1.5;  ///< of speeds, across a strip

/// X . v on the face: affine in its plane.
struct ForwardSpeed {
  double at_origin;  ///< m/s
  Vec2 gradient;     ///< 1/s

  double operator()(const Vec2& x_F) const { return at_origin + gradient.dot(x_F); }
};

ForwardSpeed forward_speed(const FaceOutline& face, const Twist& twist) {
  const Vec3 n_B = face.X_BF.R.col(0),
             turning_F = face.X_BF.R.transpose() * n_B.cross(twist.angular_B);
  return {n_B.dot(velocity_B(twist, face.X_BF.p)), turning_F.tail<2>()};
}

/// Where the speed lies between two values.
struct Speeds {
  HalfPlane above, below;
};

Speeds between(const ForwardSpeed& v, double lo, double hi) {
  return {{-v.gradient, v.at_origin - lo}, {v.gradient, hi - v.at_origin}};
}

/// Cuts an edge down to a half-plane; false if nothing is left.
bool clip_edge(RimEdge& e, const HalfPlane& h) {
  const double out_p = h.n.dot(e.from) - h.b, out_q = h.n.dot(e.to) - h.b;
  if (out_p >= 0.0 && out_q >= 0.0 && out_p + out_q > 0.0) return false;
  const Vec2 middle = e.from + out_p / (out_p - out_q) * (e.to - e.from);
  if (out_p > 0.0) e.from = middle;
  if (out_q > 0.0) e.to = middle;
  return true;
}

FaceStrip strip_of(const FaceOutline& face, const Speeds& speeds, double ahead) {
  constexpr double far = std::numeric_limits<double>::max();
  FaceStrip strip{{}, Vec2::Constant(far), Vec2::Constant(-far), {}, ahead};
  ConvexPolygon slower;
  clip(face.rim_F, speeds.below, slower);
  clip(slower, speeds.above, strip.outline_F);
  for (const Vec2& x_F : strip.outline_F) {
    strip.lo_F = strip.lo_F.cwiseMin(x_F);
    strip.hi_F = strip.hi_F.cwiseMax(x_F);
  }
  for (std::size_t i = 0; i < face.rim_F.size(); ++i) {
    RimEdge e{face.rim_F[i], face.rim_F[i + 1 < face.rim_F.size() ? i + 1 : 0]};
    if (clip_edge(e, speeds.below) && clip_edge(e, speeds.above)) strip.rim_F.push_back(e);
  }
  return strip;
}

}  // namespace

std::vector<FaceStrip> face_strips(const FaceOutline& face, const Twist& twist, double lead,
                                   double largest_turn) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const ForwardSpeed v = forward_speed(face, twist);
  double slowest = infinite, fastest = 0.0;
  for (const Vec2& x_F : face.rim_F) {
    slowest = std::min(slowest, v(x_F));
    fastest = std::max(fastest, v(x_F));
  }
  const double turning = twist.angular_B.norm();
  const double longest = turning > 0.0 ? largest_turn / turning : infinite;
  std::vector<FaceStrip> strips;
  for (double hi = fastest, above = infinite; hi > 0.0; hi /= ratio) {
    const double lo = std::max(hi / ratio, slowest);
    const bool last = lo == slowest || lead > lo * longest;
    const double bound = !last ? lo : slowest > 0.0 ? -infinite : 0.0;
    strips.push_back(strip_of(face, between(v, bound, above), std::min(lead / lo, longest)));
    if (last) break;
    above = lo;
  }
  return strips;
}

}  // namespace tdbd::rock
