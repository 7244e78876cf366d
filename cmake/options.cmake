# How Kerf compiles its own sources. These options belong to the folders of this project, not to its targets, so none of
# them reaches a program that links Kerf.

# Where a project chooses no build type, as one that is as short as README.md's, nothing would be optimised.
get_property(is_multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
if(NOT is_multi_config AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CXX_FLAGS MATCHES "(^| )-O")
  add_compile_options(-O2)
endif()
add_compile_options(-Wall -Wextra -Wconversion -Wshadow)
if(KERF_DEVELOPER)
  add_compile_options(-Werror)
endif()
# One rounding everywhere: a product and a sum are never fused (DESIGN.md, "Classification").
add_compile_options(-ffp-contract=off)
# GCC 12 sees an overlapping copy in every `"text" + std::string` (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  add_compile_options(-Wno-restrict)
endif()
# GCC does not see that the members of a variant are initialised: version 12 in what is instrumented, 14 everywhere.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND (KERF_SANITIZE OR CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13))
  add_compile_options(-Wno-maybe-uninitialized)
endif()
# In a file that includes sources, GCC takes each of them for a header, whose classes should not hold local ones.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_UNITY_BUILD)
  add_compile_options(-Wno-subobject-linkage)
endif()
# GCC looks for memory to give back again and again while it reads a hundred headers; a file of a unity build takes 7 to
# 11 % less time if it does so from 0.8 GB on (it has 1.1 GB at the end of a unity file, and 1.4 GB then).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND KERF_UNITY)
  add_compile_options(--param=ggc-min-heapsize=800000)
endif()
# Comparisons of boxes are joined by & on purpose: no branch for the processor to mispredict.
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  add_compile_options(-Wno-bitwise-instead-of-logical)
endif()
if(KERF_SANITIZE)
  add_compile_options(-fsanitize=${KERF_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${KERF_SANITIZE})
endif()
