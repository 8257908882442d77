#include <array>
#include <fstream>

#include "host/vdb/level_set.h"

namespace isotouch::vdb {

bool is_vdb_file(const std::filesystem::path& file) {
  constexpr std::array<char, 8> kMagic = {' ', 'B', 'D', 'V', 0, 0, 0, 0};
  std::array<char, 8> begin{};
  std::ifstream stream(file, std::ios::binary);
  if (stream.read(begin.data(), begin.size()) && begin == kMagic) return true;
  return file.extension() == ".vdb";
}

}  // namespace isotouch::vdb
