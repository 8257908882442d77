/// For std::unique_ptr: objects of C libraries, which a function frees.
#pragma once

namespace isotouch::files {

template <auto kFree>
struct CDeleter {
  template <class T>
  void operator()(T* object) const {
    kFree(object);
  }
};

}  // namespace isotouch::files
