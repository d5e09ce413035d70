#include "ui/truth/referee.h"

#include "ui/base/language.h"
#include "ui/base/numbers.h"

#include <QElapsedTimer>

#include <algorithm>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kProgressMs = 100;

} // namespace

Referee::Referee(Document& document, QObject* parent)
    : QObject(parent), m_document(document), m_result(
                                                 [this](const Check& check) {
                                                     m_percent = check.percent;
                                                     m_judgement = check.judgement;
                                                     Q_EMIT changed();
                                                 },
                                                 [this](Lack lack) {
                                                     m_lack = lack;
                                                     Q_EMIT changed();
                                                 })
{
    connect(&document, &Document::settingsChanged, this, [this] {
        if (m_on)
            check();
    });
}

void Referee::setOn(bool on)
{
    if (on == m_on)
        return;
    m_on = on;
    check();
}

void Referee::setSpace(ReferenceSpace space)
{
    if (space == m_space)
        return;
    m_space = space;
    check();
}

ReferenceSpace Referee::space() const { return referenceSpace(*m_document.scene(), m_space); }

bool Referee::hasSpaces() const { return m_document.scene()->space == SceneSpace::Object; }

void Referee::check()
{
    m_judgement.reset();
    m_lack.reset();
    m_percent = 0;
    if (!m_on || notJudged(*m_document.scene(), m_document.settings()) != NotJudged::No)
        m_result.drop();
    else
        m_result.ask([scene = m_document.scene(), settings = m_document.settings(),
                      space = m_space](const Turn& turn) { return run(*scene, settings, space, turn); },
                     LatestJob::Running::Interrupt);
    Q_EMIT changed();
}

/// On the background thread.
Referee::Check Referee::run(const Scene& scene, const Settings& settings, ReferenceSpace space, const Turn& turn)
{
    QElapsedTimer clock;
    clock.start();
    const auto progress = [&](double share) {
        if (clock.elapsed() < kProgressMs)
            return;
        clock.restart();
        turn.deliver({static_cast<int>(100 * share), nullptr});
    };
    return {100, std::make_shared<const Judgement>(judge(scene, settings, turn.stop(), progress, space))};
}

QString Referee::whyNot() const
{
    switch (notJudged(*m_document.scene(), m_document.settings())) {
    case NotJudged::No: break;
    case NotJudged::Unsupported: return tr("not checked: these settings cannot be drawn");
    case NotJudged::NotFilled: return tr("not checked: only filled triangles have a true coverage");
    }
    if (m_lack == Lack::Memory)
        return tr("not checked: there is not enough memory for another picture of this size");
    return m_lack ? tr("not checked: %1").arg(lackText(*m_lack)) : QString();
}

QString Referee::text() const
{
    if (!m_on)
        return {};
    if (isChecking())
        return m_percent > 0 ? tr("checking \u2026 %1 %").arg(m_percent) : tr("checking \u2026");
    if (!m_judgement)
        return whyNot();
    const CoverageDifference& difference = m_judgement->difference;
    QStringList counts;
    for (const PixelVerdict verdict : kVerdicts)
        if (const std::uint64_t count = countOf(difference, verdict); count > 0)
            counts << countText(verdict, count);
    const QString all = grouped(difference.pixels);
    const bool one = m_document.settings().samples == Samples::One;
    if (counts.isEmpty())
        return one ? tr("none wrong of %1 samples").arg(all)
                   : tr("none wrong of %1 pixels, judged by their middle samples").arg(all);
    const QString list = listed(counts);
    return one ? tr("%1 of %2 samples").arg(list, all)
               : tr("%1 of %2 pixels, judged by their middle samples").arg(list, all);
}

QString Referee::detail() const
{
    if (!m_judgement)
        return {};
    QStringList parts;
    const CoverageDifference& difference = m_judgement->difference;
    if (m_document.settings().visibility == Visibility::ZBuffer)
        parts << tr("depth off by at most %1").arg(difference.depthMax, 0, 'g', 2);
    if (m_document.settings().shading == Shading::Gouraud)
        parts << tr("colour by at most %1 of 255 steps").arg(difference.colorMax, 0, 'f', 2);
    if (m_judgement->bandPixels > 0)
        parts << tr("%1 within %2 px of an edge let pass")
                     .arg(grouped(difference.tolerated))
                     .arg(m_judgement->bandPixels, 0, 'g', 2);
    return parts.join(QStringLiteral(" \u00b7 "));
}

std::optional<QPoint> Referee::nextWrong(std::optional<QPoint> after) const
{
    if (!m_judgement || m_judgement->wrong.empty())
        return std::nullopt;
    const std::vector<WrongPixel>& wrong = m_judgement->wrong;
    const auto place = [](const WrongPixel& pixel) { return std::pair(pixel.y, pixel.x); };
    auto next = wrong.begin();
    if (after)
        next = std::ranges::upper_bound(wrong, std::pair(after->y(), after->x()), {}, place);
    if (next == wrong.end())
        next = wrong.begin();
    return QPoint(next->x, next->y);
}

std::uint64_t countOf(const CoverageDifference& difference, PixelVerdict verdict)
{
    switch (verdict) {
    case PixelVerdict::Right: return difference.pixels - difference.wrong();
    case PixelVerdict::OtherFace: return difference.otherFace;
    case PixelVerdict::HitLess: return difference.hitLess;
    case PixelVerdict::HitTwice: return difference.hitTwice;
    case PixelVerdict::Extra: return difference.extra;
    case PixelVerdict::Missing: return difference.missing;
    }
    return 0;
}

QString countText(PixelVerdict verdict, std::uint64_t count)
{
    const QString number = grouped(count);
    switch (verdict) {
    case PixelVerdict::Right: return Referee::tr("%1 right").arg(number);
    case PixelVerdict::OtherFace: return Referee::tr("%1 of another face").arg(number);
    case PixelVerdict::HitLess: return Referee::tr("%1 hit too seldom").arg(number);
    case PixelVerdict::HitTwice: return Referee::tr("%1 hit twice").arg(number);
    case PixelVerdict::Extra: return Referee::tr("%1 extra").arg(number);
    case PixelVerdict::Missing: return Referee::tr("%1 missing").arg(number);
    }
    return {};
}

} // namespace rasterlens
