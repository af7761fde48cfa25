#include "core/base/sha256.h"
#include "core/io/export/content/export_flight.h"
#include "core/io/export/flight_log.h"
#include "core/io/export/missions/plan_wpl.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/export_fixtures.h"
#include "tests/support/flight/forecast_builder.h"

#include <QTest>

#include <algorithm>
#include <utility>

using namespace berg;
using namespace berg::test;

class TestFlightLog : public QObject
{
    Q_OBJECT

private slots:
    void logHasPlannedAndFlownFigures()
    {
        const Mission mission = flown(fourIcebergs());
        ExportContent content = runContent(mission);
        QVERIFY(!flightLog(content).predicted); // it makes none of its own
        content.predicted =
            ZetaPrediction{.mean_m2s = 12345, .least_m2s = 11000, .most_m2s = 13000};
        const FlightLog log = flightLog(content);
        QCOMPARE(log.flown_s, 400.0);
        QCOMPARE(log.metrics, mission.metrics());
        QVERIFY(!log.wasChanged);
        QVERIFY(log.predicted == content.predicted);
        QVERIFY(flightLogHtml(content).find("Predicted before take-off</span><br/><b>12") !=
                std::string::npos);

        QCOMPARE(log.uavs.size(), std::size_t{1});
        const LogUav& uav = log.uavs.front();
        QCOMPARE(uav.plannedVisits, std::size_t{4});
        // The legs are straight to the future positions of the icebergs, which the plan panel and
        // the brief show, too.
        const Scenario& scenario = mission.scenario();
        Point from_m = scenario.uavs[0].position_m;
        double length_m = 0;
        const std::vector<Visit> planned =
            plannedVisits(scenario, mission.plans().front()->uavs[0].order, {});
        for (const Visit& visit : planned)
            length_m += (visit.position_m - std::exchange(from_m, visit.position_m)).norm();
        COMPARE_NEAR(uav.plannedLength_m, length_m, 1e-6);
        COMPARE_NEAR(uav.plannedTime_s, planned.back().time_s, 1e-6);
        QCOMPARE(uav.visits, mission.metrics().visits);
        QCOMPARE(uav.flown_m, mission.metrics().flown_m);
        QCOMPARE(uav.aloft_s, 400.0);
        QCOMPARE(uav.outside_s, 0.0); // no operation
        QCOMPARE(log.icebergs.size(), std::size_t{4});
        int visits = 0;
        for (const LogIceberg& iceberg : log.icebergs) {
            visits += iceberg.visits;
            QCOMPARE(iceberg.first_s.has_value(), iceberg.last_s.has_value());
            QVERIFY(!iceberg.first_s || *iceberg.first_s <= *iceberg.last_s);
            QVERIFY(iceberg.visits == 0 || iceberg.first_s);
            QVERIFY(iceberg.longestUnseen_s > 0 && iceberg.longestUnseen_s <= 400);
        }
        QCOMPARE(visits, mission.metrics().visits);
    }

    /** The hash is that of the exported plan before take-off. */
    void planIsNamedByItsFile()
    {
        const Scenario scenario = fourIcebergs();
        const Mission mission = flown(scenario);
        const Plan plan = planFromStart(scenario);
        const std::string file = wplText(exportContent({.scenario = scenario, .plan = plan}));
        QCOMPARE(flightLog(runContent(mission)).uavs.front().planHash, sha256Text(file));
    }

    void timeOutsideTheGeographyIsCounted()
    {
        Scenario scenario = fourIcebergs();
        scenario.operation = Operation{};
        QCOMPARE(flightLog(runContent(flown(scenario))).uavs.front().outside_s, 0.0);
        scenario.operation->margin_m = 1;
        scenario.uavs.front().heading_deg = 225; // away from all icebergs at first
        QVERIFY(flightLog(runContent(flown(scenario))).uavs.front().outside_s > 0);
    }

    void changesInFlightAreDeviations()
    {
        Mission mission(fourIcebergs());
        mission.advance(100);
        Intervention change;
        change.wind_mps = Point(3, 0);
        mission.intervene(change);
        mission.advance(1e9);
        const FlightLog log = flightLog(runContent(mission));
        QVERIFY(log.wasChanged);
        QVERIFY(std::ranges::any_of(log.deviations, [](const MissionEvent& event) {
            return event.kind == EventKind::Intervention && event.time_s == 100;
        }));
    }

    /** Reports by radio: of a known iceberg seen earlier, and of a new one. */
    void reportsOfOthersAreSightings()
    {
        Mission mission(fourIcebergs());
        mission.advance(100);
        const std::vector<LogIceberg> before = flightLog(runContent(mission)).icebergs;
        const auto unseen = std::ranges::find_if(
            before, [](const LogIceberg& iceberg) { return !iceberg.first_s; });
        QVERIFY(unseen != before.end());
        const std::size_t far = toIndex(unseen->iceberg);
        mission.intervene({.seen = mission.icebergs()[far].id, .seenAge_s = 30});
        mission.intervene({.appears = Iceberg{.id = "late", .position_m = {4000, 4000}}});
        mission.advance(101);
        const FlightLog log = flightLog(runContent(mission));
        QCOMPARE(log.icebergs[far].first_s, std::optional(70.0));
        QCOMPARE(log.icebergs[far].last_s, std::optional(70.0));
        QCOMPARE(log.icebergs[far].longestUnseen_s, 70.0); // 70 s before the report, 31 s after it
        QCOMPARE(log.icebergs.back().first_s, std::optional(100.0));
        QCOMPARE(log.icebergs.back().longestUnseen_s, 1.0);
        const std::string page = flightLogHtml(runContent(mission));
        QVERIFY(page.find("reported seen") != std::string::npos);
    }

    void takeOffAndLandingAreTimed()
    {
        Mission mission(fourIcebergs());
        mission.advance(100);
        const LogUav before = flightLog(runContent(mission)).uavs.front();
        QCOMPARE(before.tookOff_s, std::optional(0.0));
        QVERIFY(!before.landed_s);
        mission.intervene({.commanded = UavCommand{.uav = mission.scenario().uavs[0].id,
                                                   .order = FlightOrder::ReturnNow}});
        mission.advance(1e9);
        const LogUav after = flightLog(runContent(mission)).uavs.front();
        QCOMPARE(after.tookOff_s, std::optional(0.0));
        QVERIFY(after.landed_s && *after.landed_s > 100);
        COMPARE_NEAR(*after.landed_s, after.aloft_s, 1.5); // of the samples
    }

    /** A drag of tau is many changes but one deviation; added and removed icebergs are named. */
    void dragOfTauIsOneDeviation()
    {
        Mission mission(fourIcebergs());
        mission.advance(100);
        for (const double tau : {1.1, 1.2, 1.3}) {
            mission.intervene({.tau = tau, .policy = PolicyKind::Visitation});
            mission.advance(mission.simulation().time_s() + 1);
        }
        mission.intervene({.appears = Iceberg{.id = "late", .position_m = {2500, 1500}}});
        mission.intervene({.removed = mission.icebergs()[0].id});
        mission.advance(1e9);
        const FlightLog log = flightLog(runContent(mission));
        const std::vector<MissionEvent>& deviations = log.deviations;
        QCOMPARE(deviations.size(), std::size_t{3});
        QVERIFY(log.icebergs[0].longestUnseen_s <= 104); // until it was removed
        QCOMPARE(deviations[0].tau, 1.3);
        const std::string page = flightLogHtml(runContent(mission));
        for (const char* part : {"Planned from now on by: visitation, τ = 1.3",
                                 "<bdi>late</bdi> added", "</bdi> removed"})
            QVERIFY2(page.find(part) != std::string::npos, part);
        ExportContent french = runContent(mission);
        french.words = ReportWords([](std::string_view english) {
            return std::string(english == "%1 added" ? "%1 ajouté" : english);
        });
        QVERIFY(flightLogHtml(french).find("<bdi>late</bdi> ajouté") != std::string::npos);
    }

    void pageIsWellFormedAndWhole()
    {
        Scenario scenario = hostile();
        scenario.icebergs[2].name = "\xC2\x85 and \x7F"; // a mission refuses what is no UTF-8
        scenario.operation = Operation{};
        const Mission mission = flown(scenario);
        const std::string page = flightLogHtml(runContent(mission));
        QCOMPARE(xmlFault(bytes(page)), QString());
        const FlightLog log = flightLog(runContent(mission));
        QVERIFY(page.find(log.uavs.front().planHash) != std::string::npos);
        for (const char* part :
             {"Planned and flown", "Sightings", "Deviations", "Seed</span><br/><b>7</b>", "<svg"})
            QVERIFY2(page.find(part) != std::string::npos, part);
        QCOMPARE(flightLogHtml(runContent(mission)), page); // the same run, the same bytes
    }

    /** Wind 10 m/s from the west, freshening by 1 m/s and veering by 15 degrees an hour. */
    void forecastIsLogged()
    {
        QVERIFY(!flightLog(runContent(flown(fourIcebergs()))).forecast);
        QVERIFY(flightLogHtml(runContent(flown(fourIcebergs()))).find("<h2>Forecast") ==
                std::string::npos);
        Scenario scenario = fourIcebergs();
        scenario.wind_mps = {3, 0};
        scenario.duration_s = 3600;
        addForecast(scenario);
        const Mission mission = flown(scenario);
        const FlightLog log = flightLog(runContent(mission));
        QVERIFY(log.forecast);
        QCOMPARE(log.forecast->source, std::string("MET Norway"));
        QCOMPARE(log.forecast->issued_s, std::optional(-6 * 3600.0));
        QCOMPARE(log.forecast->ageAtTakeOff_h, std::optional(6.0));
        // The wind is constant for half a minute at a time, and 0.4 % stronger at the starts, which
        // are 0.5 km north of the middle of the grid.
        COMPARE_NEAR(log.forecast->start.wind_mps.norm(), 10, 0.06);
        COMPARE_NEAR(log.forecast->end.wind_mps.norm(), 11, 0.06);
        COMPARE_NEAR(log.forecast->end.current_mps.norm(), 0.5, 1e-9);
        QVERIFY(log.forecast->gaps.empty());
        const std::string page = flightLogHtml(runContent(mission));
        QCOMPARE(xmlFault(bytes(page)), QString());
        for (const char* part : {"<h2>Forecast</h2>", "MET Norway", "2026-05-01T06:00:00Z", "6.0 h",
                                 "m/s from 270°", "0.50 m/s towards 037°"})
            QVERIFY2(page.find(part) != std::string::npos, part);
    }

    void gapsOfTheForecastAreLogged()
    {
        Scenario scenario = fourIcebergs();
        scenario.wind_mps = {3, 0};
        scenario.current_mps = {0, 0.2};
        scenario.duration_s = 1200;
        addForecast(scenario, 12);
        cutForecast(*scenario.forecast, 0, 12); // 12 h are too long to interpolate
        const Mission mission = flown(scenario);
        const FlightLog log = flightLog(runContent(mission));
        QVERIFY(log.forecast);
        QCOMPARE(log.forecast->gaps.size(), std::size_t{2});
        QCOMPARE(log.forecast->gaps[0].quantity, ForecastQuantity::Wind);
        QCOMPARE(log.forecast->gaps[0].from_s, 60.0); // the first value itself is given
        QCOMPARE(log.forecast->gaps[0].to_s, 1200.0);
        QCOMPARE(log.forecast->gaps[1].quantity, ForecastQuantity::Current);
        COMPARE_NEAR(log.forecast->end.wind_mps.norm(), 3, 1e-9);
        COMPARE_NEAR(log.forecast->end.current_mps.norm(), 0.2, 1e-9);
        const std::string page = flightLogHtml(runContent(mission));
        for (const char* part : {"has no wind between", "has no current between"})
            QVERIFY2(page.find(part) != std::string::npos, part);
    }

    void planAloneHasNoLog()
    {
        const std::optional<Error> error =
            errorOf([] { (void)flightLog(planContent(fourIcebergs())); });
        QVERIFY(error && error->code() == ErrorCode::InvalidInput);
    }
};

QTEST_APPLESS_MAIN(TestFlightLog)
#include "tst_flight_log.moc"
