#pragma once
#include "core/base/reason.h"
#include "core/observe/step_log.h"
#include "core/questions/why.h"
#include "core/scene/scene.h"
#include "core/settings/mistakes.h"

#include <QString>
#include <QStringList>

#include <array>
#include <vector>

namespace rasterlens
{

enum class PageLanguage { English, Chinese };

/// A line of the listing.
struct PageCodeLine {
    QString code;
    QString right; ///< what should stand there, where a mistake is in its place; else empty
};

/// What a page says of a step.
struct PageStepWords {
    QString title;
    QString sentence;
    QString formula;
    std::array<PageCodeLine, 4> code;
    int line = -1; ///< of the code, the one that is run; -1: none
};

/// What a page says of a face at a pixel.
struct PageFaceWords {
    QString name;
    QString verdict;
    bool seen = false; ///< it got into the picture
    QStringList details;
};

/// What a page says of a pixel.
struct PageCardWords {
    QString answer;      ///< which face is seen
    QStringList samples; ///< with several samples a pixel: what they store, and their mean
    std::vector<PageFaceWords> faces;
};

/// The words of the window, for a page. The language is switched by use(), and holds until it is switched again.
class PageWords
{
public:
    PageWords() = default;
    virtual ~PageWords() = default;
    Q_DISABLE_COPY_MOVE(PageWords)

    virtual void use(PageLanguage language) = 0;

    [[nodiscard]] virtual QString sceneTitle(const Scene& scene) const = 0;
    [[nodiscard]] virtual QString sceneNote(const Scene& scene) const = 0;
    [[nodiscard]] virtual QString mistake(const Mistake& mistake) const = 0; ///< `M1: All edges are inclusive`
    [[nodiscard]] virtual QString remark(const Reason& reason) const = 0;    ///< a text of the context "Diagnostic"
    [[nodiscard]] virtual PageStepWords step(const StepLog& log, std::size_t i) const = 0;
    [[nodiscard]] virtual PageCardWords card(const WhyReport& report) const = 0;
};

} // namespace rasterlens
