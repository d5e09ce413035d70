# Fails if a program shows the dynamic linker instances of templates in Qt's headers: a library that was built with the
# headers of another Qt would call them.
#
# cmake -D NM=<nm> -D PROGRAM=<file> -P check_symbols.cmake

execute_process(COMMAND ${NM} --dynamic --demangle ${PROGRAM} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
if(NOT symbols MATCHES " U ")
    message(FATAL_ERROR "${PROGRAM}: nm names no function of a library")
endif()
string(REGEX MATCHALL "[^\n]* [TWV] [^\n]*(QtPrivate::|QArrayData|QList<)[^\n]*" shown "${symbols}")
if(shown)
    list(JOIN shown "\n" shown)
    message(FATAL_ERROR "${PROGRAM} exports what it made of templates in Qt's headers:\n${shown}")
endif()
