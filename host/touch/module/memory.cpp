#include "host/touch/module/memory.h"

extern "C" std::uint8_t __heap_base;  // the linker's: behind stack and data

namespace isotouch::touch {

namespace {

constexpr std::uint64_t kPage = 65536;
constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 32;

}  // namespace

std::uint8_t* block_begin() {
  return reinterpret_cast<std::uint8_t*>((reinterpret_cast<std::uintptr_t>(&__heap_base) + 63) & ~std::uintptr_t{63});
}

std::span<std::uint8_t> block_of(std::uint64_t bytes) {
  const std::uint64_t begin = reinterpret_cast<std::uintptr_t>(block_begin());
  if (bytes > kMaxBytes - begin - kPage) return {};
  const std::uint64_t pages = __builtin_wasm_memory_size(0), wanted = (begin + bytes + kPage - 1) / kPage;
  if (wanted > pages && __builtin_wasm_memory_grow(0, static_cast<std::size_t>(wanted - pages)) == SIZE_MAX) return {};
  return {block_begin(), static_cast<std::size_t>(bytes)};
}

}  // namespace isotouch::touch
