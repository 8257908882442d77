# The libraries for programs of others, in three components, each with its part of the CMake package: "library" (isotouch::isotouch), "build-library"
# (isotouch::build) and "core" (isotouch::core). The files find each other wherever the prefix is moved to.
include(CMakePackageConfigHelpers)
set(cmake_package ${CMAKE_INSTALL_LIBDIR}/cmake/isotouch)
set(pkg_config ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# The core, as people link it into a controller or a simulator of their own.
add_library(isotouch_core STATIC $<TARGET_OBJECTS:isotouch_shared> $<TARGET_OBJECTS:isotouch_firmware_core>)
set_target_properties(isotouch_core PROPERTIES LINKER_LANGUAGE CXX EXPORT_NAME core ARCHIVE_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
target_compile_features(isotouch_core INTERFACE cxx_std_20)
target_include_directories(isotouch_core INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/isotouch-core>)

configure_package_config_file(library/isotouchConfig.cmake.in isotouchConfig.cmake INSTALL_DESTINATION ${cmake_package})
write_basic_package_version_file(isotouchConfigVersion.cmake COMPATIBILITY SameMinorVersion)
file(RELATIVE_PATH up /${pkg_config} /)

# What each component installs; a library that was not built, for another processor, is left out.
function(isotouch_installed part target component)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${part})
  isotouch_install(${target} EXPORT isotouch-${part}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component}
          INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT isotouch-${part} NAMESPACE isotouch:: DESTINATION ${cmake_package} COMPONENT ${component})
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/isotouchConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/isotouchConfigVersion.cmake
          DESTINATION ${cmake_package} COMPONENT ${component})
endfunction()
function(isotouch_pkg_config module library what requires component)
  configure_file(library/isotouch.pc.in ${module}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${module}.pc DESTINATION ${pkg_config} COMPONENT ${component})
endfunction()

isotouch_installed(core isotouch_core core)
foreach(folder shared firmware/core)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/isotouch-core/${folder} COMPONENT core
          FILES_MATCHING PATTERN "*.h" PATTERN files EXCLUDE)
endforeach()
if(ISOTOUCH_HOST)
  isotouch_installed(isotouch isotouch_host_library library)
  install(FILES ${PROJECT_SOURCE_DIR}/host/library/isotouch.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library)
  isotouch_pkg_config(isotouch isotouch "Touch, sample and record distance fields by the integer core of isotouch" "" library)
endif()
if(ISOTOUCH_HOST AND NOT CMAKE_CROSSCOMPILING)   # fields are built on desks
  isotouch_installed(build isotouch_host_build_library build-library)
  install(FILES ${PROJECT_SOURCE_DIR}/host/build_library/isotouch_build.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT build-library)
  isotouch_pkg_config(isotouch-build isotouch_build "Build distance fields of oriented points" "Requires: isotouch" build-library)
endif()
