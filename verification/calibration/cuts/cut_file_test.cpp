#include <gtest/gtest.h>
#include <netcdf.h>

#include <array>
#include <fstream>

#include "calibration/cuts/cut_store.hpp"
#include "calibration/made_up_laboratory.hpp"
#include "io/whole_file.hpp"
#include "verification/core/temporary_file.hpp"

namespace tdbd::calibration::cut_file_test {
namespace {

namespace fs = std::filesystem;

fs::path written(const CutRun& run) {
  const fs::path file = write_temporary(".nc", "");
  write_cut_run(file, run, std::vector<std::string>(64, "part"));
  return file;
}

void expect_same(const CutRun& a, const CutRun& b) {
  EXPECT_EQ(a.depth, b.depth);
  ASSERT_EQ(a.cuts.size(), b.cuts.size());
  for (std::size_t i = 0; i < a.cuts.size(); ++i) {
    const simulation::CutOfPart &x = a.cuts[i], &y = b.cuts[i];
    EXPECT_EQ(x.part, y.part);
    EXPECT_EQ(x.cut.kind, y.cut.kind);
    EXPECT_EQ(x.face_area, y.face_area);
    EXPECT_EQ(x.forward_W, y.forward_W);
    EXPECT_EQ(x.cut.contact_area, y.cut.contact_area);
    EXPECT_EQ(x.cut.engaged_edge, y.cut.engaged_edge);
    EXPECT_EQ(x.cut.removed_volume, y.cut.removed_volume);
    EXPECT_EQ(x.cut.diameter, y.cut.diameter);
    EXPECT_EQ(x.cut.point, y.cut.point);
    EXPECT_EQ(x.cut.normal, y.cut.normal);
  }
}

TEST(CutFile, is_read_back_bitwise_identical) {
  const CutRun run = made_up_run(made_up_bits()[2], 1.0 / 3.0e3);
  const auto read = read_cut_run(written(run));
  ASSERT_TRUE(read);
  expect_same(run, *read);
}

/// Complete and sealed, but written by another version: each variable is required.
TEST(CutFile, without_one_of_its_variables_is_none) {
  const CutRun run = made_up_run(made_up_bits()[0], 1e-3);
  int variables = 100;
  for (int v = 0; v < variables; ++v) {
    const fs::path file = written(run);
    int id = -1;
    ASSERT_EQ(nc_open(file.c_str(), NC_WRITE, &id), NC_NOERR);
    ASSERT_EQ(nc_inq_nvars(id, &variables), NC_NOERR);
    std::array<char, NC_MAX_NAME + 1> name{};
    ASSERT_EQ(nc_inq_varname(id, v, name.data()), NC_NOERR);
    ASSERT_EQ(nc_redef(id), NC_NOERR);
    ASSERT_EQ(nc_rename_var(id, v, "other"), NC_NOERR);
    ASSERT_EQ(nc_close(id), NC_NOERR);
    seal_file(file);
    const bool is_read = read_cut_run(file).has_value();
    EXPECT_EQ(is_read, std::string(name.data()) == "part_name") << name.data();  // for people
  }
}

TEST(CutFile, without_its_depth_or_its_parts_is_none) {
  for (const bool depth : {true, false}) {
    const fs::path file = written(made_up_run(made_up_bits()[0], 1e-3));
    int id = -1, part = -1;
    ASSERT_EQ(nc_open(file.c_str(), NC_WRITE, &id), NC_NOERR);
    ASSERT_EQ(nc_redef(id), NC_NOERR);
    ASSERT_EQ(nc_inq_dimid(id, "part", &part), NC_NOERR);
    ASSERT_EQ(depth ? nc_del_att(id, NC_GLOBAL, "depth_m") : nc_rename_dim(id, part, "piece"),
              NC_NOERR);
    ASSERT_EQ(nc_close(id), NC_NOERR);
    seal_file(file);
    EXPECT_FALSE(read_cut_run(file).has_value()) << depth;
  }
}

TEST(CutFile, rejects_a_missing_or_another_commit) {
  for (const bool other : {true, false}) {
    const fs::path file = written(made_up_run(made_up_bits()[0], 1e-3));
    int id = -1;
    ASSERT_EQ(nc_open(file.c_str(), NC_WRITE, &id), NC_NOERR);
    ASSERT_EQ(nc_redef(id), NC_NOERR);
    ASSERT_EQ(other ? nc_put_att_text(id, NC_GLOBAL, "commit", 5, "other")
                    : nc_del_att(id, NC_GLOBAL, "commit"),
              NC_NOERR);
    ASSERT_EQ(nc_close(id), NC_NOERR);
    seal_file(file);
    EXPECT_FALSE(read_cut_run(file).has_value()) << other;
  }
}

TEST(CutFile, that_is_torn_is_none) {
  const fs::path file = written(made_up_run(made_up_bits()[0], 1e-3));
  const auto whole = fs::file_size(file);
  for (const double share : {0.0, 0.1, 0.5, 0.9, 0.999}) {
    fs::resize_file(file, static_cast<std::uintmax_t>(share * static_cast<double>(whole)));
    EXPECT_FALSE(read_cut_run(file)) << share;
    write_cut_run(file, made_up_run(made_up_bits()[0], 1e-3), std::vector<std::string>(64, "part"));
  }
}

/// NetCDF never sees such a file: it trusts the numbers of a header.
TEST(CutFile, with_a_changed_byte_is_none) {
  const CutRun run = made_up_run(made_up_bits()[0], 1e-3);
  const auto whole = static_cast<std::streamoff>(fs::file_size(written(run)));
  for (const double place : {0.0, 0.01, 0.1, 0.3, 0.6, 0.9, 0.999}) {
    const fs::path file = written(run);
    std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
    bytes.seekg(static_cast<std::streamoff>(place * static_cast<double>(whole)));
    const int byte = bytes.peek();
    bytes.seekp(bytes.tellg());
    bytes.put(static_cast<char>(byte ^ 0x40));
    bytes.close();
    EXPECT_FALSE(read_cut_run(file)) << place;
  }
}

TEST(CutFile, that_is_not_there_is_none) {
  EXPECT_FALSE(read_cut_run(temporary_folder() + "absent.nc"));
}

TEST(CutFile, of_another_kind_is_none) {
  EXPECT_FALSE(read_cut_run(write_temporary(".nc", "a text, not a cut run\n")));
}

}  // namespace
}  // namespace tdbd::calibration::cut_file_test
