# Makes a manual page of each program and each verb from what `--help` says.
#
# in  PROGRAM, WINDOW, VERSION, HELP2MAN, GZIP, FOLDER
function(make_page page program help_option title version_line)
    execute_process(
        COMMAND ${HELP2MAN} --no-info --no-discard-stderr "--help-option=${help_option}" "--version-string=${version_line}"
                "--name=${title}" "--output=${FOLDER}/${page}.1" ${program}
        COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND ${GZIP} -9nf ${FOLDER}/${page}.1 COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
make_page(rasterlens ${WINDOW} --help "shows how a triangle becomes pixels" "rasterlens ${VERSION}")
execute_process(COMMAND ${PROGRAM} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n  [a-z]+ +[^\n]+" verbs "${help}")
foreach(line IN LISTS verbs)
    string(REGEX MATCH "([a-z]+) +(.+)" line "${line}")
    make_page(rasterlens-cli-${CMAKE_MATCH_1} ${PROGRAM} "${CMAKE_MATCH_1} --help" "${CMAKE_MATCH_2}"
              "rasterlens-cli-${CMAKE_MATCH_1} ${VERSION}")
endforeach()
make_page(rasterlens-cli ${PROGRAM} --help "shows how a triangle becomes pixels, without a window"
          "rasterlens-cli ${VERSION}")
