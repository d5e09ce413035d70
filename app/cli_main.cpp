#include "app/cli/options.h"
#include "app/cli/output.h"
#include "app/cli/verbs.h"

#include <QFile>

#include <csignal>
#include <cstdio>
#include <new>
#include <system_error>

namespace rasterlens::cli
{
namespace
{

QString verbNames()
{
    QStringList names;
    for (const Verb& verb : verbs())
        names << QLatin1String(verb.name);
    return names.join(QStringLiteral(", "));
}

QString help()
{
    QString text = QStringLiteral("Usage: rasterlens-cli VERB [arguments]\n\n"
                                  "Shows how a triangle becomes pixels, without a window.\n\n"
                                  "Verbs:\n");
    for (const Verb& verb : verbs())
        text += QStringLiteral("  %1%2\n").arg(QLatin1String(verb.name), -10).arg(QLatin1String(verb.summary));
    return text +
           QStringLiteral("\nrasterlens-cli VERB --help explains a verb, rasterlens-cli --version names this build.\n\n"
                          "Try: rasterlens-cli render builtin:cube -o cube.png\n\n"
                          "Exit codes: 0 fine; 1 the run found what it looks for (differences, failing cases);\n"
                          "2 bad arguments or unsupported combination; 3 input that cannot be read or is invalid,\n"
                          "or output that cannot be written. Errors go to stderr.\n");
}

ExitCode run(const QStringList& words)
{
    const QString first = words.value(0);
    if (first == QLatin1String("--help") || first == QLatin1String("-h")) {
        printText(help());
        return ExitCode::Fine;
    }
    if (first == QLatin1String("--version")) {
        printText(QStringLiteral("rasterlens-cli %1\n").arg(QLatin1String(RASTERLENS_VERSION)));
        return ExitCode::Fine;
    }
    for (const Verb& verb : verbs())
        if (first == QLatin1String(verb.name))
            return words.mid(1).contains(QLatin1String("--version")) ? run({QStringLiteral("--version")})
                                                                     : verb.run(words.mid(1));
    if (first.isEmpty())
        failArguments(QStringLiteral("rasterlens-cli: a verb is missing; expected: %1").arg(verbNames()));
    failArguments(QStringLiteral("rasterlens-cli: \"%1\" is not a verb; expected: %2").arg(first, verbNames()));
}

/// Runs and words what went wrong.
ExitCode runGuarded(const QStringList& words)
{
    try {
        return run(words);
    } catch (const Failure& failure) {
        std::fprintf(stderr, "%s\n", qUtf8Printable(failure.message));
        return failure.code;
    } catch (const std::bad_alloc&) {
        std::fputs("rasterlens-cli: there is not enough memory; a smaller --size or fewer --samples need less\n",
                   stderr);
        return ExitCode::BadArguments;
    } catch (const std::system_error& error) { // what the standard library's threads throw
        std::fprintf(stderr, "rasterlens-cli: threads cannot be started: %s; fewer --threads need less\n",
                     error.code().message().c_str());
        return ExitCode::BadArguments;
    }
}

} // namespace
} // namespace rasterlens::cli

int main(int argc, char** argv)
{
#ifdef Q_OS_UNIX
    std::signal(SIGXFSZ, SIG_IGN); // a file that may not grow is an error message
#endif
    // Qt's image readers warn in words of their own; the diagnostics say the same with the file's name.
    qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
    QStringList words;
    for (int i = 1; i < argc; ++i)
        words << QFile::decodeName(argv[i]);
    return static_cast<int>(rasterlens::cli::runGuarded(words));
}
