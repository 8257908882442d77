#include "shared/field_patch.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "shared/bytes.h"
#include "shared/hash64.h"

namespace isotouch {

static_assert(std::endian::native == std::endian::little, "bricks are copied as they are");

namespace {

using namespace patch_layout;
using image_layout::kBricksPerNode;
using image_layout::kInside;
using image_layout::kOutside;
using image_layout::kSamplesPerBrick;

std::uint64_t root_cells(const FieldView& view) {
  return std::uint64_t{1} * static_cast<std::uint32_t>(view.root_size[0]) * static_cast<std::uint32_t>(view.root_size[1]) *
         static_cast<std::uint32_t>(view.root_size[2]);
}

/// A stored brick whose coefficients are all +band or all -band: that is what bricks 0 and 1 are for.
bool is_constant(const std::uint8_t* brick, std::int32_t band) {
  const auto first = load_le<std::int16_t>(brick);
  if (first != band && first != -band) return false;
  return std::memcmp(brick, brick + 2, kBrickBytes - 2) == 0;
}

/// Every cell rises, lies in the tree and has a kind, and as many are stored as the bricks say.
bool are_cells(const FieldPatch& patch) {
  const std::uint64_t end = root_cells(patch.after) * kBricksPerNode;
  std::uint64_t next = 0, stored = 0;
  for (std::size_t at = 0; at < patch.cells.size(); at += 4) {
    const auto word = load_le<std::uint32_t>(&patch.cells[at]);
    const std::uint32_t cell = word >> kKindBits, kind = word & ((1U << kKindBits) - 1);
    if (cell < next || cell >= end || kind > kStored) return false;
    next = std::uint64_t{cell} + 1;
    if (kind == kStored) ++stored;
  }
  if (stored * kBrickBytes != patch.bricks.size()) return false;
  for (std::size_t at = 0; at < patch.bricks.size(); at += kBrickBytes) {
    if (is_constant(&patch.bricks[at], patch.after.band.raw())) return false;
  }
  return true;
}

/// The cells of a patch, one after the other.
class Changes {
 public:
  explicit Changes(const FieldPatch& patch) : patch_(patch) { look(); }
  /// The next cell of the patch; none behind the last.
  std::uint64_t cell() const { return cell_; }
  std::uint32_t kind() const { return kind_; }
  const std::uint8_t* brick() const { return &patch_.bricks[stored_ * kBrickBytes]; }
  std::uint8_t stiffness() const { return patch_.stiffness[stored_]; }
  void advance() {
    if (kind_ == kStored) ++stored_;
    at_ += 4;
    look();
  }

 private:
  void look() {
    const bool ended = at_ == patch_.cells.size();
    const std::uint32_t word = ended ? 0 : load_le<std::uint32_t>(&patch_.cells[at_]);
    cell_ = ended ? ~std::uint64_t{0} : word >> kKindBits;
    kind_ = word & ((1U << kKindBits) - 1);
  }

  const FieldPatch& patch_;
  std::size_t at_ = 0, stored_ = 0;
  std::uint64_t cell_ = 0;
  std::uint32_t kind_ = 0;
};

/// Fills an image whose header is in place, and numbers nodes and bricks in the order in which they come.
class ImageWriter {
 public:
  ImageWriter(const FieldPatch& patch, const FieldView& before, std::uint8_t* image)
      : before_(before),
        changes_(patch),
        root_(reinterpret_cast<std::uint32_t*>(image + image_layout::kHeaderBytes)),
        nodes_(reinterpret_cast<std::uint32_t*>(image + load_le<std::uint32_t>(image + image_layout::kNodeOffsetAt))),
        bricks_(image + load_le<std::uint32_t>(image + image_layout::kBrickOffsetAt)),
        parts_(patch.stiffness_at() != 0 ? image + patch.stiffness_at() : nullptr),
        node_count_(patch.after.node_count),
        brick_count_(patch.after.brick_count) {}

  /// fails     kBadSize (not as many nodes or bricks as the header says), kBadPatch (a cell that does not change)
  Result<void> write() {
    const auto band = static_cast<std::int16_t>(before_.band.raw());
    std::fill_n(nodes_, kBricksPerNode, kOutside);
    std::fill_n(nodes_ + kBricksPerNode, kBricksPerNode, kInside);
    for (std::size_t n = 0; n < kSamplesPerBrick; ++n) {
      store_le(bricks_ + 2 * n, band);
      store_le(bricks_ + kBrickBytes + 2 * n, static_cast<std::int16_t>(-band));
    }
    if (parts_ != nullptr) std::fill_n(parts_, 2, std::uint8_t{0});
    const std::uint64_t cells = root_cells(before_);
    for (std::uint64_t entry = 0; entry < cells; ++entry) {
      if (const auto written = write_node(entry); !written) return written;
    }
    if (next_node_ != node_count_ || next_brick_ != brick_count_) return Error::kBadSize;
    return {};
  }

 private:
  Result<void> write_node(std::uint64_t entry) {
    const std::uint32_t* old = before_.nodes + std::size_t{before_.root[entry]} * kBricksPerNode;
    std::array<std::uint32_t, kBricksPerNode> node;
    for (std::size_t slot = 0; slot < kBricksPerNode; ++slot) {
      const bool changed = changes_.cell() == entry * kBricksPerNode + slot;
      std::uint32_t number = changed ? changes_.kind() : old[slot];
      const std::uint8_t* old_brick = reinterpret_cast<const std::uint8_t*>(before_.bricks + std::size_t{old[slot]} * kSamplesPerBrick);
      const std::uint8_t old_part = parts_ != nullptr ? before_.stiffness_parts[old[slot]] : std::uint8_t{0};
      if (number <= kInside) {
        if (changed && number == old[slot]) return Error::kBadPatch;
      } else {
        const std::uint8_t* brick = changed ? changes_.brick() : old_brick;
        const std::uint8_t part = changed && parts_ != nullptr ? changes_.stiffness() : old_part;
        if (changed && part == old_part && std::memcmp(brick, old_brick, kBrickBytes) == 0) return Error::kBadPatch;
        if (next_brick_ == brick_count_) return Error::kBadSize;
        std::memcpy(bricks_ + std::size_t{next_brick_} * kBrickBytes, brick, kBrickBytes);
        if (parts_ != nullptr) parts_[next_brick_] = part;
        number = next_brick_++;
      }
      node[slot] = number;
      if (changed) changes_.advance();
    }
    if (node[0] <= kInside && std::all_of(node.begin(), node.end(), [&](std::uint32_t n) { return n == node[0]; })) {
      root_[entry] = node[0];
      return {};
    }
    if (next_node_ == node_count_) return Error::kBadSize;
    std::copy(node.begin(), node.end(), nodes_ + std::size_t{next_node_} * kBricksPerNode);
    root_[entry] = next_node_++;
    return {};
  }

  const FieldView& before_;
  Changes changes_;
  std::uint32_t *root_, *nodes_;
  std::uint8_t *bricks_, *parts_;
  std::uint32_t node_count_, brick_count_;
  std::uint32_t next_node_ = 2, next_brick_ = 2;
};

}  // namespace

bool FieldPatch::has_magic(std::span<const std::uint8_t> bytes) { return isotouch::has_magic(kForm, bytes); }

std::size_t FieldPatch::patch_bytes() const { return patch_layout::kHeaderBytes + cells.size() + bricks.size() + stiffness.size(); }

std::size_t FieldPatch::image_bytes() const {
  return static_cast<std::size_t>(load_le<std::uint64_t>(image_header.data() + image_layout::kTotalBytesAt));
}

std::uint32_t FieldPatch::stiffness_at() const { return load_le<std::uint32_t>(image_header.data() + image_layout::kStiffnessTableAt); }

Result<FieldPatch> FieldPatch::parse(std::span<const std::uint8_t> bytes) {
  if (const auto error = refused(kForm, bytes)) return *error;
  const std::uint8_t* at = bytes.data();

  FieldPatch patch;
  patch.hash_before = load_le<std::uint64_t>(at + kHashBeforeAt);
  patch.hash_after = load_le<std::uint64_t>(at + kHashAfterAt);
  patch.image_header = bytes.subspan(kImageHeaderAt, image_layout::kHeaderBytes);
  const auto after =
      FieldView::of_header(patch.image_header, load_le<std::uint64_t>(patch.image_header.data() + image_layout::kTotalBytesAt));
  if (!after) return after.error();
  if (after->method != Method::kDefault) return Error::kBadHeader;
  patch.after = *after;

  const std::uint64_t cells = load_le<std::uint32_t>(at + kCellsAt), stored = load_le<std::uint32_t>(at + kStoredAt);
  const std::uint64_t parts = patch.stiffness_at() != 0 ? stored : 0;
  if (bytes.size() != kHeaderBytes + 4 * cells + kBrickBytes * stored + parts) return Error::kBadSize;
  auto part = [&bytes, from = kHeaderBytes](std::uint64_t size) mutable {
    const auto span = bytes.subspan(from, static_cast<std::size_t>(size));
    from += span.size();
    return span;
  };
  patch.cells = part(4 * cells);
  patch.bricks = part(kBrickBytes * stored);
  patch.stiffness = part(parts);
  if (patch.hash_before == patch.hash_after || !are_cells(patch)) return Error::kBadPatch;
  return patch;
}

bool on_one_grid(std::span<const std::uint8_t> before, std::span<const std::uint8_t> after) {
  using namespace image_layout;
  const auto agree = [&](std::size_t from, std::size_t to) {
    return std::equal(before.data() + from, before.data() + to, after.data() + from);
  };
  const auto has_table = [](std::span<const std::uint8_t> header) { return load_le<std::uint32_t>(&header[kStiffnessTableAt]) != 0; };
  return agree(0, image_layout::kChecksumAt) && agree(kOriginAt, kNodeCountAt) && agree(kRootOffsetAt, kBrickOffsetAt) &&
         agree(kMethodAt, kPointCountAt) && agree(kScaleAt, kMaxSlopeAt) && agree(kInterpolationAt, image_layout::kHeaderBytes) &&
         has_table(before) == has_table(after);
}

Result<std::span<const std::uint8_t>> apply(const FieldPatch& patch, const FieldView& before, std::span<std::uint8_t> image) {
  if (!on_one_grid(before.image, patch.image_header) || before.hash() != patch.hash_before) return Error::kOtherField;
  if (image.size() != patch.image_bytes()) return Error::kBadSize;

  const std::size_t bricks_at = load_le<std::uint32_t>(patch.image_header.data() + image_layout::kBrickOffsetAt);
  std::fill_n(image.begin(), bricks_at, std::uint8_t{0});  // the bytes between the tables
  std::copy(patch.image_header.begin(), patch.image_header.end(), image.begin());
  if (const auto written = ImageWriter(patch, before, image.data()).write(); !written) return written.error();
  if (hash64(image.data(), image.size()) != patch.hash_after) return Error::kBadChecksum;
  return std::span<const std::uint8_t>(image);
}

}  // namespace isotouch
