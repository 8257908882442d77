/// Who may include whom, and the words that do not belong into the core. The table is the one of DESIGN.md; the link lists of CMakeLists.txt
/// say the same to the linker, this says it with file and line.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace isotouch {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const fs::path kRoot = ISOTOUCH_ROOT;

struct Rule {
  Words project;      ///< folders and files of ours that this folder may include, beside itself
  bool tick = false;  ///< runs in the tick: of the standard library only what neither allocates nor throws
};

/// The longest matching folder rules; what stands in no folder of this table may not exist.
const std::map<std::string, Rule> kRules = {
    {"shared", {{}, true}},
    {"shared/files", {{"shared"}}},  // it reads and writes files: nothing that runs in the tick includes it
    {"firmware/core", {{"shared"}, true}},
    {"firmware/loop", {{"firmware/core", "shared"}}},
    {"firmware/guard", {{"firmware/loop", "shared"}}},
    {"firmware/falcon", {{"firmware/loop", "shared"}}},
    {"firmware/store", {{"firmware/loop", "shared"}}},
    {"firmware/recording", {{"firmware/loop", "shared"}}},
    {"firmware/control", {{"firmware/store", "firmware/recording", "firmware/loop", "shared"}}},
    {"firmware/lines", {{"firmware/loop", "shared"}}},
    {"firmware/settings",
     {{"firmware/falcon", "firmware/control", "firmware/store", "firmware/recording", "firmware/lines", "firmware/loop", "shared"}}},
    {"firmware/daemon",
     {{"firmware/settings", "firmware/guard", "firmware/falcon", "firmware/control", "firmware/store", "firmware/recording",
       "firmware/lines", "firmware/loop", "packaging/manual", "shared"}}},
    {"tests/firmware/store", {{"firmware/store", "firmware/loop", "shared", "tests/support"}}},
    {"tests/firmware/recording", {{"firmware/recording", "firmware/loop", "shared", "tests/support"}}},
    {"tests/firmware/control",
     {{"firmware/control", "firmware/store", "firmware/recording", "firmware/loop", "shared", "tests/support", "tests/firmware/store"}}},
    {"firmware", {{"firmware", "shared"}}},
    {"host/files", {{"host/error.h", "shared"}}},
    {"host/field_file", {{"host/files", "host/error.h", "shared"}}},
    {"host/trace",
     {{"host/field_file", "host/files", "host/angle.h", "host/error.h", "host/quantiles.h", "host/to_double.h", "firmware/core",
       "shared"}}},
    {"host/link", {{"host/trace/hash_text.h", "host/error.h", "shared"}}},
    {"host/library", {{"host/trace", "host/link", "host/field_file", "host/files", "host/error.h", "host/to_double.h", "shared"}}},
    {"host/build_library",
     {{"host/encoding", "host/field", "host/cloud", "host/field_file", "host/library/call.h", "host/error.h", "shared"}}},
    {"host/board_commands",
     {{"host/trace", "host/field_file", "host/files", "host/link", "host/error.h", "host/quantiles.h", "host/to_double.h", "firmware/core",
       "packaging/manual", "shared"}}},
    {"host/cloud", {{"host/files", "host/error.h", "shared"}}},
    {"host/field", {{"host/cloud", "host/files", "host/error.h", "shared"}}},
    {"host/vdb", {{"host/field", "host/cloud", "host/files", "host/error.h", "shared"}}},
    {"host/published", {{"host/field", "host/cloud", "host/error.h", "shared"}}},
    {"host/encoding", {{"host/field_file", "host/field", "host/cloud", "host/error.h", "host/to_double.h", "shared"}}},
    {"host/live", {{"host/encoding", "host/field_file", "host/field", "host/cloud", "host/error.h", "shared"}}},
    {"host/stream",
     {{"host/live", "host/encoding", "host/field_file", "host/field", "host/cloud", "host/files", "host/link", "host/trace",
       "host/evaluate/depth_camera.h", "host/evaluate/touch_points.h", "host/error.h", "host/quantiles.h", "host/to_double.h", "shared"}}},
    {"host/farm", {{"host/trace", "host/field_file", "host/files", "host/error.h", "shared"}}},
    {"host/qualify", {{"host/files", "host/quantiles.h", "host/link", "host/view", "host/trace/hash_text.h", "host/error.h", "shared"}}},
    {"host/motion",
     {{"host/trace", "host/cloud", "host/field/angle.h", "host/files", "host/error.h", "host/to_double.h", "firmware/core", "shared"}}},
    {"host/evaluate", {{"host", "firmware/core", "shared"}}},
    {"host/bag", {{"host/motion", "host/trace/recorded_patches.h", "host/error.h", "host/files", "host/to_double.h", "shared"}}},
    {"host/view", {{"host", "firmware/core", "shared"}}},
    {"tests/host/touch", {{"host/touch", "hil/plain_replay.h", "shared", "tests/support"}}},
    {"host/touch", {{"firmware/core", "hil/plain_replay.h", "shared"}}},  // it runs in a page: no library of the host is there
    {"host/server",
     {{"host/view", "host/trace", "host/link", "host/cloud", "host/field_file", "host/files", "host/error.h", "host/to_double.h",
       "host/touch/hand_work.h", "shared"}}},
    {"host/commands", {{"host", "firmware/core", "shared"}}},
    {"host/to_double.h", {{"shared"}}},
    {"host/control_main.cpp", {{"host/board_commands"}}},
    {"host/main.cpp", {{"host/commands", "host/board_commands"}}},
    {"host", {{}}},
    {"hil/falcon_model", {{}}},  // a mistake shared with what it is to find would hide itself
    {"hil/falcon_sim",
     {{"hil/falcon_model", "host/board_commands/number_in.h", "host/board_commands/number_list.h", "shared/files/missing_folder.h",
       "packaging/manual"}}},
    {"hil/rig", {{"hil/rig/irq_sim.c"}}},
    {"hil/plain_replay.h", {{"firmware/core", "shared"}}},
    {"hil/bare_metal", {{"hil/plain_replay.h", "shared"}}},
    {"hil/instructions", {{}}},
    {"hil/outside", {{}}},
    {"tests/support", {{"firmware/core", "firmware/loop", "host/field_file/make_patch.h", "shared"}}},
    {"tests/host/field_file",
     {{"host/field_file", "host/encoding", "host/files", "host/error.h", "shared", "tests/support", "tests/host/encoding"}}},
    {"tests/host/trace",
     {{"host/trace", "host/motion", "host/field_file", "host/files", "host/error.h", "host/to_double.h", "firmware/core", "shared",
       "tests/support"}}},
    {"tests/integration",
     {{"host", "firmware/core", "hil/plain_replay.h", "shared", "tests/support", "tests/host/commands", "tests/host/evaluate",
       "tests/host/live"}}},
    {"tests/driver", {{"firmware", "hil/falcon_model", "shared", "tests/support"}}},
    {"tests/integration/controller_writers.cpp", {{"firmware", "shared", "tests/firmware/store", "tests/integration/killed_writers.h"}}},
    {"tests/fuzz", {{"host", "firmware", "shared", "tests/support", "tests/firmware/store"}}},
    {"tests/stability", {{"firmware/core", "hil/falcon_model", "shared", "tests/support"}}},
    {"tests/integration/link",
     {{"host", "firmware/control", "firmware/store", "firmware/loop", "shared", "tests/support", "tests/firmware/control",
       "tests/firmware/store"}}},
    {"tests", {{"tests/support"}}},
};

/// Headers that stand behind a seam: the only folder or file of ours that may include each.
const std::map<std::string, std::string> kBehindASeam = {{"libusb.h", "firmware/falcon"},
                                                         {"gpiod.h", "firmware/lines"},
                                                         {"toml++/toml.h", "firmware/settings"},
                                                         {"arm_neon.h", "firmware/core/four.h"}};

const std::set<std::string> kTickHeaders = {"algorithm", "arm_neon.h", "array",       "bit",         "cassert", "compare",
                                            "concepts",  "cstddef",    "cstdint",     "cstdlib",     "cstring", "limits",
                                            "optional",  "span",       "string_view", "type_traits", "utility"};

/// A word of the language or the library with what it would bring into the tick.
const std::vector<std::pair<std::regex, std::string>> kForbiddenInCore = {
    {std::regex(R"(\b(double|float)\b)"), "floating point: another machine may round it otherwise"},
    {std::regex(R"(\b\d+\.\d*f\b)"), "floating point: another machine may round it otherwise"},
    {std::regex(R"(\b(new|delete|malloc|calloc|realloc|free)\b)"), "allocation"},
    {std::regex(R"(\b(throw|try|catch)\b)"), "exceptions"},
    {std::regex(R"(\bstd::(vector|string|map|set|deque|list|function|unique_ptr|shared_ptr|optional|any)\b)"), "a type that may allocate"},
    {std::regex(R"(\bstd::(mutex|thread|atomic|chrono|condition_variable)\b)"), "threads or time"},
    {std::regex(R"(\b(time|clock|rand|printf|getenv|errno)\s*\()"), "the outside world"},
    {std::regex(R"(\b(virtual|dynamic_cast|typeid)\b)"), "a call whose target is not known here"},
    {std::regex(R"(\bstatic\s+(?!constexpr|const\b|inline|_))"), "state that outlives a call"},
    {std::regex(R"(\b(goto|asm|volatile)\b)"), "code that is not plain"},
};

/// Division costs a library call on small processors, unless it is by a power of two. Functions named make_... prepare the tick and may divide.
const std::regex kDivision(R"([/%]=?\s*(?!(?:2|4|8|16|32|64|128|256|512)\b)[^=\s])");
const std::regex kPreparation(R"(^\S.*\bmake_\w+\(.*\{$)");

struct Line {
  std::string place;  ///< file:line
  std::string text;   ///< as written
  std::string code;   ///< without comments and the content of literals
};

/// The lines of a file; comments and literals are blanked so that prose may use any word.
std::vector<Line> read_lines(const fs::path& file) {
  std::vector<Line> lines;
  std::ifstream in(file);
  bool in_block = false;
  int number = 0;
  for (std::string text; std::getline(in, text);) {
    std::string code;
    char quote = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
      const std::string two = text.substr(i, 2);
      if (in_block) {
        if (two == "*/") in_block = false, ++i;
      } else if (quote != 0) {
        if (text[i] == '\\')
          ++i;
        else if (text[i] == quote)
          quote = 0, code += text[i];
      } else if (two == "//") {
        break;
      } else if (two == "/*") {
        in_block = true, ++i;
      } else {
        const bool separates_digits = text[i] == '\'' && i > 0 && std::isxdigit(static_cast<unsigned char>(text[i - 1])) != 0;
        if (text[i] == '"' || (text[i] == '\'' && !separates_digits)) quote = text[i];
        code += text[i];
      }
    }
    lines.push_back({fs::relative(file, kRoot).string() + ":" + std::to_string(++number), text, code});
  }
  return lines;
}

/// Every source of ours, sorted.
std::vector<fs::path> sources() {
  std::vector<fs::path> files;
  for (const char* top : {"shared", "firmware", "host", "tests", "hil"}) {
    if (!fs::exists(kRoot / top)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kRoot / top)) {
      if (entry.path().string().find("/library/examples/") != std::string::npos) continue;  // they stand for programs of others
      if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool is_below(const std::string& path, const std::string& folder) { return path == folder || path.rfind(folder + "/", 0) == 0; }

/// The name of the rule for a file: its longest matching folder; empty when there is none.
std::string rule_for(const std::string& file) {
  std::string best;
  for (const auto& [folder, rule] : kRules) {
    if (is_below(file, folder) && folder.size() > best.size()) best = folder;
  }
  return best;
}

bool may_include(const std::string& file, const std::string& target) {
  const std::string folder = rule_for(file);
  if (!folder.empty() && kRules.at(folder).tick && is_below(target, "shared/files")) return false;
  const auto allowed_by = [&](const std::string& name) {
    const Words& project = kRules.at(name).project;
    return is_below(target, name) || std::any_of(project.begin(), project.end(), [&](const std::string& p) { return is_below(target, p); });
  };
  if (allowed_by(folder)) return true;
  // A test may include what the module it mirrors may.
  if (folder != "tests") return false;
  const std::string mirrored = rule_for(file.substr(std::string("tests/").size()));
  return !mirrored.empty() && allowed_by(mirrored);
}

/// What is wrong with the include on this line; empty when nothing is, or when it is none.
std::string complaint_on_include(const std::string& file, const std::string& text) {
  static const std::regex include(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::smatch match;
  if (!std::regex_search(text, match, include)) return {};
  const std::string target = match[2];
  if (match[1] == "\"") {
    if (!fs::exists(kRoot / target)) return "includes " + target + ", which is not a path from the root";
    if (!may_include(file, target)) return rule_for(file) + " may not include " + target;
  } else if (const auto seam = kBehindASeam.find(target);
             seam != kBehindASeam.end() && !is_below(file, seam->second) && !is_below(file, "tests/" + seam->second)) {
    return "includes <" + target + ">, which belongs to " + seam->second;
  } else if (kRules.at(rule_for(file)).tick && kTickHeaders.count(target) == 0) {
    return rule_for(file) + " may not include <" + target + ">: it runs in the tick";
  }
  return {};
}

TEST(Layering, EveryIncludeFollowsTheTable) {
  int includes = 0;
  for (const fs::path& path : sources()) {
    const std::string file = fs::relative(path, kRoot).string();
    ASSERT_FALSE(rule_for(file).empty()) << file << ":1: no rule for this folder";
    for (const Line& line : read_lines(path)) {
      if (line.text.find("#include") == std::string::npos) continue;
      ++includes;
      const std::string complaint = complaint_on_include(file, line.text);
      EXPECT_TRUE(complaint.empty()) << line.place << ": " << complaint;
    }
  }
  EXPECT_GT(includes, 100);
}

TEST(Layering, TheCoreHoldsNoForbiddenWord) {
  int lines = 0;
  for (const fs::path& path : sources()) {
    if (rule_for(fs::relative(path, kRoot).string()) != "firmware/core") continue;
    bool preparation = false;
    for (const Line& line : read_lines(path)) {
      ++lines;
      if (std::regex_search(line.code, kPreparation)) preparation = true;
      if (line.code == "}") preparation = false;
      if (line.code.find("#include") != std::string::npos) continue;
      for (const auto& [word, why] : kForbiddenInCore) {
        EXPECT_FALSE(std::regex_search(line.code, word)) << line.place << ": " << why << ": " << line.text;
      }
      EXPECT_TRUE(preparation || !std::regex_search(line.code, kDivision)) << line.place << ": division in the tick: " << line.text;
    }
  }
  EXPECT_GT(lines, 100);
}

TEST(Layering, TheControllerParsesAnImageInOnePlace) {
  std::vector<std::string> places;
  for (const fs::path& path : sources()) {
    if (fs::relative(path, kRoot).string().rfind("firmware/", 0) != 0) continue;
    for (const Line& line : read_lines(path)) {
      if (line.code.find("FieldView::parse") != std::string::npos) places.push_back(line.place);
    }
  }
  ASSERT_EQ(places.size(), 1U) << "an image that is parsed twice is checked twice: " << (places.empty() ? "" : places.back());
  EXPECT_EQ(places[0].rfind("firmware/loop/field_slots.cpp:", 0), 0U);
}

TEST(Layering, TheTestItselfSeesWhatItForbids) {
  EXPECT_FALSE(may_include("host/cloud/a.cpp", "firmware/core/render.h"));
  EXPECT_FALSE(may_include("host/cloud/a.cpp", "host/field/grid.h"));
  EXPECT_FALSE(may_include("firmware/core/a.cpp", "host/error.h"));
  EXPECT_FALSE(may_include("tests/host/cloud/a_test.cpp", "firmware/core/render.h"));
  EXPECT_FALSE(may_include("firmware/core/a.cpp", "shared/files/trace_file.h"));
  EXPECT_FALSE(may_include("shared/a.cpp", "shared/files/trace_file.h"));
  EXPECT_TRUE(may_include("firmware/recording/a.cpp", "shared/files/trace_file.h"));
  EXPECT_FALSE(may_include("hil/falcon_model/a.cpp", "shared/crc32.h"));
  EXPECT_FALSE(may_include("hil/falcon_sim/a.cpp", "firmware/core/render.h"));
  EXPECT_TRUE(may_include("tests/host/cloud/a_test.cpp", "host/error.h"));
  EXPECT_TRUE(may_include("tests/firmware/core/a_test.cpp", "shared/units.h"));
  EXPECT_TRUE(may_include("host/view/a.cpp", "firmware/core/render.h"));
  EXPECT_FALSE(complaint_on_include("shared/a.h", "#include <vector>").empty());
  EXPECT_FALSE(complaint_on_include("host/a.h", "#include \"error.h\"").empty());
  EXPECT_FALSE(complaint_on_include("firmware/loop/a.h", "#include <libusb.h>").empty());
  EXPECT_TRUE(complaint_on_include("firmware/falcon/a.h", "#include <libusb.h>").empty());
  EXPECT_FALSE(may_include("firmware/falcon/a.cpp", "firmware/core/render.h"));
  EXPECT_FALSE(may_include("firmware/loop/a.cpp", "firmware/falcon/falcon_link.h"));
  EXPECT_TRUE(may_include("firmware/control/a.cpp", "firmware/loop/clock.h"));
  EXPECT_TRUE(std::regex_search("x = a / b;", kDivision));
  EXPECT_TRUE(std::regex_search("x %= 7;", kDivision));
  EXPECT_FALSE(std::regex_search("x = a / 2;", kDivision));
  EXPECT_TRUE(std::regex_search("Coupling make_coupling(int x) {", kPreparation));
  EXPECT_FALSE(std::regex_search("  make_coupling(x);", kPreparation));
  const auto forbidden = [](const std::string& code) {
    return std::any_of(kForbiddenInCore.begin(), kForbiddenInCore.end(),
                       [&](const auto& word) { return std::regex_search(code, word.first); });
  };
  for (const char* code : {"double x;", "auto* p = new int;", "throw 1;", "std::vector<int> v;", "static int calls = 0;", "y = 1.5f;"}) {
    EXPECT_TRUE(forbidden(code)) << code;
  }
  for (const char* code : {"static constexpr int kSteps = 3;", "renew(x);", "const Newton force;"}) EXPECT_FALSE(forbidden(code)) << code;
}

}  // namespace
}  // namespace isotouch
