// Missions of all aircraft profiles, read by the rules of ground stations and autopilots.

#include "core/io/export/missions/mission_upload.h"
#include "core/io/export/missions/plan_qgc.h"
#include "core/io/export/missions/plan_wpl.h"
#include "tests/support/files/autopilot_rules.h"
#include "tests/support/files/golden.h"
#include "tests/support/files/wpl_readers.h"
#include "tests/support/flight/mission_builder.h"

#include <QTest>

using namespace berg;
using namespace berg::test;

namespace {

using Commands = QList<int>;

/** Returns `fourIcebergs` for this aircraft, with a fence and a wind. */
Scenario withAircraft(const AircraftProfile& aircraft)
{
    return changed([&](Scenario& s) {
        s.uavs[0].aircraft = aircraft;
        s.wind_mps = Point(4, 0);
        s.geofence = true;
    });
}

AircraftProfile readyProfile(std::string_view id)
{
    return std::ranges::find(readyProfiles(), id, &ReadyProfile::id)->profile;
}

PlanText planOfAircraft(const AircraftProfile& aircraft, const ExportOptions& options = {})
{
    return berg::test::planText(
        bytes(qgcPlan(planContent(withAircraft(aircraft), fourIcebergPlan(), options))));
}

Commands commandsOf(const PlanText& plan)
{
    Commands commands;
    for (const QJsonValue& item : plan_rules::items(plan))
        commands << item["command"_L1].toInt();
    return commands;
}

/** Returns "rule: fault" for each rule of the readers of the plan that it breaks. */
QStringList faultsOf(const PlanText& plan)
{
    const bool isPx4 = plan_rules::mission(plan)["firmwareType"_L1].toInt() == 12;
    std::vector<PlanRule> rules = autopilotRules(plan);
    for (const std::vector<PlanRule>& more : {qgroundcontrolRules(), mavsdkRules()})
        rules.insert(rules.end(), more.begin(), more.end());
    if (!isPx4) // Mission Planner is for ArduPilot
        for (const PlanRule& rule : missionPlannerRules())
            rules.push_back(rule);
    QStringList faults;
    for (const PlanRule& rule : rules)
        if (const QString fault = rule.fault(plan); !fault.isEmpty())
            faults << QLatin1StringView(rule.name) + u": "_s + fault;
    return faults;
}

} // namespace

class TestMissionProfiles : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(u".*"_s)); }

    /** Every profile with every camera, end and take-off, of an order and of a path. */
    void readersAccept_data()
    {
        QTest::addColumn<int>("ready");
        QTest::addColumn<int>("what");
        QTest::addColumn<int>("turns");
        for (std::size_t i = 0; i < readyProfiles().size(); ++i)
            for (const auto& [what, name] : kExportScopeNames)
                for (const int turns : {0, 2})
                    if (what != ExportScope::Track)
                        QTest::addRow("%s, %s, %d turns", readyProfiles()[i].id.data(), name.data(),
                                      turns)
                            << int(i) << static_cast<int>(what) << turns;
    }

    void readersAccept()
    {
        QFETCH(int, ready);
        QFETCH(int, what);
        QFETCH(int, turns);
        for (const CameraTrigger camera :
             {CameraTrigger::None, CameraTrigger::Distance, CameraTrigger::Time})
            for (const MissionEnd end :
                 {MissionEnd::Return, MissionEnd::Landing, MissionEnd::Loiter}) {
                AircraftProfile aircraft = readyProfiles()[std::size_t(ready)].profile;
                aircraft.camera = camera;
                aircraft.end = end;
                const ExportOptions options{.what = static_cast<ExportScope>(what),
                                            .loiterTurns = turns};
                const PlanText plan = planOfAircraft(aircraft, options);
                QCOMPARE(faultsOf(plan), QStringList());
                const ExportContent content =
                    planContent(withAircraft(aircraft), fourIcebergPlan(), options);
                const WplMission rows = readers().front().read(bytes(wplText(content)));
                QVERIFY2(rows.fault.isEmpty(), qPrintable(rows.fault));
                QCOMPARE(qsizetype(rows.rows.size()) - 1, plan_rules::items(plan).size());
                for (std::size_t i = 1; i < rows.rows.size(); ++i)
                    QCOMPARE(rows.rows[i].command, commandsOf(plan)[qsizetype(i) - 1]);
            }
    }

    void rejectionsAreCaught_data()
    {
        QTest::addColumn<QString>("profile");
        QTest::addColumn<int>("row");
        QTest::addColumn<QString>("member");
        QTest::addColumn<int>("value");
        QTest::addColumn<QString>("rule");
        const auto row = [](const char* name, const QString& profile, int item,
                            const QString& member, int value, const QString& rule) {
            QTest::newRow(name) << profile << item << member << value << rule;
        };
        // Items of a fixed wing that lands: take-off, speed, four icebergs, land start, loiter,
        // land.
        row("turns for PX4", u"px4-plane"_s, 3, u"command"_s, 18, u"commands of PX4"_s);
        row("late take-off", u"px4-plane"_s, 3, u"command"_s, 22, u"take-off first"_s);
        row("return after land start", u"px4-plane"_s, 8, u"command"_s, 20, u"landing"_s);
        row("landing of a VTOL", u"px4-plane"_s, 8, u"command"_s, 85,
            u"commands of the airframe"_s);
        row("landing from a loiter", u"px4-plane"_s, 7, u"command"_s, 17, u"landing"_s);
        row("acceptance of 300 m", u"ardupilot-plane"_s, 2, u"p2"_s, 300,
            u"storage of ArduPlane"_s);
        row("steep landing", u"px4-plane"_s, 7, u"p7"_s, 200, u"landing"_s);
        row("circle over the landing place", u"px4-plane"_s, 7, u"p2"_s, 700, u"landing"_s);
    }

    void rejectionsAreCaught()
    {
        QFETCH(QString, profile);
        QFETCH(int, row);
        QFETCH(QString, member);
        QFETCH(int, value);
        QFETCH(QString, rule);
        PlanText plan = planOfAircraft(readyProfile(profile.toStdString()));
        QCOMPARE(faultsOf(plan), QStringList());
        QJsonObject mission = plan.root["mission"_L1].toObject();
        QJsonArray all = mission["items"_L1].toArray();
        QJsonObject item = all[row].toObject();
        if (member == u"command"_s) {
            item["command"_L1] = value;
        } else {
            QJsonArray params = item["params"_L1].toArray();
            params[member.mid(1).toInt() - 1] = value;
            item["params"_L1] = params;
        }
        all[row] = item;
        mission["items"_L1] = all;
        plan.root["mission"_L1] = mission;
        QVERIFY2(faultsOf(plan).join(u'\n').contains(rule + u": "_s),
                 qPrintable(faultsOf(plan).join(u'\n')));
    }

    void missionsBeginAndEndAsTheProfileSays_data()
    {
        QTest::addColumn<QString>("profile");
        QTest::addColumn<Commands>("first");
        QTest::addColumn<Commands>("last");
        QTest::newRow("default") << u"ardupilot-plane"_s << Commands{22, 178, 16} << Commands{20};
        QTest::newRow("by hand") << u"ardupilot-flying-wing"_s << Commands{178, 16, 206}
                                 << Commands{206, 189, 31, 21};
        QTest::newRow("VTOL") << u"ardupilot-vtol"_s << Commands{84, 178, 16}
                              << Commands{189, 16, 85};
        QTest::newRow("multirotor")
            << u"ardupilot-multirotor"_s << Commands{22, 178, 205, 16, 2000} << Commands{2001, 20};
        QTest::newRow("PX4") << u"px4-plane"_s << Commands{22, 178, 16} << Commands{189, 31, 21};
    }

    void missionsBeginAndEndAsTheProfileSays()
    {
        QFETCH(QString, profile);
        QFETCH(Commands, first);
        QFETCH(Commands, last);
        const Commands commands = commandsOf(planOfAircraft(readyProfile(profile.toStdString())));
        QCOMPARE(commands.first(first.size()), first);
        QCOMPARE(commands.last(last.size()), last);
    }

    void returnIsWhatTheUserChose()
    {
        const AircraftProfile landing = readyProfile("px4-plane");
        QCOMPARE(commandsOf(planOfAircraft(landing, {.returnHome = false})).last(), 17);
        QCOMPARE(commandsOf(planOfAircraft(landing, {.what = ExportScope::FirstLeg})).last(), 17);
        QCOMPARE(
            commandsOf(planOfAircraft(landing, {.what = ExportScope::FirstLeg, .returnHome = true}))
                .last(),
            21);
        const AircraftProfile loiters{.end = MissionEnd::Loiter};
        QCOMPARE(commandsOf(planOfAircraft(loiters, {.returnHome = true})).last(), 17);
    }

    /** The approach is flown against the wind, which blows to the east here, or as chosen. */
    void approachLeadsIntoTheWind()
    {
        const auto approach_m = [](const AircraftProfile& aircraft) {
            const PlanText plan = planOfAircraft(aircraft);
            const QJsonArray all = plan_rules::items(plan);
            const LocalFrame frame(fourIcebergs().origin);
            const auto at = [&](qsizetype row) {
                const QJsonArray params = all[row]["params"_L1].toArray();
                return frame.toPlane(
                    {.latitude_deg = params[4].toDouble(), .longitude_deg = params[5].toDouble()});
            };
            return Point(at(all.size() - 1) - at(all.size() - 2));
        };
        AircraftProfile aircraft = readyProfile("px4-plane");
        QVERIFY((approach_m(aircraft) - Point(-600, 0)).norm() < 1e-3);
        aircraft.approachCourse_deg = 360;
        aircraft.approach_m = 800;
        QVERIFY((approach_m(aircraft) - Point(0, 800)).norm() < 1e-3);
    }

    /** The camera is on within half the field of view of each iceberg, and off between. */
    void cameraIsOnOverIcebergs()
    {
        const PlanText plan = planOfAircraft({.camera = CameraTrigger::Distance, .trigger_m = 40});
        const Commands commands = commandsOf(plan);
        QCOMPARE(commands.count(206), 8);
        const QJsonArray all = plan_rules::items(plan);
        bool isOn = false;
        for (qsizetype i = 0; i < all.size(); ++i)
            if (commands[i] == 206) {
                isOn = !isOn;
                QCOMPARE(all[i]["params"_L1][0].toInt(), isOn ? 40 : 0);
                // The waypoint before is 300 m from the iceberg.
                const qsizetype iceberg = isOn ? i + 1 : i - 2;
                QVERIFY(std::abs(autopilot_rules::distance_m(all[i - 1], all[iceberg]) - 300) < 2);
            }
        QVERIFY(!isOn);
    }

    void speedsAreThoseOfTheAirframe()
    {
        const auto speeds = [](const char* id) {
            const QJsonObject mission = plan_rules::mission(planOfAircraft(readyProfile(id)));
            return std::pair(mission["cruiseSpeed"_L1].toInt(), mission["hoverSpeed"_L1].toInt());
        };
        QCOMPARE(speeds("px4-vtol"), std::pair(22, 5));
        QCOMPARE(speeds("px4-multirotor"), std::pair(22, 22));
        const PlanText silent = planOfAircraft({.speedItems = false});
        QVERIFY(!commandsOf(silent).contains(178));
    }

    void loiterRadiusIsAtLeastThatOfTheProfile()
    {
        ExportUav uav{.uav = {}, .circle_m = 106};
        uav.uav.aircraft.loiterRadius_m = 80;
        QCOMPARE(loiterRadius_m(uav), 106.0);
        uav.uav.aircraft.loiterRadius_m = 322;
        QCOMPARE(loiterRadius_m(uav), 330.0);
        uav.uav.aircraft.firmware = AutopilotFirmware::Px4;
        QCOMPARE(loiterRadius_m(uav), 322.0);
    }

    void uploadHasTheItemsOfTheFile()
    {
        const ExportContent content = planContent(withAircraft(readyProfile("px4-plane")));
        const std::vector<MissionPart> parts = missionParts(content, content.uavs.front());
        const PlanText plan = planOfAircraft(readyProfile("px4-plane"));
        const QJsonArray all = plan_rules::items(plan);
        QCOMPARE(parts.size(), std::size_t{3});
        QCOMPARE(qsizetype(parts[2].items.size()), all.size());
        for (qsizetype i = 0; i < all.size(); ++i) {
            const LinkMissionItem& item = parts[2].items[std::size_t(i)];
            QCOMPARE(int(item.command), all[i]["command"_L1].toInt());
            QCOMPARE(int(item.frame), all[i]["frame"_L1].toInt());
            QVERIFY(std::abs(item.x - 1e7 * autopilot_rules::paramOf(all[i], 5)) <= 0.51);
            QVERIFY(std::abs(item.y - 1e7 * autopilot_rules::paramOf(all[i], 6)) <= 0.51);
        }
        QVERIFY(parts[0].type == MissionType::Fence && parts[1].type == MissionType::Rally);
        QCOMPARE(parts[0].items.size(), std::size_t{4});
        QCOMPARE(int(parts[0].items[0].command), 5001);
        QCOMPARE(parts[0].items[0].params[0], 4.F);
        QCOMPARE(parts[1].items.size(), std::size_t{1});
    }
};

QTEST_APPLESS_MAIN(TestMissionProfiles)
#include "tst_mission_profiles.moc"
