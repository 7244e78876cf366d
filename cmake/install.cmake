# What users link, and how they find it once it is installed: find_package(kerf) gives kerf::bsp, kerf::c, kerf::scene,
# kerf::recording and kerf::adapters, and each library has a pkg-config file. Headers are included as in this repository,
# for example #include "core/bsp/bsp.h"; that of C is <kerf.h>. A build installs shared libraries or static ones; those of
# two builds lie beside each other.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

option(KERF_INSTALL "Install what is for users" ${PROJECT_IS_TOP_LEVEL})
set(kerf_headers ${CMAKE_INSTALL_INCLUDEDIR}/kerf)
set(kerf_package ${CMAKE_INSTALL_LIBDIR}/cmake/kerf)
set(kerf_kind static)
if(BUILD_SHARED_LIBS)
  set(kerf_kind shared)
endif()

# kerf_for_users(TARGET [EXPORTS FILE]) makes the library kerf_PART known as kerf::PART, here and where it is installed.
#   EXPORTS  a list of names in cmake/: the library is for C, and exports these
function(kerf_for_users target)
  cmake_parse_arguments(PARSE_ARGV 1 users "" "EXPORTS" "")
  string(REPLACE "kerf_" "" part ${target})
  add_library(kerf::${part} ALIAS ${target})
  get_target_property(type ${target} TYPE)
  set(exports ${PROJECT_SOURCE_DIR}/cmake/exported_names)
  set(scope PUBLIC)
  if(type STREQUAL "INTERFACE_LIBRARY")
    set(scope INTERFACE)
  endif()
  if(users_EXPORTS)
    set(exports ${PROJECT_SOURCE_DIR}/cmake/${users_EXPORTS})
  else()
    target_compile_features(${target} ${scope} cxx_std_20)
  endif()
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${part} VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} DEFINE_SYMBOL "")
  if(type STREQUAL "SHARED_LIBRARY")
    # Exports no names of other libraries that are compiled in.
    target_link_options(${target} PRIVATE LINKER:--version-script=${exports})
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${exports})
    # Our libraries find each other wherever they lie; where the system looks by itself, none of them says where.
    if(NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr")
      set_property(TARGET ${target} PROPERTY INSTALL_RPATH "$ORIGIN")
    endif()
  endif()
  if(KERF_INSTALL)
    get_target_property(sets ${target} INTERFACE_HEADER_SETS)
    list(TRANSFORM sets REPLACE "(.+)" "FILE_SET;\\1;DESTINATION;${kerf_headers};COMPONENT;development")
    install(TARGETS ${target} EXPORT kerf-targets
      LIBRARY COMPONENT runtime NAMELINK_COMPONENT development
      ARCHIVE COMPONENT development ${sets})
  endif()
endfunction()

# kerf_pkg_config(TARGET DESCRIPTION [OURS TARGET...] [OTHERS MODULE...] [LIBRARIES NAME...]) installs kerf-PART.pc, or
# kerf.pc for the library of that name. A static library requires the others publicly, and libraries that have no module:
# a program that links it needs them, too.
function(kerf_pkg_config target KERF_DESCRIPTION)
  cmake_parse_arguments(PARSE_ARGV 2 needs "" "" "OURS;OTHERS;LIBRARIES")
  get_target_property(KERF_LIBRARY ${target} OUTPUT_NAME)
  if(NOT KERF_LIBRARY)
    set(KERF_LIBRARY ${target})
  endif()
  string(REPLACE "_" "-" KERF_MODULE ${KERF_LIBRARY})
  string(REPLACE "_" "-" KERF_REQUIRES "${needs_OURS}")
  set(KERF_REQUIRES_PRIVATE ${needs_OTHERS})
  get_target_property(type ${target} TYPE)
  if(NOT type STREQUAL "SHARED_LIBRARY")
    list(APPEND KERF_REQUIRES ${needs_OTHERS})
    set(KERF_REQUIRES_PRIVATE)
    list(TRANSFORM needs_LIBRARIES PREPEND " -l" OUTPUT_VARIABLE KERF_LIBRARIES)
    list(JOIN KERF_LIBRARIES "" KERF_LIBRARIES)
  endif()
  list(JOIN KERF_REQUIRES " " KERF_REQUIRES)
  list(JOIN KERF_REQUIRES_PRIVATE " " KERF_REQUIRES_PRIVATE)
  set(KERF_PREFIX ${CMAKE_INSTALL_PREFIX})
  if(NOT IS_ABSOLUTE ${CMAKE_INSTALL_LIBDIR})  # then it holds wherever `cmake --install --prefix` puts it
    file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
    string(REGEX REPLACE "/$" "" KERF_PREFIX "\${pcfiledir}/${up}")
  endif()
  configure_file(${PROJECT_SOURCE_DIR}/cmake/kerf.pc.in ${PROJECT_BINARY_DIR}/${KERF_MODULE}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${KERF_MODULE}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT development)
endfunction()

# kerf_install_package() installs what find_package(kerf) reads.
function(kerf_install_package)
  install(EXPORT kerf-targets NAMESPACE kerf:: DESTINATION ${kerf_package} FILE kerf-${kerf_kind}-targets.cmake
    COMPONENT development)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/kerf-config.cmake.in ${PROJECT_BINARY_DIR}/kerf-config.cmake
    INSTALL_DESTINATION ${kerf_package})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/kerf-config-version.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/kerf-config.cmake ${PROJECT_BINARY_DIR}/kerf-config-version.cmake
    DESTINATION ${kerf_package} COMPONENT development)
endfunction()
