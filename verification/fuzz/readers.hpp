#pragma once

#include <string_view>

/// One function a reader: see FuzzTarget::take.
namespace tdbd::fuzz {

// Input files in TOML. They are read and checked, not run.
void take_case(std::string_view bytes);
void take_rotate_case(std::string_view bytes);
void take_calibration(std::string_view bytes);
void take_bit(std::string_view bytes);
/// The bytes are the words of --set, one a line.
void take_set_words(std::string_view bytes);

// Tables.
void take_cutter_table(std::string_view bytes);
void take_motion_table(std::string_view bytes);
void take_torque_table(std::string_view bytes);
void take_records(std::string_view bytes);

// Meshes.
void take_stl(std::string_view bytes);
/// Corrects the number of facets, so that a change of the length does not turn the file into text.
void take_binary_stl(std::string_view bytes);
void take_ply(std::string_view bytes);
void take_obj(std::string_view bytes);
void take_off(std::string_view bytes);

// Checkpoints.
void take_checkpoint(std::string_view bytes);
/// The bytes are the state in a checkpoint whose seal is right.
void take_archive(std::string_view bytes);

}  // namespace tdbd::fuzz
