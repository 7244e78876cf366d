# Runs before the packages are made. Without one of these tools CPack makes them all the same, but packages that depend
# on nothing: installed, the program does not find its libraries.
foreach(tool file dpkg-shlibdeps objdump)
  find_program(found_${tool} ${tool})
  if(NOT found_${tool})
    message(FATAL_ERROR "what the packages depend on cannot be found without ${tool}: install the packages file, dpkg-dev "
      "and binutils")
  endif()
endforeach()
