/// Work on the rows of a picture with every processor there is. Rows do not know each other, so the picture is the same on any number of
/// them.
#pragma once

#include <atomic>
#include <system_error>
#include <thread>
#include <vector>

namespace isotouch::view {

/// work      called once with every number from 0 to rows - 1, from several threads; must not throw
template <class Work>
void for_each_row(int rows, const Work& work) {
  std::atomic<int> next{0};
  const auto take_rows = [&] {
    for (int y = next++; y < rows; y = next++) work(y);
  };
  std::vector<std::jthread> helpers;
  for (unsigned thread = 1; thread < std::thread::hardware_concurrency(); ++thread) {
    try {
      helpers.emplace_back(take_rows);
    } catch (const std::system_error&) {
      break;  // the system gives no more; those that there are take all
    }
  }
  take_rows();
}

}  // namespace isotouch::view
