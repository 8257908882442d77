#include "host/qualify/board_files.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace isotouch::qualify {
namespace {

TEST(BoardFiles, ANumberIsANumberAndNothingElse) {
  EXPECT_EQ(whole_number(" -1\n"), -1);
  EXPECT_EQ(whole_number("9223372036854775807"), INT64_MAX);
  for (const char* text : {"", " ", "1 2", "0x1", "1.5", "9223372036854775808", "-", "+1"}) EXPECT_FALSE(whole_number(text)) << text;
}

TEST(BoardFiles, AListOfProcessorsIsReadAndWritten) {
  EXPECT_EQ(processors("0-2,5\n"), (std::set<int>{0, 1, 2, 5}));
  EXPECT_EQ(processors("\n"), std::set<int>{});
  EXPECT_EQ(processors("8191"), std::set<int>{8191});
  for (const char* text : {"a", "0,", ",0", "3-1", "-1", "0-", "0-4294967295", "8192", "0 1", "0-1-2"})
    EXPECT_FALSE(processors(text)) << text;
  for (const char* text : {"", "0", "0-1", "0,2-4,7"}) EXPECT_EQ(list_of(processors(text).value()), text);
}

/// As Linux 6.18 writes it of a thread.
std::string stat(const std::string& name, const std::string& priority, const std::string& policy) {
  return "50 (" + name +
         ") S 2 0 0 0 -1 2129984 0 0 0 0 0 0 0 0 -51 0 1 0 42 0 0 18446744073709551615 0 0 0 0 0 0 0 2147483647 0 1 0 0 17 0 " + priority +
         " " + policy + " 0 0 0 0 0 0 0 0 0 0 0";
}

TEST(BoardFiles, AThreadsSchedulingStandsBehindItsName) {
  const auto how = scheduling(stat("tick", "80", "1"));
  ASSERT_TRUE(how);
  EXPECT_EQ(how->priority, 80);
  EXPECT_TRUE(how->is_real_time());
  EXPECT_EQ(scheduling(stat("a) R 1 (b", "47", "2"))->priority, 47) << "a name may hold anything";
  EXPECT_EQ(name_in(stat("a) R 1 (b", "47", "2")), "a) R 1 (b");
  EXPECT_FALSE(scheduling(stat("tick", "0", "0"))->is_real_time());
  const std::string whole = stat("tick", "80", "1");
  for (const std::string& text : {std::string(), std::string(")"), whole.substr(0, 90), stat("tick", "x", "1"), stat("tick", "100", "1"),
                                  stat("tick", "80", "-1"), stat("tick", "80", "99999999999999999999")}) {
    EXPECT_FALSE(scheduling(text)) << text;
  }
  EXPECT_EQ(name_in(")("), "");
}

TEST(BoardFiles, OnlyRowsOfNumberedInterruptsAreRead) {
  const auto all = interrupts(
      "           CPU0       CPU1\n 24:          1          0  IO-APIC   5-edge      ACPI:Ged\nNMI:          0          0   Non-maskable\n"
      " 42:          0          0  GICv2  77  Level     xhci_hcd, ehci_hcd:usb1\n 43: 1\n 44: x 2 name\n 45: 0 -2 name\n-1: 1 1 "
      "name\n:\n\n");
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].number, 24);
  EXPECT_TRUE(all[0].has_come());
  EXPECT_FALSE(all[1].has_come());
  EXPECT_EQ(all[1].name, "GICv2 77 Level xhci_hcd, ehci_hcd:usb1");
  for (const char* text : {"", "\n", "24: 1 1 x\n", "no header\n24: 1 1 x\n"}) EXPECT_TRUE(interrupts(text).empty()) << text;
}

TEST(BoardFiles, WhatIsShownIsOneShortLine) {
  EXPECT_EQ(shown("  a\tb\n\x1b[31mc\xff\n"), "a b  [31mc");
  EXPECT_EQ(shown("abcdef", 3), "abc…");
  EXPECT_EQ(shown("äöü", 2), "ä…");
  EXPECT_EQ(shown("abc", 3), "abc");
}

}  // namespace
}  // namespace isotouch::qualify
