#pragma once
#include "core/lessons/lesson.h"
#include "core/page/page_run.h"

#include <QHash>
#include <QJsonArray>
#include <QJsonObject>

#include <optional>

namespace rasterlens
{

/// Most steps of one slide's run, and of all runs that slides add to a page.
constexpr std::size_t kMostSlideSteps = 2000;
constexpr std::size_t kMostLessonSteps = 4000;

/// The runs of a page. Slides that show one frame share its run.
class PageRuns
{
public:
    PageRuns(PageWords& words, PageTables& tables) : m_words(words), m_tables(tables) {}

    /// The run of the scene that the page is about; it is the first. Slides share it unless it is filtered.
    void addMain(const Scene& scene, const Settings& settings, const StepFilter& filter);

    /// The moment of a slide: the number of its run, of its step and its pixel.
    ///
    /// errors  nothing where its run does not have the step
    [[nodiscard]] std::optional<QJsonObject> momentJson(const Moment& moment, const OpenMoment& open);

    [[nodiscard]] const QJsonArray& json() const { return m_runs; }

private:
    /// A run that has all its steps.
    struct Known {
        int number;
        std::shared_ptr<const StepLog> log;
    };

    [[nodiscard]] std::optional<QJsonObject> stillMoment(const Moment& moment, const OpenMoment& open,
                                                         const StepLog& begun, const QImage& other);

    PageWords& m_words;
    PageTables& m_tables;
    QJsonArray m_runs;
    QHash<QByteArray, Known> m_known; ///< by what they draw
    std::size_t m_lessonSteps = 0;
};

/// The slides of a lesson, with their questions and the right answers.
///
/// errors  into the diagnostics, with file and line
[[nodiscard]] QJsonObject lessonJson(const Lesson& lesson, PageRuns& runs, PageWords& words, TextTable& texts,
                                     Diagnostics& diagnostics);

} // namespace rasterlens
