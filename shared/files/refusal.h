/// Why something was not done, in one sentence for a person; or nothing, when it was. Whoever gets one must look at it. Beside it there is only
/// `Result<T>`, for what a program decides by.
///
/// tick      no: it holds a string
#pragma once

#include <string>
#include <utility>

namespace isotouch {

class [[nodiscard]] Refusal {
 public:
  /// Nothing was refused.
  Refusal() = default;
  // A sentence is a refusal, and the empty one is none: functions return either.
  Refusal(std::string sentence) : sentence_(std::move(sentence)) {}  // NOLINT(google-explicit-constructor)
  Refusal(const char* sentence) : sentence_(sentence) {}             // NOLINT(google-explicit-constructor)

  /// True when something was refused: `if (const Refusal refusal = begin()) return refusal;`
  explicit operator bool() const { return !sentence_.empty(); }
  /// Empty when nothing was refused.
  const std::string& sentence() const { return sentence_; }

 private:
  std::string sentence_;
};

}  // namespace isotouch
