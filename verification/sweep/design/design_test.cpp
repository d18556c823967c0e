#include "sweep/design/design.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/read_file.hpp"
#include "verification/sweep/small_design.hpp"

namespace tdbd::sweep::design_test {

const std::string head =
    "[sweep]\ncase = \"" TDBD_SOURCE_DIR "/cases/slow-top.toml\"\nfigures = [\"steps\"]\n";

std::string factor(const std::string& rest) { return "[[factors]]\nkey = \"time.step\"\n" + rest; }

TEST(Design, reads_all_of_its_keys) {
  const Design d = design_from(empty_folder("design"), small_top());
  EXPECT_EQ(d.command, Command::rotate);
  EXPECT_EQ(d.fixed, std::vector<std::string>{"time.duration=2000"});
  ASSERT_EQ(d.factors.size(), 2u);
  EXPECT_EQ(d.factors[0].key, "time.step");
  EXPECT_EQ(d.factors[0].levels.size(), 3u);
  EXPECT_EQ(d.factors[0].levels[0].word.toml, "0.5");
}

TEST(Design, has_a_title_and_the_ratio_of_the_planar_model) {
  const std::string rest = "case = \"" TDBD_SOURCE_DIR
                           "/cases/bit-b-steady.toml\"\nfigures = [\"imbalance\"]\n",
                    ratio = "normal_ratio = 0.5\n", steps = factor("values = [\"1 ms\"]\n");
  const auto read = [&](const std::string& text) {
    return design_from(empty_folder("ratio"), "title = \"What for\"\n[sweep]\n" + rest + text);
  };
  const Design planar = read("command = \"planar\"\n" + ratio + steps);
  EXPECT_EQ(planar.title, "What for");
  EXPECT_EQ(planar.normal_ratio, 0.5);
  const std::string filter = "[filter]\nfigure = \"imbalance\"\nkeep = 1\n";
  EXPECT_EQ(read(ratio + steps + filter).normal_ratio, 0.5);
  EXPECT_NE(
      mistake_in("[sweep]\n" + rest + ratio + steps).find("normal_ratio: found an unknown key"),
      std::string::npos);
}

TEST(Design, of_a_filter_has_a_planar_one_with_its_figure) {
  const std::string rest = "[sweep]\ncase = \"" TDBD_SOURCE_DIR
                           "/cases/bit-b-steady.toml\"\nfigures = [\"removed_volume_m3\"]\n";
  const Design d =
      design_from(empty_folder("planar"), rest + factor("values = [\"1 ms\"]\n") +
                                              "[filter]\nfigure = \"imbalance\"\nkeep = 1\n");
  const Design planar = planar_design(d);
  EXPECT_EQ(planar.command, Command::planar);
  EXPECT_EQ(planar.figures, std::vector<std::string>{"imbalance"});
  EXPECT_FALSE(planar.filter);
}

/// 4000 of 4000 values.
TEST(Design, rejects_too_many_points) {
  std::string values = "values = [0";
  for (int k = 1; k < 4000; ++k) values += fmt::format(", {}", k);
  const std::string other = "[[factors]]\nkey = \"integrator.order\"\n";
  EXPECT_NE(mistake_in(head + factor(values + "]\n") + other + values + "]\n")
                .find("found 16000000 points, expected at most 10000000"),
            std::string::npos);
}

/// One mistake has one line.
TEST(Design, reports_a_factor_without_values_once) {
  const std::string told = mistake_in(head + factor(""));
  EXPECT_NE(told.find("found neither values nor from and to, expected one of the two"),
            std::string::npos);
  EXPECT_EQ(std::ranges::count(told, '\n'), 0) << told;
}

/// `tdbd keys --design --markdown` makes the page of them.
TEST(Design, has_the_keys_of_its_page) {
  const std::string page = read_file(TDBD_SOURCE_DIR "/src/sweep/design/KEYS.md", "a page");
  EXPECT_TRUE(page.ends_with(keys_as_markdown(design_tables())));
}

/// What is wrong, and what the message must say of it.
TEST(Design, rejects_with_line_and_key) {
  struct Wrong {
    std::string text, message;
  };
  const std::vector<Wrong> all{
      {head, "factors: found no factor, and so no points"},
      {head + factor("values = []\n"), "6: factors[0].values: found no value"},
      {head + factor("valus = [1]\n"), "6: factors[0].valus: found an unknown key"},
      {head + factor("values = [1]\nfrom = 1\n"), "from or to as well"},
      {head + factor("values = [[1]]\n"), "found an array of 1"},
      {head + factor("from = 1\nto = 2\ncount = 1000000000\n"),
       "found 1000000000 points, expected at most 10000000"},
      {head + factor("from = 1\nto = 2\n"),
       "sweep.sampling: found none, and a factor without count"},
      {head + factor("from = 2\nto = 1\ncount = 3\n"),
       "factors[0].to: found 1, expected more than from"},
      {head + factor("from = \"1 s\"\nto = \"2 ms\"\ncount = 3\n"),
       "factors[0].to: found 2 ms, expected the unit of from"},
      {head + factor("from = \"a\"\nto = 2\ncount = 3\n"),
       "factors[0].from: found a, expected a number"},
      {head + factor("from = 0\nto = 2\ncount = 3\nscale = \"log\"\n"),
       "more than 0 on a logarithmic scale"},
      {head + "samples = 4\n" + factor("values = [1]\n"),
       "sweep.samples: found no factor to sample"},
      {head + "sampling = \"sobol\"\n" + factor("values = [1]\n"),
       "sweep.sampling: found no factor to sample"},
      {head + factor("values = [1]\n") + factor("values = [2]\n"),
       "factors[1].key: found time.step again"},
      {head + "[set]\ntime.step = 1\n" + factor("values = [1]\n"),
       "factors[0].key: found time.step again"},
      {head + factor("values = [1]\n") + "[[goals]]\nfigure = \"step\"\n",
       "goals[0].figure: found step, expected one of sweep.figures: steps"},
      {head + "penetration = \"1 mm\"\n" + factor("values = [1]\n"),
       "sweep.penetration: found an unknown key"},
      {head + factor("values = [1]\n") + "[filter]\nfigure = \"imbalance\"\nkeep = 0\n",
       "filter.keep: found 0, expected a whole number from 1"},
      {head + "command = \"rotate\"\n" + factor("values = [1]\n") +
           "[filter]\nfigure = \"imbalance\"\nkeep = 1\n",
       "filter: found the command rotate, expected run"},
  };
  for (const Wrong& w : all) {
    const std::string found = mistake_in(w.text);
    EXPECT_NE(found.find("design.toml:"), std::string::npos) << w.text << found;
    EXPECT_NE(found.find(w.message), std::string::npos) << w.text << found;
  }
}

TEST(Design, has_a_figure_at_least_and_each_once) {
  const std::string start =
      "[sweep]\ncase = \"" TDBD_SOURCE_DIR "/cases/slow-top.toml\"\nfigures = ";
  EXPECT_NE(mistake_in(start + "[]\n" + factor("values = [1]\n")).find("found no figure"),
            std::string::npos);
  EXPECT_NE(mistake_in(start + "[\"a\", \"a\"]\n" + factor("values = [1]\n"))
                .find("found a figure twice"),
            std::string::npos);
}

TEST(Design, samples_at_most_what_sobol_has_directions_for) {
  std::string text = head + "sampling = \"sobol\"\nsamples = 2\n";
  for (int i = 0; i < 41; ++i)
    text += "[[factors]]\nkey = \"k" + std::to_string(i) + "\"\nfrom = 0\nto = 1\n";
  EXPECT_NE(mistake_in(text).find("found 41 factors to sample, expected at most 40"),
            std::string::npos);
}

}  // namespace tdbd::sweep::design_test
