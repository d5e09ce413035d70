#include "ui/window/window_page_words.h"

#include "ui/base/language.h"
#include "ui/face/pixel_card.h"
#include "ui/face/sample_rows.h"
#include "ui/pipeline/scene_words.h"
#include "ui/steps/step_formula.h"
#include "ui/steps/step_sentence.h"

#include <QCoreApplication>

namespace rasterlens
{

WindowPageWords::Texts::Texts()
{
    (void)m_chinese.load(QStringLiteral(":/rasterlens/translations/rasterlens_zh_CN.qm"));
}

QString WindowPageWords::Texts::translate(const char* context, const char* source, const char* disambiguation,
                                          int n) const
{
    const QString chinese =
        language == PageLanguage::Chinese ? m_chinese.translate(context, source, disambiguation, n) : QString();
    return chinese.isEmpty() ? QString::fromUtf8(source) : chinese;
}

WindowPageWords::WindowPageWords() { QCoreApplication::installTranslator(&m_texts); }

WindowPageWords::~WindowPageWords() { QCoreApplication::removeTranslator(&m_texts); }

QString WindowPageWords::sceneTitle(const Scene& scene) const { return rasterlens::sceneTitle(scene); }

QString WindowPageWords::sceneNote(const Scene& scene) const { return rasterlens::sceneNote(scene); }

QString WindowPageWords::mistake(const Mistake& mistake) const
{
    return labelled(QLatin1String(mistake.number), QCoreApplication::translate("Mistake", mistake.title));
}

QString WindowPageWords::remark(const Reason& reason) const
{
    return textOf(reason, [](const char* text) { return QCoreApplication::translate("Diagnostic", text); });
}

PageStepWords WindowPageWords::step(const StepLog& log, std::size_t i) const
{
    const StepExplanation told = explainStep(log, i);
    PageStepWords words{stepTitle(log, i), stepSentence(log, i), told.formula, {}, told.line};
    for (std::size_t line = 0; line < told.listing.size(); ++line)
        words.code[line] = {told.listing[line].code, told.listing[line].right};
    return words;
}

PageCardWords WindowPageWords::card(const WhyReport& report) const
{
    PageCardWords words{whyAnswer(report), {}, {}};
    for (const SampleWords& group : sampleWords(report))
        words.samples << group.title << group.samples << group.sums;
    for (const WhyFace& face : report.faces) {
        const WhyWords said = whyWords(report, face);
        words.faces.push_back({said.name, said.verdict, said.good, said.details});
    }
    return words;
}

} // namespace rasterlens
