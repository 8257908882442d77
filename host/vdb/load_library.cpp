#include <dlfcn.h>

#include <filesystem>

#include "host/error.h"
#include "host/vdb/library.h"

namespace isotouch::vdb {

namespace {

#ifdef ISOTOUCH_OPENVDB

const Library& load() {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  const std::filesystem::path module = program.parent_path().parent_path() / "lib/isotouch/openvdb.so";
  void* loaded = ::dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);  // never closed: grids live as long as the program
  if (loaded == nullptr) {
    throw InputError(std::string("OpenVDB cannot be loaded (") + ::dlerror() +
                     "); install isotouch as a whole, or build it as a whole with './dev build'");
  }
  using Table = const Library* (*)();
  const auto table = reinterpret_cast<Table>(::dlsym(loaded, kTable));
  if (table == nullptr) throw InputError(module.string() + " is no module of isotouch; install isotouch as a whole");
  return *table();
}

#else

const Library& load() {
  throw InputError("this program was built without OpenVDB; build it with ISOTOUCH_OPENVDB to read and write level sets");
}

#endif

}  // namespace

const Library& library() {
  static const Library& table = load();
  return table;
}

}  // namespace isotouch::vdb
