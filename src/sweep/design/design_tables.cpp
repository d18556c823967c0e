#include "sweep/design/design_tables.hpp"

#include "sweep/design/design_keys.hpp"

namespace tdbd::sweep {
namespace {

KeyTable sweep_table() {
  using namespace sweep_keys;
  return key_table(
      "sweep", table,
      rows(case_file, command, figures, sampling, samples, seed, penetration, normal_ratio));
}

KeyTable factor_table() {
  using namespace factor_keys;
  return key_table("sweep", table, rows(key, values, from, to, count, scale));
}

}  // namespace

std::vector<KeyTable> design_tables() {
  return {key_table("sweep", top_keys::table, rows(top_keys::title)),
          sweep_table(),
          key_table("sweep", set_keys::table, rows(set_keys::any)),
          factor_table(),
          key_table("sweep", goal_keys::table, rows(goal_keys::figure, goal_keys::better)),
          key_table("sweep", filter_keys::table,
                    rows(filter_keys::figure, goal_keys::better, filter_keys::keep))};
}

}  // namespace tdbd::sweep
