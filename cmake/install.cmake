# What cmake --install puts where: the library with its headers, the tool, the shaders that others
# include, and the package that find_package(Sheer) finds.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(SHEER_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Sheer)

install(TARGETS sheer_library EXPORT SheerTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY include/sheer DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.h")
install(DIRECTORY shaders/sheer DESTINATION ${CMAKE_INSTALL_DATADIR}/sheer/shaders OPTIONAL
  FILES_MATCHING PATTERN "*.glsl")
if(TARGET sheer)
  install(TARGETS sheer RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

install(EXPORT SheerTargets NAMESPACE Sheer:: DESTINATION ${SHEER_PACKAGE_DIR})
configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/SheerConfig.cmake.in ${PROJECT_BINARY_DIR}/SheerConfig.cmake
  INSTALL_DESTINATION ${SHEER_PACKAGE_DIR})
# Before 1.0 a new minor version may change the interface.
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/SheerConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(
  FILES ${PROJECT_BINARY_DIR}/SheerConfig.cmake ${PROJECT_BINARY_DIR}/SheerConfigVersion.cmake
  DESTINATION ${SHEER_PACKAGE_DIR})
