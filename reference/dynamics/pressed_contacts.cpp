#include "reference/dynamics/pressed_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace tdbd::reference {

Eigen::VectorXd pressed_velocity(const Eigen::VectorXd& free, const Eigen::MatrixXd& A,
                                 const std::vector<PressedSurface>& surfaces) {
  constexpr long most_rounds = 1'000'000;
  constexpr double unchanged = 1e-13;
  std::vector<double> p(surfaces.size(), 0.0);
  std::vector<Vec3> t(surfaces.size(), Vec3::Zero());
  double largest = 0.0;
  for (const PressedSurface& s : surfaces) largest = std::max(largest, s.limit);
  Eigen::VectorXd u = free;
  for (long round = 0; round < most_rounds; ++round) {
    double change = 0.0;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      const PressedSurface& s = surfaces[i];
      const Mat3 gives_way = s.J * A * s.J.transpose();
      const Vec3 v = s.J * u;
      const double into = v.dot(s.normal);
      const Vec3 slip = v - into * s.normal;
      const double soft = s.limit > 0.0 ? s.ramp * slip.norm() / s.limit : 0.0;
      const double step = 1.0 / (gives_way.trace() + soft);
      const double p_next =
          std::clamp(p[i] + step * (into - s.free_speed - soft * p[i]), 0.0, s.limit);
      Vec3 t_next = t[i] + slip / gives_way.trace();
      if (t_next.norm() > s.mu * p_next) t_next *= s.mu * p_next / t_next.norm();
      const Vec3 more = (p[i] - p_next) * s.normal + t[i] - t_next;
      u += A * (s.J.transpose() * more);
      p[i] = p_next;
      t[i] = t_next;
      change = std::max(change, more.norm());
    }
    if (change <= unchanged * largest) return u;
  }
  throw RunError("the forces of the pressed surfaces do not converge");
}

}  // namespace tdbd::reference
