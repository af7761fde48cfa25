#include "core/checks/scenario_warnings.h"
#include "core/checks/validate.h"
#include "core/presets/presets.h"
#include "tests/support/flight/random_scenario.h"
#include "tests/support/flight/scenario_builder.h"

#include <QTest>

#include <functional>

using namespace berg;
using namespace berg::test;

namespace {

using Change = std::function<void(Scenario&)>;

/** A change that causes exactly one finding, and a smaller one that causes none. */
struct Case
{
    const char* name;
    Change change;
    Severity severity;
    const char* field;
    IssueId id;
    Change harmless;
};

/** Two icebergs ahead of the UAV, half a kilometre and two away; 1000 s. */
Scenario calmSea()
{
    Scenario s = emptySea();
    addIceberg(s, 500, 0);
    addIceberg(s, 2000, 1000);
    return s;
}

std::vector<Point> square(double half_m)
{
    return {{-half_m, -half_m}, {half_m, -half_m}, {half_m, half_m}, {-half_m, half_m}};
}

Iceberg& tracked(Scenario& s, double begin_m, double end_s)
{
    s.icebergs[0].track.time_s = {0, end_s};
    s.icebergs[0].track.position_m = {{500, begin_m}, {500, begin_m}};
    return s.icebergs[0];
}

/** Adds a UAV like the first, `ahead_m` ahead and `above_m` higher. */
Uav& addUav(Scenario& s, double ahead_m, double above_m)
{
    Uav uav = s.uavs[0];
    uav.id = "uav-2";
    uav.position_m.x() += ahead_m;
    uav.spec.altitude_m += above_m;
    return s.uavs.emplace_back(uav);
}

void addManyIcebergs(Scenario& s, int count)
{
    while (static_cast<int>(s.icebergs.size()) < count)
        addIceberg(s, 10.0 * static_cast<double>(s.icebergs.size()), 300);
}

const std::vector<Case>& cases()
{
    constexpr Severity kWarning = Severity::Warning;
    constexpr Severity kHint = Severity::Hint;
    using S = Scenario;
    static const std::vector<Case> all = {
        {"unknown member", [](S& s) { s.icebergs[1].extraJson = R"({"shape":"tabular"})"; }, kHint,
         "", IssueId::UnknownMembers, [](S& s) { s.icebergs[1].name = "tabular"; }},
        {"one altitude layer", [](S& s) { addUav(s, 199, 29); }, kHint, "uavs[1].altitude_m",
         IssueId::SameLayer, [](S& s) { addUav(s, 199, 30); }},
        {"one altitude layer, far apart",
         [](S& s) {
             addUav(s, 300, 0);
             s.separation_m = 301;
         },
         kHint, "uavs[1].altitude_m", IssueId::SameLayer, [](S& s) { addUav(s, 201, 0); }},
        {"one altitude layer, at one place", [](S& s) { addUav(s, 0, 0); }, kWarning,
         "uavs[1].altitude_m", IssueId::SameLayer,
         [](S& s) {
             addUav(s, 0, 0);
             s.separation_m = 0;
         }},
        {"wide turn of the second UAV",
         [](S& s) {
             addUav(s, 1000, 0).fov_m = {600, 200};
         },
         kHint, "uavs[1].fov_m", IssueId::WideTurn, [](S& s) { addUav(s, 1000, 0); }},
        {"home of the second UAV without endurance",
         [](S& s) { addUav(s, 1000, 0).home_m = Point(0, 0); }, kHint, "uavs[1].home_m",
         IssueId::HomeUnused, [](S& s) { addUav(s, 1000, 0); }},
        {"second UAV cannot come home", [](S& s) { addUav(s, 40000, 0).spec.endurance_s = 600; },
         kWarning, "uavs[1].endurance_s", IssueId::NoRoundTrip,
         [](S& s) { addUav(s, 3000, 0).spec.endurance_s = 600; }},
        // 20 km from the first UAV, 2 from the second.
        {"out of reach of the UAV that is to visit it",
         [](S& s) {
             addUav(s, 25000, 0);
             s.icebergs[1].position_m = {23000, 0};
             s.icebergs[1].uav = s.uavs[0].id;
         },
         kWarning, "icebergs[1].position_m", IssueId::OutOfReach,
         [](S& s) {
             addUav(s, 25000, 0);
             s.icebergs[1].position_m = {23000, 0};
         }},
        {"home without endurance", [](S& s) { s.uavs[0].home_m = Point(100, 0); }, kHint,
         "uavs[0].home_m", IssueId::HomeUnused,
         [](S& s) {
             s.uavs[0].home_m = Point(100, 0);
             s.uavs[0].spec.endurance_s = 900;
         }},
        {"wide turn",
         [](S& s) {
             s.uavs[0].fov_m = {600, 200}; // the turn radius is 105.8 m
         },
         kHint, "uavs[0].fov_m", IssueId::WideTurn,
         [](S& s) {
             s.uavs[0].fov_m = {600, 220};
         }},
        {"reach inside turn", [](S& s) { s.reachRadius_m = 100; }, kHint, "planner.reach_radius_m",
         IssueId::ReachInsideTurn, [](S& s) { s.reachRadius_m = 110; }},
        {"clusters of a fixed route",
         [](S& s) {
             s.clusters = true;
             s.planner.policy = PolicyKind::Tour;
         },
         kHint, "planner.clusters", IssueId::ClustersIgnored,
         [](S& s) {
             s.clusters = true;
             s.planner.policy = PolicyKind::Latency;
         }},
        {"one iceberg twice", [](S& s) { addIceberg(s, 500.5, 0.5); }, kWarning,
         "icebergs[2].position_m", IssueId::SamePlace, [](S& s) { addIceberg(s, 501.1, 0); }},
        // 22 km straight on and the half diagonal of the field of view, 424 m.
        {"out of reach",
         [](S& s) {
             s.icebergs[1].position_m = {22430, 0};
         },
         kWarning, "icebergs[1].position_m", IssueId::OutOfReach,
         [](S& s) {
             s.icebergs[1].position_m = {22420, 0};
         }},
        {"out of reach by wind",
         [](S& s) {
             s.icebergs[1].position_m = {15000, 0};
             s.wind_mps = {-10, 0};
         },
         kWarning, "icebergs[1].position_m", IssueId::OutOfReach,
         [](S& s) {
             s.icebergs[1].position_m = {15000, 0};
             s.wind_mps = {10, 0};
         }},
        {"out of reach by current",
         [](S& s) {
             s.icebergs[1].position_m = {22400, 0};
             s.icebergs[1].appears_s = 900; // too late to have drifted
             s.icebergs[1].position_m.x() = 22500;
             s.current_mps = {0.5, 0};
         },
         kWarning, "icebergs[1].position_m", IssueId::OutOfReach,
         [](S& s) {
             s.icebergs[1].position_m = {22500, 0};
             s.current_mps = {-0.5, 0};
         }},
        {"too short", [](S& s) { s.duration_s = 3; }, kWarning, "duration_s", IssueId::TooShort,
         [](S& s) {
             s.duration_s = 100;
             s.icebergs.resize(1);
         }},
        {"fast",
         [](S& s) {
             s.icebergs[0].velocity_mps = {1.5, 1.5};
         },
         kHint, "icebergs[0].velocity_mps", IssueId::Fast,
         [](S& s) {
             s.icebergs[0].velocity_mps = {1.4, 1.4};
         }},
        {"reached unseen",
         [](S& s) {
             s.uavs[0].fov_m = {800, 600};
             s.reachRadius_m = 301;
         },
         kWarning, "planner.reach_radius_m", IssueId::ReachBeyondView,
         [](S& s) {
             s.uavs[0].fov_m = {800, 600};
             s.reachRadius_m = 300;
         }},
        {"track short", [](S& s) { tracked(s, 0, 999); }, kHint, "icebergs[0].track",
         IssueId::TrackShort, [](S& s) { tracked(s, 0, 1000); }},
        {"track far", [](S& s) { tracked(s, 430, 1000); }, kWarning, "icebergs[0].track",
         IssueId::TrackFar, [](S& s) { tracked(s, 420, 1000); }},
        {"nothing uncertain",
         [](S& s) {
             s.icebergs[0].sigma0_m2 = 0;
             s.icebergs[1].sigma0_m2 = 0;
         },
         kHint, "icebergs", IssueId::NoSigma,
         [](S& s) {
             s.icebergs[0].sigma0_m2 = 0;
             s.icebergs[1].sigma0_m2 = 0;
             s.icebergs[1].observed_s = 60;
         }},
        {"beyond proof", [](S& s) { addManyIcebergs(s, 128); }, kHint, "icebergs",
         IssueId::BeyondProof, [](S& s) { addManyIcebergs(s, 127); }},
        {"beyond the solver",
         [](S& s) {
             addManyIcebergs(s, 128);
             s.planner.backend = Backend::Exact;
         },
         kWarning, "planner.backend", IssueId::SolverUnable,
         [](S& s) {
             addManyIcebergs(s, 128);
             s.planner.backend = Backend::Exact;
             s.planner.tau = 0;
         }},
        {"long proof",
         [](S& s) {
             addManyIcebergs(s, 81);
             s.planner.backend = Backend::Exact;
         },
         kHint, "planner.backend", IssueId::LongProof,
         [](S& s) {
             addManyIcebergs(s, 80);
             s.planner.backend = Backend::Exact;
         }},
    };
    return all;
}

/** Returns the findings other than the hint that the area is no fence. */
std::vector<Issue> adviceInArea(Scenario scenario, double half_m)
{
    scenario.area_m = square(half_m);
    std::vector<Issue> issues = validate(scenario);
    const auto isUse = [](const Issue& issue) { return issue.reason.id == IssueId::AreaNoFence; };
    return std::erase_if(issues, isUse) == 1 ? issues : std::vector<Issue>{};
}

bool isOne(const std::vector<Issue>& issues, const Issue& expected)
{
    return issues == std::vector<Issue>{expected};
}

} // namespace

class TestAdvice : public QObject
{
    Q_OBJECT

private slots:
    void calmSeaNeedsNone() { QVERIFY(validate(calmSea()).empty()); }

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
        Scenario scenario = calmSea();
        expected.change(scenario);
        const std::vector<Issue> issues = validate(scenario);
        QCOMPARE(issues.size(), std::size_t{1});
        QCOMPARE(issues[0].field, std::string(expected.field));
        QVERIFY(issues[0].severity == expected.severity && issues[0].reason.id == expected.id);

        Scenario slighter = calmSea();
        expected.harmless(slighter);
        for (const Issue& issue : validate(slighter))
            QVERIFY2(issue.reason.id != expected.id, issue.field.c_str());
    }

    /** The reserve must cover 55 s for each other UAV of the layer. */
    void reserveForWaiting()
    {
        Scenario s = calmSea();
        addUav(s, 1000, 0).spec.endurance_s = 1000;
        s.uavs[1].spec.reserve_s = 54;
        QVERIFY(isOne(validate(s), Issue{Severity::Warning,
                                         "uavs[1].endurance_s",
                                         {.id = IssueId::CrowdedReturn,
                                          .arguments = {Amount{55, Quantity::Seconds}}}}));
        Scenario enough = s;
        enough.uavs[1].spec.reserve_s = 55;
        QVERIFY(validate(enough).empty());
        Scenario layered = s;
        layered.uavs[1].spec.altitude_m += kLayerHeight_m;
        QVERIFY(validate(layered).empty());
        Scenario free = s;
        free.separation_m = 0;
        QVERIFY(validate(free).empty());
    }

    void icebergsOutsideTheAreaAreReported()
    {
        Scenario s = calmSea();
        QVERIFY(adviceInArea(s, 2100).empty());
        QVERIFY(isOne(
            adviceInArea(s, 1900),
            Issue{Severity::Warning, "icebergs[1].position_m", {.id = IssueId::OutsideArea}}));
        s.icebergs[1].velocity_mps = {0.2, 0}; // 200 m in 1000 s
        QVERIFY(
            isOne(adviceInArea(s, 2100),
                  Issue{Severity::Hint, "icebergs[1].velocity_mps", {.id = IssueId::LeavesArea}}));
        s.icebergs[1].appears_s = 600; // 120 m on
        QVERIFY(isOne(
            adviceInArea(s, 2100),
            Issue{Severity::Warning, "icebergs[1].position_m", {.id = IssueId::OutsideArea}}));
        QVERIFY(adviceInArea(s, 2250).empty());
        s.current_mps = {0.2, 0};
        QVERIFY(
            isOne(adviceInArea(s, 2250),
                  Issue{Severity::Hint, "icebergs[1].velocity_mps", {.id = IssueId::LeavesArea}}));
        s.icebergs[1].appears_s = 1001; // after the end of the run
        QVERIFY(!adviceInArea(s, 2100).empty());
        for (const Issue& issue : adviceInArea(s, 2100))
            QVERIFY(issue.reason.id != IssueId::LeavesArea);
        s = calmSea();
        s.uavs[0].position_m = {0, -3000};
        QVERIFY(isOne(adviceInArea(s, 2100),
                      Issue{Severity::Hint, "uavs[0].position_m", {.id = IssueId::UavOutside}}));
    }

    void wayBackIsCounted()
    {
        Scenario s = calmSea();
        s.icebergs[0].position_m = {2624, 0}; // 2200 m to its sight: 100 s there, 100 s back
        s.icebergs[1].position_m = {5000, 0};
        const auto refused = [&](double endurance_s) {
            s.uavs[0].spec.endurance_s = endurance_s;
            s.uavs[0].spec.reservePercent = 0;
            for (const Issue& issue : validate(s))
                if (issue.reason.id == IssueId::NoRoundTrip)
                    return issue.severity == Severity::Warning;
            return false;
        };
        QVERIFY(refused(199));
        QVERIFY(!refused(201));
    }

    void wayHomeIsCounted()
    {
        Scenario s = calmSea();
        s.uavs[0].home_m = Point(-4400, 0); // 200 s, turn and reserve besides
        const auto warned = [&](double endurance_s) {
            s.uavs[0].spec.endurance_s = endurance_s;
            s.uavs[0].spec.reservePercent = 0;
            const std::vector<Issue> issues = validate(s);
            return std::any_of(issues.begin(), issues.end(), [](const Issue& issue) {
                return issue.reason.id == IssueId::NoPathHome &&
                       issue.severity == Severity::Warning && issue.field == "uavs[0].endurance_s";
            });
        };
        QVERIFY(warned(205));
        QVERIFY(!warned(240));
    }

    void roomBesideNoFlyAreas()
    {
        Scenario s = calmSea();
        s.noFly = {{.corners_m = {{-1000, 50}, {1000, 50}, {1000, 1100}, {-1000, 1100}}}};
        s.uavs[0].heading_deg = 90; // along it
        s.icebergs[1].position_m = {2000, -500};
        QVERIFY(validate(s).empty());
        s.uavs[0].heading_deg = 0;
        QVERIFY(
            isOne(validate(s),
                  Issue{Severity::Warning, "uavs[0].position_m", {.id = IssueId::StartNearFence}}));
        s.noFly[0].ceiling_m = s.uavs[0].spec.altitude_m - 1;
        QVERIFY(validate(s).empty());
        s.noFly[0].ceiling_m.reset();
        s.uavs[0].heading_deg = 90;
        s.icebergs[0].position_m = {500, 200}; // seen from outside
        QVERIFY(validate(s).empty());
        s.icebergs[0].position_m = {500, 500};
        QVERIFY(
            isOne(validate(s),
                  Issue{Severity::Warning, "icebergs[0].position_m", {.id = IssueId::ShutOff}}));
        s.icebergs[0].position_m = {500, 0};
        s.planner.policy = PolicyKind::Coverage;
        QVERIFY(
            isOne(validate(s), Issue{Severity::Hint, "no_fly", {.id = IssueId::FenceUnplanned}}));
        s.noFly.clear();
        s.asset = Asset{.position_m = {0, 2000}, .standoff_m = 500};
        QVERIFY(isOne(validate(s),
                      Issue{Severity::Hint, "asset.standoff_m", {.id = IssueId::FenceUnplanned}}));
    }

    void roomInsideTheGeofence()
    {
        Scenario s = calmSea();
        s.area_m = square(2500);
        s.geofence = true;
        QVERIFY(validate(s).empty());
        s.uavs[0].position_m = {2450, 0};
        s.uavs[0].heading_deg = 90;
        QVERIFY(
            isOne(validate(s),
                  Issue{Severity::Warning, "uavs[0].position_m", {.id = IssueId::StartNearFence}}));
        s.uavs[0].heading_deg = 0; // along the fence
        QVERIFY(validate(s).empty());
        s.uavs[0].spec.endurance_s = 900;
        QVERIFY(validate(s).empty());             // it turns inwards and comes back
        s.uavs[0].home_m = Point(2499.5, 2499.5); // no path comes so near the fence
        const std::vector<Issue> atHome = validate(s);
        QCOMPARE(atHome.size(), std::size_t{2});
        QVERIFY((atHome[0] ==
                 Issue{Severity::Warning, "uavs[0].position_m", {.id = IssueId::NoSafeReturn}}));
        QVERIFY((atHome[1] ==
                 Issue{Severity::Warning, "uavs[0].home_m", {.id = IssueId::HomeNearFence}}));
        s.uavs[0].home_m = Point(0, 0);
        QVERIFY(validate(s).empty());
        s.planner.policy = PolicyKind::Coverage;
        QVERIFY(
            isOne(validate(s), Issue{Severity::Hint, "geofence", {.id = IssueId::FenceUnplanned}}));
        s.planner.policy = PolicyKind::Visitation;
        s.icebergs[1].position_m = {2490, 1000};
        QVERIFY(validate(s).empty()); // seen from afar
        s.reachRadius_m = 50;
        const std::vector<Issue> issues = validate(s);
        QVERIFY(std::ranges::find(issues, Issue{Severity::Warning,
                                                "icebergs[1].position_m",
                                                {.id = IssueId::ShutOff}}) != issues.end());
    }

    /** The estimate drifts from time 0 on: where the iceberg appears is not where it is given. */
    void icebergsThatAppearOutsideTheArea()
    {
        Scenario s = calmSea();
        s.duration_s = 3600;
        s.area_m = square(2500);
        s.icebergs.resize(1);
        s.icebergs[0].position_m = {1500, 0};
        s.icebergs[0].velocity_mps = {0.5, 0};
        s.icebergs[0].appears_s = 3000;
        const Issue outside =
            Issue{Severity::Warning, "icebergs[0].position_m", {.id = IssueId::OutsideArea}};
        const std::vector<Issue> late = validate(s);
        QVERIFY(std::ranges::find(late, outside) != late.end());
        s.icebergs[0].appears_s = 0;
        const std::vector<Issue> early = validate(s);
        QVERIFY(std::ranges::find(early, outside) == early.end());
    }

    void assetInIce()
    {
        Scenario s = calmSea();
        s.asset = Asset{};
        s.asset->position_m = {549, 0}; // the radius is 50 m
        QCOMPARE(validate(s).size(), std::size_t{1});
        QCOMPARE(validate(s)[0].field, std::string("asset.position_m"));
        s.asset->position_m = {551, 0};
        QCOMPARE(validate(s).size(), std::size_t{0});
    }

    /** It may be a slip of the pen. */
    void unknownMembersAreNamed()
    {
        Scenario s = calmSea();
        s.uavs[0].extraJson = R"({"airspeed_mp":20,"colour":"red"})";
        QCOMPARE(validate(s).size(), std::size_t{1});
        QVERIFY(validate(s)[0].message().find("\"airspeed_mp\"") != std::string::npos);
    }

    void errorsComeFirst()
    {
        Scenario s = calmSea();
        s.icebergs[0].velocity_mps = {4, 0};
        s.icebergs[1].q_m2ps = -1;
        QCOMPARE(validate(s).size(), std::size_t{1});
        QVERIFY(hasErrors(validate(s)));
    }

    /** Whatever is valid can be advised on, and never gets an error for it. */
    void anyScenarioCanBeAdvised()
    {
        AnyScenario any(3);
        for (int i = 0; i < 300; ++i)
            QVERIFY(!hasErrors(scenarioWarnings(any.draw())));
    }
};

QTEST_APPLESS_MAIN(TestAdvice)
#include "tst_scenario_warnings.moc"
