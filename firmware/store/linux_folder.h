/// A folder of the machine's file system.
#pragma once

#include <string>
#include <vector>

#include "firmware/store/folder.h"

namespace isotouch::store {

class LinuxFolder final : public Folder {
 public:
  /// Opens the folder, made if there is none (mode 0700, without parents), and locks it for as long as it lives: two controllers must not share one.
  /// `is_open` tells whether that worked, `trouble` why not: kInUse where another program, or another object of this one, has it.
  explicit LinuxFolder(const std::string& path);
  ~LinuxFolder() override;
  LinuxFolder(const LinuxFolder&) = delete;
  LinuxFolder& operator=(const LinuxFolder&) = delete;

  bool is_open() const { return folder_ >= 0; }
  StoreError trouble() const { return trouble_; }

  std::vector<std::string> names() override;
  StoreResult<std::uint64_t> size(const std::string& name) override;
  StoreResult<std::size_t> read(const std::string& name, std::span<std::uint8_t> out) override;
  StoreResult<void> write(const std::string& name, std::span<const std::uint8_t> bytes) override;
  StoreResult<void> sync(const std::string& name) override;
  StoreResult<void> rename(const std::string& from, const std::string& to) override;
  StoreResult<void> remove(const std::string& name) override;
  StoreResult<void> sync_names() override;

 private:
  int folder_ = -1;
  StoreError trouble_{};
};

}  // namespace isotouch::store
