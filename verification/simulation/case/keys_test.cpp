#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "bit/files/bit_file.hpp"
#include "core/error.hpp"
#include "core/temporary_file.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/case_kind.hpp"
#include "simulation/case/force_settings.hpp"
#include "simulation/chain/chain_run.hpp"
#include "simulation/rotate/rotate_case.hpp"
#include "verification/simulation/case/covering_cases.hpp"

/// The declared keys against the cases that are read with them.
namespace tdbd::simulation::keys_test {

namespace fs = std::filesystem;

/// One line of a resolved file: the table as it is declared, and its place in the file.
struct Resolved {
  std::string table, place, key, value, unit;
};

/// Where tables of a file stand, line for line: the second [[legs]] at "legs[1]", [legs.grading]
/// after it at "legs[1].grading".
class Places {
 public:
  std::string of(const std::string& header) {
    const bool repeats = header.starts_with("[[");
    const std::string table = header.substr(repeats ? 2 : 1, header.find(']') - (repeats ? 2 : 1));
    if (repeats) ++count_[table];
    for (const auto& [name, count] : count_)
      if (table == name || table.starts_with(name + "."))
        return name + "[" + std::to_string(count - 1) + "]" + table.substr(name.size());
    return table;
  }

 private:
  std::map<std::string, int> count_;
};

/// Every key of a resolved file.
std::vector<Resolved> lines_of(const std::string& resolved) {
  std::vector<Resolved> lines;
  std::istringstream in(resolved);
  Places places;
  std::string table, place;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    if (line.front() == '[') {
      const std::size_t first = line.find_first_not_of('[');
      table = line.substr(first, line.find(']') - first);
      place = places.of(line);
      continue;
    }
    const std::size_t equals = line.find(" = "), unit = line.rfind("  # ");
    lines.push_back({table, place, line.substr(0, equals),
                     line.substr(equals + 3, unit == std::string::npos ? unit : unit - equals - 3),
                     unit == std::string::npos ? "" : line.substr(unit + 4)});
  }
  return lines;
}

/// The tables in which a table of a file is declared.
std::vector<std::string> declared_as(const std::string& table) {
  if (table == "rock.layers.material") return {"rock.material"};
  if (table == "cones.rows") return {"cones.rows", "teeth"};
  for (const std::string& kind : part_kinds)
    if (table == "forces." + kind) return {"forces.KIND", "forces"};
  if (table.starts_with("forces.areas.")) return {"forces.areas.NAME", "forces"};
  if (table.starts_with("wear.areas.")) return {"wear.areas.NAME"};
  if (table.starts_with("spalling.areas.")) return {"spalling.areas.NAME"};
  for (const char* key : {"rotary_speed", "rate_of_penetration", "weight_on_bit"})
    if (table == std::string("motion.") + key) return {"motion.KEY"};
  if (table.starts_with("bit.set")) return {"bit.set"};
  return {table};
}

/// The declarations of a line's key: of one in several force laws there are several.
std::vector<KeyRow> rows_of(const std::string& command, const Resolved& line) {
  std::vector<KeyRow> rows;
  const std::vector<std::string> names = declared_as(line.table);
  for (const KeyTable& table : all_tables())
    if (table.command == command && std::ranges::count(names, table.name) > 0)
      for (const KeyRow& row : table.rows)
        if (row.name == line.key || row.name == "KEY")
          rows.push_back(row);  // KEY: any of the bit's
  return rows;
}

bool has_unit(const KeyRow& row, const std::string& unit) {
  if (unit.empty() || row.kind.ends_with("KEY's unit")) return true;
  return row.kind.ends_with(unit == "1" ? "number" : unit);
}

/// Every key is declared, with its unit and, where the case leaves it out, with its default.
void expect_declared(const ReadCase& c) {
  const Config file = Config::read_file(c.path, {});
  for (const Resolved& line : lines_of(c.resolved)) {
    const std::string key = line.place.empty() ? line.key : line.place + "." + line.key;
    // Cones and their rows have the values of [journal] and [teeth] unless they give their own.
    const bool given = file.has(key) || file.has(line.place + ".coefficients") ||
                       (c.command == "bit" && line.table.starts_with("cones"));
    const auto agrees = [&](const KeyRow& row) {
      return has_unit(row, line.unit) && (given || row.toml.empty() || row.toml == line.value);
    };
    EXPECT_TRUE(std::ranges::any_of(rows_of(c.command, line), agrees))
        << c.path << ": " << key << " = " << line.value << " # " << line.unit;
  }
}

/// The resolved file gives every key, each with its default or its given value: it must be the same
/// case.
std::string read_again(const ReadCase& c) {
  const std::string path = write_temporary("_again.toml", c.resolved);
  if (c.command == "string") return read_chain_case(path, {}).resolved;
  return c.command == "run" ? read_case(path, {}).resolved : read_rotate_case(path, {}).resolved;
}

std::vector<fs::path> shipped() {
  std::vector<fs::path> paths;
  for (const char* folder : {"/cases", "/cases/free-rotation"})
    for (const auto& entry : fs::directory_iterator(std::string(TDBD_SOURCE_DIR) + folder))
      if (entry.path().extension() == ".toml") paths.push_back(entry.path());
  std::ranges::sort(paths);
  return paths;
}

ReadCase read_shipped(const fs::path& path) {
  if (is_rotate_case(path)) return {"rotate", path, read_rotate_case(path, {}).resolved};
  if (kind_of(path, {}) == CaseKind::string)
    return {"string", path, read_chain_case(path, {}).resolved};
  return {"run", path, read_case(path, {}).resolved};
}

TEST(Keys, of_every_shipped_case_are_declared) {
  const std::vector<fs::path> paths = shipped();
  ASSERT_GT(paths.size(), 30u);
  for (const fs::path& path : paths) expect_declared(read_shipped(path));
}

TEST(Keys, of_every_shipped_bit_are_declared) {
  for (const auto& entry : fs::directory_iterator(TDBD_SOURCE_DIR "/cases/bits")) {
    const fs::path& path = entry.path();
    if (path.extension() != ".toml") continue;
    const bit::BitFile file =
        bit::read_bit(path, bit::DirectionRule::hybrid, bit::InsideRule::down);
    expect_declared({"bit", path, file.fingerprint});
  }
}

TEST(Keys, that_are_declared_can_be_read_and_given_with_their_defaults) {
  std::vector<ReadCase> cases{drilling()};
  for (const auto& more : {motions_and_rocks(), laws(), fits(), areas(), wears(), spallings(),
                           rotations(), strings(), on_chains()})
    cases.insert(cases.end(), more.begin(), more.end());
  for (const char* name : {"bit-r-rolling", "bit-r-steady", "drill-bit-r", "laboratory"})
    cases.push_back(read_shipped(std::string(TDBD_SOURCE_DIR) + "/cases/" + name + ".toml"));
  cases.push_back(read_shipped(std::string(TDBD_SOURCE_DIR) + "/cases/drill-bit-b.toml"));
  cases.push_back(small_run(steady, "", {"output.checkpoint_every=100", "title=a case"}));
  cases.push_back(small_run(steady, "", {"bit.set.adjust.back_rake=1 deg"}));
  std::set<std::string> read;
  for (const ReadCase& c : cases) {
    for (const Resolved& line : lines_of(c.resolved))
      for (const std::string& table : declared_as(line.table))
        read.insert(c.command + " " + table + " " +
                    (table == BitChanges::table.name ? "KEY" : line.key));
    EXPECT_EQ(read_again(c), c.resolved);
  }
  for (const KeyTable& table : all_tables())
    for (const KeyRow& row : table.rows)
      EXPECT_TRUE(table.command == "bit" ||
                  read.contains(table.command + " " + table.name + " " + row.name))
          << table.command << " " << table.name << " " << row.name;
}

TEST(Keys, occur_once_in_their_table) {
  std::set<std::string> seen;
  for (const KeyTable& table : all_tables())
    for (const KeyRow& row : table.rows) {
      EXPECT_FALSE(row.meaning.empty()) << table.name << " " << row.name;
      EXPECT_TRUE(
          seen.insert(table.command + table.name + table.meaning + row.name + row.kind).second)
          << table.name << " " << row.name;
    }
}

}  // namespace tdbd::simulation::keys_test
