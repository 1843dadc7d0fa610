# Every library the project uses, as Debian ships it. Targets settle::hdf5 and settle::dealii wrap the two HDF5 builds.

find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(OpenSSL REQUIRED)
find_package(Boost 1.74 REQUIRED)
find_package(pugixml REQUIRED)
find_package(ZLIB REQUIRED)
find_package(PkgConfig REQUIRED)
find_path(TOMLPLUSPLUS_INCLUDE_DIR toml++/toml.h REQUIRED)
find_path(MUSTACHE_INCLUDE_DIR NAMES mustache.hpp kainjow/mustache.hpp REQUIRED PATH_SUFFIXES kainjow)

add_library(settle_tomlplusplus INTERFACE)
target_include_directories(settle_tomlplusplus SYSTEM INTERFACE ${TOMLPLUSPLUS_INCLUDE_DIR})
add_library(settle::tomlplusplus ALIAS settle_tomlplusplus)

pkg_check_modules(MUPARSER REQUIRED IMPORTED_TARGET muparser)
add_library(settle::muparser ALIAS PkgConfig::MUPARSER)

# The serial HDF5 for everything but the deal.II solver, which must use the MPI build that deal.II links.
pkg_check_modules(HDF5_SERIAL REQUIRED IMPORTED_TARGET hdf5-serial)
add_library(settle_hdf5 INTERFACE)
target_include_directories(settle_hdf5 SYSTEM INTERFACE ${HDF5_SERIAL_INCLUDE_DIRS})
target_link_libraries(settle_hdf5 INTERFACE ${HDF5_SERIAL_LINK_LIBRARIES})
add_library(settle::hdf5 ALIAS settle_hdf5)

if(SETTLE_WITH_FEM)
  find_package(deal.II 9.4 REQUIRED)
  include(${DEAL_II_TARGET_CONFIG})
  # Not deal_ii_setup_target: it forces C++17 and its own flags.
  add_library(settle_dealii INTERFACE)
  target_include_directories(settle_dealii SYSTEM INTERFACE ${DEAL_II_INCLUDE_DIRS})
  target_compile_definitions(settle_dealii INTERFACE ${DEAL_II_USER_DEFINITIONS} $<$<CONFIG:Debug>:DEBUG>)
  target_link_libraries(settle_dealii INTERFACE $<IF:$<CONFIG:Debug>,deal.ii.g,deal.ii>)
  add_library(settle::dealii ALIAS settle_dealii)

  pkg_check_modules(HDF5_MPI REQUIRED IMPORTED_TARGET hdf5-openmpi)
  add_library(settle_hdf5_mpi INTERFACE)
  target_include_directories(settle_hdf5_mpi SYSTEM INTERFACE ${HDF5_MPI_INCLUDE_DIRS} ${MPI_CXX_INCLUDE_PATH})
  target_link_libraries(settle_hdf5_mpi INTERFACE ${HDF5_MPI_LINK_LIBRARIES})
  add_library(settle::hdf5_mpi ALIAS settle_hdf5_mpi)
endif()

if(SETTLE_WITH_TESTS)
  find_package(GTest REQUIRED)
endif()
