// The field table: every value of every field survives JSON and text; bad values are named.
#include "core/settings/settings.h"

#include <QJsonDocument>
#include <QTest>

using namespace rasterlens;

class TestSettings : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyValueSurvivesJson();
    void everyIdIsUnique();
    void viewSurvivesJson();
    void badValuesNameTheFieldAndItsValues();
};

void TestSettings::everyValueSurvivesJson()
{
    for (const SettingsField& field : settingsFields())
        for (int value = field.minimum; value <= field.maximum; ++value) {
            Settings settings;
            field.set(settings, value);
            QCOMPARE(field.get(settings), value);
            const SettingsParse read = settingsFromJson(toJson(settings));
            QVERIFY2(read.errors.empty(), field.id);
            QVERIFY2(read.settings == settings, field.id);
            Settings fromText;
            QVERIFY2(!setFromText(field, valueId(field, settings), fromText), field.id);
            QVERIFY2(fromText == settings, field.id);
        }
}

void TestSettings::everyIdIsUnique()
{
    QStringList ids;
    for (const SettingsField& field : settingsFields()) {
        QVERIFY2(!ids.contains(QLatin1String(field.id)), field.id);
        ids << QLatin1String(field.id);
        QCOMPARE(findSettingsField(QLatin1String(field.id)), &field);
    }
}

void TestSettings::viewSurvivesJson()
{
    Settings settings;
    settings.size = {321, 123};
    settings.mistakes = {QStringLiteral("a"), QStringLiteral("b")};
    settings.view = {false, 10, -20, 2.5, {0.25, -0.5}, {1, 2, 3}, {4, 5, 6}, {0, 0, 1}, 60, 0.1, 1e5};
    const SettingsParse read = settingsFromJson(toJson(settings));
    QVERIFY(read.errors.empty());
    QVERIFY(read.settings == settings);
}

void TestSettings::badValuesNameTheFieldAndItsValues()
{
    Settings settings;
    const auto error = setFromText(*findSettingsField(QStringLiteral("culling")), QStringLiteral("sideways"), settings);
    QVERIFY(error && textOf(*error).contains(QLatin1String("culling")) &&
            textOf(*error).contains(QLatin1String("back, front, none")));
    QVERIFY(settings == Settings());
    for (const char* json :
         {R"({"size": "0x5"})", R"({"subpixel-bits": 9})", R"({"subpixel-bits": 1.5})", R"({"view": {"fov": 180}})",
          R"({"view": {"near": 2, "far": 1}})", R"({"nonsense": 1})", R"({"mistakes": "one"})"}) {
        const SettingsParse read = settingsFromJson(QJsonDocument::fromJson(json).object());
        QVERIFY2(!read.errors.empty(), json);
        QVERIFY2(read.settings == Settings(), json);
    }
}

QTEST_APPLESS_MAIN(TestSettings)
#include "test_settings.moc"
