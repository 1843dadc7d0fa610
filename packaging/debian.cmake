# cpack -G DEB: a package for the Debian release it is built on; dpkg-shlibdeps finds the libraries it depends on.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "The Settle developers")
set(CPACK_PACKAGE_CONTACT "The Settle developers <no-address@settle.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION "Settle builds the same earth construction layer by layer with two independent solvers, a material
point method and staged finite elements, and holds both against the exact solution and against each other: verification
campaigns, comparison reports, and a gate on their agreement in continuous integration.")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS gnuplot-nox) # settle runs it for the report's figures
set(CPACK_DEBIAN_PACKAGE_SUGGESTS chromium) # only `settle report --format pdf` needs one
include(CPack)
