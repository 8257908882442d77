# WebAssembly with Debian's clang. Debian: clang lld wasi-libc libc++-dev-wasm32 libclang-rt-dev-wasm32; programs run in nodejs.
# This library has no exceptions: what would throw calls abort, which ends the instance by a trap. errno is a global variable.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_FLAGS_INIT -fno-exceptions)
set(CMAKE_EXE_LINKER_FLAGS_INIT -Wl,--stack-first)   # a stack of 64 kB that overflows traps; behind the data it would change them
set(CMAKE_EXECUTABLE_SUFFIX_CXX .wasm)
set(CMAKE_CROSSCOMPILING_EMULATOR ${CMAKE_CURRENT_LIST_DIR}/../hil/webassembly/run_in_node)
