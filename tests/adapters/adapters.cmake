# Adapters with the real engines, and the samples of docs/ADAPTERS.md, each compiled as a program that is run.
pkg_check_modules(BULLET REQUIRED IMPORTED_TARGET bullet)
pkg_check_modules(FCL REQUIRED IMPORTED_TARGET fcl)
set_property(TARGET PkgConfig::FCL PROPERTY INTERFACE_COMPILE_OPTIONS)  # it would choose an older C++
pkg_check_modules(ODE REQUIRED IMPORTED_TARGET ode)
find_package(box2d 2.4.1 REQUIRED)

# kerf_adapter_sample(ENGINE LIBRARY PRINTED)
function(kerf_adapter_sample engine library printed)
  add_executable(kerf_sample_${engine} embed/adapters/${engine}.cpp)
  target_link_libraries(kerf_sample_${engine} PRIVATE kerf::adapters ${library})
  add_test(NAME Adapters.TheSampleOf_${engine}_Runs COMMAND kerf_sample_${engine})
  set_tests_properties(Adapters.TheSampleOf_${engine}_Runs PROPERTIES PASS_REGULAR_EXPRESSION "${printed}")
endfunction()

# What a step of each engine takes with its own broad phase and with ours: run by hand.
file(GLOB bench_sources CONFIGURE_DEPENDS bench/adapter_steps/*.cpp)
add_executable(kerf_adapter_steps ${bench_sources})
target_link_libraries(kerf_adapter_steps PRIVATE kerf::adapters PkgConfig::BULLET PkgConfig::FCL PkgConfig::ODE
  box2d::box2d nlohmann_json::nlohmann_json)

kerf_tests(adapters kerf_adapters PkgConfig::BULLET PkgConfig::FCL PkgConfig::ODE box2d::box2d
  SEPARATE ".")  # two engines in one file do not go together
kerf_adapter_sample(bullet PkgConfig::BULLET "the ball lies at 1\\.5")
kerf_adapter_sample(ode PkgConfig::ODE "near in 1 of 6 steps")
kerf_adapter_sample(fcl PkgConfig::FCL "near in 3 of 5 steps")
kerf_adapter_sample(box2d box2d::box2d "the ball lies at 1\\.5")
