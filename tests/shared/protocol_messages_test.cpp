#include "shared/protocol_messages.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace isotouch::protocol {
namespace {

template <class Message>
std::vector<std::uint8_t> body_of(const Message& message) {
  std::vector<std::uint8_t> frame(kMaxFrame);
  frame.resize(encode(Kind::kDone, message, frame));
  const Result<Frame> read = read_frame(frame);
  EXPECT_TRUE(read);
  return {read->body.begin(), read->body.end()};
}

/// Written, read and written again: the same bytes, and so many of them.
template <class Message>
void expect_round_trip(const Message& message, std::size_t bytes) {
  const std::vector<std::uint8_t> body = body_of(message);
  EXPECT_EQ(body.size(), bytes);
  const Result<Message> read = decode<Message>(body);
  ASSERT_TRUE(read);
  EXPECT_EQ(body_of(*read), body);
}

TEST(ProtocolMessages, EveryMessageComesBack) {
  const std::vector<std::uint8_t> some = {1, 2, 3, 250};
  expect_round_trip(Hello{1, 7}, 4);
  expect_round_trip(Welcome{1, 0, 1'000'000, 1U << 24, Text::of("isotouchd 0.1.0"), 2}, 33);
  expect_round_trip(Begin{466'000, 1'563'000, 0x0123456789ABCDEFU, Text::of("hydrant")}, 32);
  expect_round_trip(Chunk{65'536, some}, 12);
  expect_round_trip(Accepted{0xFEDCBA9876543210U, 3}, 12);
  StatusReport status{4, 2, 3, 1'000'000, 5, 0xAAAAAAAAAAAAAAAAU, 1, 2, {}, 0x01020304, 5, 6, Text::of("owl")};
  for (std::uint32_t i = 0; i < kMeasures; ++i) status.measures[i] = {10 + i, 20 + i, 30 + i};
  expect_round_trip(status, 107);
  expect_round_trip(SettingsReport{0x0102030405060708U, some}, 12);
  expect_round_trip(HistogramRequest{2}, 1);
  expect_round_trip(Bin{12'000, 99}, kBinBytes);
  expect_round_trip(HistogramReport{2, 99, some}, 13);
  expect_round_trip(WorstRequest{1}, 1);
  expect_round_trip(WorstTick{7, -1, 12'000, 9'000}, kWorstTickBytes);
  expect_round_trip(WorstTicks{1000, some}, 12);
  expect_round_trip(Subscribe{10}, 4);
  expect_round_trip(Recording{some}, 4);
  expect_round_trip(Records{77, 1, 72, 0, some}, 28);
  expect_round_trip(FieldEntry{5, 6, 1, Text::of("owl")}, 21);
  expect_round_trip(FieldList{1, some}, 6);
  expect_round_trip(Select{9}, 8);
  expect_round_trip(Refusal{2, some}, 5);
}

TEST(ProtocolMessages, AMessageStandsAsPublished) {
  const std::vector<std::uint8_t> expected = {0x10, 0x27, 0,    0,    0,    0,    0,    0,    1,    0,    0, 0,   0,   0,
                                              0,    0,    0xEF, 0xCD, 0xAB, 0x89, 0x67, 0x45, 0x23, 0x01, 3, 'o', 'w', 'l'};
  EXPECT_EQ(body_of(Begin{10'000, 1, 0x0123456789ABCDEFU, Text::of("owl")}), expected);
}

TEST(ProtocolMessages, ABodyThatIsTooShortIsRefusedAndALongerOneIsNot) {
  const std::vector<std::uint8_t> body = body_of(Begin{1, 2, 3, Text::of("owl")});
  for (std::size_t size = 0; size < body.size(); ++size) {
    const std::vector<std::uint8_t> cut(body.begin(), body.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_FALSE(decode<Begin>(cut)) << size;
  }
  std::vector<std::uint8_t> longer = body;
  longer.push_back(42);
  const Result<Begin> read = decode<Begin>(longer);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->name.view(), "owl");
}

TEST(ProtocolMessages, TextsThatWouldDriveATerminalAreRefusedAndNeverMade) {
  EXPECT_EQ(Text::of("a\x1b[2Jb\nc\x7f").view(), "a [2Jb c ");
  EXPECT_EQ(Text::of(std::string(200, 'x')).view(), std::string(kMaxName, 'x'));
  std::vector<std::uint8_t> body = body_of(Begin{1, 2, 3, Text::of("owl")});
  body.back() = '\n';
  EXPECT_EQ(decode<Begin>(body).error(), Error::kBadMessage);
  body.back() = 'l';
  body[body.size() - 4] = 64;  // a longer text than there may be
  body.resize(body.size() + 64, 'x');
  EXPECT_EQ(decode<Begin>(body).error(), Error::kBadMessage);
}

TEST(ProtocolMessages, NoBodyMakesAMessageReachBeyondIt) {
  std::mt19937 random(11);
  int read = 0;
  for (int round = 0; round < 20'000; ++round) {
    std::vector<std::uint8_t> body(random() % 100);
    for (std::uint8_t& byte : body) byte = static_cast<std::uint8_t>(random() % (round % 2 == 0 ? 256 : 8));
    body.shrink_to_fit();
    read += decode<Begin>(body).has_value() + decode<Welcome>(body).has_value() + decode<FieldEntry>(body).has_value();
    if (const Result<Records> records = decode<Records>(body)) {
      ++read;
      ASSERT_LE(records->bytes.size(), body.size());
    }
    read += decode<StatusReport>(body).has_value() + decode<SettingsReport>(body).has_value();
  }
  EXPECT_GT(read, 1000);
}

}  // namespace
}  // namespace isotouch::protocol
