#include "hil/falcon_model/packets.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace isotouch::falcon_model {
namespace {

PacketBytes bytes_of(const std::string& text) {
  PacketBytes bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(text.at(i));
  return bytes;
}

struct Command {
  const char* bytes;
  std::array<std::int16_t, 3> motors;
  unsigned flags;
};

// Worked vectors, then packets that the vendor's program sent.
constexpr Command kCommands[] = {
    {"<AAAAAAAAAAAAAA>", {0, 0, 0}, 0},
    {"<IODAADIPPPPADA>", {1000, -2000, 4095}, 3},
    {"\x3c\x50\x50\x50\x50\x42\x41\x41\x41\x41\x41\x41\x50\x49\x41\x3e", {-1, 1, -4096}, 8},
    {"\x3c\x4a\x4c\x45\x41\x4a\x4c\x45\x41\x4a\x4c\x45\x41\x46\x41\x3e", {1209, 1209, 1209}, 5},
    {"\x3c\x50\x50\x50\x48\x41\x41\x41\x49\x41\x41\x42\x41\x4f\x41\x3e", {32767, -32768, 256}, 14},
    {"\x3c\x50\x50\x50\x41\x43\x45\x50\x41\x43\x4d\x50\x41\x45\x41\x3e", {4095, 3906, 4034}, 4},
    {"\x3c\x41\x4d\x4b\x41\x4d\x4e\x4b\x41\x49\x45\x4c\x41\x45\x41\x3e", {2752, 2780, 2888}, 4},
    {"\x3c\x50\x42\x46\x41\x4e\x4b\x46\x41\x47\x50\x46\x41\x45\x41\x3e", {1311, 1453, 1526}, 4},
    {"\x3c\x46\x4a\x43\x41\x4c\x4e\x43\x41\x4f\x50\x43\x41\x45\x41\x3e", {661, 731, 766}, 4},
    {"\x3c\x4d\x4b\x45\x50\x4c\x42\x41\x41\x42\x4b\x44\x41\x45\x41\x3e", {-2900, 27, 929}, 4},
    {"\x3c\x50\x49\x42\x41\x42\x50\x44\x50\x50\x47\x45\x41\x45\x41\x3e", {399, -3087, 1135}, 4},
    {"\x3c\x50\x4c\x50\x50\x49\x49\x41\x41\x42\x47\x50\x50\x45\x41\x3e", {-65, 136, -159}, 4},
    {"\x3c\x4a\x46\x4e\x50\x42\x4f\x4a\x41\x4b\x4c\x49\x50\x45\x41\x3e", {-679, 2529, -1862}, 4},
    {"\x3c\x42\x4c\x4a\x41\x44\x47\x4e\x50\x46\x47\x4a\x50\x45\x41\x3e", {2481, -669, -1691}, 4},
};

struct Reply {
  const char* bytes;
  ReplyPacket packet;
};

const Reply kReplies[] = {
    {"\x3c\x4d\x50\x4e\x50\x4d\x50\x4e\x50\x4d\x50\x4e\x50\xb1\x41\x3e", {{-516, -516, -516}, 0, 7}},
    {"\x3c\x48\x4b\x46\x41\x4a\x46\x4b\x50\x4d\x41\x41\x41\xb5\x41\x3e", {{1447, -1447, 12}, 4, 7}},
    {"\x3c\x4d\x42\x50\x50\x4f\x42\x4d\x50\x45\x4f\x50\x50\x42\x41\x3e", {{-228, -994, -28}, 1, 0}},
    {"\x3c\x4a\x45\x4b\x50\x4a\x45\x4b\x50\x4a\x45\x4b\x50\x80\x41\x3e", {{-1463, -1463, -1463}, 15, 3}},
    {"\x3c\x46\x48\x42\x41\x43\x4f\x4d\x50\x46\x47\x43\x41\xbb\x41\x3e", {{373, -798, 613}, 10, 7}},
    {"<HNGPOKOPFPOPAA>", {{-2345, -338, -267}, 0, 0}},
};

TEST(Packets, CommandsAreReadAsTheSheetSays) {
  for (const Command& vector : kCommands) {
    const auto packet = decode_command(bytes_of(vector.bytes));
    ASSERT_TRUE(packet.has_value()) << vector.bytes;
    EXPECT_EQ(packet->motors, vector.motors);
    EXPECT_EQ(packet->homing, (vector.flags & 1) != 0);
    EXPECT_EQ(packet->leds, vector.flags >> 1);
  }
}

TEST(Packets, RepliesAreWrittenAsTheSheetSays) {
  for (const Reply& vector : kReplies) EXPECT_EQ(encode_reply(vector.packet), bytes_of(vector.bytes));
}

TEST(Packets, EveryWrongByteIsNoCommand) {
  const PacketBytes good = bytes_of("<IODAADIPPPPADA>");
  for (std::size_t i = 0; i < good.size(); ++i) {
    for (const int wrong : {0x00, 0x40, 0x51, 0xB1}) {
      PacketBytes bytes = good;
      bytes[i] = static_cast<std::uint8_t>(wrong);
      EXPECT_FALSE(decode_command(bytes).has_value()) << i;
    }
  }
}

TEST(Packets, TheScannerFindsPacketsAfterAnythingElse) {
  const std::string whole = "<IODAADIPPPPADA>";
  for (const std::string& before :
       {std::string(), std::string("AAA>"), whole.substr(0, 14), whole.substr(3), std::string("<<<"), std::string("<AAAAAAAAAAAAA<")}) {
    PacketScanner scanner;
    int found = 0;
    for (const char c : before + whole + whole) {
      if (const auto packet = scanner.push(static_cast<std::uint8_t>(c))) {
        ++found;
        EXPECT_EQ(packet->motors, (std::array<std::int16_t, 3>{1000, -2000, 4095}));
      }
    }
    EXPECT_EQ(found, 2) << before;
  }
}

}  // namespace
}  // namespace isotouch::falcon_model
