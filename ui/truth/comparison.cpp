#include "ui/truth/comparison.h"

#include "core/render/picture_memory.h"
#include "core/settings/mistakes.h"
#include "core/settings/numbers_field.h"
#include "ui/base/applicability.h"
#include "ui/base/numbers.h"

#include <QCoreApplication>

#include <cmath>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kBlinkMs = 600;

QString mistakesText(const Settings& settings)
{
    QStringList numbers;
    for (const QString& id : settings.mistakes)
        if (const Mistake* mistake = findMistake(id))
            numbers << QLatin1String(mistake->number);
    return numbers.isEmpty() ? Comparison::tr("none") : numbers.join(QLatin1Char(' '));
}

} // namespace

Comparison::Comparison(Document& document, QObject* parent)
    : QObject(parent), m_document(document),
      m_result([this](const Pair& pair) { take(pair); },
               [this](Lack lack) {
                   refuse([lack] {
                       return lack == Lack::Memory ? tr("There is not enough memory for another picture of this size.")
                                                   : tr("A was not drawn: %1").arg(lackText(lack));
                   });
               },
               LatestJob::Late::Taken)
{
    m_blink.setInterval(kBlinkMs);
    connect(&m_blink, &QTimer::timeout, this, [this] {
        m_showsA = !m_showsA;
        Q_EMIT frameChanged();
    });
    connect(&document, &Document::sceneChanged, this, [this] {
        if (m_present && m_present->scene->id != m_document.scene()->id)
            drop();
    });
}

void Comparison::setView(CompareView view)
{
    if (view == m_view)
        return;
    if (m_view == CompareView::Off)
        m_with = !m_document.settings().mistakes.isEmpty() ? CompareWith::Right
                 : m_pinned                                ? CompareWith::Pinned
                                                           : CompareWith::Scene;
    m_view = view;
    m_showsA = view == CompareView::Blink;
    if (view == CompareView::Blink)
        m_blink.start();
    else
        m_blink.stop();
    if (view == CompareView::Off)
        drop();
    compare();
    Q_EMIT changed();
    Q_EMIT frameChanged();
}

void Comparison::setWith(CompareWith with)
{
    if (with == m_with || (with == CompareWith::Pinned && !m_pinned))
        return;
    m_with = with;
    compare();
    Q_EMIT changed();
}

void Comparison::pin()
{
    m_pinned = m_document.settings();
    m_with = CompareWith::Pinned;
    compare();
    Q_EMIT changed();
}

void Comparison::swap()
{
    const Settings present = m_document.settings();
    const Settings next = other(present);
    m_pinned = present;
    m_with = CompareWith::Pinned;
    m_document.setSettings(next);
    compare();
    Q_EMIT changed();
}

void Comparison::setAmplification(int factor)
{
    if (factor == m_amplification)
        return;
    m_amplification = factor;
    compare();
    Q_EMIT changed();
}

Settings Comparison::other(const Settings& present) const
{
    Settings other = present;
    switch (m_with) {
    case CompareWith::Right: other.mistakes.clear(); break;
    case CompareWith::Scene: other = m_document.defaults(); break;
    case CompareWith::Pinned: other = m_pinned.value_or(present); break;
    }
    other.size = present.size;
    other.view = present.view;
    return other;
}

void Comparison::takeFrame(const FramePtr& present)
{
    m_present = present;
    if (m_view != CompareView::Off)
        compare();
}

void Comparison::drop()
{
    m_pair = {};
    m_difference.reset();
    m_refusal = nullptr;
    m_result.drop();
}

bool Comparison::mustInterrupt(const Settings& other) const
{
    Settings sameView = other;
    sameView.view = m_askedFor.view;
    return !(sameView == m_askedFor);
}

void Comparison::compare()
{
    if (m_view == CompareView::Off || !m_present)
        return;
    const Settings other = this->other(m_present->settings);
    if (const auto why = unsupported(*m_present->scene, other)) {
        refuse([why = *why] { return tr("A cannot be drawn: %1").arg(whyUnsupported(why)); });
        return;
    }
    m_refusal = nullptr;
    const auto running = mustInterrupt(other) ? LatestJob::Running::Interrupt : LatestJob::Running::Finish;
    m_askedFor = other;
    Pair pair;
    pair.b = m_present;
    pair.amplification = m_amplification;
    if (m_pair.a && m_pair.a->scene == m_present->scene && m_pair.a->settings == other)
        pair.a = m_pair.a;
    const bool withHeat = m_view == CompareView::Difference;
    m_result.ask([this, pair, other, withHeat](const auto& turn) { return draw(pair, other, withHeat, turn.stop()); },
                 running);
    Q_EMIT changed();
}

/// On the background thread.
Comparison::Pair Comparison::draw(Pair pair, const Settings& other, bool withHeat, const std::stop_token& stop)
{
    if (!pair.a) {
        const auto a = std::make_shared<RenderedFrame>();
        a->scene = pair.b->scene;
        a->settings = other;
        a->frame.tiled = std::exchange(m_context, nullptr);
        render(*a->scene, other, a->frame, {}, stop);
        m_context = std::exchange(a->frame.tiled, nullptr);
        if (isLarge(other))
            m_context.reset(); // small pictures are not to pay for it
        pair.a = a;
    }
    if (stop.stop_requested())
        return pair;
    pair.difference = rasterlens::difference(pair.a->frame.image, pair.b->frame.image);
    if (withHeat) {
        const auto heat = std::make_shared<RenderedFrame>();
        heat->scene = pair.b->scene;
        heat->settings = pair.b->settings;
        heat->frame.image = heatMap(pair.a->frame.image, pair.b->frame.image, pair.amplification);
        pair.heat = heat;
    }
    return pair;
}

void Comparison::take(const Pair& pair)
{
    m_pair = pair;
    m_difference = pair.difference;
    Q_EMIT changed();
    Q_EMIT frameChanged();
}

void Comparison::refuse(std::function<QString()> why)
{
    drop();
    m_refusal = std::move(why);
    Q_EMIT changed();
    Q_EMIT frameChanged();
}

FramePtr Comparison::frame() const
{
    switch (m_view) {
    case CompareView::Off: return nullptr;
    case CompareView::Wipe: return m_pair.b;
    case CompareView::Blink: return m_showsA ? m_pair.a : m_pair.b;
    case CompareView::Difference: return m_pair.heat;
    }
    return nullptr;
}

FramePtr Comparison::wiped() const { return m_view == CompareView::Wipe ? m_pair.a : nullptr; }

QString Comparison::tag() const
{
    if (m_view != CompareView::Blink || !m_pair.a)
        return {};
    return m_showsA ? QStringLiteral("A") : QStringLiteral("B");
}

bool Comparison::hasAmounts() const
{
    switch (m_pair.b ? m_pair.b->settings.shading : m_document.settings().shading) {
    case Shading::Gouraud:
    case Shading::Flat:
    case Shading::Texture:
    case Shading::Phong: return true;
    case Shading::RandomFlat:
    case Shading::Depth:
    case Shading::Normals:
    case Shading::Uv:
    case Shading::Overdraw:
    case Shading::TriangleId:
    case Shading::MipLevel: break;
    }
    return false;
}

QString Comparison::text() const
{
    if (m_refusal)
        return m_refusal();
    if (!m_difference)
        return tr("drawing A \u2026");
    const QString all = grouped(m_difference->pixels);
    if (m_difference->differing == 0)
        return tr("A and B are the same in all %1 pixels").arg(all);
    if (!hasAmounts())
        return tr("%1 of %2 pixels differ").arg(grouped(m_difference->differing), all);
    return tr("%1 of %2 pixels differ, by at most %3 of 255 steps \u00b7 PSNR %4 dB")
        .arg(grouped(m_difference->differing), all)
        .arg(m_difference->max)
        .arg(m_difference->psnrDb, 0, 'f', 1);
}

std::optional<ComparedPixel> Comparison::at(QPoint pixel) const
{
    if (!m_pair.a || !m_pair.a->frame.image.rect().contains(pixel))
        return std::nullopt;
    return ComparedPixel{m_pair.a->frame.image.pixel(pixel), m_pair.b->frame.image.pixel(pixel)};
}

std::vector<Comparison::SettingsDifference> Comparison::settingsDifferences() const
{
    const Settings& b = m_document.settings();
    const Settings a = other(b);
    std::vector<SettingsDifference> differences;
    if (a.mistakes != b.mistakes)
        differences.push_back({tr("Mistakes"), mistakesText(a), mistakesText(b)});
    if (a.light != b.light)
        differences.push_back({tr("Towards the light"), lightText(a.light), lightText(b.light)});
    for (const NumbersField& field : numbersFields())
        if (!isEqual(field, a, b))
            differences.push_back(
                {QCoreApplication::translate("Settings", field.title), valueText(field, a), valueText(field, b)});
    for (const SettingsField& field : settingsFields())
        if (field.get(a) != field.get(b))
            differences.push_back(
                {QCoreApplication::translate("Settings", field.title), valueTitle(field, a), valueTitle(field, b)});
    return differences;
}

} // namespace rasterlens
