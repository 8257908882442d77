# 64-bit RISC-V with Debian's cross compiler and its own C library. Debian 12 has no archive for this processor, so there is no root of target libraries: only
# what needs none is built.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR riscv64)
set(CMAKE_CXX_COMPILER riscv64-linux-gnu-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-riscv64 -L /usr/riscv64-linux-gnu)
