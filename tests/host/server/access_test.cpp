#include "host/server/access.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace isotouch::server {
namespace {

const std::string kToken = "0123456789abcdef0123456789abcdef";
const std::string kHost = "127.0.0.1:4711", kOrigin = "http://127.0.0.1:4711";

unsigned status(const std::string& target, const std::string& host = kHost, const std::string& origin = "", bool changes = false) {
  const Admission admission = AccessCheck(4711, kToken).admit({target, host, origin, changes});
  EXPECT_EQ(admission.granted(), admission.sentence.empty());
  return admission.status;
}

TEST(Access, TokensAreLongAndNeverTheSame) {
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) tokens.insert(random_token());
  EXPECT_EQ(tokens.size(), 100U);
  for (const std::string& token : tokens) EXPECT_EQ(token.size(), 32U);
}

TEST(Access, TheAddressOpensThePage) {
  const AccessCheck access(4711, kToken);
  EXPECT_EQ(access.address(), kOrigin + "/" + kToken + "/");
  const Admission page = access.admit({"/" + kToken + "/", kHost, "", false});
  EXPECT_TRUE(page.granted());
  EXPECT_EQ(page.path, "");
  const std::string target = "/" + kToken + "/slice?axis=z&at=1";
  const Admission slice = access.admit({target, "localhost:4711", "http://localhost:4711", true});
  EXPECT_TRUE(slice.granted());
  EXPECT_EQ(slice.path, "slice");
  EXPECT_EQ(slice.query, "axis=z&at=1");
}

TEST(Access, AWrongTokenIsRefused) {
  for (const std::string target :
       {"/", "", "/x", "//", "x", "/0123456789abcdef0123456789abcdee/", "/0123456789abcdef/", "?", "/?0123456789abcdef0123456789abcdef/"})
    EXPECT_EQ(status(target), 403U) << target;
  EXPECT_EQ(status("/" + kToken + "0/"), 403U);
  EXPECT_EQ(status("/" + kToken), 404U);
}

TEST(Access, AForeignHostIsRefused) {
  for (const std::string host :
       {"", "evil.example", "127.0.0.1", "127.0.0.1:4712", "evil.example:4711", "localhost:4711.evil.example", "LOCALHOST:4711"})
    EXPECT_EQ(status("/" + kToken + "/", host), 403U) << host;
}

TEST(Access, AForeignOriginIsRefused) {
  for (const std::string origin : {"null", "http://evil.example", "https://127.0.0.1:4711", "http://127.0.0.1", "http://localhost:4711"})
    EXPECT_EQ(status("/" + kToken + "/", kHost, origin), 403U) << origin;
}

TEST(Access, WhoeverChangesSomethingNamesItsOrigin) {
  EXPECT_EQ(status("/" + kToken + "/build", kHost, "", true), 403U);
  EXPECT_EQ(status("/" + kToken + "/build", kHost, kOrigin, true), 200U);
}

}  // namespace
}  // namespace isotouch::server
