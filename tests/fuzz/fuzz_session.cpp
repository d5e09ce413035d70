// Sessions: the JSON of a `.json` file. What is read is written and read again.
#include "core/io/session.h"
#include "tests/fuzz/target.h"

using namespace rasterlens;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const QString path = fuzz::fileOf(fuzz::bytesOf(data, size), "session.json");
    const SessionLoad load = loadSession(path);
    fuzz::requireReason(load.session, load.diagnostics);
    if (!load.session)
        return 0;
    const SettingsParse parse = settingsOf(*load.session, {});
    const QString again = fuzz::folder().filePath(QStringLiteral("again.json"));
    fuzz::require(!saveSession(*load.session, again), "a session can be written");
    const SessionLoad second = loadSession(again);
    fuzz::requireReason(second.session, second.diagnostics);
    fuzz::require(second.session && second.session->vertices == load.session->vertices &&
                      second.session->colors == load.session->colors &&
                      second.session->settings == load.session->settings && second.session->view == load.session->view,
                  "a session that was written is read as it was");
    fuzz::require(settingsOf(*second.session, {}).errors.size() == parse.errors.size(),
                  "and its settings are as good as they were");
    return 0;
}
