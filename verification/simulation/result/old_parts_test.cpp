#include "simulation/result/old_parts.hpp"

#include <gtest/gtest.h>

#include <set>

#include "bit/files/bit_export.hpp"
#include "bit/files/bit_file.hpp"
#include "simulation/mesh_bit.hpp"
#include "simulation/result/output_folder.hpp"

namespace tdbd::simulation::old_parts_test {

namespace fs = std::filesystem;

/// Files below a folder, by their names from there.
std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (!entry.is_directory()) names.insert(fs::relative(entry.path(), folder).string());
  return names;
}

/// A bit as `tdbd bit` exports it.
void export_to(const fs::path& folder, const std::string& bit_file, const std::string& format) {
  const bit::Bit bit =
      bit::read_bit(bit_file, bit::DirectionRule::hybrid, bit::InsideRule::down).bit;
  bit::export_bit(folder, bit, format);
  bit::export_solids(folder, bit, "stl");
}

/// What is left in parts/ once the folder is prepared for another bit.
std::set<std::string> left_of(const std::string& bit_file, const std::string& format) {
  const fs::path folder = test_folder();
  export_to(folder, bit_file, format);
  EXPECT_EQ(exported_parts(folder).size(), files_in(folder / "parts").size());
  write_file(folder / "parts" / ("mine." + format), "mine");
  fs::create_directories(folder / "parts" / "cutter-1");
  write_file(folder / "parts" / "cutter-1" / "notes.txt", "mine");
  prepare(folder, Overwrite::force, {}, ResultKind::bit);
  return files_in(folder / "parts");
}

using Names = std::set<std::string>;

TEST(OldParts, of_a_pdc_bit_go_and_nothing_else) {
  for (const std::string format : {"ply", "stl"})
    EXPECT_EQ(left_of(TDBD_SOURCE_DIR "/cases/bits/standard.toml", format),
              (Names{"mine." + format, "cutter-1/notes.txt"}));
}

TEST(OldParts, of_a_roller_cone_bit_go_and_nothing_else) {
  EXPECT_EQ(left_of(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml", "off"),
            (Names{"mine.off", "cutter-1/notes.txt"}));
}

/// In the format in which a user keeps one part of several, it is his.
TEST(OldParts, of_a_roller_cone_bit_are_those_of_whole_formats) {
  const fs::path folder = test_folder();
  export_to(folder, TDBD_SOURCE_DIR "/cases/bits/bit-r.toml", "ply");
  write_file(folder / "parts" / "cone-1" / "body.stl", "mine");
  prepare(folder, Overwrite::force, {}, ResultKind::bit);
  EXPECT_EQ(files_in(folder / "parts"), Names{"cone-1/body.stl"});
}

TEST(OldParts, leave_no_empty_folders) {
  const fs::path folder = test_folder();
  export_to(folder, TDBD_SOURCE_DIR "/cases/bits/standard.toml", "ply");
  prepare(folder, Overwrite::force, {}, ResultKind::bit);
  EXPECT_FALSE(fs::exists(folder / "parts"));
}

/// A bit.toml that names files elsewhere removes none of them.
TEST(OldParts, are_below_parts_only) {
  const fs::path folder = test_folder();
  const std::string own = write_file(folder / "own.ply", "mine");
  fs::create_directories(folder / "out");
  for (const std::string& file :
       {std::string("../own.ply"), std::string("parts/../../own.ply"), own}) {
    write_file(
        folder / "out" / "bit.toml",
        "# A bit as the meshes of its parts.\nname = \"a\"\n[[parts]]\nname = \"p\"\nfile = \"" +
            file + "\"\n");
    prepare(folder / "out", Overwrite::force, {}, ResultKind::bit);
    EXPECT_TRUE(fs::exists(own)) << file;
  }
}

}  // namespace tdbd::simulation::old_parts_test
