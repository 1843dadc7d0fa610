# settle_commit.hpp: the commit this build is made from, rewritten at build time only when it changes.

add_custom_target(settle_commit
  COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${CMAKE_SOURCE_DIR} -DOUTPUT=${CMAKE_BINARY_DIR}/generated/settle_commit.hpp
    -P ${CMAKE_SOURCE_DIR}/cmake/WriteCommit.cmake
  BYPRODUCTS ${CMAKE_BINARY_DIR}/generated/settle_commit.hpp
  COMMENT "" VERBATIM)
