#pragma once
#include "core/page/page_words.h"
#include "core/page/text_table.h"

#include <QJsonArray>
#include <QJsonObject>

#include <optional>

namespace rasterlens
{

/// What the runs of a page have in common.
struct PageTables {
    TextTable texts;
    QJsonArray codes; ///< listings, each four pairs of a line and the right line, as numbers of texts

    /// The number of a listing.
    [[nodiscard]] int addCode(const PageStepWords& english, const PageStepWords& chinese);
};

/// The pixels in the order of rows as base64 of a zlib stream: red, green and blue, each as its difference from the
/// pixel before, from black for the first, in one byte.
[[nodiscard]] QString packedPicture(const QImage& image);

/// A run with all its steps: the events of the log, what is said of each, and the samples that each changes.
///
/// in  `other`: a picture that the finished one is compared with; null: none
[[nodiscard]] QJsonObject runJson(const Scene& scene, const Settings& settings, const StepLog& log, const QImage& other,
                                  PageWords& words, PageTables& tables);

/// A run whose steps are too many: the picture at a moment and, if there is one, the step that led to it.
struct PageStill {
    QImage picture;
    const StepLog* log;               ///< a window of the record
    std::optional<std::size_t> event; ///< in the log
    QImage other;
    std::optional<QPoint> pixel; ///< the one that gets a card
};
[[nodiscard]] QJsonObject stillJson(const Scene& scene, const Settings& settings, const PageStill& still,
                                    PageWords& words, PageTables& tables);

} // namespace rasterlens
