/// What the program finds in the module.
#include "host/vdb/library.h"

extern "C" const isotouch::vdb::Library* isotouch_openvdb() {
  using namespace isotouch::vdb;
  static constexpr Library kLibrary{&attempt_with_openvdb, &read_with_openvdb, &widened_with_openvdb, &distances_with_openvdb,
                                    &write_with_openvdb};
  return &kLibrary;
}
