#include "shared/files/missing_folder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include "tests/support/scratch_folder.h"

namespace isotouch::files {
namespace {

TEST(MissingFolder, OfAFolderThatIsThereNothingIsSaid) {
  const ScratchFolder folder;
  EXPECT_FALSE(refusal_of_missing_folder(folder.path() / "a"));
  EXPECT_FALSE(refusal_of_missing_folder("a"));
  const Refusal missing = refusal_of_missing_folder(folder.path() / "inner" / "a");
  ASSERT_TRUE(missing);
  EXPECT_NE(missing.sentence().find("there is no folder " + (folder.path() / "inner").string()), std::string::npos);
}

TEST(MissingFolder, WhoMayNotLookIsNotToldThatItIsMissing) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can become somebody else";
  const ScratchFolder folder;
  std::filesystem::create_directories(folder.path() / "closed" / "inner");
  std::filesystem::permissions(folder.path() / "closed", std::filesystem::perms::none);
  const pid_t child = fork();
  if (child == 0) {
    if (seteuid(65534) != 0) _exit(2);
    _exit(refusal_of_missing_folder(folder.path() / "closed" / "inner" / "a") ? 1 : 0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  std::filesystem::permissions(folder.path() / "closed", std::filesystem::perms::owner_all);
}

}  // namespace
}  // namespace isotouch::files
