# Language level, warnings, sanitizers: the targets settle::options (all code) and nothing global but the output folder.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

add_library(settle_options INTERFACE)
add_library(settle::options ALIAS settle_options)
target_compile_options(settle_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
  -Wnon-virtual-dtor -Wold-style-cast -Wcast-align -Woverloaded-virtual -Wnull-dereference -Wdouble-promotion)
if(SETTLE_WARNINGS_AS_ERRORS)
  target_compile_options(settle_options INTERFACE -Werror)
endif()
target_compile_definitions(settle_options INTERFACE
  $<$<OR:$<CONFIG:Debug>,$<BOOL:${SETTLE_SANITIZE}>>:SETTLE_ENABLE_ASSERTIONS>)
if(CMAKE_UNITY_BUILD)
  # Several files compiled as one: names local to one file may hide another's.
  target_compile_options(settle_options INTERFACE -Wno-shadow -Wno-subobject-linkage)
endif()
if(SETTLE_SANITIZE)
  # Null pointers are found when they are followed; checking every reference for them, its alignment and the size of
  # what it refers to takes a third of the compile time. The library's own assertions find what they would miss: empty
  # optionals, elements beyond the end. The two warnings are unreliable under instrumentation (GCC 12 finds them inside
  # std::regex).
  target_compile_options(settle_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined
    -fno-sanitize=null,alignment,object-size -fno-omit-frame-pointer -Wno-null-dereference -Wno-maybe-uninitialized)
  target_compile_definitions(settle_options INTERFACE _GLIBCXX_ASSERTIONS)
  target_link_options(settle_options INTERFACE -fsanitize=address,undefined)
endif()
