# QCustomPlot 2.1 for Qt 6, as QCustomPlotQt6::QCustomPlotQt6. Debian's package brings a configuration file for CMake; other
# systems have a header and a library, which is libqcustomplot-qt6 in Fedora and libqcustomplot as its author builds it.
find_package(QCustomPlotQt6 CONFIG QUIET)
if(NOT QCustomPlotQt6_FOUND)
    find_path(QCUSTOMPLOT_FOLDER qcustomplot.h PATH_SUFFIXES qcustomplot-qt6 qcustomplot)
    find_library(QCUSTOMPLOT_LIBRARY NAMES QCustomPlotQt6 qcustomplot-qt6 qcustomplot)
    include(FindPackageHandleStandardArgs)
    find_package_handle_standard_args(QCustomPlotQt6 REQUIRED_VARS QCUSTOMPLOT_LIBRARY QCUSTOMPLOT_FOLDER)
    if(QCustomPlotQt6_FOUND AND NOT TARGET QCustomPlotQt6::QCustomPlotQt6)
        find_package(Qt6 6.4 REQUIRED COMPONENTS Widgets PrintSupport)
        add_library(QCustomPlotQt6::QCustomPlotQt6 UNKNOWN IMPORTED)
        set_target_properties(QCustomPlotQt6::QCustomPlotQt6 PROPERTIES
            IMPORTED_LOCATION "${QCUSTOMPLOT_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${QCUSTOMPLOT_FOLDER}")
        target_link_libraries(QCustomPlotQt6::QCustomPlotQt6 INTERFACE Qt6::Widgets Qt6::PrintSupport)
    endif()
endif()
