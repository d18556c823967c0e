#include "bit/cone/cone_shell.hpp"

#include <gtest/gtest.h>

#include "bit/cone_generate.hpp"
#include "mesh/check/check.hpp"
#include "mesh/measures.hpp"
#include "mesh/shape/convex.hpp"

namespace tdbd::bit::cone_shell_test {

/// A shell of one to six pitches that rises and falls at random.
ConeLayout any_shell() {
  ConeLayout c;
  c.segments = *rc::gen::inRange(8, 60);
  const int pitches = *rc::gen::inRange(1, 7);
  double s = number(-0.02, 0.02);
  for (int i = 0; i <= pitches; ++i) {
    c.shell.push_back({s, i == 0 && *rc::gen::arbitrary<bool>() ? 0.0 : number(0.005, 0.06)});
    s += number(0.002, 0.03);
  }
  return c;
}

RC_GTEST_PROP(ShellPieces, are_convex_and_fill_the_shell, ()) {
  const ConeLayout cone = any_shell();
  double sum = 0.0;
  for (const mesh::TriangleMesh& piece : shell_pieces(cone)) {
    RC_ASSERT(mesh::check_closed(piece).empty());
    RC_ASSERT(mesh::convex_solid(piece).has_value());
    sum += mesh::enclosed_volume(piece);
  }
  const double whole = mesh::enclosed_volume(shell_mesh(cone));
  RC_ASSERT(std::abs(sum - whole) < 1e-13 * whole);
}

}  // namespace tdbd::bit::cone_shell_test
