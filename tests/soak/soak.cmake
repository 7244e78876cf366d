# What the default tests try for a moment, `./run soak` tries for as long as one likes.
kerf_parts(property kerf_recording)
kerf_tests(property kerf_recording)
kerf_parts(fuzz/tree kerf_property_parts)
kerf_tests(fuzz/tree kerf_recording)
kerf_parts(fuzz/recording kerf_recording)
kerf_tests(fuzz/recording kerf_recording)
kerf_parts(fuzz/parsers kerf_frames)
kerf_tests(fuzz/parsers kerf_frames)

# kerf_soak(NAME LIBRARY...) is tests/soak/NAME_soak.cpp, a program that runs for as long as its command line says.
find_package(nlohmann_json 3.11 REQUIRED)
function(kerf_soak name)
  add_executable(kerf_${name}_soak soak/${name}_soak.cpp soak/options.cpp)
  target_link_libraries(kerf_${name}_soak PRIVATE ${ARGN} nlohmann_json::nlohmann_json)
endfunction()
kerf_soak(property kerf_property_parts)
kerf_soak(operator kerf_fuzz_tree_parts)

# A scene in endless motion: tests/soak/run_scene_soaks goes through all of them.
add_executable(kerf_scene_soak soak/scene_soak.cpp soak/endless_run.cpp)
target_link_libraries(kerf_scene_soak PRIVATE kerf_frames)

# kerf_fuzz(TARGET PARTS) is the libFuzzer program of TARGET_case. They need clang: the preset `fuzz`.
option(KERF_FUZZ "Build the libFuzzer programs" OFF)
function(kerf_fuzz target parts)
  add_executable(kerf_fuzz_${target} soak/libfuzzer_entry.cpp)
  target_compile_definitions(kerf_fuzz_${target} PRIVATE KERF_FUZZ_CASE=${target}_case)
  target_link_libraries(kerf_fuzz_${target} PRIVATE ${parts})
  target_link_options(kerf_fuzz_${target} PRIVATE -fsanitize=fuzzer)
  add_dependencies(kerf_fuzzers kerf_fuzz_${target})
endfunction()
if(KERF_FUZZ)
  add_custom_target(kerf_fuzzers)
  kerf_fuzz(operators kerf_fuzz_tree_parts)
  kerf_fuzz(broad_phase kerf_fuzz_tree_parts)
  foreach(target keyframe block looks recording)
    kerf_fuzz(${target} kerf_fuzz_recording_parts)
  endforeach()
  foreach(target config request png csv manifest draw_list script camera_path)
    kerf_fuzz(${target} kerf_fuzz_parsers_parts)
  endforeach()
endif()

# A mutant that no longer applies would go unnoticed until somebody runs them all.
add_test(NAME Mutants.AllApplyToTheSources COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/mutants/run_mutants --check)
