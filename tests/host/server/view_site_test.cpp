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

/// What a build was given, and what the page hears of it.
struct Sent {
  std::string file, name;
  nlohmann::ordered_json told;
};

/// Sends a scan whose name is written so in the address; the build says that it is none.
Sent sent_as(const std::string& name) {
  Sent sent;
  ViewSite site([&](const std::filesystem::path& file, const std::string& shown, const auto&) -> Built {
    sent.file = file.filename().string();
    sent.name = shown;
    throw InputError(file.string() + ": no scan");
  });
  HttpServer server(site, 0);
  site.begin(server, "", {}, {});
  EXPECT_EQ(site.reply({true, "build", "name=" + name, {1, 2, 3}}).status, 202U);
  const auto is_told = [&] {
    const auto all = site.greeting();
    return all.size() > 1 && (sent.told = nlohmann::ordered_json::parse(all.back()->bytes)).contains("result");
  };
  for (int n = 0; n < 200 && !is_told(); ++n) std::this_thread::sleep_for(50ms);
  EXPECT_TRUE(site.end());
  return sent;
}

TEST(ViewSite, AScanKeepsItsNameForPeople) {
  const Sent sent = sent_as("my%20sc%C3%A4n%2B1.ply");
  EXPECT_EQ(sent.file, "my_sc__n_1.ply");
  EXPECT_EQ(sent.name, "my sc\u00e4n+1.ply");
  EXPECT_EQ(sent.told["name"], sent.name);
  EXPECT_EQ(sent.told["sentence"], sent.name + ": no scan");
}

TEST(ViewSite, ALongNameKeepsItsEnding) {
  std::string name, shown;
  for (int i = 0; i < 80; ++i) name += "%E6%A8%A1", shown += "\u6a21";
  const Sent sent = sent_as(name + ".ply");
  EXPECT_EQ(sent.name, shown + ".ply");
  EXPECT_THAT(sent.file, EndsWith("_.ply"));
  EXPECT_THAT(sent.file, SizeIs(80));
  EXPECT_THAT(sent_as(std::string(100, 'a') + "." + std::string(100, 'b')).file, SizeIs(80));
  EXPECT_THAT(sent_as(std::string(100, 'a')).file, std::string(80, 'a'));
}

TEST(ViewSite, NoNameLeavesItsFolder) {
  for (const auto& [name, file, shown] : std::vector<std::array<std::string, 3>>{{"..%2F..%2Fx", "x", "x"},
                                                                                 {"..", "cloud..", ".."},
                                                                                 {"", "cloud", "cloud"},
                                                                                 {"a%2F", "cloud", "cloud"},
                                                                                 {"a%00b%0A%", "a_b__", "a_b_%"},
                                                                                 {"%2g%", "_2g_", "%2g%"}}) {
    const Sent sent = sent_as(name);
    EXPECT_EQ(sent.file, file);
    EXPECT_EQ(sent.name, shown);
  }
}

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
             report = frame(Kind::kStatusReport, status), device = frame(Kind::kDeviceReport, protocol::DeviceReport{}),
             image = frame(Kind::kImagePart, protocol::ImagePart{7, 8, 0, broken});
  const test::Scripted scripted({says({hello, frame(Kind::kDone)}), says({hello, bins, bins, report, device, image, report, device, report,
                                                                          device, report, device, bins, bins, report, device})});
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
  EXPECT_THAT(said, HasSubstr("is no field"));
}

}  // namespace
}  // namespace isotouch::server
