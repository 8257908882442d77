/// For std::unique_ptr: objects of C libraries, which a function frees.
#pragma once

namespace isotouch::io {

template <auto kFree>
struct Freed {
  template <class T>
  void operator()(T* object) const {
    kFree(object);
  }
};

}  // namespace isotouch::io
