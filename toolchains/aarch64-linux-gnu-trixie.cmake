set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(TRIPLE aarch64-linux-gnu)
set(QEMU qemu-aarch64)
set(SYSROOT arm64-trixie)
include(${CMAKE_CURRENT_LIST_DIR}/arm-linux-common.cmake)
# The compiler's own C library is that of its release: the root's comes first.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-B${CMAKE_SYSROOT}/usr/lib/${TRIPLE} -L${CMAKE_SYSROOT}/usr/lib/${TRIPLE}")
