#include "host/server/outbox.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace isotouch::server {
namespace {

Shared message(Topic topic, const std::string& text) {
  return std::make_shared<const Message>(Message{topic, topic == Topic::kTicks, text});
}

std::string next(Outbox& outbox) {
  const auto taken = outbox.take();
  return taken ? (*taken)->bytes : "nothing";
}

TEST(Outbox, WhatIsPutIsTaken) {
  Outbox outbox;
  EXPECT_EQ(next(outbox), "nothing");
  outbox.put(message(Topic::kTicks, "1"));
  outbox.put(message(Topic::kState, "state"));
  EXPECT_EQ(next(outbox), "state");
  EXPECT_EQ(next(outbox), "1");
  EXPECT_EQ(next(outbox), "nothing");
}

TEST(Outbox, OfTicksTheNewestBatchesWait) {
  Outbox outbox;
  for (int i = 0; i < 100; ++i) outbox.put(message(Topic::kTicks, std::to_string(i)));
  EXPECT_EQ(outbox.dropped(), 100 - Outbox::kMaxBatches);
  EXPECT_EQ(next(outbox), std::to_string(100 - Outbox::kMaxBatches));
}

TEST(Outbox, OfAnythingElseTheNewestAlone) {
  Outbox outbox;
  for (int i = 0; i < 100; ++i) outbox.put(message(Topic::kStatus, std::to_string(i)));
  EXPECT_EQ(next(outbox), "99");
  EXPECT_EQ(next(outbox), "nothing");
}

TEST(Outbox, AViewerThatShowsNothingGetsNoMoreTicksButAllElse) {
  Outbox outbox;
  for (int i = 0; i < 5; ++i) outbox.put(message(Topic::kTicks, std::to_string(i)));
  EXPECT_EQ(next(outbox), "0");
  EXPECT_EQ(next(outbox), "1");
  EXPECT_EQ(next(outbox), "nothing");
  outbox.put(message(Topic::kState, "state"));
  EXPECT_EQ(next(outbox), "state");
  outbox.seen();
  EXPECT_EQ(next(outbox), "2");
  EXPECT_EQ(next(outbox), "nothing");
}

TEST(Outbox, NothingOfAControllerThatIsGoneIsSentBehindThatItIsGone) {
  Outbox outbox;
  for (int i = 0; i < 5; ++i) outbox.put(message(Topic::kTicks, std::to_string(i)));
  outbox.put(message(Topic::kState, "state"));
  outbox.put(message(Topic::kStatus, "status"));
  outbox.put(message(Topic::kBuild, "build"));
  outbox.put(message(Topic::kLink, "gone"));
  EXPECT_EQ(next(outbox), "gone");
  EXPECT_EQ(next(outbox), "build");
  EXPECT_EQ(next(outbox), "nothing");
  outbox.put(message(Topic::kLink, "there"));
  outbox.put(message(Topic::kState, "new state"));
  outbox.put(message(Topic::kTicks, "6"));
  EXPECT_EQ(next(outbox), "there");
  EXPECT_EQ(next(outbox), "new state");
  EXPECT_EQ(next(outbox), "6");
}

TEST(Outbox, MoreThanWasSentCannotHaveBeenSeen) {
  Outbox outbox;
  for (int i = 0; i < 10; ++i) outbox.seen();
  for (int i = 0; i < 5; ++i) outbox.put(message(Topic::kTicks, std::to_string(i)));
  EXPECT_EQ(next(outbox), "0");
  EXPECT_EQ(next(outbox), "1");
  EXPECT_EQ(next(outbox), "nothing");
}

}  // namespace
}  // namespace isotouch::server
