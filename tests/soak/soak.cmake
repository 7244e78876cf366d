# What the default tests try for a moment, `./run soak` tries for as long as it is told.
kerf_parts(property kerf_core)
kerf_tests(property kerf_core)
kerf_parts(fuzz/tree kerf_property_parts)
kerf_tests(fuzz/tree kerf_core)

# kerf_soak(NAME LIBRARY...) is tests/soak/NAME_soak.cpp, a program that runs for as long as it is told.
find_package(nlohmann_json 3.11 REQUIRED)
function(kerf_soak name)
  add_executable(kerf_${name}_soak soak/${name}_soak.cpp soak/options.cpp)
  target_link_libraries(kerf_${name}_soak PRIVATE ${ARGN} nlohmann_json::nlohmann_json)
endfunction()
kerf_soak(property kerf_property_parts)
kerf_soak(operator kerf_fuzz_tree_parts)
