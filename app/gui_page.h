#pragma once
#include "core/io/reach.h"

#include <QCommandLineOption>
#include <QCommandLineParser>
#include <QPoint>
#include <QString>

#include <optional>

namespace rasterlens
{

/// A page that is written in place of a window.
struct PageArguments {
    QString path;
    QString lesson; ///< empty: none
    std::optional<std::uint32_t> face;
    std::optional<QPoint> pixel; ///< only the steps at this one
    std::optional<std::size_t> limit;
    QString scene;                     ///< a scene or a session
    QString model;                     ///< in place of the one that the session names; empty: that one
    Outside outside = Outside::Refuse; ///< whether files may name others outside their folders
    QString step;                      ///< the place that is shown first; empty: the beginning
    std::optional<QPoint> chosen;      ///< the pixel that is chosen first
};

/// The options of the program about it.
struct PageOptions {
    QCommandLineOption path;
    QCommandLineOption lesson;
    QCommandLineOption face;
    QCommandLineOption pixel;
    QCommandLineOption limit;

    PageOptions();
    [[nodiscard]] QList<QCommandLineOption> all() const { return {path, lesson, face, pixel, limit}; }
};

/// Reads the options about a page.
///
/// out  why one of them is refused
[[nodiscard]] std::optional<QString> readPage(const QCommandLineParser& parser, const PageOptions& options,
                                              PageArguments& page);

/// Writes the page; messages go to stderr.
///
/// out  the exit code of the program: 0 written; 2 settings that cannot be drawn, a face or a step that is not there;
///      3 input that cannot be read, or output that cannot be written
[[nodiscard]] int writePage(const PageArguments& page);

} // namespace rasterlens
