# cmake --install <build> --prefix <where>, find_package(pfem), cpack -G DEB
#
#   bin/                     programs, pfemHistory, pfemAnimate
#   lib/libpfem.a            the library; lib/cmake/pfem: for find_package
#   include/pfem/            its headers
#   share/pfem/              etc/ (bashrc, completion), bin/tools, tutorials, doc, examples: the project's folder of a user
#   share/man/man1/          made from the programs' own -help-man
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS ${PFEM_PROGRAMS} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
list(TRANSFORM PFEM_SCRIPTS PREPEND bin/ OUTPUT_VARIABLE scripts)
install(PROGRAMS ${scripts} DESTINATION ${CMAKE_INSTALL_BINDIR})
foreach(program ${PFEM_PROGRAMS} ${PFEM_SCRIPTS})
  install(FILES ${PROJECT_BINARY_DIR}/man/${program}.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endforeach()
install(DIRECTORY etc bin tutorials doc examples DESTINATION ${CMAKE_INSTALL_DATADIR}/pfem USE_SOURCE_PERMISSIONS
        PATTERN "__pycache__" EXCLUDE PATTERN "log.*" EXCLUDE PATTERN "postProcessing" EXCLUDE PATTERN "*.vtu*" EXCLUDE PATTERN "case.pvd" EXCLUDE
        REGEX "tutorials/[A-Za-z]*/[0-9.]+$" EXCLUDE)
install(DIRECTORY applications DESTINATION ${CMAKE_INSTALL_DATADIR}/pfem FILES_MATCHING PATTERN "*.cpp")
install(FILES README.md CHANGELOG.md CITATION.cff LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/pfem)

install(TARGETS pfem EXPORT pfemTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY src/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pfem FILES_MATCHING PATTERN "*.hpp")
install(EXPORT pfemTargets NAMESPACE pfem:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/pfem)
set(PFEM_APPLICATIONS ${CMAKE_INSTALL_DATADIR}/pfem/applications)
configure_package_config_file(cmake/pfemConfig.cmake.in ${PROJECT_BINARY_DIR}/pfemConfig.cmake
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/pfem
                              PATH_VARS PFEM_APPLICATIONS)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/pfemConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/pfemConfig.cmake ${PROJECT_BINARY_DIR}/pfemConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/pfem)

set(CPACK_PACKAGE_NAME libpfem)
set(CPACK_PACKAGE_CONTACT "the libpfem project")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Free-surface flow and elastic solids by the Particle Finite Element Method")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS gnuplot)
set(CPACK_STRIP_FILES ON)
include(CPack)
