#include "ui/truth/case_model.h"

#include "core/io/case_file.h"
#include "core/truth/expectations.h"
#include "ui/base/applicability.h"
#include "ui/base/case_note.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>

namespace rasterlens
{
namespace
{

constexpr int kThumbnail = 72;

QString translated(const char* text) { return *text ? QCoreApplication::translate("HardCase", text) : QString(); }

/// The part worth looking at, small pictures with whole pixels.
QImage thumbnailOf(const Scene& scene)
{
    Frame frame;
    render(scene, scene.defaults, frame);
    QImage part = frame.image;
    if (scene.window)
        part = part.copy(scene.window->x, scene.window->y, scene.window->width, scene.window->height);
    const bool isSmall = part.width() <= kThumbnail && part.height() <= kThumbnail;
    const QSize size = part.size().scaled(kThumbnail, kThumbnail, Qt::KeepAspectRatio).expandedTo(QSize(4, 4));
    return part.scaled(size, Qt::IgnoreAspectRatio, isSmall ? Qt::FastTransformation : Qt::SmoothTransformation);
}

CaseModel::Case judgedCase(const QString& name, const std::stop_token& stop)
{
    CaseModel::Case one;
    one.name = name;
    const SceneLoad load = loadCase(hardCasePath(name));
    if (!load.scene)
        return one;
    const Scene& scene = *load.scene;
    one.note = scene.note;
    one.expectations = scene.expectations;
    one.thumbnail = thumbnailOf(scene);
    const ExactFrame truth = caseTruth(scene, scene.defaults.samples);
    for (const CaseModel::Variant& variant : CaseModel::kVariants) {
        if (stop.stop_requested())
            break;
        CaseVerdict verdict =
            judgeCase(scene, truth, changedBy(*findVariant(QString::fromLatin1(variant.id)), scene.defaults));
        one.verdicts.push_back({verdict.grade, std::move(verdict.reasons)});
    }
    return one;
}

} // namespace

bool CaseModel::Case::fails() const
{
    return std::ranges::any_of(verdicts, [](const Verdict& verdict) { return verdict.grade == CaseGrade::Fails; });
}

QString CaseModel::Case::noteText() const { return caseNoteText(note); }

QString CaseModel::Case::expectationsText() const
{
    QStringList lines;
    for (const auto& [key, value] : expectations)
        lines << wordsOf(key, value, translated);
    return lines.join(QLatin1Char('\n'));
}

QString CaseModel::Case::reasonText(std::size_t variant) const
{
    const Verdict& verdict = verdicts[variant];
    return verdict.grade == CaseGrade::Unsupported ? whyUnsupported(verdict.reasons.front())
                                                   : textOf(verdict.reasons, translated);
}

CaseModel::CaseModel(QObject* parent)
    : QAbstractListModel(parent),
      m_result([this](const Judged& judged) { take(judged); },
               [this](Lack lack) {
                   Q_EMIT progressed();
                   Q_EMIT failed(tr("The hard cases were not drawn: %1.").arg(lackText(lack)));
               })
{
    for (const QString& name : hardCaseNames()) {
        m_cases.emplace_back();
        m_cases.back().name = name;
    }
}

void CaseModel::start()
{
    if (isBusy() || m_judged == rowCount())
        return;
    QStringList names;
    for (const Case& one : m_cases)
        names << one.name;
    m_result.ask(
        [names, first = m_judged](const auto& turn) {
            const int last = static_cast<int>(names.size()) - 1;
            for (int row = first; row < last && !turn.stop().stop_requested(); ++row)
                turn.deliver({row, judgedCase(names[row], turn.stop())});
            return Judged{last, judgedCase(names[last], turn.stop())};
        },
        LatestJob::Running::Finish);
}

void CaseModel::take(const Judged& judged)
{
    m_cases[static_cast<std::size_t>(judged.row)] = judged.result;
    m_judged = judged.row + 1;
    Q_EMIT dataChanged(index(judged.row), index(judged.row));
    Q_EMIT progressed();
}

int CaseModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_cases.size());
}

QVariant CaseModel::data(const QModelIndex& index, int role) const
{
    const Case& one = at(index.row());
    switch (role) {
    case Qt::DisplayRole: return one.name;
    case Qt::DecorationRole: return one.thumbnail;
    default: return {};
    }
}

QString CaseModel::variantTitle(std::size_t variant)
{
    return titleOf(*findVariant(QString::fromLatin1(kVariants[variant].id)),
                   [](const char* text) { return QCoreApplication::translate("Settings", text); });
}

QString CaseModel::variantSign(std::size_t variant) { return QString::fromLatin1(kVariants[variant].sign); }

} // namespace rasterlens
