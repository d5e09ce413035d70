# Fails when a text of the window has no Chinese yet.
#
# cmake -D ROOT=<tree> -P check_translations.cmake
file(READ ${ROOT}/resources/translations/rasterlens_zh_CN.ts translations)
string(REGEX MATCHALL "<source>[^<]*</source>[^<]*<translation type=\"unfinished\"" unfinished "${translations}")
if(unfinished)
    list(JOIN unfinished "\n" unfinished)
    message(FATAL_ERROR "unfinished translations:\n${unfinished}")
endif()
