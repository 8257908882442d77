# Debian's cross compilers against a root of target libraries that `./dev setup test` unpacks below build/sysroot.
# Wants TRIPLE, QEMU and SYSROOT, its name there, from the file that includes it.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_CXX_COMPILER ${TRIPLE}-g++)
set(CMAKE_LIBRARY_ARCHITECTURE ${TRIPLE})
cmake_path(ABSOLUTE_PATH SYSROOT BASE_DIRECTORY ${CMAKE_CURRENT_LIST_DIR}/../build/sysroot NORMALIZE OUTPUT_VARIABLE CMAKE_SYSROOT)
set(CMAKE_CROSSCOMPILING_EMULATOR ${QEMU} -L ${CMAKE_SYSROOT})

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# pkg-config knows nothing of the root above unless it is told.
set(ENV{PKG_CONFIG_SYSROOT_DIR} ${CMAKE_SYSROOT})
set(ENV{PKG_CONFIG_LIBDIR} ${CMAKE_SYSROOT}/usr/lib/${TRIPLE}/pkgconfig:${CMAKE_SYSROOT}/usr/share/pkgconfig)
