#include "host/bag/mcap_reader.h"

#include <zstd.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "host/bag/mcap_format.h"
#include "host/error.h"
#include "shared/bytes.h"
#include "shared/crc32.h"
#include "shared/zstd_frame.h"

namespace isotouch::bag {

namespace {

using Span = std::span<const std::uint8_t>;

constexpr std::uint64_t kMostUnpacked = std::uint64_t{1} << 30;
/// So much comes of each 4 bytes at most: they are the smallest block of zstd that says anything (RFC 8878, 3.1.1.2).
constexpr std::uint64_t kMostOfABlock = std::uint64_t{128} << 10, kLeastBlock = 4;

/// Takes values from the front; what is not there is zero, and spoils it.
class Taker {
 public:
  explicit Taker(Span bytes) : left_(bytes) {}

  template <class T>
  T number() {
    const Span bytes = take(sizeof(T));
    return bytes.empty() ? T{} : load_le<T>(bytes.data());
  }
  std::string_view text() {
    const Span bytes = take(number<std::uint32_t>());
    return {reinterpret_cast<const char*>(bytes.data()),
            bytes.size()};  // NOLINT(cppcoreguidelines-pro-type-reinterpret-cast): bytes as text
  }
  Span take(std::uint64_t size) {
    if (size > left_.size()) {
      spoilt_ = true;
      left_ = {};
      return {};
    }
    const Span taken = left_.first(static_cast<std::size_t>(size));
    left_ = left_.subspan(static_cast<std::size_t>(size));
    return taken;
  }
  Span rest() { return take(left_.size()); }
  bool is_spoilt() const { return spoilt_; }

 private:
  Span left_;
  bool spoilt_ = false;
};

class Reader {
 public:
  Reader(Span file, const std::string& name, const McapUses& uses) : file_(file), name_(name), uses_(uses) {}

  bool read() {
    bool is_data = true;  // behind the data stands what repeats a part of it
    for (at_ = kMcapMagic.size(); file_.size() - at_ >= kRecordHead;) {
      const auto kind = static_cast<Record>(file_[at_]);
      const auto size = load_le<std::uint64_t>(file_.data() + at_ + 1);
      if (size > file_.size() - at_ - kRecordHead) {
        if (has_end(file_)) refuse("is damaged: it is longer than the file; record it again, or repair it with the tool mcap");
        return false;
      }
      if (!is_data && is_of_data(kind))
        refuse("is damaged, or that before it: it stands behind the end of the data; record it again, or repair it with the tool mcap");
      if (is_data) take(kind, file_.subspan(at_ + kRecordHead, static_cast<std::size_t>(size)));
      if (kind == Record::kDataEnd) is_data = false;
      at_ += kRecordHead + static_cast<std::size_t>(size);
      if (kind == Record::kFooter) return ends_here();
    }
    return false;
  }

 private:
  static bool has_end(Span bytes) {
    return bytes.size() >= kMcapMagic.size() && std::equal(kMcapMagic.begin(), kMcapMagic.end(), bytes.end() - kMcapMagic.size());
  }

  static bool is_of_data(Record kind) {
    return kind == Record::kMessage || kind == Record::kChunk || kind == Record::kMessageIndex || kind == Record::kAttachment ||
           kind == Record::kDataEnd;
  }

  /// Behind the footer.
  bool ends_here() const {
    const Span rest = file_.subspan(at_);
    if (rest.size() < kMcapMagic.size()) return false;
    if (rest.size() == kMcapMagic.size() && has_end(rest)) return true;
    if (!has_end(rest.first(kMcapMagic.size())))
      refuse("should be the mark of the file's end; record it again, or repair it with the tool mcap");
    throw InputError(name_ + ": " + std::to_string(rest.size() - kMcapMagic.size()) +
                     " bytes follow its end; name one recording, or join several with: mcap merge");
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(name_ + ": the record at byte " + std::to_string(at_) + " " + what);
  }

  void take(Record kind, Span content) {
    switch (kind) {
      case Record::kSchema: return take_schema(content);
      case Record::kChannel: return take_channel(content);
      case Record::kMessage: return take_message(content);
      case Record::kChunk: return take_chunk(content);
      case Record::kAttachment: return take_attachment(content);
      default: return;  // what is not needed, and kinds of later versions
    }
  }

  void take_schema(Span content) {
    Taker from(content);
    const auto number = from.number<std::uint16_t>();
    const std::string_view name = from.text();
    if (from.is_spoilt()) refuse("is damaged: a schema ends before its stated size; record it again, or repair it with the tool mcap");
    schemas_[number] = name;
  }

  void take_channel(Span content) {
    Taker from(content);
    const auto number = from.number<std::uint16_t>(), schema = from.number<std::uint16_t>();
    const std::string_view topic = from.text(), encoding = from.text();
    if (from.is_spoilt()) refuse("is damaged: a channel ends before its stated size; record it again, or repair it with the tool mcap");
    const auto found = schemas_.find(schema);
    channels_[number] = {std::string(topic), found == schemas_.end() ? std::string() : found->second, std::string(encoding)};
  }

  void take_message(Span content) {
    Taker from(content);
    const auto channel = from.number<std::uint16_t>();
    from.number<std::uint32_t>();
    const auto time = from.number<std::uint64_t>();
    from.number<std::uint64_t>();
    const auto found = channels_.find(channel);
    if (from.is_spoilt() || found == channels_.end())
      refuse("is damaged: a message is too short, or names no channel; record it again, or repair it with the tool mcap");
    if (uses_.message) uses_.message({found->second.topic, found->second.schema, found->second.encoding}, time, from.rest());
  }

  void take_attachment(Span content) {
    if (content.size() < sizeof(std::uint32_t)) refuse("is damaged: an attachment is too short; record it again");
    Taker from(content.first(content.size() - sizeof(std::uint32_t)));
    from.number<std::uint64_t>();
    from.number<std::uint64_t>();
    const std::string_view name = from.text(), media_type = from.text();
    const Span data = from.take(from.number<std::uint64_t>());
    const auto crc = load_le<std::uint32_t>(content.data() + content.size() - sizeof(std::uint32_t));
    if (from.is_spoilt() || (crc != 0 && crc32(content.data(), content.size() - sizeof crc) != crc))
      refuse("is damaged: the checksum of an attachment does not match; record it again");
    if (uses_.attachment) uses_.attachment(name, media_type, data);
  }

  void take_chunk(Span content) {
    Taker from(content);
    from.number<std::uint64_t>();
    from.number<std::uint64_t>();
    const auto size = from.number<std::uint64_t>();
    const auto crc = from.number<std::uint32_t>();
    const std::string_view compression = from.text();
    const Span packed = from.take(from.number<std::uint64_t>());
    if (from.is_spoilt()) refuse("is damaged: a chunk ends before its stated size; record it again, or repair it with the tool mcap");
    if (compression.empty()) return take_records(packed, crc);
    if (compression != "zstd")
      refuse("is compressed with '" + std::string(compression.substr(0, 20)) + "'; convert it with: mcap compress --compression zstd");
    const std::optional<ZstdFrame> frame = read_zstd_frame(packed);
    if (size > kMostUnpacked || size > packed.size() / kLeastBlock * kMostOfABlock || (frame && frame->content_bytes != size))
      refuse("is damaged: the stated size of a chunk is not that of its content; record it again, or repair it with the tool mcap");
    std::vector<std::uint8_t> records(static_cast<std::size_t>(size));
    const std::size_t unpacked = ZSTD_decompress(records.data(), records.size(), packed.data(), packed.size());
    if (ZSTD_isError(unpacked) != 0 || unpacked != records.size())
      refuse("is damaged: a chunk does not unpack; record it again, or repair it with the tool mcap");
    take_records(records, crc);
  }

  void take_records(Span records, std::uint32_t crc) {
    if (crc != 0 && crc32(records.data(), records.size()) != crc)
      refuse("is damaged: the checksum of a chunk does not match; record it again, or repair it with the tool mcap");
    while (!records.empty()) {
      if (records.size() < kRecordHead) refuse("is damaged: a record within a chunk is cut off; record it again");
      const auto kind = static_cast<Record>(records[0]);
      const auto size = load_le<std::uint64_t>(records.data() + 1);
      if (size > records.size() - kRecordHead) refuse("is damaged: a record within a chunk is cut off; record it again");
      const Span content = records.subspan(kRecordHead, static_cast<std::size_t>(size));
      if (kind != Record::kChunk && kind != Record::kAttachment) take(kind, content);  // a chunk holds neither
      records = records.subspan(kRecordHead + static_cast<std::size_t>(size));
    }
  }

  struct Known {
    std::string topic, schema, encoding;
  };

  Span file_;
  const std::string& name_;
  const McapUses& uses_;
  std::size_t at_ = 0;  ///< byte of the record of the file under way, at its end of the next
  std::map<std::uint16_t, std::string> schemas_;
  std::map<std::uint16_t, Known> channels_;
};

}  // namespace

bool is_mcap(Span file) { return file.size() >= kMcapMagic.size() && std::equal(kMcapMagic.begin(), kMcapMagic.end(), file.begin()); }

bool read_mcap(Span file, const std::string& name, const McapUses& uses) {
  if (!is_mcap(file)) throw InputError(name + ": it is not an MCAP file; name one, or a table of times and positions");
  return Reader(file, name, uses).read();
}

}  // namespace isotouch::bag
