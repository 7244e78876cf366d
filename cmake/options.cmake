# What every target of Kerf is built with. `kerf_room` makes the library of one room of the house.

add_library(kerf_options INTERFACE)
target_compile_options(kerf_options INTERFACE
  -Wall -Wextra -Wconversion -Wshadow -Werror
  # One rounding everywhere: a product and a sum are never fused (DESIGN.md, "Classification").
  -ffp-contract=off)
# GCC 12 sees an overlapping copy in every `"text" + std::string` (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(kerf_options INTERFACE -Wno-restrict)
endif()
# Comparisons of boxes are joined by & on purpose: no branch for the processor to mispredict.
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  target_compile_options(kerf_options INTERFACE -Wno-bitwise-instead-of-logical)
endif()
if(KERF_SANITIZE)
  target_compile_options(kerf_options INTERFACE -fsanitize=${KERF_SANITIZE} -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  # In what is instrumented GCC 12 does not see that the members of a variant are initialised.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(kerf_options INTERFACE -Wno-maybe-uninitialized)
  endif()
  target_link_options(kerf_options INTERFACE -fsanitize=${KERF_SANITIZE})
endif()
target_include_directories(kerf_options INTERFACE ${PROJECT_SOURCE_DIR})

# kerf_room(NAME [FOLDERS FOLDER...] [EXCLUDE REGEX...]) takes every .cpp and .h below the given folders (the current one)
# that matches none of the expressions, so that a new file needs no line here. A header that has a source is its first #include (tests/house sees
# to it), so that each build shows that it compiles alone; only the others are verified by themselves.
function(kerf_room name)
  cmake_parse_arguments(PARSE_ARGV 1 room "" "" "FOLDERS;EXCLUDE")
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
  list(REMOVE_ITEM headers ${included_first})
  add_library(${name} STATIC ${sources})
  target_sources(${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${headers})
  target_link_libraries(${name} PUBLIC kerf_options)
endfunction()
