#pragma once
// Says what the guide states that the program does not have.
#include "core/scenes/builtin_scenes.h"
#include "core/settings/mistakes.h"
#include "tests/cli_support.h"
#include "ui/base/action_table.h"
#include "ui/window/guide_view.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include <map>
#include <set>

namespace rasterlens::test
{

/// What of the program a guide can name.
class GuideTruth
{
public:
    static constexpr qint64 kMostBytes = 100'000;

    /// in  root: the folder of the project
    GuideTruth(const ActionTable& table, QString root, QString window, QString cli, LanguageKind language)
        : m_table(table), m_root(std::move(root)), m_window(std::move(window)), m_cli(std::move(cli)),
          m_isChinese(language == LanguageKind::Chinese)
    {
        readActions();
        readWords();
        readLessons();
    }

    /// in   the text of a guide in the language of the table
    /// out  one sentence for each thing that does not exist
    [[nodiscard]] QStringList problems(const QString& guide)
    {
        m_problems.clear();
        checkPictures(guide);
        checkLinks(guide);
        checkKeyList(guide);
        const QString text = withoutCodeBlocks(guide);
        checkKeys(text);
        checkWords(text);
        checkCommands(guide);
        return m_problems;
    }

    /// The headings and pictures of a guide, which its twin is to have as well: `## `, `teapot`.
    [[nodiscard]] static QStringList skeleton(const QString& guide)
    {
        static const QRegularExpression part(QStringLiteral(R"(^(#+ )|\]\(images/guide/([^)]+?)(\.zh)?\.png\))"),
                                             QRegularExpression::MultilineOption);
        QStringList parts;
        for (const auto& match : part.globalMatch(withoutCodeBlocks(guide)))
            parts << match.captured(1) + match.captured(2);
        return parts;
    }

private:
    const ActionTable& m_table;
    QString m_root;
    QString m_window;
    QString m_cli;
    bool m_isChinese;
    std::set<QString> m_keys;
    std::set<QString> m_paths;
    std::set<QString> m_words;
    std::set<QString> m_lessons;
    static inline std::map<QString, QString> s_help; ///< by program and verb; it never changes
    QStringList m_problems;

    void report(const QString& what, const QString& name) { m_problems << QStringLiteral("%1: %2").arg(what, name); }

    /// A text as the guide writes it: no mnemonic, no dots of a dialog, no place for a number.
    static QString plain(const QString& text)
    {
        static const QRegularExpression number(QStringLiteral(" ?%[0-9]"));
        QString words = withoutMnemonic(text).remove(number).trimmed();
        while (words.endsWith(QChar(0x2026)))
            words.chop(1);
        return words.remove(QChar(0x25be)).trimmed();
    }

    void readActions()
    {
        for (const ActionRow& row : m_table.rows()) {
            QString path;
            for (const ActionWords& menu : row.path) {
                path += (path.isEmpty() ? QString() : QStringLiteral(" > ")) + plain(menu.text());
                m_paths.insert(path);
            }
            m_paths.insert(path + QStringLiteral(" > ") + plain(row.words.text()));
            if (row.action)
                for (const QKeySequence& key : row.action->shortcuts())
                    m_keys.insert(key.toString(QKeySequence::PortableText));
            else
                m_keys.insert(row.keyWords.text());
        }
    }

    void readWords()
    {
        QFile file(m_root + QStringLiteral("/resources/translations/rasterlens_zh_CN.ts"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QXmlStreamReader xml(&file);
        const QLatin1String wanted(m_isChinese ? "translation" : "source");
        while (!xml.atEnd())
            if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == wanted)
                m_words.insert(plain(xml.readElementText(QXmlStreamReader::IncludeChildElements)));
    }

    void readLessons()
    {
        const QDir folder(m_root + QStringLiteral("/resources/lessons"));
        for (const QString& name : folder.entryList({QStringLiteral("*.json")})) {
            const QJsonObject lesson = QJsonDocument::fromJson(readFile(folder.filePath(name))).object();
            m_lessons.insert(lesson[QLatin1String("id")].toString());
            m_words.insert(lesson[QLatin1String("title")][QLatin1String(m_isChinese ? "zh" : "en")].toString());
        }
    }

    static QString withoutCodeBlocks(const QString& guide)
    {
        static const QRegularExpression block(QStringLiteral("```.*?```|<!--.*-->"),
                                              QRegularExpression::DotMatchesEverythingOption);
        return QString(guide).remove(block);
    }

    void checkPictures(const QString& guide)
    {
        static const QRegularExpression picture(QStringLiteral(R"(!\[([^\]]*)\]\(([^)]*)\))"));
        for (const auto& match : picture.globalMatch(guide)) {
            const QString path = m_root + QStringLiteral("/docs/") + match.captured(2);
            if (QImage(path).isNull())
                report(QStringLiteral("no picture"), match.captured(2));
            if (match.captured(1).isEmpty())
                report(QStringLiteral("a picture without words"), match.captured(2));
            if (QFileInfo(path).size() > kMostBytes)
                report(QStringLiteral("a picture that is too large"), match.captured(2));
        }
    }

    void checkLinks(const QString& guide)
    {
        static const QRegularExpression link(QStringLiteral(R"((?<!!)\[[^\]]*\]\(([^)#]*)(#([^)]*))?\))"));
        static const QRegularExpression heading(QStringLiteral("^#+ (.*)$"), QRegularExpression::MultilineOption);
        std::set<QString> anchors;
        for (const auto& match : heading.globalMatch(withoutCodeBlocks(guide)))
            anchors.insert(GuideView::anchorOf(match.captured(1)));
        for (const auto& match : link.globalMatch(withoutCodeBlocks(guide))) {
            const QString page = match.captured(1);
            if (!page.isEmpty() && !GuideView::hasPage(page))
                report(QStringLiteral("no page in the program"), page);
            if (page.isEmpty() && anchors.count(match.captured(3)) == 0)
                report(QStringLiteral("no heading"), match.captured(3));
        }
    }

    void checkKeyList(const QString& guide)
    {
        const QString begin = QStringLiteral("<!-- what `rasterlens --keys` prints -->\n");
        const auto from = guide.indexOf(begin);
        const auto to = guide.indexOf(QStringLiteral("<!-- end of the keys -->"));
        if (from < 0 || guide.mid(from + begin.size(), to - from - begin.size()) != m_table.markdown())
            report(QStringLiteral("another list of keys than"), QStringLiteral("rasterlens --keys"));
    }

    void checkKeys(const QString& text)
    {
        static const QRegularExpression bold(QStringLiteral(R"(\*\*([^*]+)\*\*)"));
        for (const auto& match : bold.globalMatch(text))
            if (const QString key = match.captured(1); m_keys.count(key) == 0 && !isSpokenOf(key))
                report(QStringLiteral("no key"), key);
    }

    void checkWords(const QString& text)
    {
        static const QRegularExpression slanted(QStringLiteral(R"((?<!\*)\*([^*]+)\*(?!\*))"));
        for (const auto& match : slanted.globalMatch(text)) {
            const QString words = match.captured(1).simplified();
            const bool isPath = words.contains(QStringLiteral(" > "));
            if (isPath ? m_paths.count(words) == 0 : m_words.count(words) == 0 && !isSpokenOf(words))
                report(isPath ? QStringLiteral("no menu") : QStringLiteral("no text of the window"), words);
        }
    }

    /// The words that tell how the guide is written.
    static bool isSpokenOf(const QString& word)
    {
        static const std::set<QString> words{QStringLiteral("Bold"), QStringLiteral("slanted"),
                                             QStringLiteral("\u7c97\u4f53"), QStringLiteral("\u659c\u4f53")};
        return words.count(word) != 0;
    }

    const QString& help(const QString& program, const QString& verb)
    {
        QString& text = s_help[program + verb];
        if (text.isEmpty()) {
            const QStringList words = verb.isEmpty() ? QStringList() : QStringList{verb};
            text = QString::fromUtf8(run(words + QStringList{QStringLiteral("--help")}, m_root, program).out);
        }
        return text;
    }

    void checkCommands(const QString& guide)
    {
        static const QRegularExpression command(QStringLiteral("(?:^|`)(rasterlens(?:-cli)?) ([^`\\n]*)"),
                                                QRegularExpression::MultilineOption);
        for (const auto& match : command.globalMatch(guide)) {
            QStringList words = match.captured(2).split(QLatin1Char(' '), Qt::SkipEmptyParts);
            const bool isCli = match.captured(1) == QLatin1String("rasterlens-cli");
            const QString verb = isCli && !words.isEmpty() ? words.takeFirst() : QString();
            const QString& text = help(isCli ? m_cli : m_window, verb);
            if (!text.contains(match.captured(1) + (isCli ? QLatin1Char(' ') + verb : QString())))
                report(QStringLiteral("no command"), match.captured(1) + QLatin1Char(' ') + verb);
            else
                for (const QString& word : words)
                    checkWord(word, text);
        }
    }

    void checkWord(const QString& word, const QString& help)
    {
        static const QRegularExpression option(QStringLiteral("^--?[a-z]"));
        static const QRegularExpression shown(QStringLiteral("(^|[\\s,|\\[])%1([\\s,=|\\]]|$)"));
        if (option.match(word).hasMatch()) {
            const QRegularExpression row(shown.pattern().arg(QRegularExpression::escape(word)),
                                         QRegularExpression::MultilineOption);
            if (!row.match(help).hasMatch())
                report(QStringLiteral("no option"), word);
        } else if (word.startsWith(QLatin1String("builtin:"))) {
            if (std::ranges::none_of(builtinScenes(), [&](const BuiltinScene& scene) {
                    return word == QLatin1String("builtin:") + QLatin1String(scene.name);
                }))
                report(QStringLiteral("no scene"), word);
        }
    }
};

} // namespace rasterlens::test
