#include "core/io/export/mission_checks.h"
#include "tests/support/flight/mission_builder.h"

#include <QTest>

using namespace berg;
using namespace berg::test;

namespace {

/** Returns the ids of the findings, in their order. */
QString findings(const Scenario& scenario, const ExportOptions& options = {})
{
    QStringList ids;
    for (const ExportNote& note : missionChecks(planContent(scenario, fourIcebergPlan(), options)))
        ids << QString::fromLatin1(note.id.data(), qsizetype(note.id.size()));
    return ids.join(u' ');
}

/** Returns the finding of this kind; the scenario must have it. */
ExportNote finding(const Scenario& scenario, ExportNoteKind kind)
{
    const std::vector<ExportNote> notes = missionChecks(planContent(scenario));
    const auto note = std::ranges::find(notes, kind, &ExportNote::kind);
    require(note != notes.end(), "the finding");
    return *note;
}

Scenario landing(const AircraftProfile& aircraft)
{
    return changed([&](Scenario& s) {
        s.uavs[0].aircraft = aircraft;
        s.uavs[0].aircraft.end = MissionEnd::Landing;
    });
}

} // namespace

class TestMissionChecks : public QObject
{
    Q_OBJECT

private slots:
    void nothingIsFoundInAPlainMission() { QCOMPARE(findings(fourIcebergs()), QString()); }

    void climbMayBeLongerThanTheFirstLeg()
    {
        // 15 degrees to 1000 m take 3732 m; the first iceberg is about 2.5 km away.
        const Scenario high = changed([](Scenario& s) { s.uavs[0].spec.altitude_m = 1000; });
        QCOMPARE(findings(high), QStringLiteral("climb-too-short"));
        QVERIFY(std::abs(finding(high, ExportNoteKind::ClimbTooShort).value - 3732) < 1);
        const Scenario slow = changed([](Scenario& s) { s.uavs[0].spec.climb_s = 200; });
        QCOMPARE(finding(slow, ExportNoteKind::ClimbTooShort).value, 4400.0);
        const Scenario hovering = changed([](Scenario& s) {
            s.uavs[0].spec.altitude_m = 1000;
            s.uavs[0].aircraft.airframe = Airframe::Multirotor;
        });
        QCOMPARE(findings(hovering), QString());
    }

    void px4LimitsTheFirstLeg()
    {
        const Scenario px4 =
            changed([](Scenario& s) { s.uavs[0].aircraft.firmware = AutopilotFirmware::Px4; });
        QCOMPARE(findings(px4), QStringLiteral("first-leg-far"));
        QCOMPARE(std::string(finding(px4, ExportNoteKind::FirstLegFar).tool), std::string("PX4"));
    }

    void returnAndLandingMayLeaveTheFence()
    {
        // The take-off at (-500, 500) is 500 m from the fence in the west; 600 m are too many.
        Scenario scenario = landing({.approachCourse_deg = 90});
        scenario.geofence = true;
        QCOMPARE(findings(scenario), QStringLiteral("ends-cross"));
        QCOMPARE(finding(scenario, ExportNoteKind::EndsCross).value, 2.0); // to it, and from it
        scenario.uavs[0].aircraft.approachCourse_deg = 270;
        QCOMPARE(findings(scenario), QString());
        Scenario closed = fourIcebergs(); // across the straight line home from (1200, 3000)
        closed.noFly = {{.corners_m = {{-400, 1500}, {600, 1500}, {600, 1600}, {-400, 1600}}}};
        QCOMPARE(findings(closed), QStringLiteral("ends-cross"));
        QCOMPARE(findings(closed, {.returnHome = false}), QString());
    }

    void approachMayLeadOverLand()
    {
        Scenario scenario = landing({});
        scenario.origin = {.latitude_deg = 48.5, .longitude_deg = -56}; // inside Newfoundland
        QCOMPARE(findings(scenario), QStringLiteral("approach-over-land"));
    }

    void approachMayBeSteep()
    {
        const Scenario scenario = landing({.approachAltitude_m = 120});
        QCOMPARE(findings(scenario), QStringLiteral("approach-steep"));
        // 120 m over the tangent from 600 m to a circle of 106 m, sqrt(600^2 - 106^2) = 590.6 m
        QVERIFY(std::abs(finding(scenario, ExportNoteKind::ApproachSteep).value - 11.485) < 0.01);
        AircraftProfile vtol{.airframe = Airframe::Vtol, .approachAltitude_m = 120};
        QCOMPARE(findings(landing(vtol)), QString());
    }

    void waypointsMayBeTooClose()
    {
        const Scenario scenario = changed([](Scenario& s) {
            s.icebergs[3].position_m = s.icebergs[0].position_m + Point(100, 0);
            s.icebergs[3].velocity_mps = s.icebergs[0].velocity_mps;
        });
        QCOMPARE(findings(scenario), QStringLiteral("waypoints-close"));
        QCOMPARE(finding(scenario, ExportNoteKind::WaypointsClose).value, 1.0);
    }

    void autopilotsHoldLimitedMissions()
    {
        Scenario scenario = fourIcebergs();
        IcebergList order;
        scenario.icebergs.clear();
        for (int i = 0; i < 600; ++i) {
            Iceberg iceberg;
            iceberg.id = "many-" + std::to_string(i);
            iceberg.position_m = Point(3000 + 1000 * (i % 25), 1000 * (i / 25));
            scenario.icebergs.push_back(iceberg);
            order.push_back(IcebergIndex::of(i));
        }
        const auto idsOfPlan = [&] {
            QStringList ids;
            for (const ExportNote& note : missionChecks(planContent(scenario, planOf(order))))
                ids << QString::fromLatin1(note.id.data(), qsizetype(note.id.size()));
            return ids;
        };
        QVERIFY(!idsOfPlan().contains(QStringLiteral("too-many-items")));
        scenario.uavs[0].aircraft.firmware = AutopilotFirmware::Px4;
        QVERIFY(idsOfPlan().contains(QStringLiteral("too-many-items")));
    }

    void airspaceIsEnteredAtTheAltitudesFlown()
    {
        const std::vector<Point> onTheWay{{700, 500}, {1000, 500}, {1000, 1000}, {700, 1000}};
        const auto with = [&](double floor_m, std::optional<double> ceiling_m) {
            return changed([&](Scenario& s) {
                s.airspace = {{.name = "TRA",
                               .corners_m = onTheWay,
                               .floor_m = floor_m,
                               .ceiling_m = ceiling_m}};
            });
        };
        QCOMPARE(findings(with(100, 500)), QStringLiteral("airspace-on-the-way"));
        QCOMPARE(findings(with(121, std::nullopt)), QString());
        Scenario aside = with(0, std::nullopt);
        for (Point& corner_m : aside.airspace[0].corners_m)
            corner_m += Point(0, 20'000);
        QCOMPARE(findings(aside), QString());
    }

    void enduranceHoldsTheLandingPattern()
    {
        Scenario scenario = landing({});
        scenario.uavs[0].spec.endurance_s = 1e6;
        scenario.uavs[0].spec.reserve_s = 0;
        const ExportContent content = planContent(scenario);
        QVERIFY(!content.uavs[0].visits.back().iceberg); // the plan ends at home
        scenario.uavs[0].spec.endurance_s = content.uavs[0].visits.back().time_s + 60;
        QCOMPARE(planContent(scenario).uavs[0].visits.size(), std::size_t{5});
        QCOMPARE(findings(scenario), QStringLiteral("endurance-short"));
        scenario.uavs[0].aircraft.end = MissionEnd::Return;
        QCOMPARE(findings(scenario), QString());
    }

    void tracksAreNotChecked()
    {
        Scenario scenario = fourIcebergs();
        scenario.uavs[0].spec.altitude_m = 1000;
        const Mission mission = flown(scenario, 300);
        QVERIFY(missionChecks(runContent(mission, {.what = ExportScope::Track})).empty());
    }
};

QTEST_APPLESS_MAIN(TestMissionChecks)
#include "tst_mission_checks.moc"
