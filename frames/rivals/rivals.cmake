# Other libraries' broad phases behind our interface: for `kerf bench` and the hard cases. Without KERF_RIVALS there are
# none, and the program knows only its own.
set(rival_sources rivals/step_timer.cpp rivals/no_rivals.cpp)
if(KERF_RIVALS)
  file(GLOB rival_sources CONFIGURE_DEPENDS rivals/*.cpp)
  list(FILTER rival_sources EXCLUDE REGEX "/no_rivals\\.cpp$")
endif()
file(GLOB rival_headers CONFIGURE_DEPENDS rivals/*.h)
add_library(kerf_rivals STATIC ${rival_sources})
target_sources(kerf_rivals PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${rival_headers})
target_link_libraries(kerf_rivals PUBLIC kerf_bsp)
if(NOT KERF_RIVALS)
  return()
endif()

# GCC does not see that Bullet's branches set what they use.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set_source_files_properties(rivals/bullet_queries.cpp PROPERTIES COMPILE_OPTIONS -Wno-maybe-uninitialized)
endif()

find_package(PkgConfig REQUIRED)
find_package(box2d 2.4.1 REQUIRED)
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 REQUIRED)
endif()
pkg_check_modules(BULLET REQUIRED IMPORTED_TARGET bullet)
pkg_check_modules(FCL REQUIRED IMPORTED_TARGET fcl)
set_property(TARGET PkgConfig::FCL PROPERTY INTERFACE_COMPILE_OPTIONS)  # it would choose an older C++
find_path(KERF_CGAL_INCLUDE CGAL/box_intersection_d.h REQUIRED)
target_include_directories(kerf_rivals SYSTEM PRIVATE ${KERF_CGAL_INCLUDE})
target_link_libraries(kerf_rivals PRIVATE kerf_sims3d box2d::box2d embree PkgConfig::BULLET PkgConfig::FCL)
target_compile_definitions(kerf_rivals PRIVATE KERF_EMBREE=${embree_VERSION_MAJOR})
