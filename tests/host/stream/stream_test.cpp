/// A stream and a controller that takes all it is sent.
#include "host/stream/stream.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "host/cloud/shapes.h"
#include "host/error.h"
#include "shared/field_patch.h"
#include "shared/tick_io.h"
#include "tests/support/scripted_controller.h"

namespace isotouch::stream {
namespace {

using namespace std::chrono_literals;
using protocol::Kind, test::Bytes, test::frame;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// Serves one client.
class Taker {
 public:
  /// on_patch  called with the number of each patch, from 1, before it is confirmed
  explicit Taker(std::function<void(int)> on_patch) : on_patch_(std::move(on_patch)), scripted_({[this](int client) { serve(client); }}) {}

  std::string address() const { return scripted_.address(); }
  int patches() const { return patches_; }

  std::atomic<std::uint16_t> faults = 0;          ///< in its status
  std::atomic<std::uint64_t> accepted_wrong = 0;  ///< bits of the hash that it answers to an upload, and that are not those of the field
  std::atomic<bool> is_replaced = false;          ///< in its status: another field
  std::atomic<int> refusals = 0;                  ///< that many patches are refused from here

 private:
  void serve(int client) {
    Bytes in, piece(1 << 16);
    for (ssize_t got = 0; (got = ::recv(client, piece.data(), piece.size(), 0)) > 0;) {
      in.insert(in.end(), piece.begin(), piece.begin() + got);
      for (auto next = protocol::read_frame(in); next && next->size > 0; next = protocol::read_frame(in)) {
        const Bytes said = answer(*next);
        (void)::send(client, said.data(), said.size(), MSG_NOSIGNAL);
        in.erase(in.begin(), in.begin() + static_cast<std::ptrdiff_t>(next->size));
      }
    }
  }

  Bytes answer(const protocol::Frame& asked) {
    switch (asked.kind) {
      case Kind::kHello: return frame(Kind::kWelcome, protocol::Welcome{});
      case Kind::kStatus: {
        protocol::StatusReport status;
        status.field_hash = is_replaced ? ~hash_ : hash_;
        status.faults = faults;
        if (faults != 0) status.state = static_cast<std::uint16_t>(SupervisorState::kFault);
        return frame(Kind::kStatusReport, status);
      }
      case Kind::kDevice: {
        protocol::DeviceReport device;
        device.waits = static_cast<std::uint8_t>(protocol::OtherAngles::kKept);
        return frame(Kind::kDeviceReport, device);
      }
      case Kind::kBegin: is_patch_ = false, hash_ = protocol::decode<protocol::Begin>(asked.body)->image_hash; break;
      case Kind::kBeginPatch: {
        if (refusals > 0) {
          --refusals;
          static constexpr std::string_view kWhy = "somebody is in the way; try again";
          return frame(Kind::kRefused, protocol::Refusal{static_cast<std::uint8_t>(asked.kind),
                                                         {reinterpret_cast<const std::uint8_t*>(kWhy.data()), kWhy.size()}});
        }
        is_patch_ = true;
        break;
      }
      case Kind::kChunk: {
        const auto bytes = protocol::decode<protocol::Chunk>(asked.body)->bytes;
        upload_.insert(upload_.end(), bytes.begin(), bytes.end());
        break;
      }
      case Kind::kCommit:
        if (is_patch_) {
          hash_ = FieldPatch::parse(upload_)->hash_after;
          on_patch_(++patches_);
        }
        upload_.clear();
        return frame(Kind::kAccepted, protocol::Accepted{hash_ ^ accepted_wrong, 1});
      default: ADD_FAILURE() << "nobody asks that";
    }
    return frame(Kind::kDone);
  }

  std::function<void(int)> on_patch_;
  std::atomic<int> patches_ = 0;
  bool is_patch_ = false;
  std::uint64_t hash_ = 0;
  Bytes upload_;
  test::Scripted scripted_;
};

StreamOptions options_to(const std::string& address) {
  const cloud::Shape sphere = cloud::shape("sphere");
  StreamOptions options;
  options.to = address;
  options.box = Eigen::AlignedBox3d(sphere.low, sphere.high);
  options.space.grid = 96;  // more blocks than one
  options.enough = 1000;
  return options;
}

/// The same places, and each time a little farther out.
cloud::Model sphere(int number) {
  const cloud::OrientedPoints points = cloud::scatter_on_shape(cloud::shape("sphere"), 3000, 1);
  cloud::Model model;
  model.positions = points.positions;
  model.normals = points.normals;
  for (Eigen::Vector3d& position : model.positions) position *= 1 + 0.002 * number;
  return model;
}

Frame frame_of(std::function<cloud::Model()> read) { return {0, std::move(read), {}}; }

/// Two frames; further points wait when they are taken.
std::jthread two_frames(Inbox& inbox) {
  return std::jthread([&inbox] {
    for (const int number : {0, 1}) inbox.hand_over(frame_of([number] { return sphere(number); }));
  });
}

TEST(Stream, WhatWaitsIsFeltTurnByTurnOnceNoFrameComes) {
  std::atomic<int> patches = 0, before_third = 0;
  Inbox inbox;
  const Taker taker([&](int number) {  // the first is of the second frame, the second of what waits
    patches = number;
    if (number == 2) {
      inbox.offer(frame_of([&] {
        before_third = patches.load();
        return cloud::Model{};
      }));
    }
  });
  Stream stream(options_to(taker.address()));
  stream.connect({.is_over = [] { return false; }, .second = [](const Tally&) {}});
  const std::jthread frames = two_frames(inbox);
  const std::jthread end([&] {
    for (int n = 0; n < 600 && patches < 4; ++n) std::this_thread::sleep_for(50ms);
    inbox.finish();
  });
  stream.run(inbox);
  EXPECT_GE(patches, 4) << "before the end, and several";
  stream.finish();
  EXPECT_EQ(before_third, 2) << "a frame waits for no more than one turn";
  EXPECT_GT(stream.report().all.patches, stream.report().all.delay_ms.quantiles().count);
  EXPECT_TRUE(stream.is_felt());
}

/// What waits at the end may take long to compute, which is no time of a busy controller.
TEST(Stream, ABusyControllerGetsItsTimeFromWhenItIsAsked) {
  std::atomic<bool> is_over = false;
  const Taker taker([&](int) {
    is_over = true;
    std::this_thread::sleep_for(300ms);
  });
  Stream stream(options_to(taker.address()));
  stream.connect({.is_over = [&] { return is_over.load(); }, .second = [](const Tally&) {}});
  Inbox inbox;
  const std::jthread frames = two_frames(inbox);
  stream.run(inbox);
  EXPECT_FALSE(stream.is_felt()) << "there is something to send";
  std::this_thread::sleep_for(Stream::kGrace);
  stream.finish();
  EXPECT_TRUE(stream.is_felt());
  EXPECT_EQ(taker.patches(), 2);
}

TEST(Stream, AFaultOfTheControllerIsToldWithItsNextStep) {
  Taker taker([](int) {});
  Stream stream(options_to(taker.address()));
  stream.connect({.is_over = [] { return false; }, .second = [](const Tally&) {}});
  stream.finish();
  EXPECT_EQ(stream.fault(), "");
  taker.faults = kFaultSilent;
  stream.finish();
  EXPECT_NE(stream.fault().find("fault: other angles were measured"), std::string::npos) << stream.fault();
}

TEST(Stream, AnotherFieldThatWasTakenOverInsteadIsAnError) {
  Taker taker([](int) {});
  taker.accepted_wrong = 1;
  Stream stream(options_to(taker.address()));
  stream.connect({.is_over = [] { return false; }, .second = [](const Tally&) {}});
  Inbox inbox;
  inbox.offer(frame_of([] { return sphere(0); }));
  EXPECT_THAT([&] { stream.run(inbox); }, ThrowsMessage<InputError>(HasSubstr("another field was taken over meanwhile")));
  EXPECT_FALSE(stream.is_felt());
}

/// The same of a patch.
TEST(Stream, AnotherFieldThatWasTakenOverInsteadOfAPatchIsAnError) {
  std::function<void(int)> on_patch;
  Taker taker([&](int number) { on_patch(number); });
  on_patch = [&](int) { taker.accepted_wrong = 1; };
  Stream stream(options_to(taker.address()));
  stream.connect({.is_over = [] { return false; }, .second = [](const Tally&) {}});
  Inbox inbox;
  const std::jthread frames = two_frames(inbox);
  EXPECT_THAT([&] { stream.run(inbox); }, ThrowsMessage<InputError>(HasSubstr("another field was taken over meanwhile")));
  EXPECT_EQ(taker.patches(), 1);
  EXPECT_FALSE(stream.is_felt());
}

TEST(Stream, AFieldThatSomebodyReplacedIsNotFelt) {
  Taker taker([](int) {});
  Stream stream(options_to(taker.address()));
  stream.connect({.is_over = [] { return false; }, .second = [](const Tally&) {}});
  Inbox inbox;
  inbox.offer(frame_of([] { return sphere(0); }));
  inbox.finish();
  stream.run(inbox);
  stream.finish();
  EXPECT_TRUE(stream.is_felt());
  taker.is_replaced = true;
  EXPECT_THAT([&] { stream.finish(); }, ThrowsMessage<InputError>(HasSubstr("another field was loaded while this one grew")));
  EXPECT_FALSE(stream.is_felt());
}

/// What was taken before is felt all the same: also what waits.
TEST(Stream, WhatCameBeforeAnErrorOfItsSourceIsFelt) {
  const Taker taker([](int) {});
  Stream stream(options_to(taker.address()));
  stream.connect({.is_over = [] { return false; }, .second = [](const Tally&) {}});
  Inbox inbox;
  const std::jthread frames([&inbox] {
    for (const int number : {0, 1}) inbox.hand_over(frame_of([number] { return sphere(number); }));
    inbox.hand_over(frame_of([]() -> cloud::Model { throw InputError("the frame is broken"); }));
  });
  EXPECT_THAT([&] { stream.run(inbox); }, ThrowsMessage<InputError>(HasSubstr("the frame is broken")));
  EXPECT_TRUE(stream.is_felt());
  EXPECT_GE(taker.patches(), 2) << "of the second frame, and of what waited";
}

TEST(Stream, APatchThatIsRefusedForAWhileIsSentAgain) {
  Taker taker([](int) {});
  taker.refusals = 30;
  Stream stream(options_to(taker.address()));
  std::string seen;
  stream.connect({.is_over = [] { return false; },
                  .second =
                      [&](const Tally& second) {
                        if (second.refused_s > 0) seen += second.refusal;
                      }});
  Inbox inbox;
  const std::jthread frames([&inbox] {
    for (const int number : {0, 1}) inbox.hand_over(frame_of([number] { return sphere(number); }));
    inbox.finish();
  });
  stream.run(inbox);
  stream.finish();
  EXPECT_TRUE(stream.is_felt());
  EXPECT_EQ(taker.refusals, 0);
  EXPECT_THAT(seen, HasSubstr("somebody is in the way"));
  const Tally& all = stream.report().all;
  EXPECT_GE(all.refused_s, 30 * 0.05);
  EXPECT_GE(all.delay_ms.quantiles().max, all.refused_s * 1e3) << "the frame was felt that late";
  EXPECT_LT(stream.report().controller_ms.quantiles().max, all.refused_s * 1e3) << "the controller did not work meanwhile";
}

TEST(Stream, APatchThatIsRefusedForLongIsAnError) {
  Taker taker([](int) {});
  taker.refusals = std::numeric_limits<int>::max();
  StreamOptions options = options_to(taker.address());
  options.patience = 200ms;
  Stream stream(options);
  stream.connect({.is_over = [] { return false; }, .second = [](const Tally&) {}});
  Inbox inbox;
  const std::jthread frames = two_frames(inbox);
  EXPECT_THAT([&] { stream.run(inbox); }, ThrowsMessage<InputError>(HasSubstr("somebody is in the way")));
  EXPECT_FALSE(stream.is_felt());
  EXPECT_FALSE(stream.has_given_up());
  EXPECT_GE(stream.report().all.refused_s, 0.2);
}

/// Nobody waits for as long as the patience then.
TEST(Stream, APatchThatIsRefusedWhenTheStreamIsOverIsGivenUp) {
  std::atomic<bool> is_over = false;
  Taker taker([](int) {});
  taker.refusals = std::numeric_limits<int>::max();
  Stream stream(options_to(taker.address()));
  stream.connect({.is_over = [&] { return is_over.load(); }, .second = [](const Tally&) {}});
  Inbox inbox;
  const std::jthread frames = two_frames(inbox);
  const std::jthread end([&] {
    while (taker.refusals > std::numeric_limits<int>::max() - 2 && !inbox.is_closed()) std::this_thread::sleep_for(1ms);
    is_over = true;
  });
  EXPECT_THAT([&] { stream.run(inbox); }, ThrowsMessage<InputError>(HasSubstr("somebody is in the way")));
  EXPECT_TRUE(stream.has_given_up());
  EXPECT_FALSE(stream.is_felt());
}

TEST(Stream, WhoeverIsInTheWayMayReplaceTheField) {
  Taker taker([](int) {});
  taker.refusals = std::numeric_limits<int>::max();
  Stream stream(options_to(taker.address()));
  stream.connect({.is_over = [] { return false; }, .second = [](const Tally&) {}});
  Inbox inbox;
  const std::jthread frames = two_frames(inbox);
  const std::jthread other([&] {
    while (taker.refusals > std::numeric_limits<int>::max() - 2 && !inbox.is_closed()) std::this_thread::sleep_for(1ms);
    taker.is_replaced = true;
  });
  EXPECT_THAT([&] { stream.run(inbox); }, ThrowsMessage<InputError>(HasSubstr("another field was loaded while this one grew")));
  EXPECT_TRUE(stream.is_replaced());
}

/// A frame that nobody keeps leaves nothing behind, whatever the band.
TEST(Stream, AFieldOfAnyBandIsThatOfTheFramesThatAreKept) {
  const auto streamed = [](double band, std::optional<Clock::duration> keep, std::initializer_list<int> numbers) {
    StreamOptions options = options_to("");
    options.space.grid = 48;
    options.space.band = band;
    options.keep = keep;
    options.enough = 0;
    Stream stream(options);
    stream.connect({.is_over = [] { return false; }, .second = [](const Tally&) {}});
    Inbox inbox;
    const std::jthread frames([&] {
      for (const int number : numbers) inbox.hand_over(frame_of([number] { return sphere(number); }));
      inbox.finish();
    });
    stream.run(inbox);
    EXPECT_EQ(stream.report().all.points.expired > 0, numbers.size() > 1);
    const auto image = stream.whole().view.image;
    return Bytes(image.begin(), image.end());
  };
  Bytes before;
  for (const double band : {1.0, 1.5, 3.0, 5.75, 7.99}) {
    const Bytes alone = streamed(band, {}, {9});
    EXPECT_EQ(streamed(band, 1ns, {0, 4, 9}), alone) << band;
    EXPECT_GT(alone.size(), before.size()) << "a wider band is stored in more bricks: " << band;
    before = alone;
  }
}

/// The first frame shows a part of the object.
TEST(Stream, WithoutABoxThereIsRoomRoundTheFirstFrame) {
  StreamOptions options = options_to("");
  options.box = {};
  Stream stream(options);
  stream.connect({.is_over = [] { return false; }, .second = [](const Tally&) {}});
  Inbox inbox;
  inbox.offer(frame_of([] { return sphere(0); }));
  inbox.finish();
  stream.run(inbox);
  Eigen::AlignedBox3d own;
  for (const Eigen::Vector3d& position : sphere(0).positions) own.extend(position);
  const Eigen::Vector3d more = Eigen::Vector3d::Constant(own.sizes().maxCoeff() / 2);
  EXPECT_TRUE(stream.space().box.isApprox({own.min() - more, own.max() + more}));
}

}  // namespace
}  // namespace isotouch::stream
