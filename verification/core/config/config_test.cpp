#include "core/config/config.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>

#include "core/error.hpp"
#include "core/temporary_file.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::config_test {

enum class Motion { axial, whirl };
const std::vector<std::pair<std::string, Motion>> motions{{"axial", Motion::axial},
                                                          {"whirl", Motion::whirl}};

constexpr const char* sample = R"(name = "a \"quoted\" name"
table = "cutters.csv"
steps = 12
[motion]
kind = "whirl"
rpm = "120 rpm"
verbose = "on"
offset = ["1 mm", 0.002, "3 mm"]
[[layers]]
depth = "1 m"
strength = "30 MPa"
[[layers]]
[[layers]]
depth = 3
[layers.grading]
top = 0.1
)";

struct Layer {
  double depth, strength, top;
  bool operator==(const Layer&) const = default;
};

struct Sample {
  std::string name, table, log;
  long steps = 0;
  Motion kind = Motion::axial;
  double rpm = 0.0, bound = 0.0;
  bool verbose = false, fast = true;
  Vec3 offset = Vec3::Zero();
  std::vector<Layer> layers;
  bool operator==(const Sample&) const = default;
};

Sample read_sample(Config& config) {
  Sample s;
  s.name = config.text("name", {});
  s.table = config.path("table", {});
  s.log = config.path("log", "");
  s.steps = config.integer("steps", {}, 1, 100);
  s.bound = config.quantity("bound", "m", std::numeric_limits<double>::infinity());
  Config motion = config.table("motion");
  s.kind = motion.choice<Motion>("kind", motions, {});
  s.rpm = motion.quantity("rpm", "rad/s", {}, Range::positive());
  s.verbose = motion.flag("verbose", {});
  s.fast = config.flag("motion.fast", false);
  s.offset = motion.vector("offset", "m", {});
  for (Config layer : config.tables("layers"))
    s.layers.push_back({layer.quantity("depth", "m", 2.0), layer.quantity("strength", "Pa", 0.1),
                        layer.quantity("grading.top", "1", 0.5, Range::within(0, 1))});
  return s;
}

TEST(Config, reads_every_kind_of_value) {
  const std::string csv = tdbd::temporary_folder() + "cutters.csv";
  std::ofstream(csv) << "x\n";
  Config config = Config::read_file(write_temporary(".toml", sample), {});
  const Sample s = read_sample(config);
  config.finish();
  EXPECT_EQ(s.name, "a \"quoted\" name");
  EXPECT_TRUE(std::filesystem::equivalent(s.table, csv));
  EXPECT_TRUE(std::filesystem::path(s.table).is_absolute());
  EXPECT_EQ(s.log, "");
  EXPECT_EQ(s.steps, 12);
  EXPECT_EQ(s.kind, Motion::whirl);
  EXPECT_NEAR(s.rpm, 12.566370614359172, 1e-14);
  EXPECT_TRUE(s.verbose);
  EXPECT_FALSE(s.fast);
  EXPECT_EQ(s.offset, Vec3(0.001, 0.002, 0.003));
  const std::vector<Layer> layers{{1, 30e6, 0.5}, {2, 0.1, 0.5}, {3, 0.1, 0.1}};
  EXPECT_EQ(s.layers, layers);
}

TEST(Config, the_resolved_file_reads_the_same_and_resolves_to_itself) {
  std::ofstream(tdbd::temporary_folder() + "cutters.csv") << "x\n";
  Config config = Config::read_file(write_temporary(".toml", sample), {"motion.rpm=7 rpm"});
  const Sample first = read_sample(config);
  std::filesystem::create_directories(tdbd::temporary_folder() + "elsewhere");
  const std::string copy = tdbd::temporary_folder() + "elsewhere/resolved.toml";
  std::ofstream(copy) << config.resolved();
  Config again = Config::read_file(copy, {});
  EXPECT_EQ(read_sample(again), first) << config.resolved();
  EXPECT_NO_THROW(again.finish());
  EXPECT_EQ(again.resolved(), config.resolved());
}

TEST(Config, the_resolved_file_names_units_and_defaults) {
  Config config = Config::read_file(write_temporary(".toml", "d = \"0.1 m\"\n"), {});
  config.quantity("d", "m", {});
  config.quantity("hole.depth", "m", 0.5);
  EXPECT_EQ(config.resolved(), "d = 0.1  # m\n\n[hole]\ndepth = 0.5  # m\n");
}

/// It stays a default, as a remark explains.
TEST(Config, the_resolved_file_has_no_value_that_is_not_finite) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Config config = Config::read_text("", "made-up.toml");
  Mat3 m = Mat3::Identity();
  m(2, 1) = inf;
  config.matrix("m", "1", m);
  config.quantity("q", "1", inf);
  config.list("l", "1", std::vector{1.0, inf});
  config.pairs("p", "1", std::vector<std::pair<double, double>>{{1.0, 2.0}, {inf, 3.0}});
  config.vector("v", "1", Vec3(1.0, inf, 2.0));
  config.integer("n", 3, 0, 9);
  EXPECT_EQ(config.resolved(),
            "# l: no limit\n# m: no limit\nn = 3\n# p: no limit\n# q: no limit\n# v: no limit\n");
}

TEST(Config, overrides_replace_values_and_make_tables) {
  const std::vector<std::string> overrides{"d=2 in", "new.sub.flag=true", "list[1].x=5", "s=a b",
                                           "n=1\nm=2"};
  const std::string toml = "d = \"1 in\"\n[[list]]\nx = 1\n[[list]]\nx = 2\n";
  Config config = Config::read_file(write_temporary(".toml", toml), overrides);
  EXPECT_DOUBLE_EQ(config.quantity("d", "m", {}), 0.0508);
  EXPECT_TRUE(config.flag("new.sub.flag", {}));
  EXPECT_EQ(config.tables("list")[1].quantity("x", "1", {}), 5.0);
  EXPECT_EQ(config.tables("list")[0].quantity("x", "1", {}), 1.0);
  EXPECT_EQ(config.text("s", {}), "a b");
  EXPECT_EQ(config.text("n", {}), "1\nm=2");
  EXPECT_FALSE(config.has("m"));
  EXPECT_NO_THROW(config.finish());
}

TEST(Config, reads_a_matrix_row_by_row) {
  const std::string toml = "I = [[1, 2, \"30 kg cm2\"], [4, 5, 6], [7, 8, 9]]\n";
  Config config = Config::read_file(write_temporary(".toml", toml), {});
  const Mat3 m = config.matrix("I", "kg m2", {});
  EXPECT_EQ(m.row(0), Eigen::RowVector3d(1, 2, 0.003));
  EXPECT_EQ(m.row(2), Eigen::RowVector3d(7, 8, 9));
  EXPECT_EQ(config.matrix("J", "1", Mat3(Mat3::Identity())), Mat3(Mat3::Identity()));
  EXPECT_EQ(config.resolved(),
            "I = [[1, 2, 0.003], [4, 5, 6], [7, 8, 9]]  # kg m2\n"
            "J = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]  # 1\n");
}

TEST(Config, reads_lists_and_pairs_of_any_length) {
  const std::string toml =
      "l = [\"1 mm\", 2, 0.5]\nnone = []\np = [[\"1 mm\", \"2 mm\"], [3, 4]]\n";
  Config config = Config::read_file(write_temporary(".toml", toml), {});
  using Pairs = std::vector<std::pair<double, double>>;
  EXPECT_EQ(config.list("l", "m", {}), (std::vector<double>{0.001, 2.0, 0.5}));
  EXPECT_TRUE(config.list("none", "m", {}).empty());
  EXPECT_EQ(config.list("other", "1", std::vector<double>{7.0}), std::vector<double>{7.0});
  EXPECT_EQ(config.pairs("p", "m", {}), (Pairs{{0.001, 0.002}, {3.0, 4.0}}));
  EXPECT_EQ(config.pairs("q", "1", Pairs{{1.0, 2.0}}), (Pairs{{1.0, 2.0}}));
  EXPECT_NO_THROW(config.finish());
  EXPECT_EQ(config.resolved(),
            "l = [0.001, 2, 0.5]  # m\nnone = []  # m\nother = [7]  # 1\n"
            "p = [[0.001, 0.002], [3, 4]]  # m\nq = [[1, 2]]  # 1\n");
}

TEST(Config, distinguishes_texts_from_other_values) {
  Config config =
      Config::read_file(write_temporary(".toml", "t = \"a\"\nn = 1\nl = [\"a\"]\n"), {});
  EXPECT_TRUE(config.is_text("t"));
  for (const char* key : {"n", "l", "missing"}) EXPECT_FALSE(config.is_text(key)) << key;
  EXPECT_ANY_THROW(config.finish());  // it does not count as reading
}

TEST(Config, lists_the_quantities_that_were_read) {
  const std::string toml = "a = \"2 mm\"\nn = 3\n[[t]]\nb = 4\n";
  Config config = Config::read_file(write_temporary(".toml", toml), {});
  config.quantity("a", "m", {});
  config.quantity("bound", "m", std::numeric_limits<double>::infinity());
  config.integer("n", {}, 0, 9);
  config.tables("t")[0].quantity("b", "1", {});
  config.vector("v", "m", Vec3(Vec3::Zero()));
  EXPECT_EQ(config.quantities(), (std::map<std::string, double>{{"a", 0.002}, {"t[0].b", 4.0}}));
}

TEST(Config, counts_the_mistakes_so_far) {
  Config config = Config::read_file(write_temporary(".toml", "a = 1\n"), {});
  EXPECT_EQ(config.problem_count(), 0u);
  config.matrix("a", "m", {});
  EXPECT_EQ(config.problem_count(), 1u);
  config.other_file("x.csv: wrong");
  EXPECT_EQ(config.problem_count(), 2u);
}

TEST(Config, has_looks_without_reading) {
  Config config = Config::read_file(write_temporary(".toml", "[a]\nb = 1\n"), {});
  EXPECT_TRUE(config.has("a"));
  EXPECT_TRUE(config.has("a.b"));
  EXPECT_FALSE(config.has("a.c"));
  EXPECT_FALSE(config.has("a.b.c"));
  EXPECT_THROW(config.finish(), InputError);
}

RC_GTEST_PROP(Config, every_double_survives_the_resolved_file, (double x)) {
  RC_PRE(std::isfinite(x));
  const std::string path = tdbd::temporary_folder() + "config_double.toml";
  std::ofstream(path) << fmt::format("x = {:.17e}\n", x);
  Config config = Config::read_file(path, {});
  const double read = config.quantity("x", "m", {});
  std::ofstream(path) << config.resolved();
  RC_ASSERT(read == x);
  RC_ASSERT(Config::read_file(path, {}).quantity("x", "m", {}) == x);
}

RC_GTEST_PROP(Config, every_text_survives_the_resolved_file, (const std::string& text)) {
  const std::string path = tdbd::temporary_folder() + "config_text.toml";
  std::ofstream(path) << "";
  Config config = Config::read_file(path, {});
  std::string ascii;
  for (const char c : text) ascii += static_cast<char>(c & 0x7f);
  config.text("t", ascii);
  std::ofstream(path) << config.resolved();
  RC_ASSERT(Config::read_file(path, {}).text("t", {}) == ascii);
}

/// Where a path may be left out by an empty text, one that is given is still the file's.
TEST(Config, lists_the_files_that_it_names) {
  const std::string named = write_temporary(".csv", "x\n");
  const std::string path = write_temporary(".toml", "a = \"" + named + "\"\nb = \"\"\nc = 3\n");
  Config c = Config::read_file(path, {});
  EXPECT_EQ(c.path("a", ""), named);
  EXPECT_EQ(c.path("b", ""), "");
  EXPECT_EQ(c.integer("c", {}, 0, 9), 3);
  EXPECT_NO_THROW(c.finish());
  EXPECT_EQ(c.files(), (std::vector<std::string>{path, named}));
}

TEST(Config, an_empty_array_of_tables_is_known) {
  Config c = Config::read_file(write_temporary(".toml", "layers = []\n"), {});
  EXPECT_TRUE(c.tables("layers").empty());
  EXPECT_NO_THROW(c.finish());
}

TEST(Config, lists_the_names_in_a_table) {
  Config c = Config::read_text("z = 1\na = 2\n[t]\ny = 3\nx = 4\n", "made-up.toml");
  EXPECT_EQ(c.given(), (std::vector<std::string>{"a", "t", "z"}));
  EXPECT_EQ(c.table("t").given(), (std::vector<std::string>{"x", "y"}));
  EXPECT_TRUE(c.table("none").given().empty());
}

}  // namespace tdbd::config_test
