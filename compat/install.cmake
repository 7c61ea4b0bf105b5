# SPDX-License-Identifier: MIT
# What `cmake --install` puts where, and the CMake and pkg-config files for programs that use it.
include(CMakePackageConfigHelpers)

# Components are named like the Debian packages that they become.
install(TARGETS OpenRT EXPORT OpenRTTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    COMPONENT libopenrt0 NAMELINK_COMPONENT libopenrt-dev)
if(TARGET rtut)
    install(TARGETS rtut EXPORT OpenRTTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        COMPONENT librtut0 NAMELINK_COMPONENT libopenrt-dev)
    install(FILES ${CMAKE_CURRENT_LIST_DIR}/rtut/fonts/NOTICE
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/librtut0 RENAME NOTICE.fonts COMPONENT librtut0)
endif()
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME libopenrt-dev)
install(TARGETS smart EXPORT OpenRTSmartTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
# Not the headers that are compiled once for each instruction set: they are the kernels' own.
set(kernel_sources "")
file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/libsmart/kernel/*.h)
foreach(header ${headers})
    file(STRINGS ${header} isa REGEX SMART_ISA LIMIT_COUNT 1)
    if(isa)
        cmake_path(GET header FILENAME name)
        list(APPEND kernel_sources PATTERN kernel/${name} EXCLUDE)
    endif()
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/libsmart DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    FILES_MATCHING PATTERN "*.h" ${kernel_sources})
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

# Guides and what they link to, where it lies in the sources.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME openrt-doc)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR}
    PATTERN CMakeLists.txt EXCLUDE PATTERN docs/man EXCLUDE PATTERN docs/site EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/samples/tour ${PROJECT_SOURCE_DIR}/samples/changing
    ${PROJECT_SOURCE_DIR}/samples/ports DESTINATION ${CMAKE_INSTALL_DOCDIR}/samples
    FILES_MATCHING PATTERN "*.c" PATTERN "*.cpp" PATTERN "*.h")
foreach(page README.md CHANGELOG.md CONTRIBUTING.md SECURITY.md LICENSE compat/python/README.md
        .ci/packages.sh)
    cmake_path(GET page PARENT_PATH folder)
    install(FILES ${PROJECT_SOURCE_DIR}/${page} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder})
endforeach()
