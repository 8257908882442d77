/// Judges the settings of a board's kernel that affect the timing of ticks. Pure: contents of files in, findings out.
///
/// A finding explains the measurement and does not decide whether the board is fit. A setting that could not be read is reported as such, never as good.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace isotouch::qualify {

/// What could be read of a board; `practice_questions.h` fills it.
struct BoardFiles {
  /// Path → content without its last line end. Beside the kernel's own paths:
  ///   thread/NAME/stat, thread/NAME/cores    of the controller's thread of that name: as in /proc, and where it may run
  ///   irq_thread/PID/stat                    of a kernel thread that serves an interrupt
  ///   machine                                as `uname -m`
  ///   kernel_thread                          the name of process 2: "kthreadd" where the kernel's threads are seen
  ///   grub                                   is there where the boot options come from grub
  /// Contents are the board's, whatever they are.
  std::map<std::string, std::string> texts;
  /// Paths that are not there; what is in neither may not be read.
  std::set<std::string> missing;
};

struct Finding {
  enum class Verdict { kGood, kCouldBeBetter, kBad, kNotRead };

  std::string key;   ///< for programs
  std::string what;  ///< for people
  std::string read;  ///< what stands there, printable and short; empty where it could not be read
  Verdict verdict = Verdict::kNotRead;
  std::string why;     ///< one sentence
  std::string remedy;  ///< one sentence, with the command; empty where there is nothing to do
};

/// begin, end  of the measurement
/// wakeup_us   the largest wake-up delay that is good
/// returns     one finding for each practice, always in the same order
std::vector<Finding> judge_practice(const BoardFiles& begin, const BoardFiles& end, double wakeup_us);

/// "good", "could be better", "bad", "could not be read"
const char* name_of(Finding::Verdict verdict);

}  // namespace isotouch::qualify
