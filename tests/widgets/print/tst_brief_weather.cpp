#include "tests/support/files/brief_fixtures.h"
#include "tests/support/flight/forecast_builder.h"
#include "widgets/print/brief_content.h"
#include "widgets/print/flight_brief.h"
#include "widgets/theme/unit_settings.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

ExportContent forecastContent(const std::function<void(Scenario&)>& change = {})
{
    Scenario scenario = fleetScenario(1, 12);
    addForecast(scenario);
    if (change)
        change(scenario);
    return planContent(scenario, fleetPlan(1, 12));
}

} // namespace

/** The forecast in the flight brief. */
class TestBriefWeather : public QObject
{
    Q_OBJECT

private slots:
    void cleanup() { setShownUnits({}); }

    void briefWithoutForecastHasNone()
    {
        const ExportContent content =
            forecastContent([](Scenario& scenario) { scenario.forecast.reset(); });
        const BriefContent brief = briefContent(content, kEnglish);
        QVERIFY(brief.weather.rows.empty() && brief.weather.source.isEmpty());
        QVERIFY(
            !QString::fromStdString(briefDocument(content, kEnglish).html).contains(u"Forecast"_s));
    }

    /** From the start to the end of the flight. */
    void weatherIsATable()
    {
        const BriefWeather weather = briefWeather(forecastContent(), kEnglish);
        QCOMPARE(weather.source,
                 u"Forecast of MET Norway, issued 2026-05-01 06:00 UTC, 6 h before the start"_s);
        QCOMPARE(weather.rows[0],
                 QStringList({u"Time, UTC"_s, u"Wind, true"_s, u"Gusts"_s, u"Current, true"_s}));
        QVERIFY(weather.rows.size() >= 3 && weather.rows.size() <= 9);
        QCOMPARE(weather.rows[1][0], u"12:00:00"_s);
        QVERIFY2(weather.rows[1][1].startsWith(u"10.") && weather.rows[1][1].contains(u" from 2"_s),
                 qPrintable(weather.rows[1][1]));
        QVERIFY2(weather.rows[1][3].startsWith(u"0.50 m/s towards 03"_s),
                 qPrintable(weather.rows[1][3]));
        for (std::size_t row = 2; row < weather.rows.size(); ++row)
            QVERIFY(weather.rows[row][0] > weather.rows[row - 1][0]);
        QVERIFY2(weather.warnings.isEmpty(), qPrintable(weather.warnings.join(u'\n')));
        const std::string html = briefDocument(forecastContent(), kEnglish).html;
        QVERIFY(QString::fromStdString(html).contains(u"Forecast of MET Norway"_s));
    }

    void oldForecastIsWarnedOf()
    {
        const ExportContent content = forecastContent([](Scenario& scenario) {
            for (Forecast& place : scenario.forecast->places)
                place.issued = kForecastStartTime - std::chrono::hours(30);
        });
        const BriefContent brief = briefContent(content, kEnglish);
        QVERIFY2(brief.warnings.contains(
                     u"The forecast was issued 30 h before the flight: look for a newer one."_s),
                 qPrintable(brief.warnings.join(u'\n')));
    }

    void gapsAreWarnedOf()
    {
        const ExportContent content = forecastContent([](Scenario& scenario) {
            for (Forecast& place : scenario.forecast->places) // it begins after the flight
                for (ForecastEntry& entry : place.series)
                    entry.time += std::chrono::hours(240);
        });
        const BriefWeather weather = briefWeather(content, kEnglish);
        QCOMPARE(weather.rows[1][1], u"–"_s);
        QVERIFY(
            weather.warnings.join(u' ').contains(u"The forecast has no wind between 12:00:00"_s));
    }

    void unknownIssueIsSaid()
    {
        const ExportContent content = forecastContent([](Scenario& scenario) {
            for (Forecast& place : scenario.forecast->places) {
                place.issued.reset();
                place.source.clear();
            }
        });
        QCOMPARE(briefWeather(content, kEnglish).source,
                 u"Forecast of unknown source, time of issue unknown"_s);
    }
};

QTEST_MAIN(TestBriefWeather)
#include "tst_brief_weather.moc"
