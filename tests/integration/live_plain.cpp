/// Live fields under random batches, with nothing but the code that makes them, for processors that have no host tool: after every batch the
/// field must be the one that all present points give at once, to the byte.
///
///     live_plain VOXELS THREADS COUNT        VOXELS along the longest side of an object; COUNT histories, on ten objects in turn
///
/// Prints how many fields were compared and the hash of all of them, which is the same for any number of threads, compiler and processor.
/// Exit code 3: a field differs, and which one is printed.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

#include "host/field/parallel.h"
#include "shared/field_view.h"
#include "shared/hash64.h"
#include "tests/host/live/random_batches.h"

namespace {

using namespace isotouch;

constexpr int kBatches = 6;

struct Tally {
  std::uint64_t hash = 0;
  std::size_t fields = 0, bricks = 0, computed = 0, of_whole = 0;
};

/// fails     with false when a field differs
bool run(int history, int voxels, Tally& tally) {
  const std::string& name = cloud::shape_names()[static_cast<std::size_t>(history) % cloud::shape_names().size()];
  test::RandomBatches batches(cloud::shape(name), voxels, static_cast<std::uint64_t>(history));
  live::LiveField field(batches.grid(), field::kBand, {});
  for (int n = 0; n < kBatches; ++n) {
    tally.computed += field.apply(batches.next()).bricks;
    live::LiveField whole(batches.grid(), field::kBand, {});
    tally.of_whole += whole.apply(batches.whole()).bricks;
    const field_file::Image image = field.image(), expected = whole.image();
    const auto view = FieldView::parse(image.bytes());
    const bool equal = image.size() == expected.size() && std::memcmp(image.data(), expected.data(), image.size()) == 0;
    const bool certified = field.certificate_hash() == whole.certificate_hash();
    if (!equal || !view || !certified || !(field.verdict() == whole.verdict())) {
      std::printf("history %d on %s, batch %d: %s\n", history, name.c_str(), n,
                  !view        ? "the field is refused"
                  : !equal     ? "the bytes differ"
                  : !certified ? "the certificate of a brick differs"
                               : "the verdict differs");
      return false;
    }
    ++tally.fields;
    tally.bricks += view->brick_count - 2;
    tally.hash = hash64(image.data(), image.size(), tally.hash);
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return std::fprintf(stderr, "usage: live_plain VOXELS THREADS COUNT\n"), 2;
  try {
    const field::ThreadLimit limit(static_cast<unsigned>(std::atoi(argv[2])));
    Tally tally;
    for (int history = 0; history < std::atoi(argv[3]); ++history) {
      if (!run(history, std::atoi(argv[1]), tally)) return 3;
    }
    std::printf("%zu fields of %zu bricks equal, %zu bricks computed for %zu of whole builds, hash %016llx\n", tally.fields, tally.bricks,
                tally.computed, tally.of_whole, static_cast<unsigned long long>(tally.hash));
    return tally.bricks > 0 ? 0 : 3;
  } catch (const std::exception& error) {
    return std::fprintf(stderr, "live_plain: %s\n", error.what()), 1;
  }
}
