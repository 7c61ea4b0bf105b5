# SPDX-License-Identifier: MIT
# Debian packages, by `cpack` in a build tree of the preset `package`: a package for each component
# of the installation.
set(openrt_packages libopenrt0 libopenrt-dev openrt-tools openrt-doc)
if(TARGET rtut)
    list(APPEND openrt_packages librtut0)
endif()
if(TARGET OpenRT-mpi)
    list(APPEND openrt_packages libopenrt-mpi0)
endif()

# What Debian asks of every package: who may do what with it, and what changed.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC) # of SOURCE_DATE_EPOCH, where that is set
foreach(package ${openrt_packages})
    set(folder ${PROJECT_BINARY_DIR}/debian/${package})
    configure_file(${CMAKE_CURRENT_LIST_DIR}/debian/changelog.in ${folder}/changelog @ONLY)
    execute_process(COMMAND gzip -9nc ${folder}/changelog OUTPUT_FILE ${folder}/changelog.gz)
    execute_process(COMMAND gzip -9nc ${PROJECT_SOURCE_DIR}/CHANGELOG.md
        OUTPUT_FILE ${folder}/CHANGELOG.md.gz)
    install(FILES ${CMAKE_CURRENT_LIST_DIR}/debian/copyright ${folder}/changelog.gz ${folder}/CHANGELOG.md.gz
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${package})
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME openrt)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own
set(CPACK_PACKAGE_VENDOR "The OpenRT authors")
set(CPACK_PACKAGE_CONTACT "The OpenRT authors <noreply@openrt.example>")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL ${openrt_packages})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)

# openrt_package(NAME SECTION "what it is" "more about it" DEPENDS...)
function(openrt_package name section summary text)
    string(TOUPPER ${name} key)
    set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name} PARENT_SCOPE)
    set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${section} PARENT_SCOPE)
    set(CPACK_COMPONENT_${key}_DESCRIPTION "${summary}\n${text}" PARENT_SCOPE)
    set(CPACK_COMPONENT_${key}_DEPENDS ${ARGN} PARENT_SCOPE)
endfunction()

openrt_package(libopenrt0 libs "real-time ray tracing with an interface like OpenGL's"
    "OpenRT traces rays on the processor, on all its cores, through scenes that a
program describes as it would to OpenGL: rtBegin, rtVertex3f, rtEnd. This
package holds the shared library.")
openrt_package(librtut0 libs "windows and events for OpenRT"
    "The counterpart of GLUT for programs that draw with OpenRT: windows, input,
timers, shapes and fonts, and frames without a display." libopenrt0)
openrt_package(libopenrt-mpi0 libs "OpenRT on several machines, by MPI"
    "Lets all processes that mpirun starts of an OpenRT program render its frames
together. OpenRT opens it by itself when a program was started so." libopenrt0)
set(CPACK_DEBIAN_LIBOPENRT-MPI0_PACKAGE_RECOMMENDS "openmpi-bin")
set(CPACK_DEBIAN_LIBOPENRT0_PACKAGE_SUGGESTS "libopenrt-mpi0")
set(development libopenrt0)
if(TARGET rtut)
    list(APPEND development librtut0)
endif()
openrt_package(libopenrt-dev libdevel "real-time ray tracing - development files"
    "Headers, pkg-config and CMake files for programs that draw with OpenRT and for
shader libraries, and the static ray tracing core libsmart." ${development})
openrt_package(openrt-tools graphics "programs of the OpenRT ray tracing library"
    "openrt-render makes pictures of glTF, OBJ and PLY scenes, openrt-view shows
them, openrt-cave and openrt-xr show them in CAVEs and head-mounted displays,
openrt-trace records and replays what programs call, openrt-info tells what the
library and the machine have. Shader libraries to try and to learn from are
included." libopenrt0)
openrt_package(openrt-doc doc "real-time ray tracing - documentation"
    "Guides to OpenRT: porting OpenGL programs, shaders, textures, precision,
performance and the library's architecture.")
foreach(library LIBOPENRT0 LIBRTUT0 LIBOPENRT-MPI0)
    set(CPACK_DEBIAN_${library}_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/debian/triggers)
endforeach()
set(CPACK_DEBIAN_OPENRT-DOC_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_OPENRT-DOC_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_LIBOPENRT-DEV_PACKAGE_DEPENDS "libglm-dev")
include(CPack)
