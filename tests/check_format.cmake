# Fails when a source is not formatted as .clang-format says.
#
# cmake -D ROOT=<tree> -D CLANG_FORMAT=<program, may be empty> -P check_format.cmake
set(version 14)  # other versions format some lines differently

if(NOT CLANG_FORMAT)
    message("SKIPPED: there is no clang-format here")
    return()
endif()
execute_process(COMMAND ${CLANG_FORMAT} --version OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT found MATCHES "version ${version}\\.")
    message("SKIPPED: sources are formatted by clang-format ${version}, this is: ${found}")
    return()
endif()
set(sources "")
foreach(folder core ui app tests bench)
    file(GLOB_RECURSE inFolder ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.cpp)
    list(APPEND sources ${inFolder})
endforeach()
execute_process(COMMAND ${CLANG_FORMAT} --dry-run -Werror ${sources} RESULT_VARIABLE result)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "Not formatted. Mend it with: clang-format -i FILE")
endif()
