#pragma once
#include "core/base/reason.h"

#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>

namespace rasterlens
{

/// The bytes of a file in memory, read from the disk as they are looked at.
///
/// covers  a file that another program shortens meanwhile: the bytes that are gone read as 0, and wasShortened() says
/// so
class MappedFile
{
public:
    MappedFile() = default;
    ~MappedFile();
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;

    /// Opens a file, once.
    ///
    /// out     why there is nothing to read, a sentence without the file name; or nothing
    /// errors  those of readInput()
    [[nodiscard]] std::optional<Reason> open(const QString& path);

    [[nodiscard]] std::string_view text() const { return {m_data, m_size}; }
    [[nodiscard]] bool wasShortened() const;

private:
    struct Guard;

    const char* m_data = nullptr;
    std::size_t m_size = 0;
    Guard* m_guard = nullptr;
};

} // namespace rasterlens
