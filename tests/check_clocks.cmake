# Fails where a program asks what time of the day it is: clocks are set, also backwards, and what is measured or waited
# for with one would then be wrong. std::chrono::steady_clock and QElapsedTimer only go forwards.
#
# cmake -D ROOT=<tree> -P check_clocks.cmake
set(violations "")
file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/core/*.h ${ROOT}/core/*.cpp ${ROOT}/ui/*.h ${ROOT}/ui/*.cpp
     ${ROOT}/app/*.h ${ROOT}/app/*.cpp)
list(LENGTH sources count)
if(count LESS 100)
    message(FATAL_ERROR "${ROOT} holds ${count} sources")
endif()
foreach(source IN LISTS sources)
    file(STRINGS ${ROOT}/${source} uses REGEX
         "system_clock|high_resolution_clock|currentDateTime|currentMSecsSinceEpoch|currentSecsSinceEpoch|QTime::current|QDate::current|gettimeofday|CLOCK_REALTIME|[^A-Za-z_]time\\((nullptr|NULL|0)\\)")
    foreach(line IN LISTS uses)
        string(STRIP "${line}" line)
        string(APPEND violations "${source}: ${line}\n")
    endforeach()
endforeach()
if(violations)
    message(FATAL_ERROR "A clock that can be set:\n${violations}")
endif()
