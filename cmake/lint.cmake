# `kerf_lint` runs clang-tidy over the sources of the rooms, `kerf_lint_tests` over those of tests/, which take as
# long again and are left out of the default tests. Sources are checked a batch at a time (tidy_batch says how), and
# again when one of the batch has changed, or any header of ours.
# `kerf_sources` has clang read each source of the rooms alone, which a build in unity does not show (read_alone says
# how).
# `kerf_format_check` compares all C++ files with what clang-format makes of them. tests/lint.cmake finds the tools.

# kerf_own_sources(TARGET NAME) sets NAME to the full paths of the target's own sources.
function(kerf_own_sources target name)
  get_target_property(listed ${target} SOURCES)
  get_target_property(folder ${target} SOURCE_DIR)
  set(sources)
  foreach(source IN LISTS listed)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${folder} NORMALIZE)
    cmake_path(IS_PREFIX PROJECT_BINARY_DIR ${source} generated)
    if(source MATCHES "\\.cpp$" AND NOT generated)
      list(APPEND sources ${source})
    endif()
  endforeach()
  set(${name} ${sources} PARENT_SCOPE)
endfunction()

# kerf_united(TARGET NAME) takes from the list NAME the target's sources that KERF_UNITY does not join.
function(kerf_united target name)
  set(united)
  foreach(source IN LISTS ${name})
    get_source_file_property(is_separate ${source} TARGET_DIRECTORY ${target} SKIP_UNITY_BUILD_INCLUSION)
    if(NOT is_separate)
      list(APPEND united ${source})
    endif()
  endforeach()
  set(${name} ${united} PARENT_SCOPE)
endfunction()

# kerf_tidy_batch(STAMP SOURCE...) adds a command that makes the stamp if all these sources are clean.
function(kerf_tidy_batch stamp)
  cmake_path(GET stamp STEM name)
  add_custom_command(OUTPUT ${stamp}
    COMMAND ${tidy_batch} ${KERF_CLANG_TIDY} ${PROJECT_BINARY_DIR} ${ARGN}
    COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
    DEPENDS ${tidy_batch} ${PROJECT_SOURCE_DIR}/.clang-tidy ${PROJECT_SOURCE_DIR}/tests/.clang-tidy ${ARGN} ${headers}
    COMMENT "clang-tidy ${name}" VERBATIM)
endfunction()

# kerf_tidy_batches(TARGET STAMPS SOURCE...) adds the batches of a target, and their stamps to a global property.
function(kerf_tidy_batches target stamps)
  list(LENGTH ARGN count)
  set(first 0)
  set(size 48)
  while(first LESS count)
    list(SUBLIST ARGN ${first} ${size} batch)
    set(stamp ${PROJECT_BINARY_DIR}/lint/tidy-${target}-${first}.stamp)
    kerf_tidy_batch(${stamp} ${batch})
    set_property(GLOBAL APPEND PROPERTY ${stamps} ${stamp})
    math(EXPR first "${first} + ${size}")
  endwhile()
endfunction()

file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/lint)
set(tidy_batch ${PROJECT_SOURCE_DIR}/cmake/tidy_batch)
set(read_alone ${PROJECT_SOURCE_DIR}/cmake/read_alone)
set(rooms core viz sims2d sims3d frames tests)
list(TRANSFORM rooms REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/\\1/*.h" OUTPUT_VARIABLE patterns)
file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${patterns})
set(united)
foreach(room IN LISTS rooms)
  set(property KERF_LINT_STAMPS)
  if(room STREQUAL "tests")
    set(property KERF_LINT_TESTS_STAMPS)
  endif()
  get_property(targets DIRECTORY ${PROJECT_SOURCE_DIR}/${room} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type MATCHES "STATIC_LIBRARY|SHARED_LIBRARY|EXECUTABLE")
      kerf_own_sources(${target} sources)
      kerf_tidy_batches(${target} ${property} ${sources})
      if(NOT room STREQUAL "tests")
        kerf_united(${target} sources)  # the others are alone in every build
        list(APPEND united ${sources})
      endif()
    endif()
  endforeach()
endforeach()
get_property(stamps GLOBAL PROPERTY KERF_LINT_STAMPS)
add_custom_target(kerf_lint DEPENDS ${stamps})
add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/lint/read_alone.stamp
  COMMAND ${read_alone} ${KERF_CLANG} ${PROJECT_BINARY_DIR} ${united}
  COMMAND ${CMAKE_COMMAND} -E touch ${PROJECT_BINARY_DIR}/lint/read_alone.stamp
  DEPENDS ${read_alone} ${united} ${headers}
  COMMENT "sources read alone"
  USES_TERMINAL VERBATIM)
add_custom_target(kerf_sources DEPENDS ${PROJECT_BINARY_DIR}/lint/read_alone.stamp)
get_property(stamps GLOBAL PROPERTY KERF_LINT_TESTS_STAMPS)
add_custom_target(kerf_lint_tests DEPENDS ${stamps})

list(TRANSFORM rooms REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/\\1/*.cpp" OUTPUT_VARIABLE patterns)
file(GLOB_RECURSE formatted CONFIGURE_DEPENDS ${patterns})
add_custom_target(kerf_format_check
  COMMAND ${KERF_CLANG_FORMAT} --dry-run -Werror ${headers} ${formatted} VERBATIM)
