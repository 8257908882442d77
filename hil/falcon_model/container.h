/// Reads the firmware's container as the boot loader does, byte by byte: nothing is stored, only its form is followed.
///
/// Little-endian 16-bit words, 32-bit values high word first: 08AA, eight zero words, entry point; then blocks of size in words, destination
/// and data; a block of size 0 ends it.
/// source    TI SPRU095, TMS320F28x boot ROM, 8-bit data stream
#pragma once

#include <cstdint>

namespace isotouch::falcon_model {

class Container {
 public:
  enum class State { kReading, kComplete, kMalformed };

  State push(std::uint8_t byte);
  State state() const { return state_; }
  std::uint32_t entry_point() const { return entry_point_; }
  unsigned blocks() const { return blocks_; }

 private:
  void push_word(std::uint16_t word);

  State state_ = State::kReading;
  bool half_ = false;
  std::uint8_t low_ = 0;
  std::uint32_t words_ = 0;  ///< of header, or of the block at hand
  std::uint32_t block_words_ = 0;
  bool in_block_ = false;
  std::uint32_t entry_point_ = 0;
  unsigned blocks_ = 0;
};

}  // namespace isotouch::falcon_model
