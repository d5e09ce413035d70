// Command lines: the first byte chooses the verb, words end in newlines. They are sorted and become settings; nothing
// is run.
#include "app/cli/failure.h"
#include "app/cli/settings_options.h"
#include "app/cli/verbs.h"
#include "core/scenes/builtin_scenes.h"
#include "tests/fuzz/target.h"

using namespace rasterlens;
using namespace rasterlens::cli;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const Scene scene = *makeBuiltinScene(QStringLiteral("square-diagonal")).scene;
    if (size == 0)
        return 0;
    const Usage usage = verbs()[data[0] % verbs().size()].usage();
    QStringList words;
    for (const QByteArray& word : fuzz::bytesOf(data + 1, size - 1).split('\n'))
        words << QString::fromUtf8(word);
    if (words.contains(QStringLiteral("--help")) || words.contains(QStringLiteral("-h")))
        return 0; // is printed
    try {
        const auto arguments = parseArguments(usage, words);
        fuzz::require(arguments.has_value(), "without --help there are arguments");
        (void)refusal(scene, withOptions(scene.defaults, *arguments));
    } catch (const Failure& failure) {
        fuzz::require(!failure.message.isEmpty() && failure.code != ExitCode::Fine, "a failure says why");
    }
    return 0;
}
