#include "ui/face/clip_theatre.h"

#include "ui/base/field_row.h"
#include "ui/base/flow_layout.h"
#include "ui/base/inks.h"
#include "ui/base/named_places.h"
#include "ui/base/theme.h"
#include "ui/base/turning.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr double kCornerRadius = 3.5;
constexpr double kFarthestNdc = 100; ///< what lies farther off the screen is left out of the picture
QString brief(double value)
{
    constexpr int kDigits = 4;
    return QString::number(value, 'g', kDigits).replace(QLatin1Char('-'), QChar(0x2212));
}

/// The name the canvas gives it; a corner whose place is not a number has its index.
QString cornerName(const ClipVertex& corner, const ClipStory& story, std::size_t index)
{
    const auto named = std::ranges::find(story.named, corner.positionClip, &MomentCorner::positionClip);
    return named == story.named.end() ? QString::number(index) : named->name;
}

} // namespace

/// One of the two pictures: a coordinate against w, or the screen in NDC.
class ClipTheatre::Stage : public QWidget
{
public:
    Stage(ClipTheatre& theatre, View view) : m_theatre(theatre), m_view(view) { setMinimumSize(150, 170); }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        m_inks = inksFor(palette());
        const double line = QFontMetricsF(textFont(-1)).lineSpacing();
        m_area = QRectF(rect()).adjusted(2, line + 3, -2, -2);
        painter.setFont(textFont(-1));
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect(), Qt::AlignLeft | Qt::AlignTop, caption());
        painter.setClipRect(m_area);
        painter.fillRect(m_area, palette().color(QPalette::Window));
        if (m_view == View::ClipSpace)
            paintClipSpace(painter);
        else
            paintScreen(painter);
    }

private:
    [[nodiscard]] int axis() const { return m_theatre.m_axis->currentIndex(); }

    [[nodiscard]] QString caption() const
    {
        if (m_view == View::ClipSpace)
            return ClipTheatre::tr("clip space: %1 across, w up").arg(QLatin1Char("xyz"[axis()]));
        return m_theatre.m_story && m_theatre.m_story->rules.clipping == Clipping::CohenSutherland
                   ? ClipTheatre::tr("the nine regions: above, below, right, left")
                   : ClipTheatre::tr("the screen after the divide, and the fan");
    }

    [[nodiscard]] QPointF flat(const ClipVertex& corner) const
    {
        const glm::dvec4& p = corner.positionClip;
        return m_view == View::ClipSpace ? QPointF(p[axis()], p.w) : QPointF(p.x / p.w, p.y / p.w);
    }

    [[nodiscard]] QPointF place(QPointF value) const
    {
        return {m_area.center().x() + (value.x() - m_middle.x()) * m_scale,
                m_area.center().y() - (value.y() - m_middle.y()) * m_scale};
    }

    /// Chooses the scale so that the triangle and the volume both are in sight.
    void frame(QRectF shown)
    {
        constexpr double kLargest = 1e6;
        if (m_theatre.m_story)
            for (const ClipVertex& corner : m_theatre.m_story->corners) {
                const QPointF at = flat(corner);
                if (!std::isfinite(at.x()) || !std::isfinite(at.y()) ||
                    (m_view == View::Screen && corner.positionClip.w <= 0))
                    continue;
                const QPointF held(std::clamp(at.x(), -kLargest, kLargest), std::clamp(at.y(), -kLargest, kLargest));
                shown.setLeft(std::min(shown.left(), held.x()));
                shown.setRight(std::max(shown.right(), held.x()));
                shown.setTop(std::min(shown.top(), held.y()));
                shown.setBottom(std::max(shown.bottom(), held.y()));
            }
        if (m_view == View::Screen) { // a far corner is not to shrink the screen to a dot
            constexpr double kFarthest = 4;
            shown = shown.intersected(QRectF(-kFarthest, -kFarthest, 2 * kFarthest, 2 * kFarthest));
        }
        constexpr double kRoom = 1.2;
        m_middle = shown.center();
        m_scale = std::min(m_area.width() / (shown.width() * kRoom), m_area.height() / (shown.height() * kRoom));
    }

    void paintClipSpace(QPainter& painter)
    {
        frame(QRectF(-1, 0, 2, 1));
        // The view volume: |x| <= w.
        const double far =
            (m_area.height() + m_area.width()) / m_scale + std::abs(m_middle.x()) + std::abs(m_middle.y());
        QColor inside = m_inks.plus;
        inside.setAlpha(28);
        painter.setPen(Qt::NoPen);
        painter.setBrush(inside);
        painter.drawPolygon(QPolygonF{place({0, 0}), place({far, far}), place({-far, far})});
        painter.setPen(QPen(m_inks.plus, 1.2));
        painter.drawLine(place({0, 0}), place({far, far}));
        painter.drawLine(place({0, 0}), place({-far, far}));
        painter.setPen(QPen(palette().color(QPalette::Mid), 1, Qt::DashLine));
        painter.drawLine(place({-far, 0}), place({far, 0}));
        painter.drawLine(place({0, -far}), place({0, far}));
        const QString name = QString(QLatin1Char("xyz"[axis()]));
        painter.setFont(textFont(-1));
        painter.setPen(m_inks.plus);
        const double reach = std::min((m_area.right() - place({0, 0}).x()), place({0, 0}).y() - m_area.top()) / m_scale;
        const double label = std::max(0.2, reach * 0.82);
        const QString plain = name + QStringLiteral(" = w");
        const QPointF beside = place({label, label}) + QPointF(6, 10);
        const double rightmost = m_area.right() - QFontMetricsF(painter.font()).horizontalAdvance(plain) - 2;
        painter.drawText(QPointF(std::min(beside.x(), rightmost), beside.y()), plain);
        const QPointF mirrored = place({-label, label}) + QPointF(-58, 10);
        painter.drawText(QPointF(std::max(mirrored.x(), m_area.left() + 3), mirrored.y()),
                         name + QStringLiteral(" = \u2212w"));
        paintPolygons(painter);
    }

    void paintScreen(QPainter& painter)
    {
        const bool regions = m_theatre.m_story && m_theatre.m_story->rules.clipping == Clipping::CohenSutherland;
        constexpr double kBeyond = 1.6; // of the outer regions, too, something is to be seen
        frame(regions ? QRectF(-kBeyond, -kBeyond, 2 * kBeyond, 2 * kBeyond) : QRectF(-1, -1, 2, 2));
        const QRectF screen(place({-1, 1}), place({1, -1}));
        QColor inside = m_inks.plus;
        inside.setAlpha(28);
        painter.setBrush(inside);
        painter.setPen(QPen(m_inks.plus, 1.5));
        painter.drawRect(screen);
        if (regions)
            paintRegions(painter, screen);
        paintPolygons(painter);
    }

    void paintRegions(QPainter& painter, const QRectF& screen)
    {
        painter.setPen(QPen(palette().color(QPalette::Mid), 1, Qt::DashLine));
        for (const double x : {screen.left(), screen.right()})
            painter.drawLine(QPointF(x, m_area.top()), QPointF(x, m_area.bottom()));
        for (const double y : {screen.top(), screen.bottom()})
            painter.drawLine(QPointF(m_area.left(), y), QPointF(m_area.right(), y));
        painter.setFont(numberFont(-0.5));
        painter.setPen(palette().color(QPalette::PlaceholderText));
        const double xs[] = {m_area.left(), screen.left(), screen.right(), m_area.right()};
        const double ys[] = {m_area.top(), screen.top(), screen.bottom(), m_area.bottom()};
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row) {
                const unsigned code = (column == 0   ? kRegionLeft
                                       : column == 2 ? kRegionRight
                                                     : 0) |
                                      (row == 0   ? kRegionAbove
                                       : row == 2 ? kRegionBelow
                                                  : 0);
                const QRectF cell(QPointF(xs[column], ys[row]), QPointF(xs[column + 1], ys[row + 1]));
                painter.drawText(cell.adjusted(3, 2, -3, -2), Qt::AlignLeft | Qt::AlignTop, regionText(code));
            }
    }

    /// What was there before the stage, dashed; what is left of it, filled; its corners with their names.
    void paintPolygons(QPainter& painter)
    {
        if (!m_theatre.m_story || m_theatre.m_story->corners.empty())
            return;
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(m_inks.minus, 1.3, Qt::DashLine));
        paintOutline(painter, m_theatre.before());
        const std::vector<ClipVertex>& left = m_theatre.after();
        QColor fill = palette().color(QPalette::Highlight);
        fill.setAlpha(56);
        painter.setBrush(fill);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        paintOutline(painter, left);
        if (m_view == View::Screen && left.size() > 3) {
            painter.setPen(QPen(palette().color(QPalette::Highlight), 1, Qt::DotLine));
            for (std::size_t i = 2; i + 1 < left.size(); ++i)
                painter.drawLine(place(flat(left[0])), place(flat(left[i])));
        }
        m_names.clear();
        paintCorners(painter, gone(), m_inks.minus);
        paintCorners(painter, left, palette().color(QPalette::Text));
    }

    /// The corners that this stage cut off.
    [[nodiscard]] std::vector<ClipVertex> gone() const
    {
        const std::vector<ClipVertex>& left = m_theatre.after();
        std::vector<ClipVertex> gone;
        for (const ClipVertex& corner : m_theatre.before())
            if (std::ranges::find(left, corner.positionClip, &ClipVertex::positionClip) == left.end() &&
                (m_view == View::ClipSpace || corner.positionClip.w > 0) && std::abs(flat(corner).x()) < kFarthestNdc)
                gone.push_back(corner);
        return gone;
    }

    void paintOutline(QPainter& painter, const std::vector<ClipVertex>& polygon)
    {
        QPolygonF outline;
        for (const ClipVertex& corner : polygon) {
            const QPointF at = flat(corner);
            if (m_view == View::Screen && (corner.positionClip.w <= 0 || std::hypot(at.x(), at.y()) > kFarthestNdc))
                return; // has no place on the screen, or none worth drawing to
            outline << place(at);
        }
        painter.drawPolygon(outline);
    }

    /// Where a name is written: outward of its corner, or in another direction where another name stands there.
    [[nodiscard]] QRectF freeBox(QPointF corner, QPointF away, QSizeF size) const
    {
        const auto boxAt = [&](QPointF centre) {
            QRectF box(QPointF(0, 0), size);
            box.moveCenter(centre);
            box.moveLeft(std::clamp(box.left(), m_area.left(), m_area.right() - box.width()));
            box.moveTop(std::clamp(box.top(), m_area.top(), m_area.bottom() - box.height()));
            return box;
        };
        const QRectF outward = boxAt(corner + away);
        const QPointF across(size.width() / 2 + 12, 0);
        const QPointF along(0, size.height());
        for (const QPointF& way : {away, along, -along, across, -across}) {
            const QRectF box = boxAt(corner + way);
            if (std::ranges::none_of(m_names, [&](const QRectF& name) { return name.intersects(box); }))
                return box;
        }
        return outward;
    }

    void paintCorners(QPainter& painter, const std::vector<ClipVertex>& polygon, const QColor& ink)
    {
        const std::vector<ClipVertex>& left = m_theatre.after();
        QPointF middle(0, 0);
        for (const ClipVertex& corner : left)
            middle += place(flat(corner)) / static_cast<double>(left.size());
        painter.setFont(textFont(-0.5, true));
        const QFontMetricsF metrics(painter.font());
        painter.setBrush(palette().color(QPalette::Base));
        painter.setPen(QPen(ink, 1.5));
        std::vector<NamedPlace> names;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const QPointF at = place(flat(polygon[i]));
            if (!m_area.adjusted(-kCornerRadius, -kCornerRadius, kCornerRadius, kCornerRadius).contains(at))
                continue;
            painter.drawEllipse(at, kCornerRadius, kCornerRadius);
            names.push_back({at, cornerName(polygon[i], *m_theatre.m_story, i)});
        }
        for (const NamedPlace& corner : joinedPlaces(names, kCornerRadius)) {
            QPointF away = corner.at - middle;
            const double length = std::hypot(away.x(), away.y());
            away = length > 1 ? away / length * 12 : QPointF(0, -12);
            const QSizeF size(metrics.horizontalAdvance(corner.name) + 2, metrics.height());
            const QRectF box = freeBox(corner.at, away, size);
            m_names.push_back(box);
            painter.drawText(box, Qt::AlignCenter, corner.name);
        }
    }

    ClipTheatre& m_theatre;
    View m_view;
    Inks m_inks;
    QRectF m_area;
    QPointF m_middle;
    double m_scale = 1;
    std::vector<QRectF> m_names; ///< where names of corners stand
};

ClipTheatre::ClipTheatre(FaceSelection& selection, QWidget* parent)
    : QWidget(parent), m_start(new QToolButton), m_sides(new QToolButton), m_axis(new PanelCombo),
      m_summary(new QLabel),
      m_cuts(new QLabel), m_stages{new Stage(*this, View::ClipSpace), new Stage(*this, View::Screen)}
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 2, 12, 8);
    column->setSpacing(6);
    auto* head = new FlowLayout(5);
    head->addWidget(new FacePicker(selection));
    const auto addButton = [&](QToolButton* tool) {
        tool->setObjectName(QStringLiteral("flat"));
        tool->setCheckable(true);
        tool->setCursor(Qt::PointingHandCursor);
        head->addWidget(tool);
    };
    addButton(m_start);
    connect(m_start, &QToolButton::clicked, this, [this] { setStage(0); });
    for (int i = 0; i < kClipPlanes; ++i) {
        auto* tool = new QToolButton;
        addButton(tool);
        m_planes[static_cast<std::size_t>(i)] = tool;
        connect(tool, &QToolButton::clicked, this, [this, i] {
            for (std::size_t s = 0; m_story && s < m_story->steps.size(); ++s)
                if (m_story->steps[s].plane == static_cast<ClipPlane>(i))
                    setStage(s + 1);
            sync();
        });
    }
    addButton(m_sides);
    connect(m_sides, &QToolButton::clicked, this, [this] { setStage(m_story ? m_story->steps.size() + 1 : 0); });
    m_axis->addItems({QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")});
    m_axis->setMinimumWidth(52);
    connect(m_axis, &QComboBox::currentIndexChanged, this, [this] { m_stages[0]->update(); });
    head->addWidget(m_axis);
    column->addLayout(head);

    auto* scene = new QHBoxLayout;
    scene->setSpacing(12);
    scene->addWidget(m_stages[0], 4);
    auto* texts = new QVBoxLayout;
    m_summary->setObjectName(QStringLiteral("heading"));
    m_summary->setWordWrap(true);
    m_cuts->setObjectName(QStringLiteral("numbers"));
    m_cuts->setWordWrap(true);
    m_cuts->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_cuts->setTextInteractionFlags(Qt::TextSelectableByMouse);
    texts->addWidget(m_summary);
    texts->addWidget(m_cuts, 1);
    scene->addLayout(texts, 3);
    scene->addWidget(m_stages[1], 4);
    column->addLayout(scene, 1);
    constexpr int kBeside = 560;
    new Turning(this, kBeside, [scene](bool beside) {
        scene->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    });
    retranslate();
}

void ClipTheatre::setStory(std::shared_ptr<const ClipStory> story)
{
    m_story = std::move(story);
    m_stage = m_story ? usualStage() : 0;
    showAxisOfStage();
    sync();
}

void ClipTheatre::followStep(std::optional<StepKind> kind, std::optional<ClipPlane> plane)
{
    m_followed = kind;
    m_followedPlane = plane;
    if (m_story && kind)
        setStage(usualStage());
    else
        sync();
}

/// That of the step which is followed, or else of the last plane that did something.
std::size_t ClipTheatre::usualStage() const
{
    const auto& steps = m_story->steps;
    if (m_followed == StepKind::Vertex)
        return 0;
    const auto step = std::ranges::find_if(steps, [this](const ClipStep& one) { return one.plane == m_followedPlane; });
    if (step != steps.end())
        return static_cast<std::size_t>(step - steps.begin()) + 1;
    std::size_t stage = steps.size() + (m_story->regions ? 1 : 0);
    while (stage > 1 && stage <= steps.size() && steps[stage - 1].cuts.empty())
        --stage;
    return stage;
}

void ClipTheatre::setStage(std::size_t stage)
{
    if (!m_story)
        return;
    m_stage = std::min(stage, m_story->steps.size() + (m_story->regions ? 1 : 0));
    showAxisOfStage();
    sync();
}

/// The coordinate that is cut by is the one to look at.
void ClipTheatre::showAxisOfStage()
{
    if (!m_story || m_stage == 0 || m_stage > m_story->steps.size())
        return;
    const int plane = static_cast<int>(m_story->steps[m_stage - 1].plane);
    if (plane > 0)
        m_axis->setCurrentIndex((plane - 1) / 2);
}

const std::vector<ClipVertex>& ClipTheatre::before() const
{
    if (m_stage == 0)
        return m_story->corners;
    return m_stage <= m_story->steps.size() ? m_story->steps[m_stage - 1].before : m_story->regions->before;
}

const std::vector<ClipVertex>& ClipTheatre::after() const
{
    if (m_stage == 0)
        return m_story->corners;
    return m_stage <= m_story->steps.size() ? m_story->steps[m_stage - 1].after : m_story->regions->after;
}

QString ClipTheatre::summary() const
{
    if (!m_story || m_story->corners.empty())
        return tr("no face");
    if (m_story->fate == FaceFate::NonFinite)
        return tr("a corner is not a finite number");
    if (m_story->steps.empty() && !m_story->regions) {
        if (m_story->fate == FaceFate::Rejected)
            return tr("rejected whole: no plane had to cut");
        return m_story->outsideOf == 0 ? tr("wholly inside: no plane cuts")
                                       : tr("kept whole: no plane of the mode cuts");
    }
    QStringList counts;
    for (const int count : m_story->counts())
        if (isTold(static_cast<std::size_t>(counts.size())))
            counts << QString::number(count);
    const bool isWhole = counts.size() == std::ssize(m_story->counts());
    if (!isWhole)
        counts << QStringLiteral("\u2026");
    const QString path = counts.join(QStringLiteral(" \u2192 "));
    if (!isWhole)
        return tr("%1 corners").arg(path);
    return m_story->fate == FaceFate::Rejected ? tr("%1 corners: nothing is left").arg(path)
                                               : tr("%1 corners, a fan of %2").arg(path).arg(m_story->pieces);
}

QStringList ClipTheatre::cuts() const
{
    QStringList lines;
    if (!m_story || m_story->corners.empty())
        return lines;
    if (m_stage == 0) {
        for (std::size_t i = 0; i < m_story->corners.size(); ++i) {
            const glm::dvec4& p = m_story->corners[i].positionClip;
            lines << QStringLiteral("%1  %2, %3, %4, w %5")
                         .arg(QLatin1Char(static_cast<char>('A' + static_cast<char>(i))))
                         .arg(brief(p.x), brief(p.y), brief(p.z), brief(p.w));
        }
        return lines;
    }
    if (m_stage > m_story->steps.size()) {
        for (std::size_t i = 0; i < m_story->regions->before.size(); ++i)
            lines << tr("%1  outcode %2")
                         .arg(cornerName(m_story->regions->before[i], *m_story, i),
                              regionText(m_story->regions->regions[i]));
        return lines;
    }
    const ClipStep& step = m_story->steps[m_stage - 1];
    for (const ClipCut& cut : step.cuts) {
        const auto name = [&](int corner) {
            const auto index = static_cast<std::size_t>(corner);
            return cornerName(step.before[index], *m_story, index);
        };
        QString line = QStringLiteral("%1 \u2192 %2  t = %3")
                           .arg(name(cut.inside), name(cut.outside), QString::number(cut.t, 'f', 4));
        if (cut.corner >= 0) {
            const auto index = static_cast<std::size_t>(cut.corner);
            const glm::dvec4& p = step.after[index].positionClip;
            line += QStringLiteral("\n    %1 (%2, %3, %4, %5)")
                        .arg(cornerName(step.after[index], *m_story, index), brief(p.x), brief(p.y), brief(p.z),
                             brief(p.w));
        }
        lines << line;
    }
    if (lines.isEmpty())
        lines << tr("all corners are inside: nothing to cut here");
    return lines;
}

void ClipTheatre::sync()
{
    m_start->setChecked(m_stage == 0);
    for (int i = 0; i < kClipPlanes; ++i) {
        const auto plane = static_cast<ClipPlane>(i);
        QToolButton* tool = m_planes[static_cast<std::size_t>(i)];
        const ClipStep* step = m_story ? m_story->stepOf(plane) : nullptr;
        const bool isKnown = step && isTold(static_cast<std::size_t>(step - m_story->steps.data()) + 1);
        tool->setEnabled(step != nullptr);
        const QString sign = QString::fromUtf8(infoOf(plane).sign);
        tool->setText(isKnown ? QStringLiteral("%1  %2").arg(sign).arg(step->after.size()) : sign);
        const bool shown =
            m_stage > 0 && m_stage <= m_story->steps.size() && m_story->steps[m_stage - 1].plane == plane;
        tool->setChecked(shown);
        const QString formula = clipPlaneFormula(plane, m_story ? m_story->rules : Rules());
        tool->setToolTip(isKnown ? tr("Plane %1: %2 corners before, %3 after")
                                       .arg(formula)
                                       .arg(step->before.size())
                                       .arg(step->after.size())
                         : step ? tr("Plane %1: its turn comes later; a click shows it").arg(formula)
                                : tr("Plane %1 does not cut this face").arg(formula));
    }
    m_sides->setVisible(m_story && m_story->rules.clipping == Clipping::CohenSutherland);
    m_sides->setEnabled(m_story && m_story->regions);
    m_sides->setChecked(m_story && m_stage > m_story->steps.size());
    m_summary->setText(summary());
    m_cuts->setText(cuts().join(QLatin1Char('\n')));
    for (Stage* stage : m_stages)
        stage->update();
}

void ClipTheatre::retranslate()
{
    m_start->setText(tr("before"));
    m_start->setToolTip(tr("The triangle before any plane"));
    m_sides->setText(tr("sides"));
    m_sides->setToolTip(tr("The four sides of the screen, edge by edge"));
    m_axis->setToolTip(tr("The coordinate that is drawn against w"));
    sync();
}

void ClipTheatre::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace rasterlens
