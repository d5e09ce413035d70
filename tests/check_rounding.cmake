# Fails when core calls a function that libraries round in ways of their own: a pixel or a stored code is never theirs to
# decide.
#
# cmake -D ROOT=<tree> -P check_rounding.cmake
set(violations "")
file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/core/*.h ${ROOT}/core/*.cpp)
foreach(source IN LISTS sources)
    file(STRINGS ${ROOT}/${source} calls
         REGEX "(^|[^A-Za-z0-9_])(roundEven|iround|uround|qRound(64)?|ApproximateReciprocal(Sqrt)?)[ \t]*\\(")
    foreach(line IN LISTS calls)
        string(STRIP "${line}" line)
        string(APPEND violations "${source}: ${line}\n")
    endforeach()
endforeach()
if(violations)
    message(FATAL_ERROR "Rounding that differs between libraries or instruction sets:\n${violations}")
endif()
