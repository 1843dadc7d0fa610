# The kernels of the explicit step, compiled once for every instruction set and chosen at run time. Everything that
# decides in which cell a point lies rounds alike: no contraction to fused multiply-add, which also makes the results of
# all variants the same.

target_compile_options(settle_mpm PRIVATE -ffp-contract=off)
target_sources(settle_mpm PRIVATE src/kernel/variants.cpp)

function(settle_add_kernels variant)
  add_library(settle_mpm_${variant} OBJECT src/kernel/variant.cpp src/kernel/simplices.cpp
    src/kernel/linear_boxes.cpp src/kernel/plane_b_splines.cpp src/kernel/solid_b_splines.cpp)
  target_compile_definitions(settle_mpm_${variant} PRIVATE SETTLE_VARIANT=${variant})
  target_compile_options(settle_mpm_${variant} PRIVATE -ffp-contract=off -fno-math-errno -fno-trapping-math
    -Wno-psabi ${ARGN}) # vectors are passed to functions that are inlined only
  target_link_libraries(settle_mpm_${variant} PRIVATE settle::options)
  target_sources(settle_mpm PRIVATE $<TARGET_OBJECTS:settle_mpm_${variant}>)
endfunction()

settle_add_kernels(baseline)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  settle_add_kernels(x86_64_v3 -march=x86-64-v3)
  settle_add_kernels(x86_64_v4 -march=x86-64-v4 -mprefer-vector-width=512)
  target_compile_definitions(settle_mpm PRIVATE SETTLE_X86_64_VARIANTS)
endif()
