#include <array>
#include <cmath>

#include "claims/example_bits.hpp"
#include "core/types.hpp"
#include "reference/literature/roller/wheel/briggs_bit.hpp"

/// Chapter 2, on Briggs: a sprocket that rolls over a plastic rock.
namespace tdbd::claims::wheel_torque_test {

namespace ref = reference;

const std::string claim = "chapter2/wheel-torque";
const ref::CoulombRock shale{24.82e6, 23.8 * degree};

/// The slope of least squares of ln(drag/load) over ln(penetration).
double observed_power(const ref::Sprocket& wheel) {
  constexpr std::array penetrations{0.25e-3, 0.5e-3, 1e-3, 2e-3, 4e-3};
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  ref::Rolling r;
  for (const double delta : penetrations) {
    ref::roll(wheel, 1.0, delta, wheel.radius, {.distance = 0.02}, r);
    const double x = std::log(delta), y = std::log(r.drag / r.load);
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double n = penetrations.size();
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

TEST(WheelTorque, grows_as_the_root_of_the_penetration) {
  record_near(
      claim,
      "smooth wheel of 60 mm, penetrations of 0.25 to 4 mm: power of the penetration in drag "
      "over load",
      observed_power(ref::smooth_wheel(60e-3, 720, 10e-3)), 0.5, 0.02);
}

TEST(WheelTorque, does_the_work_of_the_craters) {
  const ref::BriggsBit bit{{60e-3, 12, 30.0 * degree, 10e-3}, 3, 70e-3};
  const double speed = 3.0 * pi;  // rad/s
  const ref::BriggsDrilling d = ref::briggs_at_penetration(bit, shale, 2e-3, speed);
  const double crushed = ref::wedge_pressure(shale, bit.wheel.half_angle) * bit.wheel.width * 2.0 *
                         pi * bit.track_radius * d.rate;  // W
  const std::string of = "three sprockets of 12 teeth, 60 mm, 2 mm deep in shale: ";
  record_near(claim, of + "power of the torque over pressure times volume rate",
              d.torque * speed / crushed, 1.0, 0.007);
  record_near(claim, of + "drag over load, beside 0.129 of a smooth wheel",
              d.wheel.drag / d.wheel.load, 0.0985, 1e-3);
}

}  // namespace tdbd::claims::wheel_torque_test
