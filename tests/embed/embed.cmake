# The sample of README.md ("Embed"): compiled and run here, and configured as a project of its own.
add_executable(kerf_embed embed/main.cpp)
target_link_libraries(kerf_embed PRIVATE kerf::bsp)
add_test(NAME Embed.TheSampleReportsWhatTouchesTheFloor COMMAND kerf_embed)
set_tests_properties(Embed.TheSampleReportsWhatTouchesTheFloor PROPERTIES
  PASS_REGULAR_EXPRESSION "^step 4: 0 and 1 overlap\nstep 5: 0 and 1 overlap\nstep 6: 0 and 1 overlap\nstep 6: 0 and 2 overlap\n$")
add_test(NAME Embed.TheSampleIsConfiguredByAddSubdirectory
  COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_SOURCE_DIR}/embed -B ${CMAKE_CURRENT_BINARY_DIR}/embed
    -G ${CMAKE_GENERATOR} -D CMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER})
