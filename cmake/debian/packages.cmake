# The Debian packages, by CPack, from two builds: one with static libraries, which gives only these, and one with shared
# ones, which gives the rest (`./run packages`).
#   libkerf0.2   the shared libraries       (component runtime)
#   libkerf-dev  headers, static libraries  (component development)
#   kerf         the program                (component program)
#   python3-kerf the Python module          (component python, if KERF_PYTHON)
#   kerf-doc     the pages of docs/         (component documentation)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME kerf)
# apt-get installs nothing over the same version, so each build has a higher one.
string(TIMESTAMP built "%Y%m%d%H%M" UTC)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION}+${built})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/check_tools.cmake)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The Kerf authors <kerf@kerf.invalid>" CACHE STRING "Who maintains the packages")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL runtime development program documentation)
if(KERF_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_COMPONENTS_STATIC development)  # what the build with static libraries gives

set(abi ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(about "Kerf reports which axis-aligned boxes overlap while they move, in 2D and
3D: the broad phase of collision detection. It stands on semi-adjusting BSP
trees, and is exact.")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # the first line of each description is one

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libkerf${abi})
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "broad phase of collision detection - shared libraries\n${about}")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY "=")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/debian/triggers)
install(FILES cmake/debian/libkerf.lintian DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides COMPONENT runtime
  RENAME libkerf${abi} EXCLUDE_FROM_ALL)

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libkerf-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "broad phase of collision detection - headers\n${about}

This package has headers, static libraries, files for CMake and pkg-config,
examples, and adapters with which Bullet, ODE, FCL and Box2D use the broad
phase.")
string(CONCAT CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libkerf${abi} (= ${CPACK_PACKAGE_VERSION}), "
  "libhwy-dev, libtbb-dev, libxxhash-dev, libsqlite3-dev, libzstd-dev, pkgconf | pkg-config")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "kerf-doc, libbullet-dev, libode-dev, libfcl-dev, libbox2d-dev")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME kerf)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "broad phase of collision detection - to see and measure it\n${about}

This package has the program kerf, which renders, records, debugs and
measures the broad phase in scenes of physics and in what other engines
recorded.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/core)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_COMPONENT_PROGRAM_DEPENDS runtime)
# These are loaded or run by name. Only Debian 12 and 13 have OSMesa; without it, EGL draws.
set(drawing "libosmesa6 | libegl-mesa0, libosmesa6 | libegl1")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS ${drawing})
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "ffmpeg, gnuplot-nox | gnuplot")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "kerf-doc, parallel")

set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_NAME kerf-doc)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_ARCHITECTURE all)
set(CPACK_COMPONENT_DOCUMENTATION_DESCRIPTION "broad phase of collision detection - documentation\n${about}

This package has the pages about the program, the libraries and the Python
module, with their pictures, notebooks and studies.")

if(KERF_PYTHON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-kerf)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "broad phase of collision detection - Python 3\n${about}

This package has the module kerf: the broad phase for numpy, its queries, and
recordings, pictures and checks of broad phases.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_COMPONENT_PYTHON_DEPENDS runtime)
  math(EXPR next "${Python_VERSION_MINOR} + 1")  # the module is loaded by this Python 3 only
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.${Python_VERSION_MINOR}~), python3 (<< 3.${next}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS ${drawing})
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS kerf-doc)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/debian/python/postinst
    ${PROJECT_SOURCE_DIR}/cmake/debian/python/prerm)
endif()

# The pages' links to each other hold in the package, and so does what the program calls docs/NAME.md.
set(pages DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/kerf-doc COMPONENT documentation EXCLUDE_FROM_ALL)
install(FILES README.md CHANGELOG.md LICENSE ${pages})
install(DIRECTORY docs studies ${pages} PATTERN Doxyfile EXCLUDE PATTERN reference.md EXCLUDE)

# The example is beside the sample of README.md, as it is here.
set(examples DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libkerf-dev/examples COMPONENT development EXCLUDE_FROM_ALL)
install(FILES tests/embed/main.cpp ${examples})
install(DIRECTORY tests/embed/example tests/embed/adapters ${examples})

# What Debian wants of each package: copyright and changelog.
file(READ LICENSE licence)
configure_file(cmake/debian/copyright.in ${PROJECT_BINARY_DIR}/copyright @ONLY)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(changelog ${PROJECT_BINARY_DIR}/changelog)
configure_file(cmake/debian/changelog.in ${changelog} @ONLY)
find_program(KERF_GZIP gzip)
if(NOT KERF_GZIP)
  return()
endif()
execute_process(COMMAND ${KERF_GZIP} --best --no-name --force --keep ${changelog} COMMAND_ERROR_IS_FATAL ANY)
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper)
  set(place DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME} COMPONENT ${component})
  install(FILES ${PROJECT_BINARY_DIR}/copyright ${place} EXCLUDE_FROM_ALL)
  install(FILES ${changelog}.gz ${place} EXCLUDE_FROM_ALL)
endforeach()

include(CPack)
