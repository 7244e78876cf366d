# What the Debian packages are made of, without a build.
add_test(NAME Packages.HaveWhatADebianUserExpects
  COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/packages/check_parts ${CMAKE_CURRENT_BINARY_DIR}/packages ${CMAKE_GENERATOR}
    ${CMAKE_CXX_COMPILER})
find_program(KERF_DPKG dpkg)
if(NOT KERF_DPKG)
  set_tests_properties(Packages.HaveWhatADebianUserExpects PROPERTIES DISABLED ON)
endif()
