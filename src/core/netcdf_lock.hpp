#pragma once

#include <mutex>

namespace tdbd {

/// NetCDF and HDF5 are not thread-safe, even for different files. Every call to them must be made
/// while this mutex is locked.
inline std::recursive_mutex& netcdf_mutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

using NetcdfLock = std::lock_guard<std::recursive_mutex>;

}  // namespace tdbd
