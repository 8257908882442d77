#include "host/board_commands/output.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "host/commands/commands.h"
#include "host/error.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::commands {
namespace {

using ::testing::HasSubstr;

std::string refusal(const std::string& name, const Forms& all, const std::string& named = {}, const std::string& hint = {}) {
  try {
    (void)form_of(name, all, named, hint);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no refusal";
}

const Forms kOne = {&forms::kField};
const Forms kSeveral = {&forms::kField, &forms::kObj};

TEST(Output, TheNameDecides) {
  EXPECT_EQ(form_of("a/b.itf", kOne)->ending, ".itf");
  EXPECT_EQ(form_of("a.b.ITF", kOne)->ending, ".itf");
  EXPECT_EQ(form_of("field", kOne)->ending, ".itf") << "nothing else can be meant";
  EXPECT_EQ(form_of("/dev/null", kOne)->ending, ".itf");
  EXPECT_EQ(form_of("-", kOne)->ending, ".itf");
  EXPECT_EQ(form_of("a.obj", kSeveral)->ending, ".obj");
  EXPECT_EQ(form_of("-", kSeveral, "obj")->ending, ".obj");
  EXPECT_EQ(form_of("a.obj", kSeveral, "obj")->ending, ".obj");
}

TEST(Output, AnotherNameIsRefusedWithTheFormsThatThereAre) {
  EXPECT_EQ(refusal("a.jpg", kSeveral), "a.jpg: this command does not write .jpg; it writes .itf (a field, packed), .obj (Wavefront OBJ)");
  EXPECT_EQ(refusal("a.vdb", kOne, {}, "use export"),
            "a.vdb: this command does not write .vdb; it writes .itf (a field, packed); use export");
  EXPECT_THAT(refusal("-", kSeveral), HasSubstr("-: its name does not say what to write; say it with --format: .itf"));
  EXPECT_EQ(refusal("a.itf", kSeveral, "obj"), "a.itf: its name asks for .itf, and --format for obj; leave one of them out");
}

TEST(Output, AFolderHasNoFilesName) {
  EXPECT_NO_THROW(require_folder("build/demo"));
  EXPECT_NO_THROW(require_folder("demo.1"));
  EXPECT_THROW(require_folder("demo.png"), InputError);
  EXPECT_THROW(require_folder("-"), InputError);
}

/// Every option of a command below `app` that names a file to write, with the words that lead to it.
void each_output(const CLI::App& app, const std::string& words, const std::function<void(const std::string&)>& use) {
  for (const CLI::Option* option : app.get_options()) {
    const bool is_output = option->check_lname("out") || option->check_lname("worst") ||
                           (words == " scan" && option->check_lname("trace")) || (words == " qualify" && option->check_lname("json")) ||
                           (words == " stream" && option->check_lname("first"));
    if (is_output) use(words + " --" + option->get_lnames().front());
  }
  for (const CLI::App* command : app.get_subcommands(nullptr)) each_output(*command, words + ' ' + command->get_name(), use);
}

/// What a command says of a file to write.
std::string said_of(const std::string& option, const std::string& file) {
  CLI::App app;
  add_all(app);
  const std::string field = ISOTOUCH_GOLDEN "/field_1_1.itf";
  try {
    app.parse(option.substr(1) + ' ' + file + (option == " export --out" ? ' ' + field : ""));
  } catch (const InputError& e) {
    return e.what();
  } catch (const CLI::ParseError& e) {
    return std::string("usage: ") + e.what();
  }
  return "nothing";
}

TEST(Output, NoCommandWritesUnderAnUnknownEnding) {
  CLI::App all;
  add_all(all);
  int asked = 0;
  each_output(all, "", [&](const std::string& option) {
    if (option == " demo --out") return;  // a folder
    EXPECT_THAT(said_of(option, "a.nonsense"), HasSubstr("a.nonsense: this command does not write .nonsense; it writes .")) << option;
    ++asked;
  });
  EXPECT_EQ(asked, 25) << "a new command that writes a file? count it here";
}

/// Hours of work would end in a file that nobody can write.
TEST(Output, NoCommandWorksForAFolderThatIsMissing) {
  const ScratchFolder folder;
  CLI::App all;
  add_all(all);
  int asked = 0;
  each_output(all, "", [&](const std::string& option) {
    if (option == " demo --out" || option == " export --out") return;  // a folder; and one whose work is short
    const std::string endings = said_of(option, "a.nonsense");
    const std::size_t first = endings.find("it writes ") + 10;
    const std::string ending = endings.substr(first, endings.find(' ', first) - first);
    EXPECT_THAT(said_of(option, "missing/a" + ending), HasSubstr("there is no folder missing; make it")) << option;
    const std::string taken = (folder.path() / ("a" + ending)).string();
    std::filesystem::create_directory(taken);
    EXPECT_THAT(said_of(option, taken), HasSubstr("it is a folder, name a file")) << option;
    ++asked;
  });
  EXPECT_EQ(asked, 24);
}

}  // namespace
}  // namespace isotouch::commands
