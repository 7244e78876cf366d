# Other libraries' broad phases behind our interface: for `kerf bench` and the hard cases.
find_package(PkgConfig REQUIRED)
find_package(box2d 2.4.1 REQUIRED)
find_package(embree 3 REQUIRED)
pkg_check_modules(BULLET REQUIRED IMPORTED_TARGET bullet)
pkg_check_modules(FCL REQUIRED IMPORTED_TARGET fcl)
find_path(KERF_CGAL_INCLUDE CGAL/box_intersection_d.h REQUIRED)

file(GLOB rival_sources CONFIGURE_DEPENDS rivals/*.cpp)
file(GLOB rival_headers CONFIGURE_DEPENDS rivals/*.h)
add_library(kerf_rivals STATIC ${rival_sources})
target_sources(kerf_rivals PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${rival_headers})
target_include_directories(kerf_rivals SYSTEM PRIVATE ${KERF_CGAL_INCLUDE})
target_link_libraries(kerf_rivals PUBLIC kerf_bsp
  PRIVATE kerf_sims3d box2d::box2d embree PkgConfig::BULLET PkgConfig::FCL)
