#include "shared/falcon_packet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/random.h"

namespace isotouch {
namespace {

FalconPacket packet(const std::string& text) {
  EXPECT_EQ(text.size(), kFalconPacketBytes);
  FalconPacket bytes{};
  std::copy(text.begin(), text.end(), bytes.begin());
  return bytes;
}

TEST(FalconPacket, CommandsStandAsPublished) {
  const std::vector<std::pair<FalconCommand, std::string>> rows = {
      {{{0, 0, 0}, 0}, "<AAAAAAAAAAAAAA>"},
      {{{1000, -2000, 4095}, 0x03}, "<IODAADIPPPPADA>"},
      {{{-1, 1, -4096}, 0x08}, "<PPPPBAAAAAAPIA>"},
      {{{1209, 1209, 1209}, 0x05}, "<JLEAJLEAJLEAFA>"},
      {{{32767, -32768, 256}, 0x0E}, "<PPPHAAAIAABAOA>"},
      // Recorded from the vendor's program.
      {{{4095, 3906, 4034}, 0x04}, "<PPPACEPACMPAEA>"},
      {{{2752, 2780, 2888}, 0x04}, "<AMKAMNKAIELAEA>"},
      {{{1311, 1453, 1526}, 0x04}, "<PBFANKFAGPFAEA>"},
      {{{661, 731, 766}, 0x04}, "<FJCALNCAOPCAEA>"},
      {{{-2900, 27, 929}, 0x04}, "<MKEPLBAABKDAEA>"},
      {{{399, -3087, 1135}, 0x04}, "<PIBABPDPPGEAEA>"},
      {{{-65, 136, -159}, 0x04}, "<PLPPIIAABGPPEA>"},
      {{{-679, 2529, -1862}, 0x04}, "<JFNPBOJAKLIPEA>"},
      {{{2481, -669, -1691}, 0x04}, "<BLJADGNPFGJPEA>"},
  };
  for (const auto& [command, text] : rows) {
    EXPECT_EQ(encode(command), packet(text)) << text;
    const Result<FalconCommand> read = decode_command(packet(text));
    ASSERT_TRUE(read) << text;
    EXPECT_EQ(*read, command) << text;
  }
}

TEST(FalconPacket, RepliesStandAsPublished) {
  const std::vector<std::pair<FalconReply, std::string>> rows = {
      {{{-516, -516, -516}, 0, 7}, "<MPNPMPNPMPNP\xb1\x41>"}, {{{1447, -1447, 12}, 4, 7}, "<HKFAJFKPMAAA\xb5\x41>"},
      {{{-228, -994, -28}, 1, 0}, "<MBPPOBMPEOPP\x42\x41>"},  {{{-1463, -1463, -1463}, 0xF, 3}, "<JEKPJEKPJEKP\x80\x41>"},
      {{{373, -798, 613}, 0xA, 7}, "<FHBACOMPFGCA\xbb\x41>"}, {{{-2345, -338, -267}, 0, 0}, "<HNGPOKOPFPOPAA>"},
  };
  for (const auto& [reply, text] : rows) {
    EXPECT_EQ(encode(reply), packet(text));
    const Result<FalconReply> read = decode_reply(packet(text));
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, reply);
  }
}

TEST(FalconPacket, EveryNumberComesBack) {
  for (int value = -32768; value <= 32767; ++value) {
    const auto v = static_cast<std::int16_t>(value);
    const FalconCommand command = {{v, static_cast<std::int16_t>(~v), 7}, static_cast<std::uint8_t>(value & 0x0F)};
    const Result<FalconCommand> read = decode_command(encode(command));
    ASSERT_TRUE(read);
    ASSERT_EQ(*read, command);
  }
}

TEST(FalconPacket, EveryByteIsTakenOnlyInItsRange) {
  const FalconPacket good = encode(FalconReply{{1447, -1447, 12}, 5, 7});
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (int value = 0; value < 256; ++value) {
      FalconPacket bytes = good;
      bytes[at] = static_cast<std::uint8_t>(value);
      const bool may = at == 0 ? value == '<' : at == 15 ? value == '>' : value >= 0x41 && value <= (at == 13 ? 0xC0 : 0x50);
      EXPECT_EQ(decode_reply(bytes).has_value(), may) << at << ' ' << value;
      const bool may_command = may && (at != 13 || value <= 0x50);
      bytes[13] = at == 13 ? bytes[13] : 0x41;
      EXPECT_EQ(decode_command(bytes).has_value(), may_command) << at << ' ' << value;
    }
  }
}

TEST(FalconPacket, APacketThatLostBytesIsRefused) {
  const FalconPacket good = encode(FalconReply{{1447, -1447, 12}, 5, 7});
  for (std::size_t lost = 1; lost < 16; ++lost) {
    for (std::size_t from = 0; from + lost <= 16; ++from) {
      std::vector<std::uint8_t> stream(good.begin(), good.end());
      stream.erase(stream.begin() + static_cast<std::ptrdiff_t>(from), stream.begin() + static_cast<std::ptrdiff_t>(from + lost));
      stream.insert(stream.end(), good.begin(), good.end());
      FalconPacket bytes{};
      std::copy_n(stream.begin(), bytes.size(), bytes.begin());
      const Result<FalconReply> read = decode_reply(bytes);
      ASSERT_FALSE(read) << from << ' ' << lost;
      EXPECT_EQ(read.error(), Error::kBadPacket);
    }
  }
}

}  // namespace
}  // namespace isotouch
