/// The doors for scans: PLY, OBJ and text, by the first byte.
#include "host/cloud/obj.h"
#include "host/cloud/ply.h"
#include "host/cloud/xyz.h"
#include "host/error.h"
#include "tests/fuzz/input.h"

using namespace isotouch;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  const std::span<const std::uint8_t> file(data + 1, size - 1);
  try {
    switch (data[0] % 3) {
      case 0: cloud::read_ply("a.ply", file), cloud::is_bare_ply_mesh(cloud::read_ply_header("a.ply", file)); break;
      case 1: cloud::read_obj_points("a.obj", file); break;
      default: cloud::read_xyz("a.xyz", file); break;
    }
  } catch (const InputError&) {  // refused with a sentence
  }
  return 0;
}
