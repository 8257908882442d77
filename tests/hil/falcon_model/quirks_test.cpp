#include "hil/falcon_model/quirks.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace isotouch::falcon_model {
namespace {

TEST(Quirks, EveryNameThatIsOfferedIsTaken) {
  Quirks quirks;
  for (std::string name : quirk_names()) {
    if (name.back() == 'N') name.back() = '3';
    EXPECT_NO_THROW(set_quirk(quirks, name)) << name;
  }
  EXPECT_TRUE(quirks.leading_zero && quirks.stray_13 && quirks.stale_status && quirks.mislock && quirks.silent_on_wrong_rate &&
              quirks.firmware_loaded);
  EXPECT_TRUE(quirks.no_wall_power && quirks.forgets_on_unplug && quirks.homed_only_while_homing && quirks.frozen_until_homed);
  EXPECT_EQ(quirks.fail_handshakes, 3);
  EXPECT_EQ(quirks.fail_uploads, 3);
}

TEST(Quirks, OthersAreRefused) {
  Quirks quirks;
  for (const char* text : {"", "leading", "leading-zero=1", "fail-uploads", "fail-uploads=", "fail-uploads=-1", "fail-uploads=2x",
                           "fail-uploads=99999999999"}) {
    EXPECT_THROW(set_quirk(quirks, text), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace isotouch::falcon_model
