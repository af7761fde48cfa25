#include "core/checks/validate.h"
#include "core/checks/weather.h"

#include <QTest>

#include <algorithm>

using namespace berg;

namespace {

bool hasWarning(const Scenario& scenario, IssueId id)
{
    return std::ranges::any_of(validate(scenario), [id](const Issue& issue) {
        return issue.reason.id == id && issue.severity == Severity::Warning;
    });
}

} // namespace

class TestWeather : public QObject
{
    Q_OBJECT

private slots:
    void icingNeedsColdAndMoisture_data()
    {
        QTest::addColumn<double>("temperature_degC");
        QTest::addColumn<double>("dewPoint_degC");
        QTest::addColumn<double>("height_m");
        QTest::addColumn<bool>("icing");
        QTest::newRow("cold and moist") << -3.0 << -4.0 << 0.0 << true;
        QTest::newRow("cold and dry") << -3.0 << -8.0 << 0.0 << false;
        QTest::newRow("warm and moist") << 3.0 << 2.5 << 0.0 << false;
        // 6.5 and 1.8 degC colder a kilometre up: -3.5 and 0.7, saturated.
        QTest::newRow("cold above") << 3.0 << 2.5 << 1000.0 << true;
        // 1 km up the spread of 8 has shrunk to 3.3, 1.5 km up to 0.95.
        QTest::newRow("dry still") << 0.0 << -8.0 << 1000.0 << false;
        QTest::newRow("moist farther up") << 0.0 << -8.0 << 1500.0 << true;
    }

    void icingNeedsColdAndMoisture()
    {
        QFETCH(double, temperature_degC);
        QFETCH(double, dewPoint_degC);
        QFETCH(double, height_m);
        QFETCH(bool, icing);
        const Weather weather{.temperature_degC = temperature_degC, .dewPoint_degC = dewPoint_degC};
        QCOMPARE(isIcing(weather, height_m), icing);
        QVERIFY(!isIcing({.temperature_degC = temperature_degC}, height_m));
        QVERIFY(!isIcing({.dewPoint_degC = dewPoint_degC}, height_m));
    }

    void limitsAreChecked()
    {
        Scenario scenario;
        Uav& uav = scenario.uavs.emplace_back();
        uav.id = "uav-1";
        scenario.wind_mps = {9, 12};
        scenario.weather = {.gust_mps = 20, .temperature_degC = -2, .dewPoint_degC = -2};
        uav.weather = {.wind_mps = 15, .gust_mps = 20, .icing = true};
        for (const IssueId id : {IssueId::WindLimit, IssueId::GustLimit, IssueId::Icing})
            QVERIFY(!hasWarning(scenario, id));
        uav.weather = {.wind_mps = 14.9, .gust_mps = 19.9, .icing = false};
        for (const IssueId id : {IssueId::WindLimit, IssueId::GustLimit, IssueId::Icing})
            QVERIFY(hasWarning(scenario, id));
        uav.weather = {};
        scenario.weather = {};
        for (const IssueId id : {IssueId::WindLimit, IssueId::GustLimit, IssueId::Icing})
            QVERIFY(!hasWarning(scenario, id));
    }
};

QTEST_APPLESS_MAIN(TestWeather)
#include "tst_weather.moc"
