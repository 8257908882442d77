# What the programs consist of, as an SPDX document that is made when the build is configured: each library with the version that was found, its licence, and
# the shared object that a program needs; a library of headers alone has none. tests/integration/components reads it beside the programs.
find_package(PkgConfig REQUIRED)

set(components)
function(isotouch_component name version licence shared)
  if(NOT version)
    message(FATAL_ERROR "No version of ${name} is known: install the file of pkg-config that comes with it")
  endif()
  string(CONFIGURE [[{
      "SPDXID": "SPDXRef-@name@",
      "name": "@name@",
      "versionInfo": "@version@",
      "downloadLocation": "NOASSERTION",
      "filesAnalyzed": false,
      "licenseConcluded": "@licence@",
      "licenseDeclared": "@licence@",
      "copyrightText": "NOASSERTION",
      "packageFileName": "@shared@"
    }]] component @ONLY)
  set(components "${components}${component}@" PARENT_SCOPE)
endfunction()
macro(isotouch_component_of module name licence shared)
  pkg_check_modules(component_of QUIET ${module})
  isotouch_component(${name} "${component_of_VERSION}" ${licence} "${shared}")
endmacro()

isotouch_component_of(CLI11 CLI11 BSD-3-Clause "")
isotouch_component_of(libzstd zstd BSD-3-Clause libzstd.so)
if(ISOTOUCH_DEVICE)
  isotouch_component(libusb "${libusb_VERSION}" LGPL-2.1-or-later libusb-1.0.so)
  if(libgpiod_FOUND)
    isotouch_component(libgpiod "${libgpiod_VERSION}" LGPL-2.1-or-later libgpiod.so)
  endif()
  isotouch_component_of(tomlplusplus tomlplusplus MIT "")
endif()
if(ISOTOUCH_HOST)
  isotouch_component_of(eigen3 Eigen MPL-2.0 "")
  isotouch_component_of(nanoflann nanoflann BSD-2-Clause "")
  isotouch_component_of(nlohmann_json nlohmann-json MIT "")
  isotouch_component_of(libpng libpng libpng-2.0 libpng16.so)
  isotouch_component_of(cairo cairo LGPL-2.1-only libcairo.so)
  isotouch_component_of(sqlite3 SQLite blessing libsqlite3.so)
endif()
if(ISOTOUCH_VIEW)
  find_path(BOOST_INCLUDE_DIR boost/version.hpp REQUIRED)
  file(STRINGS ${BOOST_INCLUDE_DIR}/boost/version.hpp boost_version REGEX "define BOOST_LIB_VERSION")
  string(REGEX REPLACE ".*\"([0-9_]+)\".*" "\\1" boost_version "${boost_version}")
  string(REPLACE "_" "." boost_version "${boost_version}")
  isotouch_component(Boost "${boost_version}" BSL-1.0 "")
  file(READ ${PROJECT_SOURCE_DIR}/host/page/package.json page_packages)   # they are in the page that the program carries
  foreach(package three uplot)
    string(JSON package_version GET "${page_packages}" dependencies ${package})
    isotouch_component(${package} "${package_version}" MIT "")
  endforeach()
endif()
if(ISOTOUCH_HOST AND ISOTOUCH_OPENVDB)
  find_path(OPENVDB_INCLUDE_DIR openvdb/openvdb.h REQUIRED)
  file(STRINGS ${OPENVDB_INCLUDE_DIR}/openvdb/version.h numbers REGEX "define OPENVDB_LIBRARY_(MAJOR|MINOR|PATCH)_VERSION_NUMBER +[0-9]+")
  string(REGEX REPLACE "[^;]*NUMBER +([0-9]+)[^;]*" "\\1" numbers "${numbers}")
  list(JOIN numbers "." openvdb_version)
  isotouch_component(OpenVDB "${openvdb_version}" MPL-2.0 libopenvdb.so)
  isotouch_component_of(tbb oneTBB Apache-2.0 libtbb.so)
  pkg_check_modules(imath QUIET Imath)
  string(REGEX REPLACE "^([0-9]+)\\.([0-9]+).*" "libImath-\\1_\\2.so" imath_object "${imath_VERSION}")
  isotouch_component(Imath "${imath_VERSION}" BSD-3-Clause "${imath_object}")
endif()

set(relations)
string(REGEX MATCHALL "SPDXRef-[A-Za-z0-9-]+" ids "${components}")
foreach(id ${ids})
  string(APPEND relations ",\n    {\"spdxElementId\": \"SPDXRef-isotouch\", \"relationshipType\": \"DEPENDS_ON\", \"relatedSpdxElement\": \"${id}\"}")
endforeach()
string(REPLACE "@" ",\n    " packages "${components}")
set(epoch "$ENV{SOURCE_DATE_EPOCH}")
set(ENV{SOURCE_DATE_EPOCH} ${made_at})
string(TIMESTAMP created "%Y-%m-%dT%H:%M:%SZ" UTC)
if(NOT epoch)
  unset(ENV{SOURCE_DATE_EPOCH})
endif()
file(CONFIGURE OUTPUT isotouch.spdx.json @ONLY CONTENT [[{
  "spdxVersion": "SPDX-2.3",
  "dataLicense": "CC0-1.0",
  "SPDXID": "SPDXRef-DOCUMENT",
  "name": "isotouch-@PROJECT_VERSION@",
  "documentNamespace": "https://spdx.org/spdxdocs/isotouch-@PROJECT_VERSION@-@ISOTOUCH_COMMIT@",
  "creationInfo": {"created": "@created@", "creators": ["Tool: CMake-@CMAKE_VERSION@"]},
  "packages": [
    @packages@{
      "SPDXID": "SPDXRef-isotouch",
      "name": "isotouch",
      "versionInfo": "@PROJECT_VERSION@+@ISOTOUCH_COMMIT@",
      "downloadLocation": "NOASSERTION",
      "filesAnalyzed": false,
      "licenseConcluded": "NOASSERTION",
      "licenseDeclared": "NOASSERTION",
      "copyrightText": "NOASSERTION"
    }
  ],
  "relationships": [
    {"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": "SPDXRef-isotouch"}@relations@
  ]
}
]])
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/isotouch.spdx.json DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT daemon)
