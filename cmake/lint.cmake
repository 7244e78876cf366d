# `kerf_lint` runs clang-tidy over each source of the rooms, `kerf_lint_tests` over those of tests/, which take as
# long again and are left out of the default tests. A source is checked again when its object file is newer,
# which is when it or a header that it includes has changed: the build knows that already.
# `kerf_format_check` compares all C++ files with what clang-format makes of them. Both need version 14.

# kerf_tidy(TARGET STAMPS) adds the sources of one target, and what says that they are clean to a global property.
function(kerf_tidy target stamps)
  get_target_property(sources ${target} SOURCES)
  get_target_property(folder ${target} SOURCE_DIR)
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${folder} NORMALIZE)
    cmake_path(IS_PREFIX PROJECT_BINARY_DIR ${source} generated)
    if(generated OR NOT source MATCHES "\\.cpp$")
      continue()
    endif()
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${folder} OUTPUT_VARIABLE object)
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE name)
    set(stamp ${PROJECT_BINARY_DIR}/lint/${name}.stamp)
    cmake_path(GET stamp PARENT_PATH stamp_folder)
    file(MAKE_DIRECTORY ${stamp_folder})
    string(REGEX REPLACE "([][+.*()^$?|\\])" "\\\\\\1" pattern "/${object}.o")
    add_custom_command(OUTPUT ${stamp}
      COMMAND ${KERF_CLANG_TIDY} --quiet -p ${PROJECT_BINARY_DIR} ${source}
      COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
      DEPENDS ${PROJECT_SOURCE_DIR}/.clang-tidy $<FILTER:$<TARGET_OBJECTS:${target}>,INCLUDE,${pattern}$>
      COMMENT "clang-tidy ${name}" VERBATIM)
    set_property(GLOBAL APPEND PROPERTY ${stamps} ${stamp})
  endforeach()
endfunction()

set(rooms core viz sims2d sims3d frames tests)
find_program(KERF_CLANG_TIDY clang-tidy-14)
foreach(room IN LISTS rooms)
  set(property KERF_LINT_STAMPS)
  if(room STREQUAL "tests")
    set(property KERF_LINT_TESTS_STAMPS)
  endif()
  get_property(targets DIRECTORY ${PROJECT_SOURCE_DIR}/${room} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type MATCHES "STATIC_LIBRARY|EXECUTABLE")
      kerf_tidy(${target} ${property})
    endif()
  endforeach()
endforeach()
get_property(stamps GLOBAL PROPERTY KERF_LINT_STAMPS)
add_custom_target(kerf_lint DEPENDS ${stamps})
get_property(stamps GLOBAL PROPERTY KERF_LINT_TESTS_STAMPS)
add_custom_target(kerf_lint_tests DEPENDS ${stamps})

find_program(KERF_CLANG_FORMAT clang-format-14)
list(TRANSFORM rooms REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/\\1/*.h;${PROJECT_SOURCE_DIR}/\\1/*.cpp"
  OUTPUT_VARIABLE patterns)
file(GLOB_RECURSE formatted CONFIGURE_DEPENDS ${patterns})
add_custom_target(kerf_format_check COMMAND ${KERF_CLANG_FORMAT} --dry-run -Werror ${formatted} VERBATIM)
