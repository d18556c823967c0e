#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "io/record.hpp"
#include "string/chain.hpp"

namespace tdbd::simulation {

/// A chain between two steps, and the motion of its last node at that time.
struct ChainView {
  const string::Chain& chain;
  const string::ChainState& state;
  const string::ChainWork& work;
  string::EndMotion end;
};

/// Returns the measured depths of these nodes as suffixes of columns: "1500m".
std::vector<std::string> node_names(const string::Chain& chain, const std::vector<int>& nodes);

/// Adds the axis "node" with these names and the columns of each node: the tension (N) and torque
/// (N m) of the element above it, its two speeds (m/s, rad/s), and the side force (N).
void add_node_columns(const std::vector<std::string>& names, Over over, RecordLayout& layout);

/// Appends the values of these columns.
void append_nodes(const ChainView& c, const std::vector<int>& nodes, std::vector<double>& row);

/// Records `string.nc`: profiles over all nodes (displacement, angle, speeds, side force) and over
/// all elements (tension, torque).
class ChainProfiles {
 public:
  /// Creates `path.partial`. Throws RunError if it cannot be created.
  ChainProfiles(const std::filesystem::path& path, const string::Chain& chain);

  void append(double time, const ChainView& c);

  /// Returns the numbers of the last row. All rows have the same number of values.
  const std::vector<double>& last_row() const { return row_; }
  std::size_t width() const { return layout_.row_width(); }

  /// Appends a row that was a last_row() of these profiles.
  void append_again(std::span<const double> row) { record_.append(row); }

  /// Writes what is buffered and renames the file to its final name. Throws RunError.
  void close() { record_.close(); }

 private:
  RecordLayout layout_;
  Record record_;
  std::vector<double> row_;
};

}  // namespace tdbd::simulation
