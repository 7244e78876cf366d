# kerf_room(NAME [INSTALLED] [FOLDERS FOLDER...] [EXCLUDE REGEX...] [SEPARATE REGEX...]) makes the library of one room.
# It takes every .cpp and .h below the given folders (the current one) that matches none of the expressions of EXCLUDE,
# so that a new file needs no line here. A header that has a source is its first #include (a test of tests/house checks
# this), so a build without KERF_UNITY shows that it compiles alone; only the other headers are verified by themselves.
#   INSTALLED  users link it: BUILD_SHARED_LIBS makes it shared or static, and its alias is kerf::NAME without kerf_
#   SEPARATE   sources that KERF_UNITY leaves alone: each is tuned by itself, or local names are equal on purpose
function(kerf_room name)
  cmake_parse_arguments(PARSE_ARGV 1 room "INSTALLED" "" "FOLDERS;EXCLUDE;SEPARATE")
  set(folders ${CMAKE_CURRENT_SOURCE_DIR})
  if(room_FOLDERS)
    list(TRANSFORM room_FOLDERS PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ OUTPUT_VARIABLE folders)
  endif()
  list(TRANSFORM folders APPEND /*.cpp OUTPUT_VARIABLE source_patterns)
  list(TRANSFORM folders APPEND /*.h OUTPUT_VARIABLE header_patterns)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${source_patterns})
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${header_patterns})
  foreach(pattern IN LISTS room_EXCLUDE)
    list(FILTER sources EXCLUDE REGEX "${pattern}")
    list(FILTER headers EXCLUDE REGEX "${pattern}")
  endforeach()
  list(TRANSFORM sources REPLACE "\\.cpp$" ".h" OUTPUT_VARIABLE included_first)
  set(alone ${headers})
  list(REMOVE_ITEM alone ${included_first})
  list(REMOVE_ITEM headers ${alone} "")

  set(kind STATIC)
  if(room_INSTALLED)
    set(kind)
  endif()
  add_library(${name} ${kind} ${sources})
  target_sources(${name} PUBLIC
    FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${alone}
    FILE_SET with_source TYPE HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${headers})
  set_target_properties(${name} PROPERTIES INTERFACE_HEADER_SETS_TO_VERIFY HEADERS)
  kerf_unity(${name} ${room_SEPARATE})
  if(room_INSTALLED)
    kerf_for_users(${name})
  endif()
endfunction()

# kerf_unity(TARGET [REGEX...]) compiles the target's sources several at a time if KERF_UNITY is on, except those that
# match an expression. Most of the time of a small source goes into headers that all of them include.
function(kerf_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${KERF_UNITY} UNITY_BUILD_BATCH_SIZE 12)
  get_target_property(sources ${target} SOURCES)
  foreach(pattern IN LISTS ARGN)
    set(separate ${sources})
    list(FILTER separate INCLUDE REGEX "${pattern}")
    set_source_files_properties(${separate} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endforeach()
endfunction()

# kerf_calls_only(TARGET...): what calls the tree and the libraries, and computes little itself, is compiled at -O2, which
# takes a quarter less time than -O3.
function(kerf_calls_only)
  foreach(target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O2>)
  endforeach()
endfunction()
