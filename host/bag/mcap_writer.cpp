#include "host/bag/mcap_writer.h"

#include <zstd.h>

#include <algorithm>
#include <concepts>
#include <stdexcept>

#include "host/bag/mcap_format.h"
#include "shared/crc32.h"

namespace isotouch::bag {

namespace {

constexpr std::size_t kChunkBytes = 1 << 20;
constexpr int kLevel = 3;

/// A record in the making.
class Content {
 public:
  template <std::unsigned_integral T>
  Content& add(T value) {
    for (std::size_t i = 0; i < sizeof value; ++i) bytes_.push_back(static_cast<std::uint8_t>(std::uint64_t{value} >> (8 * i)));
    return *this;
  }
  Content& add(std::string_view text) {
    add(static_cast<std::uint32_t>(text.size()));
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    return *this;
  }
  Content& raw(std::span<const std::uint8_t> data) {
    bytes_.insert(bytes_.end(), data.begin(), data.end());
    return *this;
  }
  /// After 32 bits with their length.
  Content& sized(const Content& other) { return add(static_cast<std::uint32_t>(other.bytes_.size())).raw(other.bytes_); }
  const Bytes& bytes() const { return bytes_; }

 private:
  Bytes bytes_;
};

void write(Bytes& to, Record kind, const Content& content) {
  const Bytes head = Content().add(static_cast<std::uint8_t>(kind)).add(std::uint64_t{content.bytes().size()}).bytes();
  to.insert(to.end(), head.begin(), head.end());
  to.insert(to.end(), content.bytes().begin(), content.bytes().end());
}

Bytes compressed(const Bytes& bytes) {
  Bytes packed(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), kLevel);
  if (ZSTD_isError(size) != 0) throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(size));
  packed.resize(size);
  return packed;
}

}  // namespace

McapWriter::McapWriter(std::string_view library) : file_(kMcapMagic.begin(), kMcapMagic.end()) {
  write(file_, Record::kHeader, Content().add(std::string_view()).add(library));
}

std::uint16_t McapWriter::schema(std::string_view name, std::string_view encoding, std::string_view data) {
  const auto number = ++schemas_;
  const Content content = Content().add(number).add(name).add(encoding).add(data);
  write(chunk_.records, Record::kSchema, content);
  write(summary_.schemas, Record::kSchema, content);
  return number;
}

std::uint16_t McapWriter::channel(std::uint16_t schema, std::string_view topic, std::string_view encoding) {
  const auto number = static_cast<std::uint16_t>(counts_.size() + 1);
  counts_[number] = 0;
  const Content content = Content().add(number).add(schema).add(topic).add(encoding).sized({});
  write(chunk_.records, Record::kChannel, content);
  write(summary_.channels, Record::kChannel, content);
  return number;
}

void McapWriter::message(std::uint16_t channel, std::uint64_t time_ns, std::span<const std::uint8_t> data) {
  if (messages_++ == 0) from_ns_ = time_ns;
  to_ns_ = time_ns;
  if (chunk_.index.empty()) chunk_.from_ns = time_ns;
  chunk_.to_ns = time_ns;
  chunk_.index[channel].emplace_back(time_ns, chunk_.records.size());
  const auto sequence = static_cast<std::uint32_t>(counts_[channel]++);
  write(chunk_.records, Record::kMessage, Content().add(channel).add(sequence).add(time_ns).add(time_ns).raw(data));
  if (chunk_.records.size() >= kChunkBytes) end_chunk();
}

void McapWriter::end_chunk() {
  if (chunk_.records.empty()) return;
  const std::uint64_t start = file_.size();
  const Bytes packed = compressed(chunk_.records);
  write(file_, Record::kChunk,
        Content()
            .add(chunk_.from_ns)
            .add(chunk_.to_ns)
            .add(std::uint64_t{chunk_.records.size()})
            .add(crc32(chunk_.records.data(), chunk_.records.size()))
            .add(std::string_view("zstd"))
            .add(std::uint64_t{packed.size()})
            .raw(packed));
  const std::uint64_t length = file_.size() - start;
  Content offsets;
  const std::uint64_t indices = file_.size();
  for (const auto& [channel, messages] : chunk_.index) {
    offsets.add(channel).add(std::uint64_t{file_.size()});
    Content entries;
    for (const auto& [time, offset] : messages) entries.add(time).add(offset);
    write(file_, Record::kMessageIndex, Content().add(channel).sized(entries));
  }
  write(summary_.chunks, Record::kChunkIndex,
        Content()
            .add(chunk_.from_ns)
            .add(chunk_.to_ns)
            .add(start)
            .add(length)
            .sized(offsets)
            .add(std::uint64_t{file_.size() - indices})
            .add(std::string_view("zstd"))
            .add(std::uint64_t{packed.size()})
            .add(std::uint64_t{chunk_.records.size()}));
  ++chunks_;
  chunk_ = {};
}

void McapWriter::attach(std::string_view name, std::string_view media_type, std::span<const std::uint8_t> data) {
  end_chunk();
  const std::uint64_t start = file_.size();
  Content content =
      Content().add(std::uint64_t{0}).add(std::uint64_t{0}).add(name).add(media_type).add(std::uint64_t{data.size()}).raw(data);
  content.add(crc32(content.bytes().data(), content.bytes().size()));
  write(file_, Record::kAttachment, content);
  write(summary_.attachments, Record::kAttachmentIndex,
        Content()
            .add(start)
            .add(std::uint64_t{file_.size() - start})
            .add(std::uint64_t{0})
            .add(std::uint64_t{0})
            .add(std::uint64_t{data.size()})
            .add(name)
            .add(media_type));
  ++attachments_;
}

Bytes McapWriter::finish() {
  end_chunk();
  write(file_, Record::kDataEnd, Content().add(std::uint32_t{0}));
  const std::uint64_t summary = file_.size();
  Content counts;
  for (const auto& [channel, count] : counts_) counts.add(channel).add(count);
  Bytes statistics;
  write(statistics, Record::kStatistics,
        Content()
            .add(messages_)
            .add(schemas_)
            .add(static_cast<std::uint32_t>(counts_.size()))
            .add(attachments_)
            .add(std::uint32_t{0})
            .add(chunks_)
            .add(from_ns_)
            .add(to_ns_)
            .sized(counts));
  Bytes offsets;
  const auto group = [&](Record kind, const Bytes& records) {
    if (records.empty()) return;
    write(offsets, Record::kSummaryOffset,
          Content().add(static_cast<std::uint8_t>(kind)).add(std::uint64_t{file_.size()}).add(std::uint64_t{records.size()}));
    file_.insert(file_.end(), records.begin(), records.end());
  };
  group(Record::kSchema, summary_.schemas);
  group(Record::kChannel, summary_.channels);
  group(Record::kStatistics, statistics);
  group(Record::kChunkIndex, summary_.chunks);
  group(Record::kAttachmentIndex, summary_.attachments);
  const std::uint64_t offset_start = file_.size();
  file_.insert(file_.end(), offsets.begin(), offsets.end());
  const Content before = Content().add(summary).add(offset_start);
  Bytes sealed(file_.begin() + static_cast<std::ptrdiff_t>(summary), file_.end());
  write(sealed, Record::kFooter, Content(before).add(std::uint32_t{0}));
  const std::uint32_t crc = crc32(sealed.data(), sealed.size() - sizeof(std::uint32_t));
  write(file_, Record::kFooter, Content(before).add(crc));
  file_.insert(file_.end(), kMcapMagic.begin(), kMcapMagic.end());
  return std::move(file_);
}

}  // namespace isotouch::bag
