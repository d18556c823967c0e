#include "sweep/table/table_netcdf.hpp"

#include <fmt/format.h>
#include <netcdf.h>

#include <cerrno>
#include <cstring>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/memory_left.hpp"
#include "core/netcdf_lock.hpp"
#include "core/plain_path.hpp"
#include "core/provenance.hpp"
#include "core/whole_file.hpp"
#include "simulation/checkpoint/hdf5_at_exit.hpp"

namespace tdbd::sweep {
namespace {

/// An open file that is closed where the writing fails.
struct TableFile {
  std::filesystem::path path;
  int id = -1;
  int dim = -1;

  void require(int status) const {
    if (status == NC_NOERR) return;
    throw RunError(
        fmt::format("cannot write {}: {}", path.string(),
                    status > 0 || errno != 0 ? std::strerror(errno) : nc_strerror(status)));
  }
  ~TableFile() {
    if (id >= 0) nc_close(id);
  }
  void attribute(int variable, const char* name, const std::string& text) const {
    require(nc_put_att_text(id, variable, name, text.size(), text.c_str()));
  }
};

int define(const TableFile& f, const std::string& name, nc_type type, const std::string& units,
           const std::string& long_name) {
  int variable = -1;
  f.require(nc_def_var(f.id, name.c_str(), type, 1, &f.dim, &variable));
  if (!units.empty()) f.attribute(variable, "units", units);
  f.attribute(variable, "long_name", long_name);
  return variable;
}

void put_numbers(const TableFile& f, const std::string& name, const std::string& units,
                 const std::string& long_name, const std::vector<double>& values) {
  const int variable = define(f, name, NC_DOUBLE, units, long_name);
  f.require(nc_put_var_double(f.id, variable, values.data()));
}

void put_texts(const TableFile& f, const std::string& name, const std::string& long_name,
               const std::vector<std::string>& texts) {
  const int variable = define(f, name, NC_STRING, "", long_name);
  std::vector<const char*> pointers;
  pointers.reserve(texts.size());
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  f.require(nc_put_var_string(f.id, variable, pointers.data()));
}

void put_flags(const TableFile& f, const std::string& name, const std::string& meanings,
               const std::string& long_name, const std::vector<signed char>& values,
               const std::vector<signed char>& flags) {
  const int variable = define(f, name, NC_BYTE, "", long_name);
  f.require(nc_put_att_schar(f.id, variable, "flag_values", NC_BYTE, flags.size(), flags.data()));
  f.attribute(variable, "flag_meanings", meanings);
  f.require(nc_put_var_schar(f.id, variable, values.data()));
}

/// One value of each point.
template <class Value, class Of>
std::vector<Value> column(const Table& t, Of&& of) {
  std::vector<Value> values;
  for (std::size_t i = 0; i < t.points.size(); ++i) values.push_back(of(i));
  return values;
}

void put_factors(const TableFile& f, const Table& t) {
  for (std::size_t k = 0; k < t.factors.size(); ++k) {
    const FactorColumn& factor = t.factors[k];
    if (factor.numbers)
      put_numbers(f, factor.key, factor.unit.empty() ? "1" : factor.unit, "factor " + factor.key,
                  column<double>(t, [&](std::size_t i) { return *t.levels[i][k].number; }));
    else
      put_texts(f, factor.key, "factor " + factor.key,
                column<std::string>(t, [&](std::size_t i) { return t.levels[i][k].word.text; }));
  }
}

void put_outcomes(const TableFile& f, const Table& t) {
  const auto outcome = [&](std::size_t i) {
    return t.points[i] == nullptr ? PointOutcome{} : t.points[i]->outcome;
  };
  put_flags(f, "status", "done failed missing left_out", "how the point ended",
            column<signed char>(t,
                                [&](std::size_t i) {
                                  if (!t.judged.keeps(i)) return static_cast<signed char>(3);
                                  if (t.points[i] == nullptr) return static_cast<signed char>(2);
                                  return static_cast<signed char>(
                                      t.points[i]->outcome.status == PointStatus::failed ? 1 : 0);
                                }),
            {0, 1, 2, 3});
  if (!t.design->goals.empty())
    put_flags(f, "front", "dominated not_dominated",
              "whether no other point is as good in every goal and better in one",
              column<signed char>(
                  t, [&](std::size_t i) { return static_cast<signed char>(t.on_front[i]); }),
              {0, 1});
  put_texts(f, "case_hash", "of the resolved case",
            column<std::string>(t, [&](std::size_t i) { return outcome(i).case_hash; }));
  put_texts(f, "message", "why the point failed",
            column<std::string>(t, [&](std::size_t i) { return outcome(i).message; }));
}

void put_figures(const TableFile& f, const Table& t) {
  if (t.design->filter)
    put_numbers(f, "planar." + t.design->filter->goal.figure, "",
                "filter planar." + t.design->filter->goal.figure, t.judged.figure);
  for (std::size_t k = 0; k < t.design->figures.size(); ++k)
    put_numbers(f, t.design->figures[k], "", "figure " + t.design->figures[k],
                column<double>(t, [&](std::size_t i) {
                  return t.points[i] == nullptr ? std::numeric_limits<double>::quiet_NaN()
                                                : t.points[i]->outcome.figures[k];
                }));
}

void put_head(const TableFile& f, const Design& d) {
  const Provenance& p = provenance();
  f.attribute(NC_GLOBAL, "title", d.title);
  f.attribute(NC_GLOBAL, "command", name_of(d.command));
  f.attribute(NC_GLOBAL, "source", fmt::format("tdbd {} {}", p.version, p.commit));
  std::string goals;
  for (const Goal& goal : d.goals)
    goals += fmt::format("{}{} {}", goals.empty() ? "" : ", ", goal.figure,
                         goal.sense == Sense::smaller ? "smaller" : "larger");
  if (!goals.empty()) f.attribute(NC_GLOBAL, "goals", goals);
}

}  // namespace

void write_netcdf(const std::filesystem::path& file, const Table& t) {
  constexpr std::size_t own = 8'000'000, by_cell = 64;
  demand_memory(own + by_cell * t.points.size());
  const NetcdfLock lock(netcdf_mutex());
  simulation::leave_files_alone_at_exit();
  TableFile f{partial_path(file)};
  errno = 0;
  f.require(nc_create(PlainPath(f.path).c_str(), NC_NETCDF4 | NC_CLOBBER, &f.id));
  f.require(nc_def_dim(f.id, "point", t.points.size(), &f.dim));
  put_head(f, *t.design);
  put_factors(f, t);
  put_figures(f, t);
  put_outcomes(f, t);
  f.require(nc_sync(f.id));
  put_on_disk(f.path);
  f.require(nc_close(std::exchange(f.id, -1)));
  rename_partial(file);
}

}  // namespace tdbd::sweep
