#include "firmware/settings/ascii_toml.h"

#include <gtest/gtest.h>

#include <string>

#include "firmware/settings/read_settings.h"

namespace isotouch::settings {
namespace {

TEST(AsciiToml, CharactersBeyondAsciiMayStandInCommentsAlone) {
  struct Text {
    const char* text;
    std::size_t stray_line;
    const char* read;
  };
  for (const Text& t : {Text{"", 0, ""},
                        {"a = 1\n", 0, "a = 1\n"},
                        {"# 10 µm\na = 1\n", 0, "# 10 ??m\na = 1\n"},
                        {"a = 'b'  # µ\n", 0, "a = 'b'  # ??\n"},
                        {"a = '# \\' # µ", 0, "a = '# \\' # ??"},
                        {"a = \"\\\"# \\\\\" # µ", 0, "a = \"\\\"# \\\\\" # ??"},
                        {"a = '''b\n'#'''  # µ\n", 0, "a = '''b\n'#'''  # ??\n"},
                        {"\xEF\xBB\xBF# é", 0, "# ??"}}) {
    const AsciiToml toml = ascii_toml(t.text);
    EXPECT_EQ(toml.stray_line, t.stray_line) << t.text;
    EXPECT_EQ(toml.text, t.read) << t.text;
  }
  for (const Text& t : {Text{"µ = 1\n", 1, ""},
                        {"a = 1\n\nµ\n", 3, ""},
                        {"# a\n'µ' # b\n", 2, ""},
                        {"a = \"# µ\"\n", 1, ""},
                        {"a = \"\\\"# µ\"\n", 1, ""},
                        {"a = \"\"\"\n# µ\"\"\"\n", 2, ""},
                        {"a = 'b\nµ\n", 2, ""}}) {
    EXPECT_EQ(ascii_toml(t.text).stray_line, t.stray_line) << t.text;
  }
}

TEST(AsciiToml, WhatTheLibraryDoesNotSurviveIsRefusedInASentence) {
  Settings settings;
  EXPECT_EQ(parse_settings("[loop]\nt\u00e9.a = 1\n", "F.toml", settings).sentence(),
            "F.toml:2: there is a character that is not ASCII outside a comment; in a string write it as \\u and four hexadecimal digits");
}

}  // namespace
}  // namespace isotouch::settings
