#include "ui/pipeline/mistakes_section.h"

#include "ui/base/language.h"
#include "ui/base/parts.h"

#include <QAction>
#include <QCheckBox>
#include <QCoreApplication>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace rasterlens
{
namespace
{

QString translated(const char* text) { return QCoreApplication::translate("Mistake", text); }

} // namespace

Settings withMistake(const Settings& settings, const QString& id, bool on)
{
    Settings next = settings;
    next.mistakes.removeAll(id);
    if (on)
        next.mistakes << id;
    return next;
}

QString mistakeTitle(const Mistake& mistake)
{
    return QStringLiteral("%1  %2").arg(QLatin1String(mistake.number), translated(mistake.title));
}

QString mistakeToolTip(const Mistake& mistake, const Language& language)
{
    const auto paragraph = [](const QString& heading, const QString& text) {
        return QStringLiteral("<p><b>%1</b><br/>%2</p>").arg(heading, text);
    };
    return QStringLiteral("<p><b>%1</b><br/>%2</p>")
               .arg(mistakeTitle(mistake).toHtmlEscaped(), language.inOther("Mistake", mistake.title).toHtmlEscaped()) +
           paragraph(MistakesSection::tr("The wrong line"),
                     QStringLiteral("<code>%1</code>").arg(QString::fromUtf8(mistake.wrongLine).toHtmlEscaped())) +
           paragraph(MistakesSection::tr("What one sees"), translated(mistake.symptom).toHtmlEscaped()) +
           paragraph(MistakesSection::tr("Why people write it"), translated(mistake.seed).toHtmlEscaped());
}

MistakesSection::MistakesSection(Document& document, const Language& language, QWidget* parent)
    : QWidget(parent), m_document(document), m_language(language)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 2, 4, 0);
    column->setSpacing(3);
    auto* header = new QHBoxLayout;
    header->setSpacing(4);
    m_heading = new QToolButton;
    m_heading->setObjectName(QStringLiteral("fold"));
    m_heading->setCheckable(true);
    m_heading->setArrowType(Qt::RightArrow);
    m_heading->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_heading->setCursor(Qt::PointingHandCursor);
    connect(m_heading, &QToolButton::toggled, this, &MistakesSection::setOpen);
    m_clear = makeLink();
    QSizePolicy keepsItsPlace = m_clear->sizePolicy();
    keepsItsPlace.setRetainSizeWhenHidden(true); // the list below does not move under the mouse
    m_clear->setSizePolicy(keepsItsPlace);
    connect(m_clear, &QToolButton::clicked, this, [this] {
        Settings next = m_document.settings();
        next.mistakes.clear();
        m_document.setSettings(next);
    });
    m_key = new QLabel;
    m_key->setObjectName(QStringLiteral("keyHint"));
    header->addWidget(m_heading);
    header->addStretch(1);
    header->addWidget(m_clear);
    header->addWidget(m_key);
    header->addSpacing(14);
    column->addLayout(header);
    m_list = makePanelScroll();
    m_list->hide();
    column->addWidget(m_list, 1);
    connect(&document, &Document::settingsChanged, this, &MistakesSection::sync);
    retranslate();
}

void MistakesSection::makeRows()
{
    if (!m_rows.empty())
        return;
    QWidget* content = makePanelContent();
    auto* grid = new QGridLayout(content);
    grid->setContentsMargins(4, 0, 2, 4);
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(2, 1);
    int line = 0;
    for (const Mistake& mistake : mistakes()) {
        const QString id = QLatin1String(mistake.id);
        auto* box = new QCheckBox;
        connect(box, &QCheckBox::toggled, this,
                [this, id](bool on) { m_document.setSettings(withMistake(m_document.settings(), id, on)); });
        auto* number = new QLabel(QLatin1String(mistake.number));
        number->setObjectName(QStringLiteral("muted"));
        auto* title = new QLabel;
        title->setWordWrap(true);
        title->setBuddy(box);
        QSizePolicy narrow(QSizePolicy::Ignored, QSizePolicy::Preferred);
        narrow.setHeightForWidth(true);
        title->setSizePolicy(narrow);
        constexpr QMargins kToTheBox(0, 2, 0, 0);
        title->setContentsMargins(kToTheBox);
        number->setContentsMargins(kToTheBox);
        QToolButton* show = makeLink();
        connect(show, &QToolButton::clicked, this, [this, id] { m_document.openMistake(id); });
        grid->addWidget(box, line, 0, Qt::AlignTop);
        grid->addWidget(number, line, 1, Qt::AlignTop);
        grid->addWidget(title, line, 2, Qt::AlignTop);
        grid->addWidget(show, line, 3, Qt::AlignTop);
        ++line;
        m_rows.push_back({&mistake, box, title, show});
    }
    m_list->setWidget(content);
    retranslate();
}

void MistakesSection::setOpen(bool open)
{
    if (open)
        makeRows();
    const QSignalBlocker blocked(m_heading);
    m_heading->setChecked(open);
    m_heading->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    if (m_list->isHidden() == !open)
        return;
    m_list->setVisible(open);
    Q_EMIT opened(open);
}

bool MistakesSection::isOpen() const { return !m_list->isHidden(); }

void MistakesSection::setKeyHint(const QString& key) { m_key->setText(key); }

QCheckBox* MistakesSection::box(const QString& id)
{
    makeRows();
    const auto row = std::ranges::find_if(m_rows, [&](const Row& r) { return id == QLatin1String(r.mistake->id); });
    return row == m_rows.end() ? nullptr : row->box;
}

QString MistakesSection::heading() const { return m_heading->text(); }

void MistakesSection::sync()
{
    const QStringList& on = m_document.settings().mistakes;
    QStringList numbers;
    for (const QString& id : on)
        if (const Mistake* mistake = findMistake(id))
            numbers << QLatin1String(mistake->number);
    constexpr qsizetype kNamed = 4;
    const QString named = numbers.size() > kNamed ? QString::number(numbers.size()) : listed(numbers);
    m_heading->setText(numbers.isEmpty() ? tr("Mistakes: none") : tr("Mistakes: %1").arg(named));
    m_clear->setVisible(!numbers.isEmpty());
    for (const Row& row : m_rows) {
        const QSignalBlocker blocked(row.box);
        row.box->setChecked(on.contains(QLatin1String(row.mistake->id)));
    }
}

void MistakesSection::retranslate()
{
    m_heading->setToolTip(tr("Mistakes that people make in a rasterizer, to switch on and look at"));
    m_clear->setText(tr("none"));
    m_clear->setToolTip(tr("Switch all mistakes off"));
    for (const Row& row : m_rows) {
        row.title->setText(translated(row.mistake->title));
        const QString tip = mistakeToolTip(*row.mistake, m_language);
        row.title->setToolTip(tip);
        row.box->setToolTip(tip);
        row.box->setAccessibleName(mistakeTitle(*row.mistake));
        row.show->setText(tr("show"));
        row.show->setToolTip(tr("Show in its scene"));
        row.show->setAccessibleName(tr("Show %1 in its scene").arg(mistakeTitle(*row.mistake)));
    }
    sync();
}

void MistakesSection::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

MistakesMenu::MistakesMenu(Document& document, const Language& language, ActionMenu menu)
    : QObject(menu.menu()), m_document(document), m_language(language)
{
    const auto words = [this](const char* english) { return ActionWords{metaObject()->className(), english}; };
    m_none = menu.add("mistakes.none", words(QT_TR_NOOP("None")), {}, [this] {
        Settings next = m_document.settings();
        next.mistakes.clear();
        m_document.setSettings(next);
    });
    menu.addSeparator();
    ActionMenu show = menu.addMenu(words(QT_TR_NOOP("Show in its scene")));
    menu.addSeparator();
    constexpr std::size_t kEach = 10;
    const auto all = mistakes();
    for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
        end = std::min(first + kEach, all.size());
        while (end < all.size() && QLatin1String(all[end].number) == QLatin1String(all[end - 1].number))
            ++end; // forms of one mistake stay together
        const auto some = all.subspan(first, end - first);
        const QString range =
            QStringLiteral("%1 \u2013 %2").arg(QLatin1String(some.front().number), QLatin1String(some.back().number));
        addRange(some, menu.addMenu({.name = range}), show.addMenu({.name = range}));
    }
    connect(&document, &Document::settingsChanged, this, &MistakesMenu::sync);
    retranslate();
}

void MistakesMenu::addRange(std::span<const Mistake> range, ActionMenu switches, ActionMenu demos)
{
    switches.menu()->setToolTipsVisible(true);
    demos.menu()->setToolTipsVisible(true);
    for (const Mistake& mistake : range) {
        const QString id = QLatin1String(mistake.id);
        const ActionWords words{"Mistake", mistake.title, QString(QLatin1String(mistake.number)) + QLatin1Char(' ')};
        QAction* toggle = switches.add(QStringLiteral("mistake.%1").arg(id), words, {}, [this, id](bool on) {
            m_document.setSettings(withMistake(m_document.settings(), id, on));
        });
        toggle->setCheckable(true);
        m_switches.push_back({&mistake, toggle});
        QAction* demo =
            demos.add(QStringLiteral("mistake.%1.show").arg(id), words, {}, [this, id] { m_document.openMistake(id); });
        m_demos.push_back({&mistake, demo});
    }
}

void MistakesMenu::sync()
{
    const QStringList& on = m_document.settings().mistakes;
    m_none->setEnabled(!on.isEmpty());
    for (const Entry& entry : m_switches)
        entry.action->setChecked(on.contains(QLatin1String(entry.mistake->id)));
}

void MistakesMenu::retranslate()
{
    for (const auto* entries : {&m_switches, &m_demos})
        for (const Entry& entry : *entries)
            entry.action->setToolTip(mistakeToolTip(*entry.mistake, m_language));
    sync();
}

} // namespace rasterlens
