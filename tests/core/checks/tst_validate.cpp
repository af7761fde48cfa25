#include "core/checks/validate.h"
#include "core/presets/presets.h"
#include "tests/support/expect_error.h"
#include "tests/support/flight/random_scenario.h"

#include <QTest>

#include <functional>
#include <limits>

using namespace berg;
using namespace berg::test;

namespace {

using Change = std::function<void(Scenario&)>;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/** A change to a clean scenario and the one finding it must lead to. */
struct Case
{
    const char* name;
    Change change;
    Severity severity;
    const char* field;
};

Asset platform()
{
    Asset asset;
    asset.name = "Platform";
    return asset;
}

const std::vector<Case>& cases()
{
    constexpr Severity kError = Severity::Error;
    constexpr Severity kWarning = Severity::Warning;
    constexpr Severity kHint = Severity::Hint;
    using S = Scenario;
    static const std::vector<Case> all = {
        {"name no UTF-8", [](S& s) { s.name = std::string("\xFF"); }, kError, "name"},
        {"notes no UTF-8", [](S& s) { s.notes = std::string("\xC3"); }, kError, "notes"},
        {"latitude", [](S& s) { s.origin.latitude_deg = -90.5; }, kError, "origin.latitude_deg"},
        {"longitude", [](S& s) { s.origin.longitude_deg = 181; }, kError, "origin.longitude_deg"},
        {"longitude NaN", [](S& s) { s.origin.longitude_deg = kNan; }, kError,
         "origin.longitude_deg"},
        {"start without zone", [](S& s) { s.startUtc = "2024-05-01T06:00:00"; }, kError,
         "start_utc"},
        {"duration 0", [](S& s) { s.duration_s = 0; }, kError, "duration_s"},
        {"duration above a week", [](S& s) { s.duration_s = 604800.5; }, kError, "duration_s"},
        {"duration NaN", [](S& s) { s.duration_s = kNan; }, kError, "duration_s"},
        {"dt too small", [](S& s) { s.dt_s = 0.0099; }, kError, "dt_s"},
        {"dt too large", [](S& s) { s.dt_s = 1.01; }, kError, "dt_s"},
        {"dt above duration", [](S& s) { s.duration_s = 0.05; }, kError, "dt_s"},
        {"seed negative", [](S& s) { s.seed = -1; }, kError, "seed"},
        {"seed above 2^53", [](S& s) { s.seed = (std::int64_t{1} << 53) + 1; }, kError, "seed"},
        {"wind as fast as UAV",
         [](S& s) {
             s.wind_mps = {0, -22};
         },
         kError, "wind_mps"},
        {"wind infinite",
         [](S& s) {
             s.wind_mps = {kInfinity, 0};
         },
         kError, "wind_mps"},
        {"wind strong",
         [](S& s) {
             s.wind_mps = {0.7 * 22, 0};
         },
         kWarning, "wind_mps"},
        {"current",
         [](S& s) {
             s.current_mps = {0, 5.01};
         },
         kError, "current_mps[1]"},
        {"area of two points",
         [](S& s) {
             s.area_m = {{0, 0}, {1, 1}};
         },
         kError, "area_m"},
        {"no UAV", [](S& s) { s.uavs.clear(); }, kError, "uavs"},
        {"UAV without id", [](S& s) { s.uavs[0].id.clear(); }, kError, "uavs[0].id"},
        {"UAV id no UTF-8", [](S& s) { s.uavs[0].id = std::string("\x80"); }, kError, "uavs[0].id"},
        {"UAV name no UTF-8", [](S& s) { s.uavs[0].name = std::string("\x80"); }, kError,
         "uavs[0].name"},
        {"UAV far", [](S& s) { s.uavs[0].position_m.x() = 1.1e6; }, kError,
         "uavs[0].position_m[0]"},
        {"heading NaN", [](S& s) { s.uavs[0].heading_deg = kNan; }, kError, "uavs[0].heading_deg"},
        {"airspeed 0", [](S& s) { s.uavs[0].spec.airspeed_mps = 0; }, kError,
         "uavs[0].airspeed_mps"},
        {"airspeed below 1", [](S& s) { s.uavs[0].spec.airspeed_mps = 0.99; }, kError,
         "uavs[0].airspeed_mps"},
        {"airspeed above 1000", [](S& s) { s.uavs[0].spec.airspeed_mps = 1001; }, kError,
         "uavs[0].airspeed_mps"},
        {"field of view below 1", [](S& s) { s.uavs[0].fov_m.x() = 0.9; }, kError,
         "uavs[0].fov_m[0]"},
        {"altitude below 1", [](S& s) { s.uavs[0].spec.altitude_m = 1e-9; }, kError,
         "uavs[0].altitude_m"},
        {"endurance below 1", [](S& s) { s.uavs[0].spec.endurance_s = 1e-300; }, kError,
         "uavs[0].endurance_s"},
        {"bank below 1", [](S& s) { s.uavs[0].spec.maxBank_deg = 0.9; }, kError,
         "uavs[0].max_bank_deg"},
        {"bank above 80", [](S& s) { s.uavs[0].spec.maxBank_deg = 80.1; }, kError,
         "uavs[0].max_bank_deg"},
        {"field of view 0", [](S& s) { s.uavs[0].fov_m.y() = 0; }, kError, "uavs[0].fov_m[1]"},
        {"altitude 0", [](S& s) { s.uavs[0].spec.altitude_m = 0; }, kError, "uavs[0].altitude_m"},
        {"endurance negative", [](S& s) { s.uavs[0].spec.endurance_s = -1; }, kError,
         "uavs[0].endurance_s"},
        {"home far", [](S& s) { s.uavs[0].home_m = Point(0, -1.1e6); }, kError,
         "uavs[0].home_m[1]"},
        {"turn-around negative", [](S& s) { s.uavs[0].turnaround_s = -1; }, kError,
         "uavs[0].turnaround_s"},
        {"slow autopilot with endurance",
         [](S& s) {
             s.uavs[0].spec.endurance_s = 3600;
             s.uavs[0].spec.autopilot_s = 1.1;
         },
         kError, "uavs[0].autopilot_s"},
        {"geofence without area", [](S& s) { s.geofence = true; }, kError, "geofence"},
        {"UAV outside the geofence",
         [](S& s) {
             s.area_m = {{0, 0}, {6000, 0}, {6000, 6000}, {0, 6000}};
             s.geofence = true;
         },
         kError, "uavs[0].position_m"},
        {"home outside the geofence",
         [](S& s) {
             s.area_m = {{-1000, 0}, {6000, 0}, {6000, 6000}, {-1000, 6000}};
             s.geofence = true;
             s.uavs[0].home_m = Point(-500, -1);
         },
         kError, "uavs[0].home_m"},
        {"geofence of too many corners",
         [](S& s) {
             for (int i = 0; i < 201; ++i)
                 s.area_m.emplace_back(9000 * std::cos(i * 0.03), 9000 * std::sin(i * 0.03));
             s.geofence = true;
         },
         kError, "area_m"},
        {"UAV in a no-fly area",
         [](S& s) {
             const Point at_m = s.uavs[0].position_m;
             s.noFly = {
                 {.name = "rig",
                  .corners_m = {at_m + Point(-9, -9), at_m + Point(9, -9), at_m + Point(0, 9)}}};
         },
         kError, "uavs[0].position_m"},
        {"home in a stand-off ring",
         [](S& s) {
             s.asset = Asset{.position_m = {5000, 5000}, .standoff_m = 300};
             s.uavs[0].home_m = Point(5200, 5100);
         },
         kError, "uavs[0].home_m"},
        {"no-fly areas of too many corners",
         [](S& s) {
             for (int k = 0; k < 51; ++k)
                 s.noFly.push_back({.corners_m = {{1e5 + 100 * k, 0},
                                                  {1e5 + 100 * k, 50},
                                                  {1e5 + 100 * k + 50, 50},
                                                  {1e5 + 100 * k + 50, 0}}});
         },
         kError, "no_fly"},
        {"no iceberg", [](S& s) { s.icebergs.clear(); }, kHint, "icebergs"},
        {"too many icebergs", [](S& s) { s.icebergs.resize(1001); }, kError, "icebergs"},
        {"iceberg without id", [](S& s) { s.icebergs[2].id.clear(); }, kError, "icebergs[2].id"},
        {"id twice", [](S& s) { s.icebergs[3].id = s.icebergs[1].id; }, kError, "icebergs[3].id"},
        {"id of a UAV", [](S& s) { s.icebergs[0].id = std::string("uav-1"); }, kError,
         "icebergs[0].id"},
        {"iceberg name no UTF-8", [](S& s) { s.icebergs[0].name = std::string("\xED\xA0\x80"); },
         kError, "icebergs[0].name"},
        {"iceberg far", [](S& s) { s.icebergs[0].position_m.y() = -1.1e6; }, kError,
         "icebergs[0].position_m[1]"},
        {"iceberg nowhere", [](S& s) { s.icebergs[0].position_m.x() = kNan; }, kError,
         "icebergs[0].position_m[0]"},
        {"iceberg fast", [](S& s) { s.icebergs[1].velocity_mps.x() = -5.1; }, kError,
         "icebergs[1].velocity_mps[0]"},
        {"q negative", [](S& s) { s.icebergs[0].q_m2ps = -1e-9; }, kError, "icebergs[0].q_m2ps"},
        {"sigma negative", [](S& s) { s.icebergs[0].sigma0_m2 = -1; }, kError,
         "icebergs[0].sigma0_m2"},
        {"sigma infinite", [](S& s) { s.icebergs[0].sigma0_m2 = kInfinity; }, kError,
         "icebergs[0].sigma0_m2"},
        {"observed negative", [](S& s) { s.icebergs[0].observed_s = -1; }, kError,
         "icebergs[0].observed_s"},
        {"appears negative", [](S& s) { s.icebergs[0].appears_s = -1; }, kError,
         "icebergs[0].appears_s"},
        {"appears after the end", [](S& s) { s.icebergs[4].appears_s = 1000.5; }, kHint,
         "icebergs[4].appears_s"},
        {"UAV of an iceberg unknown", [](S& s) { s.icebergs[0].uav = "uav-9"; }, kError,
         "icebergs[0].uav"},
        {"UAV of an iceberg an iceberg", [](S& s) { s.icebergs[0].uav = s.icebergs[1].id; }, kError,
         "icebergs[0].uav"},
        {"UAV of an iceberg no UTF-8", [](S& s) { s.icebergs[0].uav = "\xFF"; }, kError,
         "icebergs[0].uav"},
        {"separation negative", [](S& s) { s.separation_m = -1; }, kError, "separation_m"},
        {"separation NaN", [](S& s) { s.separation_m = kNan; }, kError, "separation_m"},
        {"radius negative", [](S& s) { s.icebergs[0].radius_m = -1; }, kError,
         "icebergs[0].radius_m"},
        {"iceberg runs away",
         [](S& s) {
             s.uavs[0].spec.airspeed_mps = 4;
             s.uavs[0].position_m = {-900, 0};
             s.icebergs.resize(1);
             s.icebergs[0].position_m = {0, 0};
             s.icebergs[0].velocity_mps = {-1.6, 0};
             s.wind_mps = {2.5, 0};
         },
         kWarning, "icebergs[0].velocity_mps"},
        {"tau negative", [](S& s) { s.planner.tau = -0.1; }, kError, "planner.tau"},
        {"tau above 100", [](S& s) { s.planner.tau = 100.1; }, kError, "planner.tau"},
        {"tau NaN", [](S& s) { s.planner.tau = kNan; }, kError, "planner.tau"},
        {"reach 0", [](S& s) { s.reachRadius_m = 0; }, kError, "planner.reach_radius_m"},
    };
    return all;
}

std::vector<Issue> errorsOf(const Scenario& scenario)
{
    std::vector<Issue> issues = validate(scenario);
    std::erase_if(issues, [](const Issue& issue) { return issue.severity != Severity::Error; });
    return issues;
}

} // namespace

class TestValidate : public QObject
{
    Q_OBJECT

private slots:
    void presetsAreClean()
    {
        QVERIFY(validate(defaultScenario()).empty());
        for (std::int64_t seed = 0; seed < 50; ++seed)
            QVERIFY(validate(randomScenario(seed)).empty());
    }

    void faultGivesExactlyOneFinding_data()
    {
        QTest::addColumn<int>("row");
        for (std::size_t i = 0; i < cases().size(); ++i)
            QTest::newRow(cases()[i].name) << static_cast<int>(i);
    }
    void faultGivesExactlyOneFinding()
    {
        QFETCH(const int, row);
        const Case& expected = cases()[static_cast<std::size_t>(row)];
        Scenario scenario = defaultScenario();
        expected.change(scenario);
        const std::vector<Issue> issues = validate(scenario);
        QCOMPARE(issues.size(), std::size_t{1});
        QCOMPARE(issues[0].field, std::string(expected.field));
        QVERIFY(issues[0].severity == expected.severity);
        QVERIFY(!issues[0].message().empty());
    }

    void assetFaults_data()
    {
        QTest::addColumn<double>("range_m");
        QTest::addColumn<double>("gain");
        QTest::addColumn<QString>("field");
        QTest::newRow("range 0") << 0.0 << 5.0 << "asset.range_m";
        QTest::newRow("range infinite") << kInfinity << 5.0 << "asset.range_m";
        QTest::newRow("gain negative") << 1.0 << -0.5 << "asset.gain";
        QTest::newRow("gain NaN") << 1.0 << kNan << "asset.gain";
    }
    void assetFaults()
    {
        QFETCH(const double, range_m);
        QFETCH(const double, gain);
        QFETCH(const QString, field);
        Scenario scenario = defaultScenario();
        scenario.asset = platform();
        scenario.asset->range_m = range_m;
        scenario.asset->gain = gain;
        const std::vector<Issue> errors = errorsOf(scenario);
        QCOMPARE(errors.size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(errors[0].field), field);
    }

    void areaFaults_data()
    {
        QTest::addColumn<QList<QPointF>>("corners");
        QTest::addColumn<QString>("field");
        QTest::newRow("crossing") << QList<QPointF>{{0, 0}, {9, 9}, {9, 0}, {0, 9}} << "area_m";
        QTest::newRow("on a line") << QList<QPointF>{{0, 0}, {9, 0}, {18, 0}} << "area_m";
        QTest::newRow("a corner twice")
            << QList<QPointF>{{0, 0}, {9, 0}, {9, 0}, {0, 9}} << "area_m";
        QTest::newRow("far") << QList<QPointF>{{0, 0}, {2e6, 0}, {0, 9}} << "area_m[1][0]";
        QTest::newRow("nowhere") << QList<QPointF>{{0, 0}, {9, 0}, {0, kNan}} << "area_m[2][1]";
    }
    void areaFaults()
    {
        QFETCH(const QList<QPointF>, corners);
        QFETCH(const QString, field);
        Scenario scenario = defaultScenario();
        for (const QPointF& corner : corners)
            scenario.area_m.emplace_back(corner.x(), corner.y());
        const std::vector<Issue> errors = errorsOf(scenario);
        QCOMPARE(errors.size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(errors[0].field), field);
    }

    void endsOfRangesAreAllowed()
    {
        Scenario s = defaultScenario();
        s.origin = {.latitude_deg = -90, .longitude_deg = 180};
        s.duration_s = 604800;
        s.dt_s = 1;
        s.seed = std::int64_t{1} << 53;
        s.wind_mps = {0, 21.999};
        s.current_mps = {-5, 5};
        s.uavs[0].position_m = {1e6, -1e6};
        s.uavs[0].heading_deg = -1e6;
        s.uavs[0].spec.maxBank_deg = 80;
        s.icebergs[0].position_m = {-1e6, 1e6};
        s.icebergs[0].velocity_mps = {5, -5};
        s.icebergs[0].q_m2ps = 0;
        s.icebergs[0].sigma0_m2 = 0;
        s.icebergs[0].radius_m = 0;
        s.planner.tau = 100;
        QVERIFY(errorsOf(s).empty());
        s.dt_s = 0.01;
        s.duration_s = 0.01;
        s.seed = 0;
        s.planner.tau = 0;
        s.uavs[0].spec.maxBank_deg = 1;
        QVERIFY(errorsOf(s).empty());
    }

    void everyFaultIsReported()
    {
        Scenario s = defaultScenario();
        s.duration_s = -1;
        s.uavs[0].spec.airspeed_mps = kNan;
        s.icebergs[0].q_m2ps = -1;
        s.icebergs[11].velocity_mps = {6, 7};
        s.planner.tau = 1000;
        const std::vector<Issue> errors = errorsOf(s);
        QCOMPARE(errors.size(), std::size_t{6});
        for (const char* field :
             {"duration_s", "uavs[0].airspeed_mps", "icebergs[0].q_m2ps",
              "icebergs[11].velocity_mps[0]", "icebergs[11].velocity_mps[1]", "planner.tau"})
            QVERIFY2(names(errors, field), field);
    }

    void windIsComparedWithTheSlowestUav()
    {
        Scenario s = defaultScenario();
        s.uavs.push_back(s.uavs[0]);
        s.uavs[1].id = "slow";
        s.uavs[1].spec.airspeed_mps = 12;
        s.wind_mps = {0, 13};
        const std::vector<Issue> errors = errorsOf(s);
        QCOMPARE(errors.size(), std::size_t{1});
        QVERIFY(errors[0].message().find("slow") != std::string::npos);
    }

    void fieldsThatDoNotFitAreReadable_data()
    {
        QTest::addColumn<Change>("change");
        const auto row = [](const char* name, const Change& change) {
            QTest::newRow(name) << change;
        };
        row("step longer than the run", [](Scenario& s) { s.duration_s = s.dt_s / 2; });
        row("hardly any airspeed", [](Scenario& s) { s.uavs[0].spec.airspeed_mps = 0.01; });
        row("crossing area", [](Scenario& s) {
            s.area_m = {{0, 0}, {1000, 1000}, {1000, 0}, {0, 1000}};
        });
        row("geofence without area", [](Scenario& s) { s.geofence = true; });
        row("UAV outside the geofence", [](Scenario& s) {
            s.area_m = {{5000, 0}, {6000, 0}, {6000, 1000}};
            s.geofence = true;
        });
        row("slow autopilot with endurance", [](Scenario& s) {
            s.uavs[0].spec.endurance_s = 1000;
            s.uavs[0].spec.autopilot_s = 10;
        });
        row("iceberg assigned to nobody", [](Scenario& s) { s.icebergs[0].uav = "nobody"; });
        row("wind", [](Scenario& s) { s.wind_mps = {50, 0}; });
        row("interval", [](Scenario& s) {
            s.observer.model = ObserverModel::Kalman;
            s.observer.interval_s = s.dt_s / 2;
        });
    }

    void fieldsThatDoNotFitAreReadable()
    {
        QFETCH(Change, change);
        Scenario scenario = randomScenario(1);
        change(scenario);
        QVERIFY(hasErrors(validate(scenario)));
        QCOMPARE(unreadable(scenario), std::vector<Issue>());
        scenario.icebergs[0].q_m2ps = -1;
        QCOMPARE(unreadable(scenario).size(), 1U);
    }

    void airspaceEndsAfterItBegins()
    {
        Scenario scenario = defaultScenario();
        scenario.airspace = {{.name = "West",
                              .kind = "TRA",
                              .corners_m = {{0, 0}, {500, 0}, {500, 500}},
                              .floor_m = 9000,
                              .fromUtc = "2026-05-01T06:00:30Z",
                              .untilUtc = "2026-05-01T06:00Z"}};
        const std::vector<Issue> issues = validate(scenario);
        QCOMPARE(issues.size(), std::size_t{1});
        QCOMPARE(issues[0].field, std::string("airspace[0].until_utc"));
        QCOMPARE(issues[0].message(),
                 std::string("the airspace \"TRA West\" ends before it begins"));
        QVERIFY(issues[0].severity == Severity::Error);
        QVERIFY(unreadable(scenario).empty());
        for (const char* until : {"2026-05-01T06:00:30Z", ""}) {
            scenario.airspace[0].untilUtc = until;
            QVERIFY(validate(scenario).empty());
        }
    }

    void iceChartsAreLimited()
    {
        Scenario s = defaultScenario();
        const IceArea area{.concentration_tenths = 5, .outlines_m = {{{0, 0}, {9, 0}, {0, 9}}}};
        s.iceChart = IceChart{.areas = {area}};
        QVERIFY(validate(s).empty());
        const auto faultOf = [](IceArea faulty) {
            Scenario wrong = defaultScenario();
            wrong.iceChart = IceChart{.areas = {std::move(faulty)}};
            const std::vector<Issue> issues = validate(wrong);
            return issues.size() == 1 ? issues[0].field : std::to_string(issues.size());
        };
        QCOMPARE(faultOf({.concentration_tenths = 11, .outlines_m = area.outlines_m}),
                 std::string("ice_chart.areas[0].concentration_tenths"));
        QCOMPARE(faultOf({}), std::string("ice_chart.areas[0].outlines_m"));
        QCOMPARE(faultOf({.outlines_m = {{{0, 0}, {9, 0}}}}),
                 std::string("ice_chart.areas[0].outlines_m[0]"));
        QVERIFY(faultOf({.outlines_m = {{{0, 0}, {2e6, 0}, {0, 9}}}})
                    .starts_with("ice_chart.areas[0].outlines_m[0][1]"));
        QCOMPARE(faultOf({.outlines_m = {std::vector<Point>(kMostIceCorners + 1, Point(1, 1))}}),
                 std::string("ice_chart.areas"));
        s.iceChart->areas.resize(kMostIceAreas + 1, area);
        QCOMPARE(validate(s).size(), 1U);
        s.iceChart->areas.resize(1);
        s.iceChart->dateUtc = "yesterday";
        QCOMPARE(validate(s).front().field, std::string("ice_chart.date_utc"));
    }

    void oldIceChartsAreReported()
    {
        Scenario s = defaultScenario();
        s.startUtc = "2021-01-20T18:00:00Z";
        s.iceChart = IceChart{.dateUtc = "2021-01-18T18:00:00Z"};
        QVERIFY(validate(s).empty());
        s.iceChart->dateUtc = "2021-01-18T16:30:00Z";
        const std::vector<Issue> issues = validate(s);
        QCOMPARE(issues.size(), 1U);
        QVERIFY(issues[0].severity == Severity::Hint);
        QCOMPARE(issues[0].message(), std::string("the ice chart is 49 hours older than the start: "
                                                  "ice has moved since"));
        s.startUtc.clear();
        QVERIFY(validate(s).empty());
    }

    void hugeListsAreCountedNotChecked()
    {
        Scenario s = defaultScenario();
        s.icebergs.resize(1'000'000); // a distance matrix of these would need 8 TB
        s.uavs.resize(100'000);
        for (int i = 0; i < 100'000; ++i)
            s.area_m.emplace_back(std::cos(i * 6e-5), std::sin(i * 6e-5));
        const std::vector<Issue> errors = errorsOf(s);
        QCOMPARE(errors.size(), std::size_t{3});
        for (const char* field : {"icebergs", "uavs", "area_m"})
            QVERIFY2(names(errors, field), field);
    }

    void anyScenarioHasNoErrors()
    {
        AnyScenario any(1);
        for (int i = 0; i < 300; ++i) {
            const std::vector<Issue> errors = errorsOf(any.draw());
            QVERIFY2(errors.empty(), errors.empty() ? "" : errors[0].field.c_str());
        }
    }
};

QTEST_APPLESS_MAIN(TestValidate)
#include "tst_validate.moc"
