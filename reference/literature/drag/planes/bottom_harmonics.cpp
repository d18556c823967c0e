#include "reference/literature/drag/planes/bottom_harmonics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace tdbd::reference {
namespace {

struct Circle {
  std::vector<double> cosine, sine;
};

Circle circle(std::size_t samples) {
  Circle c;
  for (std::size_t k = 0; k < samples; ++k) {
    const double a = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(samples);
    c.cosine.push_back(std::cos(a));
    c.sine.push_back(std::sin(a));
  }
  return c;
}

}  // namespace

BottomHarmonics bottom_harmonics(const std::vector<double>& depth) {
  const std::size_t count = depth.size();
  const Circle c = circle(count);
  BottomHarmonics h;
  for (std::size_t n = 0; n <= count / 2; ++n) {
    double real = 0.0, imaginary = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      real += depth[k] * c.cosine[n * k % count];
      imaginary += depth[k] * c.sine[n * k % count];
    }
    // all others have a conjugate of equal magnitude
    const bool is_alone = n == 0 || 2 * n == count;
    h.amplitude.push_back((is_alone ? 1.0 : 2.0) * std::hypot(real, imaginary) /
                          static_cast<double>(count));
  }
  const auto [lo, hi] = std::minmax_element(depth.begin(), depth.end());
  h.peak_to_peak = *hi - *lo;
  return h;
}

std::vector<int> strongest(const BottomHarmonics& harmonics, int count) {
  std::vector<int> order(harmonics.amplitude.size() - 1);
  std::iota(order.begin(), order.end(), 1);
  std::stable_sort(order.begin(), order.end(), [&](int m, int n) {
    return harmonics.amplitude[at(m)] > harmonics.amplitude[at(n)];
  });
  order.resize(std::min(order.size(), at(count)));
  return order;
}

std::vector<double> depth_on_circle(const Spokes& rock, double r) {
  const double place = std::clamp(r / rock.node_spacing() - 0.5, 0.0, rock.nodes - 1.0);
  const int inner = std::min(static_cast<int>(place), std::max(0, rock.nodes - 2));
  const int outer = std::min(inner + 1, rock.nodes - 1);
  const double share = place - inner;
  std::vector<double> depth;
  for (int k = 0; k < rock.spokes; ++k) {
    const double a = rock.depth[at(k * rock.nodes + inner)];
    depth.push_back(a + share * (rock.depth[at(k * rock.nodes + outer)] - a));
  }
  return depth;
}

}  // namespace tdbd::reference
