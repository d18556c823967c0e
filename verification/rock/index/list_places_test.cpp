#include "rock/index/list_places.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "verification/battery/generators.hpp"

namespace tdbd::rock::list_places_test {

/// A list of random places, near an origin or flat along an axis.
NearList any_list(std::size_t places) {
  NearList list;
  make_room(list, places);
  const double flat = *rc::gen::element(0.0, 1e-3, 1.0);
  for (std::size_t i = 0; i < places; ++i) {
    const Vec3 x = *battery::point(0.3);
    list.x[i] = static_cast<Single>(x.x());
    list.y[i] = static_cast<Single>(flat * x.y());
    list.z[i] = static_cast<Single>(x.z() + 0.1);
    list.v[i] = static_cast<int>(i);
  }
  close(list, places);
  return list;
}

Vec3 place(const NearList& list, std::size_t i) { return {list.x[i], list.y[i], list.z[i]}; }

/// A ball about the middle of the box of each pack, through its farthest place.
RC_GTEST_PROP(Balls, hold_the_places_of_their_packs_and_no_more, ()) {
  constexpr double rounding = 2.3e-8;  // m, of single precision at half a metre
  const auto places = 8 * static_cast<std::size_t>(*battery::integer(1, 5));
  const NearList list = any_list(places);
  for (std::size_t pack = 0; pack < places / 8; ++pack) {
    mesh::Box box;
    for (std::size_t i = 8 * pack; i < 8 * pack + 8; ++i) box.add(place(list, i));
    const Vec3 middle(list.balls.x[pack], list.balls.y[pack], list.balls.z[pack]);
    RC_ASSERT((middle - 0.5 * (box.lo + box.hi)).norm() < rounding);
    double farthest = 0.0;
    for (std::size_t i = 8 * pack; i < 8 * pack + 8; ++i)
      farthest = std::max(farthest, (place(list, i) - middle).norm());
    RC_ASSERT(farthest <= list.balls.radius[pack]);
    RC_ASSERT(list.balls.radius[pack] < 1.0011 * farthest + rounding);
  }
}

}  // namespace tdbd::rock::list_places_test
