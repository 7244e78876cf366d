# The hard cases: scripts and their judge (a library), tests, and the table beside the rivals (a program).
file(GLOB hard_sources CONFIGURE_DEPENDS hard/*.cpp hard/cases/*.cpp)
file(GLOB hard_headers CONFIGURE_DEPENDS hard/*.h hard/cases/*.h)
add_library(kerf_hard_parts STATIC ${hard_sources})
target_sources(kerf_hard_parts PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${hard_headers})
kerf_unity(kerf_hard_parts)
target_link_libraries(kerf_hard_parts PUBLIC kerf_recording)

kerf_tests(hard kerf_recording SEPARATE "/values_test")

find_package(nlohmann_json 3.11 REQUIRED)
file(GLOB hard_report_sources CONFIGURE_DEPENDS hard/report/*.cpp)
add_executable(kerf_hardcases ${hard_report_sources})
kerf_unity(kerf_hardcases)
target_link_libraries(kerf_hardcases PRIVATE kerf_hard_parts kerf_rivals kerf_frames kerf_sims3d
  nlohmann_json::nlohmann_json)

# F cases: they run the program and need all of its libraries, so they are a program of their own.
kerf_tests(hard_files kerf_frames)
target_sources(kerf_hard_files_tests PRIVATE frames/program.cpp)
target_link_libraries(kerf_hard_files_tests PRIVATE nlohmann_json::nlohmann_json)
target_compile_definitions(kerf_hard_files_tests PRIVATE KERF_PROGRAM="$<TARGET_FILE:kerf>")
add_dependencies(kerf_hard_files_tests kerf)
