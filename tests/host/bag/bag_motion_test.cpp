/// reference.mcap was written by @mcap/core 2 and @foxglove/rosmsg2-serialization: five PoseStamped on /hand and five WrenchStamped on /force, 10 ms apart,
/// recorded 3 ms after their stamps; x = i mm, y = -2i mm, z = 10 mm, force (0, i, -i/2) N.
#include "host/bag/bag_motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>
#include <string_view>

#include "host/bag/mcap_reader.h"
#include "host/bag/mcap_writer.h"
#include "host/bag/ros_message.h"
#include "host/error.h"
#include "host/files/whole_file.h"
#include "shared/bytes.h"

namespace isotouch::bag {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

const fs::path kReference = ISOTOUCH_BAGS "/reference.mcap";

fs::path in_temp(const std::string& name) { return fs::path(testing::TempDir()) / name; }

fs::path written(const std::string& name, const Bytes& bytes) {
  write_file(in_temp(name), bytes.data(), bytes.size());
  return in_temp(name);
}

std::string refusal_of(const fs::path& file, const BagTopics& topics = {}) {
  try {
    (void)read_bag_motion(file, topics);
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr(file.string()));
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
    return e.what();
  }
  return "nothing was refused";
}

/// The reference with its forces in the frame of its positions: as long, because what follows a frame's name begins at a multiple of eight bytes.
std::filesystem::path reference_in_one_frame() {
  Bytes bytes = read_file(kReference);
  const std::string_view tool("\6\0\0\0tool0\0", 10), base("\5\0\0\0base\0\0", 10);
  for (auto at = bytes.begin(); (at = std::search(at, bytes.end(), tool.begin(), tool.end())) != bytes.end();) {
    at = std::copy(base.begin(), base.end(), at);
  }
  std::size_t chunk = 8;
  while (bytes[chunk] != 6) chunk += 9 + load_le<std::uint64_t>(&bytes[chunk + 1]);
  std::fill_n(&bytes[chunk + 9 + 24], 4, std::uint8_t{0});  // without a checksum
  return written("one_frame.mcap", bytes);
}

TEST(Bag, PositionsAndForcesOfTheReferenceAreRead) {
  ASSERT_TRUE(is_bag(kReference));
  EXPECT_THAT(refusal_of(kReference, {.with_forces = true}), HasSubstr("in the coordinate frame 'base' and the forces in 'tool0'"));
  const auto points = read_bag_motion(reference_in_one_frame(), {.with_forces = true});
  ASSERT_EQ(points.size(), 5U);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto n = static_cast<double>(i);
    EXPECT_NEAR(points[i].time - points[0].time, 0.01 * n, 1e-6) << "the stamps of the messages";
    EXPECT_LT((points[i].position - Eigen::Vector3d(n, -2 * n, 10)).norm(), 1e-9);
    EXPECT_LT((points[i].force - Eigen::Vector3d(0, n, -n / 2)).norm(), 1e-6);
  }
}

TEST(Bag, WithoutForcesTheyAreNotAskedFor) {
  EXPECT_EQ(read_bag_motion(kReference, {})[3].force, Eigen::Vector3d::Zero());
  EXPECT_THAT(refusal_of(kReference, {.positions = "/hnad"}), HasSubstr("the topic /hnad does not have a position; choose one of /hand"));
}

/// A position as JSON on each topic, each at its own times.
Bytes with_topics(const std::vector<std::string>& topics, const std::string& text = R"({"point":{"x":1,"y":2,"z":3}})") {
  McapWriter writer("test");
  const auto schema = writer.schema("geometry_msgs/msg/PointStamped", "jsonschema", "{}");
  std::vector<std::uint16_t> channels;
  for (const std::string& topic : topics) channels.push_back(writer.channel(schema, topic, "json"));
  for (std::uint64_t i = 0; i < 3; ++i) {
    for (const std::uint16_t channel : channels) writer.message(channel, i * 1'000'000, Bytes(text.begin(), text.end()));
  }
  return writer.finish();
}

TEST(Bag, WhatMayBeMeantIsAskedFor) {
  const fs::path two = written("two.mcap", with_topics({"/a", "/b"}));
  EXPECT_THAT(refusal_of(two), HasSubstr("several topics have a position; choose one with --topic: /a, /b"));
  EXPECT_EQ(read_bag_motion(two, {.positions = "/b"}).size(), 3U);
  EXPECT_THAT(refusal_of(two, {.positions = "/a", .with_forces = true}), HasSubstr("none of its topics has a force"));
  EXPECT_THAT(refusal_of(written("none.mcap", with_topics({}))),
              HasSubstr("none of its topics has a position; these types of messages are read"));
}

TEST(Bag, AMessageThatIsNoPositionIsRefused) {
  for (const char* text : {"", "{", "[]", R"({"point":3})", R"({"point":{"x":1,"y":2}})", R"({"point":{"x":1,"y":2,"z":"3"}})",
                           R"({"point":{"x":1,"y":2,"z":1e999}})"})
    EXPECT_THAT(refusal_of(written("bad.mcap", with_topics({"/a"}, text))), HasSubstr("message 0 of /a cannot be read")) << text;
}

/// Positions every 10 ms of one second; forces of 2 N from one time to another.
Bytes with_forces(std::uint64_t from_ms, std::uint64_t to_ms) {
  McapWriter writer("test");
  const auto positions = writer.channel(writer.schema("geometry_msgs/msg/PointStamped", "jsonschema", "{}"), "/hand", "json");
  const auto forces = writer.channel(writer.schema("geometry_msgs/msg/WrenchStamped", "jsonschema", "{}"), "/force", "json");
  const std::string place = R"({"point":{"x":0,"y":0,"z":0}})", force = R"({"wrench":{"force":{"x":2,"y":0,"z":0}}})";
  for (std::uint64_t ms = 0; ms <= 1000; ms += 10) {
    writer.message(positions, ms * 1'000'000, Bytes(place.begin(), place.end()));
    if (ms >= from_ms && ms <= to_ms) writer.message(forces, ms * 1'000'000, Bytes(force.begin(), force.end()));
  }
  return writer.finish();
}

TEST(Bag, WhereNoForceWasRecordedThereIsNone) {
  const BagTopics topics{.with_forces = true};
  EXPECT_EQ(read_bag_motion(written("whole.mcap", with_forces(50, 950)), topics).back().force.x(), 2.0);
  EXPECT_THAT(refusal_of(written("late.mcap", with_forces(400, 1000)), topics),
              HasSubstr("no force within 0.1 s of the position at 0 s; the forces are from 0.4 to 1 s"));
  EXPECT_THAT(refusal_of(written("early.mcap", with_forces(0, 600)), topics), HasSubstr("of the position at 0.71 s"));
}

TEST(Bag, PositionsMayHaveAnotherUnit) { EXPECT_NEAR(read_bag_motion(kReference, {.mm_per_unit = 1})[3].position.x(), 0.003, 1e-9); }

/// A simulation's clock begins at zero.
TEST(Bag, AStampOfZeroIsOneWhereOthersAreNot) {
  for (const bool all : {false, true}) {
    McapWriter writer("test");
    const auto channel = writer.channel(writer.schema("geometry_msgs/PointStamped", "jsonschema", "{}"), "/a", "json");
    for (std::uint64_t i = 0; i < 3; ++i) {
      const std::string text =
          R"({"header":{"stamp":{"sec":0,"nanosec":)" + std::to_string(all ? 0 : i * 10'000'000) + R"(}},"point":{"x":1,"y":2,"z":3}})";
      writer.message(channel, i * 20'000'000, Bytes(text.begin(), text.end()));
    }
    EXPECT_NEAR(read_bag_motion(written("zero.mcap", writer.finish()), {})[2].time, all ? 0.04 : 0.02, 1e-12);
  }
}

TEST(Bag, TheStampOfAJsonMessageCounts) {
  McapWriter writer("test");
  const auto channel = writer.channel(writer.schema("geometry_msgs/PointStamped", "jsonschema", "{}"), "/a", "json");
  for (std::uint64_t i = 0; i < 3; ++i) {
    const std::string text =
        R"({"header":{"stamp":{"sec":1700000000,"nanosec":)" + std::to_string(i * 10'000'000) + R"(}},"point":{"x":1,"y":2,"z":3}})";
    writer.message(channel, i * 100'000, Bytes(text.begin(), text.end()));
  }
  const auto points = read_bag_motion(written("stamped.mcap", writer.finish()), {});
  EXPECT_NEAR(points[2].time, 0.02, 1e-12);
}

TEST(Bag, OtherVectorsAndOtherBodiesAreNoHand) {
  const auto with = [](const char* type, const std::vector<std::string>& texts) {
    McapWriter writer("test");
    const auto channel = writer.channel(writer.schema(type, "jsonschema", "{}"), "/a", "json");
    for (std::size_t i = 0; i < texts.size(); ++i) writer.message(channel, i, Bytes(texts[i].begin(), texts[i].end()));
    return written("others.mcap", writer.finish());
  };
  const std::string vector = R"({"vector":{"x":0,"y":0,"z":9.81}})";
  const fs::path speeds = with("geometry_msgs/Vector3Stamped", {vector, vector});
  EXPECT_THAT(refusal_of(speeds), HasSubstr("none of its topics has a position"));
  EXPECT_EQ(read_bag_motion(speeds, {.positions = "/a"}).size(), 2U) << "when it is named";
  const auto transform = [](const std::string& child) {
    return R"({"child_frame_id":")" + child + R"(","transform":{"translation":{"x":1,"y":2,"z":3}}})";
  };
  EXPECT_THAT(refusal_of(with("geometry_msgs/TransformStamped", {transform("hand"), transform("head")})),
              HasSubstr("/a has positions of several bodies, 'hand' and 'head'"));
}

/// Positions as JSON, one for each text that stands before them.
Bytes in_frames(const char* type, const std::vector<std::string>& fronts, const std::string& place) {
  McapWriter writer("test");
  const auto channel = writer.channel(writer.schema(type, "jsonschema", "{}"), "/a", "json");
  for (std::size_t i = 0; i < fronts.size(); ++i) {
    const std::string text = "{" + fronts[i] + place + "}";
    writer.message(channel, 1'000'000 * i, Bytes(text.begin(), text.end()));
  }
  return writer.finish();
}

TEST(Bag, PositionsInSeveralCoordinateFramesAreNotJoined) {
  const auto refused = [](const char* type, const std::vector<std::string>& fronts, const std::string& place) {
    return refusal_of(written("frames.mcap", in_frames(type, fronts, place)));
  };
  const std::string point = R"("point":{"x":1,"y":2,"z":3})", pose = R"("pose":{"position":{"x":1,"y":2,"z":3}})";
  const std::string map = R"("header":{"frame_id":"map"},)", odom = R"("header":{"frame_id":"odom"},)";
  constexpr const char* kPoint = "geometry_msgs/PointStamped";
  EXPECT_THAT(refused(kPoint, {map, odom}, point), HasSubstr("/a is in several coordinate frames, 'map' and 'odom'; transform"));
  EXPECT_THAT(refused(kPoint, {map, ""}, point), HasSubstr("in several coordinate frames, 'map' and ''"));
  EXPECT_THAT(refused("foxglove.PoseInFrame", {R"("frame_id":"map",)", R"("frame_id":"odom",)"}, pose), HasSubstr("'map' and 'odom'"));
  EXPECT_EQ(read_bag_motion(written("frame.mcap", in_frames(kPoint, {map, map}, point)), {}).size(), 2U);
}

TEST(Bag, ForcesInAnotherFrameThanThePositionsAreRefused) {
  const auto bag = [](const std::string& of_place, const std::string& of_force) {
    McapWriter writer("test");
    const auto places = writer.channel(writer.schema("geometry_msgs/msg/PointStamped", "jsonschema", "{}"), "/hand", "json");
    const auto forces = writer.channel(writer.schema("geometry_msgs/msg/WrenchStamped", "jsonschema", "{}"), "/force", "json");
    const std::string place = "{" + of_place + R"("point":{"x":0,"y":0,"z":0}})",
                      force = "{" + of_force + R"("wrench":{"force":{"x":2,"y":0,"z":0}}})";
    for (std::uint64_t ms = 0; ms < 50; ms += 10) {
      writer.message(places, ms * 1'000'000, Bytes(place.begin(), place.end()));
      writer.message(forces, ms * 1'000'000, Bytes(force.begin(), force.end()));
    }
    return written("frames_of_forces.mcap", writer.finish());
  };
  const std::string w = R"("header":{"frame_id":"w"},)", tool = R"("header":{"frame_id":"tool"},)";
  EXPECT_THAT(refusal_of(bag(w, tool), {.with_forces = true}), HasSubstr("frame 'w' and the forces in 'tool'; transform"));
  EXPECT_EQ(read_bag_motion(bag(w, tool), {}).size(), 5U);
  EXPECT_EQ(read_bag_motion(bag(w, w), {.with_forces = true}).size(), 5U);
  EXPECT_EQ(read_bag_motion(bag(w, ""), {.with_forces = true}).size(), 5U);
}

TEST(Bag, TimeMustRise) {
  McapWriter writer("test");
  const auto channel = writer.channel(writer.schema("geometry_msgs/Point", "jsonschema", "{}"), "/a", "json");
  const std::string text = R"({"x":1,"y":2,"z":3})";
  for (const std::uint64_t time : {5U, 5U}) writer.message(channel, time, Bytes(text.begin(), text.end()));
  EXPECT_THAT(refusal_of(written("later.mcap", writer.finish())), HasSubstr("message 1 of the topic is not later"));
}

TEST(Bag, ATraceComesBackToTheBit) {
  McapWriter writer("test");
  const Bytes trace = {1, 2, 3, 0, 255};
  writer.attach("felt.trace", kTraceMediaType, trace);
  const std::optional<AttachedTrace> found = attached_trace(written("attached.mcap", writer.finish()));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->trace, trace);
  EXPECT_FALSE(found->patches);
  EXPECT_FALSE(attached_trace(kReference));
}

TEST(Bag, ManyMessagesFillManyChunks) {
  McapWriter writer("test");
  const auto channel = writer.channel(writer.schema("geometry_msgs/Point", "jsonschema", "{}"), "/a", "json");
  for (std::uint64_t i = 0; i < 60'000; ++i) {
    const std::string text = R"({"x":)" + std::to_string(i) + R"(,"y":0,"z":0})";
    writer.message(channel, i * 1000, Bytes(text.begin(), text.end()));
  }
  const auto points = read_bag_motion(written("many.mcap", writer.finish()), {});
  ASSERT_EQ(points.size(), 60'000U);
  EXPECT_EQ(points.back().position.x(), 59'999'000);
}

TEST(Bag, WhateverIsDamagedIsRefusedOrReadWhole) {
  const Bytes good = read_file(kReference);
  std::uint32_t state = 1;
  const auto next = [&] { return state = state * 1664525 + 1013904223, state >> 8; };
  for (int round = 0; round < 2000; ++round) {
    Bytes bad = good;
    for (int i = 0; i < 1 + static_cast<int>(next() % 3); ++i) bad[next() % bad.size()] = static_cast<std::uint8_t>(next());
    if (round % 3 == 0) bad.resize(next() % bad.size());
    try {
      for (const motion::TimedPoint& point : read_bag_motion(written("damaged.mcap", bad), {})) EXPECT_TRUE(point.position.allFinite());
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(), HasSubstr("damaged.mcap"));
    }
  }
}

/// Seventeen bytes of a chunk cannot become a gigabyte: that is known before the memory is taken.
TEST(Bag, AChunkThatStatesMoreThanItCanHoldIsRefused) {
  const auto number = [](std::uint64_t value, std::size_t size) {
    Bytes bytes(size);
    for (std::size_t i = 0; i < std::min<std::size_t>(size, 8); ++i) bytes[i] = static_cast<std::uint8_t>(value >> 8 * i);
    return bytes;
  };
  constexpr std::uint64_t kStated = std::uint64_t{1} << 30;
  const auto add = [](Bytes& to, const Bytes& more) { to.insert(to.end(), more.begin(), more.end()); };
  Bytes frame = number(0xFD2FB528, 4);
  frame.push_back(0xE0);  // one segment, and eight bytes of its size
  add(frame, number(kStated, 8));
  add(frame, {1, 0, 0});  // a last block of nothing
  Bytes chunk;
  for (const Bytes& part :
       {number(0, 16), number(kStated, 8), number(0, 4), number(4, 4), Bytes{'z', 's', 't', 'd'}, number(frame.size(), 8), frame})
    add(chunk, part);
  Bytes file{0x89, 'M', 'C', 'A', 'P', '0', 0x0D, 0x0A, 6};
  add(file, number(chunk.size(), 8));
  add(file, chunk);
  EXPECT_THAT(refusal_of(written("bomb.mcap", file)), HasSubstr("the stated size of a chunk is not that of its content"));
}

TEST(Bag, WithoutItsEndItIsReadAsFarAsItIsWhole) {
  Bytes cut = with_topics({"/a"});
  cut.resize(cut.size() - 20);
  EXPECT_EQ(read_bag_motion(written("cut.mcap", cut), {}).size(), 3U);
}

/// Where the record of this kind begins that stands at this place among those of the file.
std::size_t record_at(const Bytes& file, std::uint8_t kind, int which) {
  for (std::size_t at = 8;; at += 9 + load_le<std::uint64_t>(&file[at + 1])) {
    if (file[at] == kind && which-- == 0) return at;
  }
}

/// A file of 1000 messages in several chunks.
Bytes in_chunks() {
  McapWriter writer("test");
  const auto channel = writer.channel(writer.schema("geometry_msgs/Point", "jsonschema", "{}"), "/a", "json");
  for (std::uint64_t i = 0; i < 60'000; ++i) {
    const std::string text = R"({"x":)" + std::to_string(i) + R"(,"y":0,"z":0})";
    writer.message(channel, i * 1000, Bytes(text.begin(), text.end()));
  }
  return writer.finish();
}

constexpr std::uint8_t kChunkRecord = 6, kDataEndRecord = 15;

TEST(Bag, WhatIsWholeAtItsEndIsNotReadInPart) {
  const Bytes good = in_chunks();
  Bytes two = good;
  two.insert(two.end(), good.begin(), good.end());
  EXPECT_THAT(refusal_of(written("two.mcap", two)), HasSubstr(std::to_string(good.size()) + " bytes follow its end; name one recording"));
  const std::size_t second = record_at(good, kChunkRecord, 1);
  Bytes ended = good;
  ended[second] = kDataEndRecord;
  EXPECT_THAT(refusal_of(written("ended.mcap", ended)), HasSubstr("it stands behind the end of the data"));
  Bytes longer = good;
  longer[second + 7] = 1;
  EXPECT_THAT(refusal_of(written("longer.mcap", longer)),
              HasSubstr("the record at byte " + std::to_string(second) + " is damaged: it is longer than the file"));
  Bytes unmarked = good;
  unmarked[good.size() - 4] = 0;
  EXPECT_THAT(refusal_of(written("unmarked.mcap", unmarked)), HasSubstr("should be the mark of the file's end"));
  longer.resize(longer.size() - 8);
  EXPECT_LT(read_bag_motion(written("cut.mcap", longer), {}).size(), 60'000U) << "a recorder that was killed";
}

/// The format does not order them, and chunks may overlap in time.
TEST(Bag, MessagesMayStandInAnyOrder) {
  for (const bool stamped : {false, true}) {
    McapWriter writer("test");
    const auto channel = writer.channel(writer.schema("geometry_msgs/PointStamped", "jsonschema", "{}"), "/a", "json");
    for (const std::uint64_t i : {3U, 1U, 0U, 2U}) {
      const std::string stamp = stamped ? R"("header":{"stamp":{"sec":)" + std::to_string(7 + i) + R"(,"nanosec":0}},)" : "";
      const std::string text = "{" + stamp + R"("point":{"x":)" + std::to_string(i) + R"(,"y":0,"z":0}})";
      writer.message(channel, i * 10'000'000, Bytes(text.begin(), text.end()));
    }
    const auto points = read_bag_motion(written("swapped.mcap", writer.finish()), {});
    ASSERT_EQ(points.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(points[i].position.x(), 1000.0 * static_cast<double>(i));
      EXPECT_NEAR(points[i].time, (stamped ? 1.0 : 0.01) * static_cast<double>(i), 1e-12);
    }
  }
}

/// A message on its way may be overtaken. Forces without stamps make the recording's time count.
TEST(Bag, MessagesAreInTheOrderOfTheTimeThatCounts) {
  constexpr std::array<std::uint64_t, 5> kRecordedMs = {5, 30, 20, 40, 50};
  McapWriter writer("test");
  const auto places = writer.channel(writer.schema("geometry_msgs/PointStamped", "jsonschema", "{}"), "/hand", "json");
  const auto forces = writer.channel(writer.schema("geometry_msgs/msg/WrenchStamped", "jsonschema", "{}"), "/force", "json");
  const std::string force = R"({"wrench":{"force":{"x":2,"y":0,"z":0}}})";
  for (std::size_t i = 0; i < kRecordedMs.size(); ++i) {
    const std::string place = R"({"header":{"stamp":{"sec":1,"nanosec":)" + std::to_string(i * 10'000'000) + R"(}},"point":{"x":)" +
                              std::to_string(i) + R"(,"y":0,"z":0}})";
    writer.message(places, kRecordedMs[i] * 1'000'000, Bytes(place.begin(), place.end()));
    writer.message(forces, kRecordedMs[i] * 1'000'000, Bytes(force.begin(), force.end()));
  }
  const fs::path file = written("overtaken.mcap", writer.finish());
  const auto by_stamp = read_bag_motion(file, {.mm_per_unit = 1}),
             recorded = read_bag_motion(file, {.with_forces = true, .mm_per_unit = 1});
  ASSERT_EQ(by_stamp.size(), kRecordedMs.size());
  ASSERT_EQ(recorded.size(), kRecordedMs.size());
  for (std::size_t i = 0; i < by_stamp.size(); ++i) {
    EXPECT_EQ(by_stamp[i].position.x(), static_cast<double>(i));
    EXPECT_NEAR(by_stamp[i].time, 0.01 * static_cast<double>(i), 1e-12);
  }
  EXPECT_EQ(recorded[1].position.x(), 2);
  EXPECT_NEAR(recorded[1].time, 0.015, 1e-12);
}

/// A recording of rosbag2: its tables, and messages of PointStamped in CDR.
class Db3 {
 public:
  explicit Db3(const fs::path& file) : file_(file) {
    fs::remove(file);
    EXPECT_EQ(sqlite3_open(file.c_str(), &database_), SQLITE_OK);
    run("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, serialization_format TEXT NOT NULL, "
        "offered_qos_profiles TEXT NOT NULL)");
    run("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL, data BLOB NOT NULL)");
    run("INSERT INTO topics VALUES (1, '/probe', 'geometry_msgs/msg/PointStamped', 'cdr', '')");
  }
  ~Db3() { sqlite3_close(database_); }
  Db3(const Db3&) = delete;
  Db3& operator=(const Db3&) = delete;

  void run(const std::string& sql) { EXPECT_EQ(sqlite3_exec(database_, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sql; }
  void add(std::int64_t time_ns, const Bytes& data) {
    std::string hex;
    for (const std::uint8_t byte : data) {
      constexpr const char* kDigits = "0123456789abcdef";
      hex += kDigits[byte >> 4];
      hex += kDigits[byte & 15];
    }
    run("INSERT INTO messages(topic_id, timestamp, data) VALUES (1, " + std::to_string(time_ns) + ", x'" + hex + "')");
  }

 private:
  fs::path file_;
  sqlite3* database_ = nullptr;
};

/// source    the classic representation: numbers at multiples of their size behind the first four bytes
Bytes point_in_cdr(std::uint32_t seconds, double x, bool little, const std::string& frame = "mm") {
  Bytes bytes = {0, static_cast<std::uint8_t>(little ? 1 : 0), 0, 0};
  const auto add = [&](std::uint64_t value, std::size_t size) {
    while ((bytes.size() - 4) % size != 0) bytes.push_back(0);
    for (std::size_t i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * (little ? i : size - 1 - i))));
  };
  add(seconds, 4), add(0, 4);
  add(frame.size() + 1, 4);
  bytes.insert(bytes.end(), frame.begin(), frame.end());
  bytes.push_back(0);
  for (const double value : {x, 0.5, -0.25}) add(std::bit_cast<std::uint64_t>(value), 8);
  return bytes;
}

TEST(Db3, PositionsAreReadInBothOrdersOfBytes) {
  const fs::path file = in_temp("run.db3");
  {
    Db3 made(file);
    made.add(2000, point_in_cdr(0, 0.002, false));
    made.add(1000, point_in_cdr(0, 0.001, true));
    made.add(3000, point_in_cdr(0, 0.003, true));
  }
  ASSERT_TRUE(is_bag(file));
  const auto points = read_bag_motion(file, {});
  ASSERT_EQ(points.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(points[i].position.x(), static_cast<double>(i + 1), 1e-12) << "by rising time";
    EXPECT_EQ(points[i].position.z(), -250);
    EXPECT_NEAR(points[i].time, 1e-6 * static_cast<double>(i), 1e-15) << "without a stamp the recording's time counts";
  }
}

TEST(Db3, PositionsInSeveralCoordinateFramesAreNotJoined) {
  const fs::path file = in_temp("frames.db3");
  {
    Db3 made(file);
    made.add(1000, point_in_cdr(1, 0.001, true, "map"));
    made.add(2000, point_in_cdr(2, 0.002, true, "odom"));
  }
  EXPECT_THAT(refusal_of(file), HasSubstr("/probe is in several coordinate frames, 'map' and 'odom'"));
}

TEST(Db3, ShortMessagesAndOtherDatabasesAreRefused) {
  const fs::path file = in_temp("short.db3");
  {
    Db3 made(file);
    Bytes cut = point_in_cdr(1, 1, true);
    cut.pop_back();
    made.add(1, cut);
  }
  EXPECT_THAT(refusal_of(file), HasSubstr("message 0 of /probe cannot be read as geometry_msgs/msg/PointStamped"));
  const fs::path other = in_temp("other.db3");
  {
    Db3 made(other);
    made.run("DROP TABLE messages");
  }
  EXPECT_THAT(refusal_of(other), HasSubstr("it cannot be read as a recording of ROS 2"));
}

TEST(Db3, AMessageWithoutItsTopicIsNotLeftOut) {
  const fs::path file = in_temp("topic.db3");
  {
    Db3 made(file);
    for (std::uint32_t i = 0; i < 9; ++i) made.add(i, point_in_cdr(i + 1, i, true));
    made.run("UPDATE messages SET topic_id = 9 WHERE timestamp = 5");
  }
  EXPECT_THAT(refusal_of(file),
              HasSubstr("topic.db3: it is damaged: the message of 5 ns belongs to no topic that it has; record it again"));
}

TEST(Db3, AViewIsNoTable) {
  const fs::path file = in_temp("view.db3");
  {
    Db3 made(file);
    made.run("DROP TABLE messages");
    made.run(
        "CREATE VIEW messages AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) "
        "SELECT i AS id, 1 AS topic_id, i AS timestamp, x'00' AS data FROM n");
  }
  EXPECT_THAT(refusal_of(file), HasSubstr("it cannot be read as a recording of ROS 2"));
}

TEST(Db3, DamageIsRefusedOrReadWhole) {
  const fs::path file = in_temp("whole.db3");
  {
    Db3 made(file);
    for (std::uint32_t i = 0; i < 200; ++i) made.add(i, point_in_cdr(i + 1, i, true));
  }
  const Bytes good = read_file(file);
  std::uint32_t state = 7;
  const auto next = [&] { return state = state * 1664525 + 1013904223, state >> 8; };
  for (int round = 0; round < 300; ++round) {
    Bytes bad = good;
    for (int i = 0; i < 4; ++i) bad[16 + next() % (bad.size() - 16)] = static_cast<std::uint8_t>(next());
    if (round % 4 == 0) bad.resize(std::max<std::size_t>(16, next() % bad.size()));
    try {
      (void)read_bag_motion(written("damaged.db3", bad), {});
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(), HasSubstr("damaged.db3"));
    }
  }
}

TEST(Bag, WhatIsNeitherIsNoBag) {
  EXPECT_FALSE(is_bag(written("table.csv", {'t', ',', 'x'})));
  EXPECT_FALSE(is_bag(in_temp("missing.mcap")));
  EXPECT_FALSE(is_bag("-"));
}

}  // namespace
}  // namespace isotouch::bag
