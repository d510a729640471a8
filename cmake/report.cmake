# SHEER_REPORT_PAGE: the page of `sheer compare` as a source file. Its chart and its slider are
# libraries that `npm ci` brings into web/node_modules, as ./dev does where there is npm; without
# them all else builds and works, and the page has a table, pictures side by side and no chart.
set(SHEER_REPORT_PAGE ${CMAKE_CURRENT_BINARY_DIR}/report_page.cpp)
set(web ${PROJECT_SOURCE_DIR}/web)
file(GLOB sources CONFIGURE_DEPENDS ${web}/report/*)
set(chart ${web}/node_modules/chart.js/dist/chart.umd.min.js)
if(EXISTS ${chart})
  list(APPEND sources ${chart} ${web}/package-lock.json)
else()
  message(STATUS "Reports will have no chart and no slider: 'npm ci' in web/ brings what they need")
endif()
add_custom_command(OUTPUT ${SHEER_REPORT_PAGE}
  COMMAND ${CMAKE_COMMAND} -D WEB=${web} -D TO=${SHEER_REPORT_PAGE}
    -P ${PROJECT_SOURCE_DIR}/cmake/report_page.cmake
  DEPENDS ${sources} ${PROJECT_SOURCE_DIR}/cmake/report_page.cmake VERBATIM)
