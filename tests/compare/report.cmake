settle_add_test(report_tests
  SOURCES
    ${CMAKE_CURRENT_LIST_DIR}/perfect_body.cpp
    ${CMAKE_CURRENT_LIST_DIR}/report_body_tests.cpp
    ${CMAKE_CURRENT_LIST_DIR}/report_chart_tests.cpp
    ${CMAKE_CURRENT_LIST_DIR}/report_data_tests.cpp
    ${CMAKE_CURRENT_LIST_DIR}/report_field_tests.cpp
    ${CMAKE_CURRENT_LIST_DIR}/report_figure_tests.cpp
    ${CMAKE_CURRENT_LIST_DIR}/report_fixture.cpp
    ${CMAKE_CURRENT_LIST_DIR}/report_formula_tests.cpp
    ${CMAKE_CURRENT_LIST_DIR}/report_page_tests.cpp
    ${CMAKE_CURRENT_LIST_DIR}/report_raster_tests.cpp
    ${CMAKE_CURRENT_LIST_DIR}/report_shared_tests.cpp
  ALONE ${CMAKE_CURRENT_LIST_DIR}/report_field_tests.cpp ${CMAKE_CURRENT_LIST_DIR}/report_page_tests.cpp
    ${CMAKE_CURRENT_LIST_DIR}/report_shared_tests.cpp
  LIBRARIES settle::compare fmt::fmt nlohmann_json::nlohmann_json pugixml::pugixml ZLIB::ZLIB
  LABELS compare)
target_include_directories(report_tests PRIVATE ${PROJECT_SOURCE_DIR}/compare/src/report ${PROJECT_SOURCE_DIR}/compare/src)
target_compile_definitions(report_tests PRIVATE SETTLE_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
