#include "host/server/view_site.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include "host/error.h"
#include "tests/support/scripted_controller.h"

namespace isotouch::server {
namespace {

using namespace std::chrono_literals;
using protocol::Kind, test::frame;
using testing::EndsWith, testing::HasSubstr, testing::Not, testing::SizeIs;

/// Where its field cannot be read, the object before stays, and somebody has to say why.
TEST(ViewSite, WhyAControllersFieldCannotBeDrawnIsSaid) {
  const auto says = [](const std::vector<test::Bytes>& frames) {
    test::Bytes all;
    for (const test::Bytes& bytes : frames) all.insert(all.end(), bytes.begin(), bytes.end());
    return test::Scripted::says(all, false);
  };
  protocol::Welcome welcome;
  welcome.period_ns = 1'000'000;
  protocol::StatusReport status;
  status.field_hash = 7;
  const std::array<std::uint8_t, 8> broken{1, 2, 3};
  const auto hello = frame(Kind::kWelcome, welcome), bins = frame(Kind::kHistogramReport, protocol::HistogramReport{}),
             report = frame(Kind::kStatusReport, status), image = frame(Kind::kImagePart, protocol::ImagePart{7, 8, 0, broken});
  const test::Scripted scripted(
      {says({hello, frame(Kind::kDone)}), says({hello, bins, bins, report, image, report, report, report, bins, bins, report})});
  ViewSite site(Build{});
  HttpServer server(site, 0);
  site.begin(server, scripted.address(), [](link::Controller&) { return nlohmann::ordered_json::object(); }, {});
  std::string said;
  const auto is_said = [&] {
    for (const Shared& message : site.greeting()) {
      if (message->topic == Topic::kStatus) said = message->bytes;
    }
    return said.find("field_sentence") != std::string::npos;
  };
  for (int n = 0; n < 200 && !is_said(); ++n) std::this_thread::sleep_for(50ms);
  EXPECT_TRUE(site.end());
  EXPECT_THAT(said, HasSubstr("not usable as a field"));
}

}  // namespace
}  // namespace isotouch::server
