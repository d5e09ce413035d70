// How a command line may go on, as the shells ask for it.
#include "core/lessons/lesson.h"
#include "core/settings/mistakes.h"
#include "core/settings/settings.h"
#include "tests/cli_support.h"

#include <QTemporaryDir>

#include <algorithm>

using namespace rasterlens;

class TestCompletion : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    QStringList complete(const QStringList& words) const
    {
        const test::Run run =
            test::run(QStringList{QStringLiteral("complete"), QStringLiteral("--")} + words, m_folder.path());
        if (run.exitCode != 0)
            return {QStringLiteral("exit code %1: %2").arg(run.exitCode).arg(run.err)};
        return QString::fromUtf8(run.out).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    }

private Q_SLOTS:
    void verbsComeFirst()
    {
        QCOMPARE(complete({QStringLiteral("re")}), QStringList{QStringLiteral("render")});
        QCOMPARE(complete({QStringLiteral("--v")}), QStringList{QStringLiteral("--version")});
        const QStringList all = complete({QString()});
        QVERIFY(all.contains(QStringLiteral("why")) && all.contains(QStringLiteral("lesson")));
        QVERIFY(!all.contains(QStringLiteral(":files")));
    }

    /// Every value of every field of the table is offered behind the field's option, and nothing else.
    void valuesAreThoseOfTheFieldTable()
    {
        for (const SettingsField& field : settingsFields()) {
            if (field.kind != SettingsField::Kind::Choice)
                continue;
            QStringList ids;
            for (const Choice& choice : field.choices)
                ids << QLatin1String(choice.id);
            QCOMPARE(complete({QStringLiteral("render"), QStringLiteral("builtin:cube"),
                               QStringLiteral("--") + QLatin1String(field.id), QString()}),
                     ids);
        }
    }

    void mistakesAndLessonsAreOffered()
    {
        const QStringList ids = complete({QStringLiteral("why"), QStringLiteral("--mistake"), QString()});
        QCOMPARE(ids.size(), static_cast<qsizetype>(mistakes().size()));
        QCOMPARE(ids.first(), QLatin1String(mistakes().front().id));
        QCOMPARE(complete({QStringLiteral("lesson"), QStringLiteral("show"), QString()}),
                 lessonIds() + QStringList{QStringLiteral(":files")});
    }

    void scenesAndFilesAreOperands()
    {
        QCOMPARE(complete({QStringLiteral("render"), QStringLiteral("builtin:square-d")}),
                 (QStringList{QStringLiteral("builtin:square-diagonal"), QStringLiteral(":files")}));
        QCOMPARE(complete({QStringLiteral("diff"), QString()}), QStringList{QStringLiteral(":files")});
        QCOMPARE(complete({QStringLiteral("render"), QStringLiteral("-o"), QString()}),
                 QStringList{QStringLiteral(":files")});
        QCOMPARE(complete({QStringLiteral("render"), QStringLiteral("--size"), QString()}), QStringList());
        QCOMPARE(complete({QStringLiteral("figure"), QStringLiteral("--language"), QString()}),
                 (QStringList{QStringLiteral("en"), QStringLiteral("zh")}));
    }

    void unknownVerbsAreNotCompleted() { QCOMPARE(complete({QStringLiteral("rendr"), QString()}), QStringList()); }

    /// Each option of a verb's help is offered, and each that is offered is one the verb takes.
    void optionsAreThoseOfTheHelp()
    {
        for (const char* verb : {"render", "bench", "figure", "diff", "cases"}) {
            const QString help =
                QString::fromUtf8(test::run({QLatin1String(verb), QStringLiteral("--help")}, m_folder.path()).out);
            const QStringList options = complete({QLatin1String(verb), QStringLiteral("--")});
            QVERIFY(options.size() > 1);
            for (const QString& option : options)
                if (option != QLatin1String("--help"))
                    QVERIFY2(help.contains(QStringLiteral("\n  ") + option), qPrintable(option));
        }
    }

    void dashesAreNeeded()
    {
        const test::Run run = test::run({QStringLiteral("complete"), QStringLiteral("render")}, m_folder.path());
        QCOMPARE(run.exitCode, 2);
        QVERIFY(run.err.contains(QStringLiteral("-- is missing")));
    }
};

QTEST_GUILESS_MAIN(TestCompletion)
#include "test_completion.moc"
