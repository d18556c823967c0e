#include "bit/cutter/cutter_table.hpp"
#include "calibration/record/record.hpp"
#include "core/error.hpp"
#include "fuzz/readers.hpp"
#include "fuzz/scratch_folder.hpp"
#include "simulation/case/motion.hpp"
#include "simulation/rotate/rotate_case.hpp"

namespace tdbd::fuzz {

void take_cutter_table(std::string_view bytes) {
  try {
    bit::read_cutter_table(scratch_file("fuzzed.csv", bytes), {});
  } catch (const InputError&) {  // refused
  }
}

void take_motion_table(std::string_view bytes) {
  try {
    simulation::read_path_table(scratch_file("fuzzed.csv", bytes));
  } catch (const InputError&) {  // refused
  }
}

void take_torque_table(std::string_view bytes) {
  try {
    simulation::read_torque_samples(scratch_file("fuzzed.csv", bytes), dynamics::TorqueFrame::body);
  } catch (const InputError&) {  // refused
  }
}

void take_records(std::string_view bytes) {
  try {
    calibration::read_records(scratch_file("fuzzed.csv", bytes));
  } catch (const InputError&) {  // refused
  }
}

}  // namespace tdbd::fuzz
