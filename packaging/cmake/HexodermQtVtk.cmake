# Qt must be the one that VTK's widgets were built with; the sources compile with Qt 5.15 and Qt 6.

find_package(VTK 9.1 REQUIRED COMPONENTS
  CommonColor CommonCore CommonDataModel CommonTransforms FiltersCore FiltersGeneral FiltersSources GUISupportQt
  IOImage InteractionStyle InteractionWidgets RenderingAnnotation RenderingCore RenderingFreeType RenderingOpenGL2)
find_package(Qt${VTK_QT_VERSION} 5.15 REQUIRED COMPONENTS Core Gui Widgets Svg Test)
set(HEXODERM_QT Qt${VTK_QT_VERSION})
# moc 5.15 can't read <concepts> and <numbers>.
set(CMAKE_AUTOMOC_MOC_OPTIONS -D_GLIBCXX_CONCEPTS -D_GLIBCXX_NUMBERS)

# The tones of capturing.
find_package(${HEXODERM_QT}Multimedia QUIET)
if(NOT ${HEXODERM_QT}Multimedia_FOUND)
  message(FATAL_ERROR "${HEXODERM_QT}Multimedia was not found (Debian: qtmultimedia5-dev). packaging/setup.sh installs it.")
endif()

# Plots. Debian's Qwt has neither CMake files nor a name that is the same for all versions of Qt.
find_path(QWT_INCLUDE_DIR qwt_plot.h PATH_SUFFIXES qwt qwt-qt${VTK_QT_VERSION} qwt6)
find_library(QWT_LIBRARY NAMES qwt-qt${VTK_QT_VERSION} qwt6-qt${VTK_QT_VERSION} qwt)
if(NOT QWT_INCLUDE_DIR OR NOT QWT_LIBRARY)
  message(FATAL_ERROR "Qwt 6.1 for Qt ${VTK_QT_VERSION} was not found (Debian: libqwt-qt5-dev). packaging/setup.sh installs it.")
endif()
if(NOT TARGET Qwt::Qwt)
  add_library(Qwt::Qwt UNKNOWN IMPORTED)
  set_target_properties(Qwt::Qwt PROPERTIES
    IMPORTED_LOCATION "${QWT_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${QWT_INCLUDE_DIR}")
endif()

# lrelease compiles the translations (qttools5-dev, qttools5-dev-tools).
find_package(${HEXODERM_QT}LinguistTools QUIET)
if(NOT ${HEXODERM_QT}LinguistTools_FOUND)
  message(FATAL_ERROR "${HEXODERM_QT}'s Linguist tools are missing; Debian has them in qttools5-dev and "
    "qttools5-dev-tools (packaging/setup.sh installs them)")
endif()
