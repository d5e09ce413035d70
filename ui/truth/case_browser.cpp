#include "ui/truth/case_browser.h"

#include "ui/base/case_note.h"
#include "ui/base/flow_layout.h"
#include "ui/base/inks.h"
#include "ui/base/parts.h"
#include "ui/base/theme.h"
#include "ui/base/turning.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMouseEvent>
#include <QPainter>
#include <QProgressBar>
#include <QScrollArea>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <algorithm>

namespace rasterlens
{
namespace
{

constexpr int kThumbnail = 72;
constexpr int kPadding = 6;
constexpr int kDetailWidth = 250;

QSize cellSize()
{
    const QFontMetrics metrics(textFont(-1));
    return {kThumbnail + 4 * kPadding + 5 * (metrics.horizontalAdvance(QStringLiteral("f32")) + 10),
            std::max(kThumbnail + 2 * kPadding, 5 * metrics.lineSpacing())};
}

QString gradeGlyph(CaseGrade grade)
{
    switch (grade) {
    case CaseGrade::Passes: return QStringLiteral("\u2713");
    case CaseGrade::PassesWithin: return QStringLiteral("\u2248");
    case CaseGrade::Fails: return QStringLiteral("\u2717");
    case CaseGrade::Unsupported: return QStringLiteral("\u2013");
    }
    return {};
}

} // namespace

/// Lists the cases whose name, note or expectations hold the words, and only the failing ones where asked.
class CaseBrowser::Filter : public QSortFilterProxyModel
{
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    void setWords(const QString& text)
    {
        m_words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
        invalidateFilter();
    }
    void setFailing(bool on)
    {
        m_failing = on;
        invalidateFilter();
    }

protected:
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex&) const override
    {
        const CaseModel::Case& one = static_cast<CaseModel*>(sourceModel())->at(row);
        if (m_failing && !one.fails())
            return false;
        return std::ranges::all_of(m_words, [&](const QString& word) {
            const QString all = one.name + caseTitle(one.name) + one.note + one.noteText() + one.expectationsText();
            return all.contains(word, Qt::CaseInsensitive);
        });
    }

private:
    QStringList m_words;
    bool m_failing = false;
};

/// Thumbnail, name and the variants' signs.
class CaseBrowser::Delegate : public QStyledItemDelegate
{
public:
    Delegate(const Filter& filter, const CaseModel& model, QObject* parent)
        : QStyledItemDelegate(parent), m_filter(filter), m_model(model)
    {
    }

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return cellSize(); }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const CaseModel::Case& one = m_model.at(m_filter.mapToSource(index).row());
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        const QRectF card = QRectF(option.rect).adjusted(2, 2, -2, -2);
        const bool chosen = option.state & QStyle::State_Selected;
        const bool hovered = option.state & QStyle::State_MouseOver;
        painter->setPen(QPen(option.palette.color(chosen ? QPalette::Highlight : QPalette::Mid), chosen ? 2 : 1));
        painter->setBrush(option.palette.color(hovered ? QPalette::AlternateBase : QPalette::Base));
        painter->drawRoundedRect(card, 6, 6);

        const QRectF place(card.left() + kPadding, card.top() + kPadding - 1, kThumbnail - 2, kThumbnail - 2);
        if (one.thumbnail.isNull()) {
            painter->fillRect(place, option.palette.color(QPalette::Window));
        } else {
            const QSizeF size = one.thumbnail.size().scaled(place.size().toSize(), Qt::KeepAspectRatio);
            painter->fillRect(place, Qt::black);
            painter->drawImage(QRectF(place.center() - QPointF(size.width(), size.height()) / 2, size), one.thumbnail);
        }

        const QFontMetrics metrics(textFont(-1));
        const QRect words = QRectF(place.right() + kPadding, place.top(), card.right() - place.right() - 2 * kPadding,
                                   3 * metrics.lineSpacing())
                                .toRect();
        painter->setFont(textFont(-1, true));
        painter->setPen(option.palette.color(QPalette::Text));
        painter->drawText(words, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, caseTitle(one.name));
        for (std::size_t i = 0; i < CaseModel::kVariants.size(); ++i)
            paintSign(*painter, signBox(option.rect, i), option.palette, one, i);
        painter->restore();
    }

private:
    static void paintSign(QPainter& painter, const QRect& box, const QPalette& palette, const CaseModel::Case& one,
                          std::size_t variant)
    {
        const int half = box.height() / 2;
        const QRect above(box.left(), box.top(), box.width(), half);
        const QRect below(box.left(), box.top() + half, box.width(), half);
        painter.setFont(textFont(-1.5));
        painter.setPen(palette.color(QPalette::PlaceholderText));
        painter.drawText(above, Qt::AlignCenter, CaseModel::variantSign(variant));
        if (variant >= one.verdicts.size()) {
            painter.drawText(below, Qt::AlignCenter, QStringLiteral("\u2026"));
            return;
        }
        const CaseGrade grade = one.verdicts[variant].grade;
        const Inks inks = inksFor(palette);
        if (grade == CaseGrade::Fails) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(inks.minus);
            painter.drawRoundedRect(below.adjusted(1, 0, -1, 0), 4, 4);
            painter.setPen(palette.color(QPalette::Base));
        } else {
            painter.setPen(grade == CaseGrade::Unsupported ? palette.color(QPalette::PlaceholderText) : inks.plus);
        }
        painter.setFont(textFont(0, true));
        painter.drawText(below, Qt::AlignCenter, gradeGlyph(grade));
    }

    const Filter& m_filter;
    const CaseModel& m_model;
};

CaseBrowser::CaseBrowser(QWidget* parent)
    : QWidget(parent), m_model(new CaseModel(this)), m_filtered(new Filter(this)), m_filter(new QLineEdit),
      m_failing(new QCheckBox), m_state(new QLabel), m_progress(new QProgressBar), m_list(new QListView),
      m_detail(new QLabel)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 2, 12, 8);
    column->setSpacing(4);
    column->addLayout(buildHead());
    column->addLayout(buildCases(), 1);

    connect(m_filter, &QLineEdit::textChanged, this, [this](const QString& text) {
        m_filtered->setWords(text);
        syncState();
    });
    connect(m_failing, &QCheckBox::toggled, this, [this](bool on) {
        m_filtered->setFailing(on);
        syncState();
    });
    connect(m_model, &CaseModel::progressed, this, &CaseBrowser::syncState);
    connect(m_list, &QListView::activated, this, [this](const QModelIndex& index) { choose(index, {}); });
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this, &CaseBrowser::describe);
    retranslate();
}

/// What chooses among the cases, and how far they are judged.
QLayout* CaseBrowser::buildHead()
{
    auto* head = new FlowLayout(10);
    m_filter->setClearButtonEnabled(true);
    m_filter->setMaximumWidth(280);
    m_progress->setTextVisible(false);
    m_progress->setFixedSize(90, 8);
    m_progress->setRange(0, m_model->rowCount());
    m_state->setObjectName(QStringLiteral("muted"));
    head->addWidget(m_filter);
    head->addWidget(m_failing);
    head->addWidget(m_state);
    head->addWidget(m_progress);
    return head;
}

/// The list of cases and, beside it or below it, what is known of the chosen one.
QLayout* CaseBrowser::buildCases()
{
    m_filtered->setSourceModel(m_model);
    m_list->setModel(m_filtered);
    m_list->setItemDelegate(new Delegate(*m_filtered, *m_model, this));
    m_list->setViewMode(QListView::IconMode);
    m_list->setMovement(QListView::Static);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setUniformItemSizes(true);
    m_list->setMouseTracking(true);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setMinimumSize(cellSize() + QSize(20, 0));
    m_list->viewport()->installEventFilter(this);
    m_detail->setWordWrap(true);
    m_detail->setTextFormat(Qt::RichText);
    m_detail->setAlignment(Qt::AlignTop);
    m_detail->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_detail->setObjectName(QStringLiteral("panelContent"));
    QScrollArea* scroll = makePanelScroll();
    scroll->setFocusPolicy(Qt::StrongFocus); // keys scroll: nothing inside takes them
    scroll->setFixedWidth(kDetailWidth);
    scroll->setWidget(m_detail);

    auto* row = new QHBoxLayout;
    row->addWidget(m_list, 1);
    row->addWidget(scroll);
    constexpr int kBeside = 620;
    new Turning(this, kBeside, [row, scroll](bool beside) {
        row->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
        scroll->setMinimumWidth(beside ? kDetailWidth : 0);
        scroll->setMaximumWidth(beside ? kDetailWidth : QWIDGETSIZE_MAX);
    });
    return row;
}

int CaseBrowser::listed() const { return m_filtered->rowCount(); }

QRect CaseBrowser::signBox(const QRect& cell, std::size_t variant)
{
    const QFontMetrics metrics(textFont(-1));
    const int left = cell.left() + kThumbnail + 2 * kPadding;
    const int width = (cell.right() - kPadding - left) / static_cast<int>(CaseModel::kVariants.size());
    const int height = 2 * metrics.height();
    return {left + static_cast<int>(variant) * width, cell.bottom() - height - kPadding + 2, width, height};
}

bool CaseBrowser::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_list->viewport() && event->type() == QEvent::MouseButtonRelease) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        const QModelIndex index = m_list->indexAt(mouse->position().toPoint());
        if (mouse->button() == Qt::LeftButton && index.isValid())
            choose(index, mouse->position().toPoint());
    }
    return QWidget::eventFilter(watched, event);
}

void CaseBrowser::choose(const QModelIndex& listed, QPoint at)
{
    std::size_t variant = 0;
    for (std::size_t i = 0; i < CaseModel::kVariants.size(); ++i)
        if (signBox(m_list->visualRect(listed), i).contains(at))
            variant = i;
    const CaseModel::Case& one = m_model->at(m_filtered->mapToSource(listed).row());
    if (variant < one.verdicts.size() && one.verdicts[variant].grade == CaseGrade::Unsupported)
        variant = 0;
    Q_EMIT caseChosen(one.name, QString::fromLatin1(CaseModel::kVariants[variant].id));
}

QString CaseBrowser::reasonText(const CaseModel::Case& one) const
{
    QString text;
    for (std::size_t i = 0; i < one.verdicts.size(); ++i) {
        const CaseModel::Verdict& verdict = one.verdicts[i];
        text +=
            QStringLiteral("<p><b>%1 %2</b> %3")
                .arg(gradeGlyph(verdict.grade), CaseModel::variantSign(i), CaseModel::variantTitle(i).toHtmlEscaped());
        if (!verdict.reasons.empty())
            text += QStringLiteral("<br/>") + one.reasonText(i).toHtmlEscaped();
        text += QStringLiteral("</p>");
    }
    return text;
}

void CaseBrowser::describe(const QModelIndex& listed)
{
    if (!listed.isValid()) {
        m_detail->setText(
            tr("A click opens a case in the lens, with its wrong pixels glowing; a click on a sign opens it "
               "with that variant."));
        return;
    }
    const CaseModel::Case& one = m_model->at(m_filtered->mapToSource(listed).row());
    const auto lines = [](const QString& text) {
        return text.toHtmlEscaped().replace(QLatin1Char('\n'), QStringLiteral("<br/>"));
    };
    m_detail->setText(QStringLiteral("<p><b>%1</b></p><p>%2</p><p><b>%3</b><br/>%4</p>%5")
                          .arg(caseTitle(one.name).toHtmlEscaped(), lines(one.noteText()), tr("What must hold:"),
                               lines(one.expectationsText()), reasonText(one)));
}

void CaseBrowser::syncState()
{
    int failing = 0;
    for (int i = 0; i < m_model->judged(); ++i)
        failing += m_model->at(i).fails();
    const int all = m_model->rowCount();
    m_state->setText(m_model->isBusy()
                         ? tr("%1 of %2 drawn, in %3 a variant fails").arg(m_model->judged()).arg(all).arg(failing)
                         : tr("%1 of %2 cases listed, in %3 a variant fails").arg(listed()).arg(all).arg(failing));
    m_progress->setValue(m_model->judged());
    m_progress->setVisible(m_model->isBusy());
    if (m_list->currentIndex().isValid())
        describe(m_list->currentIndex());
}

void CaseBrowser::retranslate()
{
    m_filter->setPlaceholderText(tr("Filter by name, note or expectation"));
    m_filter->setAccessibleName(m_filter->placeholderText());
    m_failing->setText(tr("Only where a variant fails"));
    QStringList signs;
    for (std::size_t i = 0; i < CaseModel::kVariants.size(); ++i)
        signs << QStringLiteral("<b>%1</b> %2")
                     .arg(CaseModel::variantSign(i), CaseModel::variantTitle(i).toHtmlEscaped());
    signs << tr("\u2713 passes, \u2248 passes within what snapping or the depth format can tell, \u2717 fails, \u2013 "
                "cannot be drawn");
    m_list->setToolTip(QStringLiteral("<p>%1</p>").arg(signs.join(QStringLiteral("<br/>"))));
    m_list->setAccessibleName(tr("Hard cases"));
    describe(m_list->currentIndex());
    syncState();
}

void CaseBrowser::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_model->start();
    syncState();
}

void CaseBrowser::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::FontChange)
        m_list->setMinimumSize(cellSize() + QSize(20, 0));
}

} // namespace rasterlens
