#include "host/vdb/level_set.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <new>
#include <system_error>

#include "host/cloud/forked_call.h"
#include "host/error.h"
#include "host/files/whole_file.h"
#include "host/vdb/library.h"
#include "shared/hash64.h"

namespace isotouch::vdb {

namespace {

/// What reading a file may take: level sets shrink to a hundredth at most when they are saved, and a gigabyte is read within a minute by one
/// processor that has nothing else to do.
cloud::ProcessLimits limits_for(std::size_t file_bytes) {
  const unsigned seconds = 20 + static_cast<unsigned>(file_bytes >> 22U);
  return {
      .more_bytes = (std::uint64_t{512} << 20U) + 200 * std::uint64_t{file_bytes}, .cpu_seconds = seconds, .wall_seconds = 16 * seconds};
}

/// A file that has no place on a disk, for a library that wants a name.
class MemoryFile {
 public:
  /// fails     InputError naming the file that it is a copy of
  MemoryFile(const std::string& name, std::span<const std::uint8_t> bytes) : descriptor_(::memfd_create("isotouch", MFD_CLOEXEC)) {
    for (std::size_t done = 0; done < bytes.size();) {
      const ssize_t wrote = ::write(descriptor_, bytes.data() + done, bytes.size() - done);
      if (wrote <= 0) throw InputError(name + ": there is no memory for a copy of it; save it as a file and name that");
      done += static_cast<std::size_t>(wrote);
    }
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { ::close(descriptor_); }
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

constexpr int kWidened = 4;
constexpr double kStencil = 2.5;  ///< how far the samples of an interpolation that carry weight may lie from its place

}  // namespace

bool is_vdb_file(const std::filesystem::path& file, std::span<const std::uint8_t> bytes) {
  constexpr std::array<std::uint8_t, 8> kMagic = {' ', 'B', 'D', 'V', 0, 0, 0, 0};
  if (bytes.size() >= kMagic.size() && std::equal(kMagic.begin(), kMagic.end(), bytes.begin())) return true;
  return file.extension() == ".vdb";
}

LevelSet LevelSet::read(const std::filesystem::path& file, std::span<const std::uint8_t> bytes, const std::string& grid_name) {
  const std::string name = file.string();
  std::error_code ignored;
  std::optional<MemoryFile> copy;
  if (is_standard(file) || !std::filesystem::is_regular_file(file, ignored)) copy.emplace(name, bytes);
  const Source source{name, copy ? copy->path() : name};
  // A damaged count makes the library write beyond its buffers (3 of 250 mutated files, version 10.0.1, 2026-11), and where it throws it leaks.
  // The copy loads the library itself: its threads, started as it is loaded, could hold a lock at the moment of the fork.
  const cloud::ForkedCall trial = cloud::call_in_fork([&] {
    const Library& openvdb = library();
    cloud::limit_this_process(limits_for(bytes.size()));
    try {
      openvdb.attempt(source, grid_name);
    } catch (const std::bad_alloc&) {
      throw InputError(name + ": the file is damaged: it asks for far more memory than a level set of its size needs; save it again");
    }
    return std::string();
  });
  if (trial.crashed) throw InputError(name + ": the file is damaged: reading it crashes OpenVDB; save it again");
  if (!trial.thrown.empty()) throw InputError(trial.thrown);
  LevelSet set = library().read(source, grid_name);
  set.source_hash = hash64(bytes.data(), bytes.size());
  return set;
}

LevelSet LevelSet::read(const std::filesystem::path& file, const std::string& grid_name) { return read(file, read_file(file), grid_name); }

Interpolation::Interpolation(const LevelSet& set)
    : grid_(library().widened(*set.grid, kWidened)), reach_(set.half_width + kWidened - kStencil) {}

void Interpolation::distances(std::span<const Eigen::Vector3d> places, std::span<double> values) const {
  library().distances(*grid_, places, values);
}

std::vector<std::uint8_t> write_level_set(const field::BandField& field, const std::string& name, const Notes& notes) {
  return library().write(field, name, notes);
}

}  // namespace isotouch::vdb
