#include "shared/printable.h"

#include <gtest/gtest.h>

#include <string>

namespace isotouch {
namespace {

std::string printable(std::string text) {
  make_printable(text, '?');
  return text;
}

TEST(Printable, TextOfAnyLanguageStays) {
  for (const char* text : {"", "SN-0001 ~", "Größe 3 mm²", "\xE8\xA7\xA6\xE8\xA6\x9A", "\xF0\x9F\x91\x8B"}) {
    EXPECT_TRUE(is_printable(text)) << text;
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Printable, WhatATerminalObeysOrTurnsDoesNot) {
  EXPECT_EQ(printable("a\x1B[2Jb"), "a?[2Jb");
  EXPECT_EQ(printable("a\nb\x7F"), "a?b?");
  EXPECT_EQ(printable("a\xC2\x9B"
                      "2Jb"),
            "a??2Jb")
      << "C1: CSI in one character";
  EXPECT_EQ(printable("\xE2\x80\xAE"
                      "321"),
            "???321")
      << "right to left";
  EXPECT_EQ(printable("\xE2\x81\xA6"
                      "1"),
            "???1");
  EXPECT_EQ(printable("\xD8\x9C"), "??");
}

TEST(Printable, WhatIsNoUtf8DoesNot) {
  for (const char* text : {"\x9B", "\xC2", "\xC0\x9B", "\xE0\x82\x9B", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xFF", "\xE2\x80"}) {
    EXPECT_FALSE(is_printable(text));
    EXPECT_EQ(printable(text).find_first_not_of('?'), std::string::npos);
  }
}

}  // namespace
}  // namespace isotouch
