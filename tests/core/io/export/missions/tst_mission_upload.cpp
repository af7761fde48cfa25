// A simulated aircraft receives exported missions and flies them.

#include "core/io/export/missions/mission_upload.h"
#include "core/link/link_session.h"
#include "core/link/message/memory_link.h"
#include "core/sim/rehearsal_vehicle.h"
#include "tests/support/flight/mission_builder.h"

#include <QTest>

using namespace berg;
using namespace berg::test;

namespace {

constexpr LinkAddress kAircraft{.system = 1, .component = 1};

/** A ground station and an aircraft at the home of the content, in steps of 0.1 s. */
struct UploadRehearsal
{
    explicit UploadRehearsal(const ExportContent& content)
        : parts(missionParts(content, content.uavs.front()))
        , vehicle(ends.second, {.side = {.autopilot = isArduPilot(content.uavs.front())
                                                          ? AutopilotKind::ArduPilot
                                                          : AutopilotKind::Px4},
                                .uav = {.endurance_s = 3600},
                                .home = content.frame.toGeographic(content.uavs.front().home_m)})
        , session(ends.first, {})
    {
        session.setSending(true);
        run(2);
        session.startSync(kAircraft, parts, MissionSync::Task::UploadAndCompare);
        run(60, [this] { return phase() == SyncPhase::Equal; });
    }

    void run(
        double duration_s, const std::function<bool()>& isDone = [] { return false; })
    {
        for (const double end_s = time_s + duration_s; time_s < end_s && !isDone();) {
            time_s += 0.1;
            const LinkTime now{.monotonic_s = time_s, .unix_us = std::llround(1e6 * time_s)};
            vehicle.advance(now);
            (void)session.advance(now);
        }
    }

    [[nodiscard]] SyncPhase phase() const { return session.findVehicle(kAircraft)->sync->phase; }

    double time_s = 0;
    std::pair<MemoryLink, MemoryLink> ends = MemoryLink::pair();
    std::vector<MissionPart> parts;
    RehearsalVehicle vehicle;
    LinkSession session;
};

} // namespace

class TestMissionUpload : public QObject
{
    Q_OBJECT

private slots:
    /** The vehicle has on board what was planned, for every profile. */
    void everyProfileIsUploaded_data()
    {
        QTest::addColumn<int>("ready");
        for (std::size_t i = 0; i < readyProfiles().size(); ++i)
            QTest::newRow(readyProfiles()[i].id.data()) << int(i);
    }

    void everyProfileIsUploaded()
    {
        QFETCH(int, ready);
        const Scenario scenario = changed([&](Scenario& s) {
            s.geofence = true;
            s.uavs[0].aircraft = readyProfiles()[std::size_t(ready)].profile;
        });
        const UploadRehearsal rehearsal(planContent(scenario));
        QVERIFY(rehearsal.phase() == SyncPhase::Equal);
    }

    /** An empty list would delete the fence that the aircraft has. */
    void planWithoutFenceLeavesTheAircraftsOwn()
    {
        const auto hasFence = [](const Scenario& scenario) {
            const ExportContent content = planContent(scenario);
            for (const MissionPart& part : missionParts(content, content.uavs.front()))
                if (part.type == MissionType::Fence)
                    return true;
            return false;
        };
        QVERIFY(!hasFence(changed([](Scenario& s) { s.geofence = false; })));
        QVERIFY(hasFence(changed([](Scenario& s) { s.geofence = true; })));
    }

    /** The default mission, started in AUTO, leads past all icebergs and home again. */
    void defaultMissionIsFlown()
    {
        const ExportContent content = planContent(fourIcebergs());
        UploadRehearsal rehearsal(content);
        QVERIFY(rehearsal.phase() == SyncPhase::Equal);
        QVERIFY(
            rehearsal.session.sendCommand(kAircraft, {.command = LinkCommandId::kSetMode,
                                                      .params = {1, 10, 0, 0, 0, 0, 0}})); // AUTO
        std::vector<double> nearest_m(content.uavs[0].visits.size(), 1e9);
        const auto distance_m = [&](const Point& place_m) {
            return (content.frame.toPlane(rehearsal.vehicle.readings().place) - place_m).norm();
        };
        rehearsal.run(1500, [&] {
            for (std::size_t i = 0; i < nearest_m.size(); ++i)
                nearest_m[i] =
                    std::min(nearest_m[i], distance_m(content.uavs[0].visits[i].position_m));
            return false;
        });
        for (const double each_m : nearest_m)
            QVERIFY2(each_m < 258, std::to_string(each_m).c_str()); // the radius and a step
        const double home_m = distance_m(content.uavs[0].home_m);
        QVERIFY2(home_m < 250, std::to_string(home_m).c_str()); // it circles there
    }
};

QTEST_APPLESS_MAIN(TestMissionUpload)
#include "tst_mission_upload.moc"
