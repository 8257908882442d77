/// The doors for meshes: PLY, OBJ and STL, by the first byte. A face never names a vertex that is not there.
#include "host/cloud/obj.h"
#include "host/cloud/ply.h"
#include "host/cloud/polygon.h"
#include "host/cloud/stl.h"
#include "host/error.h"
#include "tests/fuzz/input.h"

using namespace isotouch;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  const std::span<const std::uint8_t> file(data + 1, size - 1);
  try {
    cloud::Model model = data[0] % 3 == 0   ? cloud::read_ply("a.ply", file)
                         : data[0] % 3 == 1 ? cloud::read_obj_faces("a.obj", file)
                                            : cloud::read_stl("a.stl", file);
    cloud::cut_polygons(model, "a");
    for (const auto& face : model.faces) {
      for (const auto vertex : face)
        fuzz::hold(static_cast<std::size_t>(vertex) < model.positions.size(), "a face names vertices that are there");
    }
  } catch (const InputError&) {  // refused with a sentence
  }
  return 0;
}
