#include "host/field/mesh_repair.h"

#include <locale>
#include <sstream>

namespace isotouch::field {

std::string length_text(double length) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream << length;
  return stream.str();
}

std::string place_text(const Eigen::Vector3d& place) {
  return '(' + length_text(place.x()) + ", " + length_text(place.y()) + ", " + length_text(place.z()) + ')';
}

std::string count_text(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

std::string rims_text(const MeshRepair& repair) {
  return "the mesh is open: " + count_text(repair.holes, "rim", "rims") + " of " + length_text(repair.rim_length) +
         " units length together, the longest round " + place_text(repair.rim);
}

std::vector<std::string> MeshRepair::warnings() const {
  std::vector<std::string> list;
  if (holes > 0) {
    list.push_back(rims_text(*this) + ", closed by fans of faces" +
                   (holes > 1 ? "; where one rim lies round another, join the two in a mesh program instead" : ""));
  }
  if (repeated > 0) list.push_back(count_text(repeated, "face was", "faces were") + " written more than once; each was kept once");
  if (branching > 0) {
    list.push_back(count_text(branching, "edge has", "edges have") + " more than two faces, the first near " + place_text(branch) +
                   "; inside is what the faces wind round");
  }
  if (crossing > 0) {
    list.push_back("the mesh runs through itself: " + count_text(crossing, "face crosses", "faces cross") + " others, the first near " +
                   place_text(cross) + "; inside is what the faces wind round");
  }
  if (coarse > 0) {
    list.push_back("so many faces cross that they were cut only into parts of " + length_text(1000 * coarse) +
                   " thousandths of the mesh's size; where gaps or pieces are narrower, the surface may be wrong; unite the pieces in a "
                   "mesh program");
  }
  if (swallowed > 0) {
    list.push_back(count_text(swallowed, "closed piece lies", "closed pieces lie") + " within others and " +
                   (swallowed == 1 ? "has" : "have") + " no effect, the first near " + place_text(swallow) +
                   "; reverse the faces of those that are hollows");
  }
  if (turned) list.push_back("the faces pointed inwards; all were reversed");
  return list;
}

}  // namespace isotouch::field
