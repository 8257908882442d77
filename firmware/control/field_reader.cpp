#include "firmware/control/field_reader.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace isotouch::control {

namespace {
constexpr const char* kFromTheFront = "; begin with its first byte";
}

Refusal FieldReader::begin(const ControlClient& client, const protocol::ReadImage& wanted, std::int64_t now_ns) {
  if (reader_ != nullptr && reader_ != &client && now_ns < due_ns_)
    return "another client is reading the field; try again when that has ended";
  reader_ = &client;
  return want(wanted, now_ns);
}

Refusal FieldReader::go_on(const ControlClient& client, const protocol::ReadImage& wanted, std::int64_t now_ns) {
  if (reader_ != &client || fields_.copied().empty())
    return std::string("no field is being read on this connection, or another one was loaded") + kFromTheFront;
  if (wanted.offset >= fields_.copied().size()) return std::string("the field has fewer bytes") + kFromTheFront;
  return want(wanted, now_ns);
}

Refusal FieldReader::want(const protocol::ReadImage& wanted, std::int64_t now_ns) {
  if (wanted.bytes == 0 || wanted.bytes > protocol::kMaxChunk)
    return "a part of a field has 1 to " + std::to_string(protocol::kMaxChunk) + " bytes; install the same release on both sides";
  wanted_ = wanted;
  due_ns_ = now_ns + kPatienceNs;
  return {};
}

protocol::ImagePart FieldReader::part() {
  const std::span<const std::uint8_t> rest = fields_.copied().subspan(static_cast<std::size_t>(wanted_.offset));
  const std::span<const std::uint8_t> bytes = rest.first(std::min<std::size_t>(rest.size(), wanted_.bytes));
  if (bytes.size() == rest.size()) reader_ = nullptr;
  return {fields_.copied_hash(), fields_.copied().size(), wanted_.offset, bytes};
}

void FieldReader::drop(const ControlClient& client) {
  if (reader_ == &client) reader_ = nullptr;
}

}  // namespace isotouch::control
