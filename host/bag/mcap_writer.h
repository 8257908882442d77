/// Writes an MCAP file: messages of several channels in compressed chunks, with the indices by which a viewer jumps to a time.
///
/// source    MCAP format specification, version 0, mcap.dev/spec
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isotouch::bag {

using Bytes = std::vector<std::uint8_t>;

class McapWriter {
 public:
  /// library   name and version of the program that writes
  explicit McapWriter(std::string_view library);

  /// data      the schema itself, in the language `encoding` ("jsonschema")
  /// returns   its number for `channel`
  std::uint16_t schema(std::string_view name, std::string_view encoding, std::string_view data);
  /// returns   its number for `message`
  std::uint16_t channel(std::uint16_t schema, std::string_view topic, std::string_view encoding);
  /// time_ns   log time, ns since 1970 or since the recording's beginning; never less than that of the message before
  void message(std::uint16_t channel, std::uint64_t time_ns, std::span<const std::uint8_t> data);
  /// A whole file within the file.
  void attach(std::string_view name, std::string_view media_type, std::span<const std::uint8_t> data);

  /// The bytes of the file, complete. Nothing may follow.
  Bytes finish();

 private:
  struct Chunk {
    Bytes records;
    std::uint64_t from_ns = 0, to_ns = 0;
    std::map<std::uint16_t, std::vector<std::pair<std::uint64_t, std::uint64_t>>> index;  ///< time and offset by channel
  };
  struct Summary {
    Bytes schemas, channels, chunks, attachments;
  };

  void end_chunk();

  Bytes file_;
  Chunk chunk_;
  Summary summary_;
  std::map<std::uint16_t, std::uint64_t> counts_;  ///< messages by channel
  std::uint16_t schemas_ = 0;
  std::uint32_t attachments_ = 0, chunks_ = 0;
  std::uint64_t from_ns_ = 0, to_ns_ = 0, messages_ = 0;
};

}  // namespace isotouch::bag
