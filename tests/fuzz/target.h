#pragma once
// What the fuzz targets share: bytes as files, and properties that must hold.
#include "core/base/diagnostics.h"

#include <QByteArray>
#include <QFile>
#include <QTemporaryDir>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

/// One execution. libFuzzer calls it with bytes of its own; replay.cpp with those of the files of a corpus.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace rasterlens::fuzz
{

/// Ends the program where a property does not hold: libFuzzer then keeps the input.
inline void require(bool holds, const char* what)
{
    if (holds)
        return;
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
}

/// The bytes, not copied.
inline QByteArray bytesOf(const std::uint8_t* data, std::size_t size)
{
    return QByteArray::fromRawData(reinterpret_cast<const char*>(data), static_cast<qsizetype>(size));
}

/// Takes bytes from the front of an input; zeros once there are none left.
class Bytes
{
public:
    Bytes(const std::uint8_t* data, std::size_t size) : m_data(data), m_left(size) {}

    [[nodiscard]] std::size_t left() const { return m_left; }
    std::uint8_t byte()
    {
        if (m_left == 0)
            return 0;
        --m_left;
        return *m_data++;
    }
    std::uint16_t word()
    {
        const std::uint16_t low = byte();
        return static_cast<std::uint16_t>(low | byte() << 8);
    }
    /// 0..most
    int upTo(int most) { return int(word() % std::uint32_t(most + 1)); }

private:
    const std::uint8_t* m_data;
    std::size_t m_left;
};

/// A folder that is there as long as the program.
inline const QTemporaryDir& folder()
{
    static const QTemporaryDir folder;
    require(folder.isValid(), "a folder for files");
    return folder;
}

/// The bytes as a file of this name, which replaces the former one.
inline QString fileOf(const QByteArray& bytes, const char* name)
{
    QString path = folder().filePath(QString::fromLatin1(name));
    QFile file(path);
    require(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size(), "a file is written");
    return path;
}

/// Nothing is refused without a reason, and what is loaded has no error.
template <class Loaded>
void requireReason(const std::optional<Loaded>& loaded, const Diagnostics& diagnostics)
{
    require(loaded.has_value() != hasErrors(diagnostics), "there is either a result or an error");
    for (const Diagnostic& diagnostic : diagnostics)
        require(!diagnostic.text().isEmpty(), "each diagnostic says something");
}

} // namespace rasterlens::fuzz
