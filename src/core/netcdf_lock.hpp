#pragma once

#include <mutex>

namespace tdbd {

/// NetCDF and HDF5 are not made for two threads at once, not even on two files: whoever calls them holds this meanwhile.
inline std::recursive_mutex& netcdf_mutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

using NetcdfLock = std::lock_guard<std::recursive_mutex>;

}  // namespace tdbd
