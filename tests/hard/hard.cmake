# The hard cases: scripts and their judge (a library), tests, and the table beside the rivals (a program).
file(GLOB hard_sources CONFIGURE_DEPENDS hard/*.cpp hard/cases/*.cpp)
file(GLOB hard_headers CONFIGURE_DEPENDS hard/*.h hard/cases/*.h)
add_library(kerf_hard_parts STATIC ${hard_sources})
target_sources(kerf_hard_parts PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${hard_headers})
target_link_libraries(kerf_hard_parts PUBLIC kerf_core)

kerf_tests(hard kerf_core)
