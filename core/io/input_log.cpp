#include "core/io/input_log.h"

#include "core/io/path_bytes.h"

#include <QFileInfo>

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <system_error>

namespace rasterlens
{
namespace
{

thread_local InputLog* openLog = nullptr;

} // namespace

FileStamp stampOf(const QString& path)
{
    const std::filesystem::path file(bytesOfPath(path).toStdString());
    std::error_code error;
    FileStamp stamp;
    const auto modified = std::filesystem::last_write_time(file, error);
    if (error)
        return {};
    stamp.exists = true;
    stamp.modified = static_cast<qint64>(modified.time_since_epoch().count());
    const auto bytes = std::filesystem::file_size(file, error);
    stamp.bytes = error ? 0 : static_cast<qint64>(bytes); // a folder has no size
    return stamp;
}

InputLog::InputLog()
{
    assert(openLog == nullptr);
    openLog = this;
}

InputLog::~InputLog() { openLog = nullptr; }

void InputLog::note(const QString& path)
{
    if (openLog == nullptr || path.startsWith(QLatin1Char(':'))) // resources of the program never change
        return;
    const QString absolute = QFileInfo(path).absoluteFilePath();
    const auto known =
        std::ranges::any_of(openLog->m_files, [&](const InputFile& file) { return file.path == absolute; });
    if (!known)
        openLog->m_files.push_back({absolute, stampOf(absolute)});
}

} // namespace rasterlens
