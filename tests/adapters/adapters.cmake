# Adapters with the real engines, and the samples of docs/EMBEDDING.md, each compiled as a program that is run.
pkg_check_modules(BULLET REQUIRED IMPORTED_TARGET bullet)
pkg_check_modules(FCL REQUIRED IMPORTED_TARGET fcl)
set_property(TARGET PkgConfig::FCL PROPERTY INTERFACE_COMPILE_OPTIONS)  # it would choose an older C++
pkg_check_modules(ODE REQUIRED IMPORTED_TARGET ode)
find_package(box2d 2.4.1 REQUIRED)

# kerf_adapter_sample(ENGINE LIBRARY PRINTED)
function(kerf_adapter_sample engine library printed)
  add_executable(kerf_sample_${engine} adapters/samples/${engine}.cpp)
  target_link_libraries(kerf_sample_${engine} PRIVATE kerf::adapters ${library})
  add_test(NAME Adapters.TheSampleOf_${engine}_Runs COMMAND kerf_sample_${engine})
  set_tests_properties(Adapters.TheSampleOf_${engine}_Runs PROPERTIES PASS_REGULAR_EXPRESSION "${printed}")
endfunction()

kerf_tests(adapters kerf_adapters PkgConfig::BULLET PkgConfig::FCL PkgConfig::ODE box2d::box2d)
