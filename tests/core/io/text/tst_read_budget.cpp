#include "core/base/error.h"
#include "core/io/files/scenario_json.h"
#include "core/io/import/import_formats.h"
#include "core/io/import/scenario/import_scenario.h"
#include "core/io/text/read_budget.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/export_text.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;

Q_DECLARE_METATYPE(std::function<void(ReadBudget&)>)

/** Each read limit names itself and says how to raise it. */
class TestReadBudget : public QObject
{
    Q_OBJECT

private:
    static std::string rows(int count)
    {
        std::string text = "lat,lon\n";
        for (int i = 0; i < count; ++i)
            text += "1,2\n";
        return text;
    }

private slots:
    void cleanup() { qunsetenv(kReadLimitsVariable); }

    void exceededLimitNamesItself_data()
    {
        QTest::addColumn<std::function<void(ReadBudget&)>>("act");
        QTest::addColumn<QByteArray>("says");
        const auto add = [](const char* name, std::function<void(ReadBudget&)> act,
                            const char* says) {
            QTest::newRow(name) << std::move(act) << QByteArray(says);
        };
        add(
            "memory", [](ReadBudget& budget) { budget.take(50'009'001); },
            "would take more than 50 MB of memory");
        add(
            "values",
            [](ReadBudget& budget) {
                for (int i = 0; i <= 10'000'000; ++i)
                    budget.takeValue();
            },
            "holds more than 10000000 values");
        add(
            "rows",
            [](ReadBudget& budget) {
                for (int i = 0; i <= 1'000'000; ++i)
                    budget.takeRow(0);
            },
            "holds more than 1000000 rows");
        add(
            "bytes", [](ReadBudget&) { ReadBudget("file", (64U << 20U) + 1); },
            "is larger than 64 MiB");
    }
    void exceededLimitNamesItself()
    {
        QFETCH(std::function<void(ReadBudget&)>, act);
        QFETCH(QByteArray, says);
        ReadBudget budget("file", 1000);
        const std::optional<Error> error = errorOf([&] { act(budget); });
        QVERIFY(error);
        QCOMPARE(codeName(error->code()), std::string("FileTooLarge"));
        QVERIFY2(QByteArray(error->what()).startsWith("file: " + says), error->what());
        QVERIFY2(QByteArray(error->what()).contains("BERGWATCH_READ_LIMITS=2"), error->what());
        qputenv(kReadLimitsVariable, "2");
        ReadBudget twice("file", 1000);
        QVERIFY(!errorOf([&] { act(twice); }));
    }

    void releasedMemoryIsFree()
    {
        ReadBudget budget("file", 0);
        for (int i = 0; i < 1000; ++i) {
            budget.take(40'000'000);
            budget.release(40'000'000);
        }
        QCOMPARE(budget.memory(), std::size_t{0});
    }

    void onlyWholeFactorsCount_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("limit");
        QTest::newRow("none") << QByteArray() << 10;
        QTest::newRow("three") << QByteArray("3") << 30;
        QTest::newRow("none at all") << QByteArray("0") << 10;
        QTest::newRow("too many") << QByteArray("5000") << 10'000;
        QTest::newRow("words") << QByteArray("many") << 10;
        QTest::newRow("below zero") << QByteArray("-4") << 10;
    }
    void onlyWholeFactorsCount()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, limit);
        qputenv(kReadLimitsVariable, text);
        QCOMPARE(readLimit(10), static_cast<std::size_t>(limit));
    }

    /** Rows of four bytes would take eighty times as much memory. */
    void manyShortRowsAreRejected()
    {
        const std::string text = rows(300'000);
        QCOMPARE(codeOf([&] { (void)readSightings(text, "file"); }), std::string("FileTooLarge"));
        qputenv(kReadLimitsVariable, "4");
        QCOMPARE(readSightings(text, "file").sightings.size(), std::size_t{300'000});
    }

    /** An archive of a hundred bytes may contain large texts up to the limit. */
    void packedTextIsLimited()
    {
        const std::string text = zipFile(
            "doc.kml",
            "<kml>" + std::string(60'000'000, ' ') +
                "<Placemark><Point><coordinates>1,2</coordinates></Point></Placemark></kml>");
        QCOMPARE(codeOf([&] { (void)readSightings(text, "file"); }), std::string("FileTooLarge"));
        qputenv(kReadLimitsVariable, "4");
        QCOMPARE(readSightings(text, "file").sightings.size(), std::size_t{1});
    }

    void manyIcebergsAreLimited()
    {
        std::string text = "id,lat,lon,remarks\n";
        for (int i = 0; i <= 50'000; ++i)
            text += std::to_string(i) + ",1,2,a remark\n";
        const SightingTable table = readSightings(text, "file");
        const auto import = [&] {
            return importSightings(newScenarioForImport("sea"), table).scenario.icebergs.size();
        };
        const std::optional<Error> error = errorOf([&] { (void)import(); });
        QVERIFY(error);
        QVERIFY2(QByteArray(error->what()).contains("narrow the area or the time"), error->what());
        qputenv(kReadLimitsVariable, "2");
        QCOMPARE(import(), std::size_t{1000});
    }
};

QTEST_APPLESS_MAIN(TestReadBudget)

#include "tst_read_budget.moc"
