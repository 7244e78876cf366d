# What `./run lint` checks: what compilers and tools say of the sources, not what the program does. These tests have the
# label lint and run in the build of the preset lint, which optimises nothing.

# kerf_lint_test(NAME COMMAND...) adds such a test. kerf_lint_test(NAME) adds one that is shown as disabled: this system
# does not have its tool.
function(kerf_lint_test name)
  if(ARGC EQUAL 1)
    add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} -E false)
    set_tests_properties(${name} PROPERTIES DISABLED ON)
  else()
    add_test(NAME ${name} COMMAND ${ARGN})
  endif()
  set_tests_properties(${name} PROPERTIES TIMEOUT 2400 RUN_SERIAL ON LABELS lint)
endfunction()

# The targets come later in the configuration, so a test asks the build for them by name.
function(kerf_lint_build name target)
  kerf_lint_test(${name} ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target ${target} -- -k 0)
endfunction()

# The same runs give the same hashes. The release, which `./run lint` builds first and `./run tests` needs, is compared
# with what is not optimised, and with full optimisation by the other compiler; without variants the script compares
# every level of both.
find_program(KERF_CLANG NAMES clang++-14 clang++-19)
kerf_lint_test(Determinism.CompilersAndLevelsAgree
  ${CMAKE_CURRENT_SOURCE_DIR}/determinism/compare_builds ${PROJECT_BINARY_DIR}/variants
  ${PROJECT_SOURCE_DIR}/build/release/tests/kerf_fingerprint g++:-O0 ${KERF_CLANG}:-O3)

# Other projects use Kerf, in each of the ways in which they can get it.
kerf_lint_test(Embed.InstalledAndAsSources ${CMAKE_CURRENT_SOURCE_DIR}/embed/check_embed ${PROJECT_BINARY_DIR}/embed)

# Each comment that the reference is made of is one that Doxygen understands, and each name in it is there.
find_program(KERF_DOXYGEN doxygen REQUIRED)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/reference)
kerf_lint_test(House.TheReferenceIsWhole
  ${CMAKE_COMMAND} -E env KERF_REFERENCE=${PROJECT_BINARY_DIR}/reference ${KERF_DOXYGEN} docs/Doxyfile)
set_tests_properties(House.TheReferenceIsWhole PROPERTIES WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})

kerf_lint_build(House.HeadersCompileAlone all_verify_interface_header_sets)

# Each source begins with its own header, so that its header is compiled alone, too.
if(KERF_CLANG)
  kerf_lint_build(House.SourcesCompileAlone kerf_sources)
else()
  kerf_lint_test(House.SourcesCompileAlone)
endif()

# Releases of the tools disagree, so there is one of each.
find_program(KERF_CLANG_TIDY clang-tidy-14)
find_program(KERF_CLANG_FORMAT clang-format-14)
if(KERF_CLANG_TIDY)
  kerf_lint_build(House.ClangTidyIsContent kerf_lint)
  kerf_lint_test(House.ClangTidyFindsWhatIsPlantedInABatch
    ${CMAKE_CURRENT_SOURCE_DIR}/house/check_tidy_batch ${PROJECT_SOURCE_DIR}/cmake/tidy_batch ${KERF_CLANG_TIDY}
    ${PROJECT_SOURCE_DIR}/.clang-tidy ${CMAKE_CURRENT_BINARY_DIR}/planted_batch)
else()
  kerf_lint_test(House.ClangTidyIsContent)
endif()
if(KERF_CLANG_FORMAT)
  kerf_lint_build(House.ClangFormatIsContent kerf_format_check)
else()
  kerf_lint_test(House.ClangFormatIsContent)
endif()
