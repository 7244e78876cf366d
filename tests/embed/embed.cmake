# The sample of README.md ("Embed"): compiled and run here, and configured as a project of its own.
add_executable(kerf_embed embed/main.cpp)
target_link_libraries(kerf_embed PRIVATE kerf::bsp)
add_test(NAME Embed.TheSampleReportsWhatTouchesTheFloor COMMAND kerf_embed)
set_tests_properties(Embed.TheSampleReportsWhatTouchesTheFloor PROPERTIES
  PASS_REGULAR_EXPRESSION "^step 4: 0 and 1 overlap\nstep 5: 0 and 1 overlap\nstep 6: 0 and 1 overlap\nstep 6: 0 and 2 overlap\n$")
add_test(NAME Embed.KerfIsOptimisedUnlessItsProjectChooses
  COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/embed/check_optimised ${CMAKE_CURRENT_BINARY_DIR}/embed ${CMAKE_GENERATOR}
    ${CMAKE_CXX_COMPILER})

# The header of C alone, as C11 and as C++98.
enable_language(C)
foreach(way IN ITEMS C:11:c CXX:98:cpp)
  string(REPLACE ":" ";" way ${way})
  list(GET way 0 language)
  list(GET way 1 standard)
  list(GET way 2 ending)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/header_alone.${ending})
  file(CONFIGURE OUTPUT ${source} CONTENT "#include <kerf.h>\n")
  add_library(kerf_header_in_${ending} OBJECT ${source})
  target_include_directories(kerf_header_in_${ending} PRIVATE ${PROJECT_SOURCE_DIR}/core/c)
  set_target_properties(kerf_header_in_${ending} PROPERTIES ${language}_STANDARD ${standard}
    ${language}_EXTENSIONS OFF)
  target_compile_options(kerf_header_in_${ending} PRIVATE -pedantic -Werror)
endforeach()

# The examples in C and C++17.
add_executable(kerf_in_c embed/example/in_c.c)
add_executable(kerf_in_cpp embed/example/in_cpp.cpp)
set_target_properties(kerf_in_c PROPERTIES C_STANDARD 11 C_EXTENSIONS OFF LINKER_LANGUAGE CXX)
set_target_properties(kerf_in_cpp PROPERTIES CXX_STANDARD 17)
target_link_libraries(kerf_in_c PRIVATE kerf::c)
target_link_libraries(kerf_in_cpp PRIVATE kerf::c)
target_compile_options(kerf_in_c PRIVATE -pedantic -Werror)
target_compile_options(kerf_in_cpp PRIVATE -pedantic -Werror)
add_test(NAME Embed.TheExampleInCSeesPairsBeginAndEnd COMMAND kerf_in_c)
set_tests_properties(Embed.TheExampleInCSeesPairsBeginAndEnd PROPERTIES
  PASS_REGULAR_EXPRESSION "step 2: begun 0 and 1\nstep 3:\nstep 4:\nstep 5: ended 0 and 1\nstep 6:\n$")
add_test(NAME Embed.TheExampleInCppSeesASensorsPairs COMMAND kerf_in_cpp)
set_tests_properties(Embed.TheExampleInCppSeesASensorsPairs PROPERTIES
  PASS_REGULAR_EXPRESSION "step 1: nothing\nstep 2: noticed\nstep 3: noticed\nstep 4: nothing\n$")

# The ABI of libkerf, as a shared library, against the one that is written down.
file(GLOB abi_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/core/c/*.cpp)
add_library(kerf_abi SHARED ${abi_sources})
target_compile_definitions(kerf_abi PRIVATE $<TARGET_PROPERTY:kerf_c,COMPILE_DEFINITIONS>)
target_link_libraries(kerf_abi PRIVATE kerf_bsp)
target_include_directories(kerf_abi PRIVATE ${PROJECT_SOURCE_DIR}/core/c)
set_target_properties(kerf_abi PROPERTIES OUTPUT_NAME kerf CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} DEFINE_SYMBOL "")
target_link_options(kerf_abi PRIVATE LINKER:--version-script=${PROJECT_SOURCE_DIR}/cmake/exported_c_names)
find_program(KERF_ABIDIFF abidiff)
add_test(NAME Embed.TheAbiOfCIsTheOneThatIsWrittenDown
  COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/embed/check_abi $<TARGET_FILE:kerf_abi>
    ${CMAKE_CURRENT_SOURCE_DIR}/embed/kerf.abi ${PROJECT_SOURCE_DIR}/core/c)
if(NOT KERF_ABIDIFF)
  set_tests_properties(Embed.TheAbiOfCIsTheOneThatIsWrittenDown PROPERTIES DISABLED ON)
endif()

# The samples of docs/EMBEDDING.md. They run where they were compiled, and may write there.
add_test(NAME Embed.TheSamplesOfThePagePrintWhatItSays
  COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/embed/run_page ${PROJECT_SOURCE_DIR}/docs/EMBEDDING.md
    ${CMAKE_CURRENT_BINARY_DIR}/embed_page -I${PROJECT_SOURCE_DIR} -I${PROJECT_SOURCE_DIR}/core/c
    $<TARGET_FILE:kerf_recording> $<TARGET_FILE:kerf_scene> $<TARGET_FILE:kerf_c> $<TARGET_FILE:kerf_bsp>
    -lstdc++ -lm -lhwy_contrib -lhwy -lxxhash -ltbb -lsqlite3 -lzstd)

# Memory that ends.
add_executable(kerf_out_of_memory embed/out_of_memory.cpp)
target_link_libraries(kerf_out_of_memory PRIVATE kerf_c)
target_link_options(kerf_out_of_memory PRIVATE LINKER:--wrap=realloc)
add_test(NAME Embed.AWorldSurvivesEachAllocationThatFails COMMAND kerf_out_of_memory)
