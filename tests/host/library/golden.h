/// Files that stay, and how a call that must succeed is written.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "host/library/isotouch.h"

namespace isotouch::test {

inline std::string golden(const std::string& name) { return ISOTOUCH_GOLDEN "/" + name; }

#define EXPECT_DONE(call) EXPECT_EQ(call, ISOTOUCH_OK) << isotouch_last_error()
#define ASSERT_DONE(call) ASSERT_EQ(call, ISOTOUCH_OK) << isotouch_last_error()

/// A call that must fail: with this status and a sentence that holds these words.
#define EXPECT_REFUSED(call, status, words)                                                                \
  do {                                                                                                     \
    EXPECT_EQ(call, status);                                                                               \
    EXPECT_NE(std::string(isotouch_last_error()).find(words), std::string::npos) << isotouch_last_error(); \
  } while (false)

/// A field that ends with the test.
class Field {
 public:
  explicit Field(const std::string& name = "field_1_1.itf") {
    EXPECT_EQ(isotouch_field_load(golden(name).c_str(), &handle), ISOTOUCH_OK) << isotouch_last_error();
  }
  ~Field() { isotouch_free(handle); }
  Field(const Field&) = delete;
  Field& operator=(const Field&) = delete;

  isotouch_field_facts facts() const {
    isotouch_field_facts found{};
    EXPECT_EQ(isotouch_field_describe(handle, &found, sizeof found), ISOTOUCH_OK) << isotouch_last_error();
    return found;
  }

  isotouch_field handle = 0;
};

}  // namespace isotouch::test
