#include "core/io/files/field_rows.h"
#include "core/scenario/fields.h"

#include <QtTest>

#include <algorithm>

using namespace berg;

namespace {

std::vector<FieldRow> englishRows()
{
    return fieldRows([](const char* english) { return english; });
}

FieldRow rowOf(std::string_view field)
{
    const std::vector<FieldRow> rows = englishRows();
    const auto row = std::ranges::find(rows, field, &FieldRow::field);
    return row == rows.end() ? FieldRow{} : *row;
}

} // namespace

/** The page of scenario fields, made of the tables of the core. */
class TestFieldRows : public QObject
{
    Q_OBJECT

private slots:
    void eachFieldHasARowWithAMeaning()
    {
        const std::vector<FieldRow> rows = englishRows();
        forEachObject([&](const std::string& object, const auto& fields) {
            for (const auto& field : fields)
                QCOMPARE(std::ranges::count(rows, object + field.name, &FieldRow::field), 1);
        });
        for (const FieldRow& row : rows) {
            QVERIFY2(!row.meaning.empty() && !row.standard.empty(), row.field.c_str());
            QVERIFY2(row.meaning.find("%1") == std::string::npos, row.field.c_str());
        }
    }

    void rowsHaveDefaultsAndLimits_data()
    {
        QTest::addColumn<QString>("field");
        QTest::addColumn<QString>("standard");
        QTest::addColumn<QString>("values");
        QTest::newRow("number") << "uavs[].airspeed_mps"
                                << "22"
                                << "1 … 1000";
        QTest::newRow("whole") << "seed"
                               << "1"
                               << "0 … 9007199254740992";
        QTest::newRow("above") << "dt_s"
                               << "0.1"
                               << "0.01 … 1";
        QTest::newRow("pair") << "uavs[].fov_m"
                              << "[600, 600]"
                              << "1 … 1e6";
        QTest::newRow("optional") << "uavs[].home_m"
                                  << "none"
                                  << "-1e6 … 1e6";
        QTest::newRow("missing") << "uavs[].endurance_s"
                                 << "unlimited"
                                 << "1 … 1e9";
        QTest::newRow("required") << "icebergs[].position_m"
                                  << "required"
                                  << "-1e6 … 1e6";
        QTest::newRow("choice") << "planner.route"
                                << "\"open\""
                                << "open, closed";
        QTest::newRow("truth") << "noise"
                               << "true"
                               << "";
        QTest::newRow("text") << "icebergs[].uav"
                              << "\"\""
                              << "";
        QTest::newRow("origin") << "origin.latitude_deg"
                                << "47"
                                << "-90 … 90";
        QTest::newRow("object") << "asset"
                                << "none"
                                << "";
    }
    void rowsHaveDefaultsAndLimits()
    {
        QFETCH(QString, field);
        QFETCH(QString, standard);
        QFETCH(QString, values);
        const FieldRow row = rowOf(field.toStdString());
        QCOMPARE(QString::fromStdString(row.standard), standard);
        QCOMPARE(QString::fromStdString(row.values), values);
    }

    void meaningNamesTheOlderName()
    {
        QVERIFY(rowOf("planner.planning_delay_s").meaning.ends_with("`latency_s` in older files."));
        QVERIFY(rowOf("uavs[].altitude_m").meaning.find("30 m") != std::string::npos);
    }

    void textsAreTranslated()
    {
        const std::vector<FieldRow> rows =
            fieldRows([](const char* english) { return '<' + std::string(english) + '>'; });
        QCOMPARE(rows.size(), englishRows().size());
        for (const FieldRow& row : rows)
            QVERIFY2(row.meaning.starts_with('<'), row.field.c_str());
    }

    void tableHasALineForEachRow()
    {
        const std::string table = fieldTable();
        QCOMPARE(static_cast<std::size_t>(std::ranges::count(table, '\n')),
                 englishRows().size() + 2);
        QVERIFY(table.find("| planner.tau | 1 | 0 … 100 | 0 visits") != std::string::npos);
    }
};

QTEST_APPLESS_MAIN(TestFieldRows)
#include "tst_field_rows.moc"
