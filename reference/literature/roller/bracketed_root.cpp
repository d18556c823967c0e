#include "reference/literature/roller/bracketed_root.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "reference/dynamics/quiet_gsl.hpp"

namespace tdbd::reference {
namespace {

/// The function, and the number of its evaluations.
struct Counted {
  const std::function<double(double)>& f;
  int evaluations = 0;
};

double ask(double x, void* counted) {
  auto& c = *static_cast<Counted*>(counted);
  ++c.evaluations;
  return c.f(x);
}

struct BrentSolver {
  BrentSolver() = default;
  BrentSolver(const BrentSolver&) = delete;
  BrentSolver& operator=(const BrentSolver&) = delete;
  ~BrentSolver() { gsl_root_fsolver_free(solver); }
  gsl_root_fsolver* solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
};

void need_different_signs(Counted& counted, const RootSearch& search) {
  const double at_low = ask(search.low, &counted), at_high = ask(search.high, &counted);
  if (std::isfinite(at_low) && std::isfinite(at_high) && std::min(at_low, at_high) <= 0.0 &&
      std::max(at_low, at_high) >= 0.0)
    return;
  throw InputError(fmt::format(
      "{}: found no root, the balance is {:.6g} at {:.6g} and {:.6g} at {:.6g}, expected a bracket "
      "at whose ends it has different signs",
      search.what, at_low, search.low, at_high, search.high));
}

}  // namespace

BracketedRoot bracketed_root(const std::function<double(double)>& f, const RootSearch& search) {
  Counted counted{f};
  need_different_signs(counted, search);
  const QuietGsl quiet;
  const BrentSolver brent;
  gsl_function function{&ask, &counted};
  gsl_root_fsolver_set(brent.solver, &function, search.low, search.high);
  for (int i = 0; i < search.at_most; ++i) {
    if (gsl_root_fsolver_iterate(brent.solver) != GSL_SUCCESS) break;
    const double low = gsl_root_fsolver_x_lower(brent.solver);
    const double high = gsl_root_fsolver_x_upper(brent.solver);
    const double root = std::abs(gsl_root_fsolver_root(brent.solver));
    if (high - low <= search.relative * root) break;
  }
  return {gsl_root_fsolver_root(brent.solver), counted.evaluations};
}

}  // namespace tdbd::reference
