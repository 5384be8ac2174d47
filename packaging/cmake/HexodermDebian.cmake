# Debian packages, one of each install component, by `cpack` (packaging/deb.sh does all of it).
find_program(HEXODERM_DPKG_DEB dpkg-deb)
find_program(HEXODERM_GZIP gzip)
if(NOT HEXODERM_DPKG_DEB OR NOT HEXODERM_GZIP)
  return()
endif()
set(HEXODERM_MAINTAINER "The Hexoderm authors <hexoderm@example.org>" CACHE STRING
  "Name and address of whoever answers for the Debian packages")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME hexoderm)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGE_VENDOR "The Hexoderm authors")
set(CPACK_PACKAGE_CONTACT "${HEXODERM_MAINTAINER}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# The versions of libraries that are asked for are those of the symbols that are used.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")

set(version "${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}")
# As Debian derives it from the name of the shared library.
set(library "libhexoderm-core${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
# Lines of 79 characters at most, as Debian wants them.
set(what [[
Hexoderm reconstructs the placement of every cell of a robot's artificial
skin from the direction of gravity in the cells' accelerometers and from the
links between the cells. It states how accurate the placements are, and
exports them in the formats that robot software reads.
.
]])

file(READ "${PROJECT_SOURCE_DIR}/LICENSE" licence)
string(REGEX REPLACE "^[^\n]*\n\n([^\n]*)\n\n" "" licence "${licence}")
string(REGEX REPLACE "^Copyright \\(c\\) " "" holder "${CMAKE_MATCH_1}")
string(REGEX REPLACE "\n+$" "" licence "${licence}")
string(REPLACE "\n\n" "\n.\n" licence "${licence}")
string(REPLACE "\n" "\n " licence "${licence}")
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # of SOURCE_DATE_EPOCH, where that is set
set(made "${CMAKE_CURRENT_BINARY_DIR}/debian")
file(CONFIGURE OUTPUT "${made}/copyright" @ONLY CONTENT [[
Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: Hexoderm

Files: *
Copyright: @holder@
License: BSD-3-Clause
 @licence@
]])
file(CONFIGURE OUTPUT "${made}/changelog.Debian" @ONLY CONTENT [[
hexoderm (@version@) unstable; urgency=medium

  * Made by packaging/deb.sh; changelog.gz says what is new.

 -- @HEXODERM_MAINTAINER@  @date@
]])
configure_file("${PROJECT_SOURCE_DIR}/CHANGELOG.md" "${made}/changelog" COPYONLY)
foreach(text changelog changelog.Debian)
  execute_process(COMMAND "${HEXODERM_GZIP}" -9nkf "${made}/${text}" COMMAND_ERROR_IS_FATAL ANY)
endforeach()

# hexoderm_package(COMPONENT NAME SECTION SUMMARY TEXT): `cmake --install` without a component leaves out what only Debian's
# packages have.
function(hexoderm_package component name section summary text)
  string(TOUPPER "${component}" COMPONENT)
  set(CPACK_DEBIAN_${COMPONENT}_PACKAGE_NAME "${name}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${COMPONENT}_PACKAGE_SECTION "${section}" PARENT_SCOPE)
  set(CPACK_COMPONENT_${COMPONENT}_DESCRIPTION "${summary}\n${what}${text}" PARENT_SCOPE)
  install(FILES "${made}/copyright" "${made}/changelog.gz" "${made}/changelog.Debian.gz"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${name}" COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()

hexoderm_package(Runtime hexoderm science "calibration of artificial skin on robots"
  "This package has the window, the command line and an emulated device.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS "hexoderm-data (= ${version})")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS
  "fonts-inter, qttranslations5-l10n, qtspeech5-speechd-plugin")

hexoderm_package(Data hexoderm-data science "calibration of artificial skin on robots - shared data"
  "This package has cell models, the schemas of file formats, the demo robot,\nand for makers of skins the protocol, a header for firmware, and examples.")
set(CPACK_DEBIAN_DATA_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DATA_PACKAGE_SHLIBDEPS OFF)

hexoderm_package(Library ${library} libs "calibration of artificial skin on robots - library"
  "This package has the shared library.")
# CPack calls ldconfig in scripts of the package, and Debian wants a trigger.
file(WRITE "${made}/triggers" "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA "${made}/triggers")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_RECOMMENDS "hexoderm-data (= ${version})")

hexoderm_package(Development libhexoderm-dev libdevel "calibration of artificial skin on robots - development files"
  "This package has what C++20 programs that use the library are compiled with.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "${library} (= ${version}), hexoderm-data (= ${version}), libeigen3-dev (>= 3.4)")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "cmake, pkg-config")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)

set(CPACK_COMPONENTS_ALL Runtime Data Library Development)
get_cmake_property(components COMPONENTS)
# hexoderm_python_package(COMPONENT NAME): Python compiles the files when the package is installed, and what it
# makes of them goes with the package.
function(hexoderm_python_package component name)
  file(CONFIGURE OUTPUT "${made}/${name}/postinst" @ONLY CONTENT [[
#!/bin/sh
set -e
if [ "$1" = configure ] && command -v py3compile >/dev/null; then
  py3compile -p @name@
fi
]])
  file(CONFIGURE OUTPUT "${made}/${name}/prerm" @ONLY CONTENT [[
#!/bin/sh
set -e
if command -v py3clean >/dev/null; then
  py3clean -p @name@
fi
]])
  string(TOUPPER "${component}" COMPONENT)
  set(CPACK_DEBIAN_${COMPONENT}_PACKAGE_CONTROL_EXTRA "${made}/${name}/postinst;${made}/${name}/prerm" PARENT_SCOPE)
endfunction()

if(Python IN_LIST components)
  list(APPEND CPACK_COMPONENTS_ALL Python)
  hexoderm_package(Python python3-hexoderm python "calibration of artificial skin on robots - Python module"
    "This package has the module for Python, and an example that ends in a\npicture.")
  hexoderm_python_package(Python python3-hexoderm)
  # A compiled module is for the minor version of Python that it was made with.
  execute_process(COMMAND "${HEXODERM_PYTHON_EXECUTABLE}" -c
    "import sys; v = sys.version_info; print(f'python3 (>= {v[0]}.{v[1]}~), python3 (<< {v[0]}.{v[1] + 1}~)')"
    OUTPUT_VARIABLE for_python OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "hexoderm-data (= ${version}), ${for_python}, python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib")
endif()
if(Ros IN_LIST components)
  list(APPEND CPACK_COMPONENTS_ALL Ros)
  hexoderm_package(Ros hexoderm-ros science "calibration of artificial skin on robots - adapter for ROS"
    "This package passes readings of ROS topics on to Hexoderm, and publishes a\ncalibration as frames of TF.")
  hexoderm_python_package(Ros hexoderm-ros)
  set(CPACK_DEBIAN_ROS_PACKAGE_ARCHITECTURE all)
  set(CPACK_DEBIAN_ROS_PACKAGE_SHLIBDEPS OFF)
  set(CPACK_DEBIAN_ROS_PACKAGE_DEPENDS "python3 (>= 3.9), python3-genpy, python3-geometry-msgs, python3-rospy, \
python3-sensor-msgs, python3-tf2-ros, python3-yaml")
  set(CPACK_DEBIAN_ROS_PACKAGE_SUGGESTS "hexoderm, ros-core")
endif()
include(CPack)
