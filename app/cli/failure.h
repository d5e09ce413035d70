#pragma once
#include <QString>

#include <utility>

namespace rasterlens::cli
{

/// How the program ends. Scripts rely on the numbers.
enum class ExitCode {
    Fine = 0,
    Found = 1,        ///< the run found what it looks for: differences, failing cases
    BadArguments = 2, ///< or a combination of settings that is not supported
    BadInput = 3,     ///< unreadable or invalid input, or output that cannot be written
};

/// Ends the verb. Thrown where the trouble is found, caught by main, which prints the message to stderr.
struct Failure {
    ExitCode code;
    QString message; ///< `FILE:LINE: what is wrong and what is expected`; may be several lines
};

[[noreturn]] inline void failArguments(QString message) { throw Failure{ExitCode::BadArguments, std::move(message)}; }
[[noreturn]] inline void failInput(QString message) { throw Failure{ExitCode::BadInput, std::move(message)}; }

} // namespace rasterlens::cli
