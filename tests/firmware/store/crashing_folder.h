/// A folder in memory that can lose power: what was not synced is then kept, lost or torn as the test says.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "firmware/store/folder.h"

namespace isotouch::store {

using FileBytes = std::vector<std::uint8_t>;

class CrashingFolder final : public Folder {
 public:
  /// What becomes of content that was not synced.
  enum class Content { kKept, kEmpty, kTorn };

  /// The power fails in the step after so many: it and all later ones do nothing and fail. Negative: never.
  int steps_left = -1;
  int steps = 0;  ///< done since the beginning
  /// The storage is full from here on.
  bool full = false;
  /// What another thread does after the next read, once.
  std::function<void()> after_read;
  /// Changes of names that are not synced.
  std::size_t pending() const { return pending_.size(); }

  /// What a new start finds.
  ///
  /// kept      bit i: the i-th pending change of names came through
  CrashingFolder after_power_cut(unsigned kept, Content content) const {
    CrashingFolder next;
    std::map<std::string, Inode> names = synced_;
    for (std::size_t i = 0; i < pending_.size(); ++i) {
      if ((kept >> i & 1U) != 0) pending_[i](names);
    }
    for (const auto& [name, inode] : names) {
      const bool lost = !inode->synced && content != Content::kKept;
      auto copy = std::make_shared<File>(*inode);
      if (lost) copy->bytes.resize(content == Content::kTorn ? copy->bytes.size() / 2 : 0);
      copy->synced = true;
      next.synced_[name] = next.names_[name] = copy;
    }
    return next;
  }

  std::vector<std::string> names() override {
    std::vector<std::string> all;
    for (const auto& [name, inode] : names_) all.push_back(name);
    std::reverse(all.begin(), all.end());  // in any order
    return all;
  }
  StoreResult<std::uint64_t> size(const std::string& name) override {
    if (names_.count(name) == 0) return StoreError::kNotFound;
    return std::uint64_t{names_.at(name)->bytes.size()};
  }
  StoreResult<std::size_t> read(const std::string& name, std::span<std::uint8_t> out) override {
    if (names_.count(name) == 0) return StoreError::kNotFound;
    const FileBytes& bytes = names_.at(name)->bytes;
    if (bytes.size() > out.size()) return StoreError::kTooLarge;
    std::copy(bytes.begin(), bytes.end(), out.begin());
    const std::size_t size = bytes.size();
    if (const auto then = std::exchange(after_read, {})) then();
    return size;
  }
  StoreResult<void> write(const std::string& name, std::span<const std::uint8_t> bytes) override {
    const bool first_without_power = steps_left == 0 && !failed_;  // it falls into this write: a part of the bytes may be there
    if (!step() && !first_without_power) return StoreError::kFailed;
    const std::size_t taken = first_without_power || full ? bytes.size() / 3 : bytes.size();
    const auto inode = std::make_shared<File>();
    inode->bytes.assign(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(taken));
    change([name, inode](auto& names) { names[name] = inode; });
    if (first_without_power) return StoreError::kFailed;
    if (full) return StoreError::kNoSpace;
    return {};
  }
  StoreResult<void> sync(const std::string& name) override {
    if (!step()) return StoreError::kFailed;
    names_.at(name)->synced = true;
    return {};
  }
  StoreResult<void> rename(const std::string& from, const std::string& to) override {
    if (!step()) return StoreError::kFailed;
    if (names_.count(from) == 0) return StoreError::kNotFound;
    // Applied to what a power cut left, the old name may be missing: then nothing is renamed.
    change([from, to](auto& names) {
      if (names.count(from) == 0) return;
      names[to] = names[from];
      names.erase(from);
    });
    return {};
  }
  StoreResult<void> remove(const std::string& name) override {
    if (!step()) return StoreError::kFailed;
    if (names_.count(name) == 0) return StoreError::kNotFound;
    change([name](auto& names) { names.erase(name); });
    return {};
  }
  StoreResult<void> sync_names() override {
    if (!step()) return StoreError::kFailed;
    synced_ = names_;
    pending_.clear();
    return {};
  }

 private:
  struct File {
    FileBytes bytes;
    bool synced = false;
  };
  using Inode = std::shared_ptr<File>;
  using Change = std::function<void(std::map<std::string, Inode>&)>;

  bool step() {
    failed_ |= steps_left == 0;
    if (failed_) return false;
    if (steps_left > 0) --steps_left;
    ++steps;
    return true;
  }
  void change(const Change& change) {
    change(names_);
    pending_.push_back(change);
  }

  std::map<std::string, Inode> names_, synced_;
  std::vector<Change> pending_;
  bool failed_ = false;
};

}  // namespace isotouch::store
