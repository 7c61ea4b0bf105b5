# SPDX-License-Identifier: MIT
# What `cmake --install` puts where, and the CMake and pkg-config files for programs that use it.
include(CMakePackageConfigHelpers)

install(TARGETS OpenRT EXPORT OpenRTTargets
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
if(TARGET rtut)
    install(TARGETS rtut EXPORT OpenRTTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
    install(FILES ${CMAKE_CURRENT_LIST_DIR}/rtut/fonts/NOTICE
        DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME NOTICE.fonts)
endif()
install(TARGETS smart EXPORT OpenRTSmartTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/libsmart DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    FILES_MATCHING PATTERN "*.h")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/openrt DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp")
install(FILES ${PROJECT_BINARY_DIR}/include/openrt/version.h
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/openrt)

set(openrt_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/OpenRT)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/OpenRTConfig.cmake.in
    ${PROJECT_BINARY_DIR}/OpenRTConfig.cmake INSTALL_DESTINATION ${openrt_cmake_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/OpenRTConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/OpenRTConfig.cmake
    ${PROJECT_BINARY_DIR}/OpenRTConfigVersion.cmake DESTINATION ${openrt_cmake_dir})
install(EXPORT OpenRTTargets NAMESPACE OpenRT:: DESTINATION ${openrt_cmake_dir})
install(EXPORT OpenRTSmartTargets NAMESPACE OpenRT:: DESTINATION ${openrt_cmake_dir})

# The .pc files find their prefix from where they lie: the tree may be installed anywhere.
file(RELATIVE_PATH openrt_prefix_from_pc
    /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)

set(packages openrt openrt-shader)
if(TARGET rtut)
    list(APPEND packages rtut)
endif()
foreach(package ${packages})
    configure_file(${CMAKE_CURRENT_LIST_DIR}/${package}.pc.in
        ${PROJECT_BINARY_DIR}/${package}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/${package}.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()
