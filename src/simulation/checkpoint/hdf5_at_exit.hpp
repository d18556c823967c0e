#pragma once

#include <H5public.h>

namespace tdbd::simulation {

/// To be called before the first call to NetCDF: at exit HDF5 would touch files again that it could
/// not close on a full disk, and crash.
inline void leave_files_alone_at_exit() { H5dont_atexit(); }

}  // namespace tdbd::simulation
