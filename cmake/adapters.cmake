# Adapters put the broad phase into physics engines. They are headers only, so that they fit whatever build of an engine
# the user has, and so the user links the engine.
file(GLOB adapter_headers CONFIGURE_DEPENDS sims2d/box2d/*.h sims3d/bullet/*.h sims3d/fcl/*.h sims3d/ode/*.h)
add_library(kerf_adapters INTERFACE)
target_sources(kerf_adapters INTERFACE
  FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}
  FILE_SET with_source TYPE HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${adapter_headers})
target_link_libraries(kerf_adapters INTERFACE kerf_bsp)
# Each needs its engine's headers to compile: its tests and samples have them.
set_target_properties(kerf_adapters PROPERTIES VERIFY_INTERFACE_HEADER_SETS OFF)
kerf_for_users(kerf_adapters)
