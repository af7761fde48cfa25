#include "core/link/link_session.h"
#include "core/link/message/memory_link.h"
#include "core/sim/rehearsal_vehicle.h"
#include "tests/support/approx.h"

using namespace berg;

namespace {

constexpr LatLon kHome{.latitude_deg = 47, .longitude_deg = -48};

/** A rehearsal of ground station and vehicle in steps of 0.1 s. */
struct Rehearsal
{
    explicit Rehearsal(AutopilotKind kind, Point wind_mps = Point::Zero())
        : vehicle(ends.second, {.side = {.autopilot = kind},
                                .uav = {.endurance_s = 3600},
                                .home = kHome,
                                .homeAltitude_m = 5,
                                .wind_mps = wind_mps})
        , session(ends.first, {})
    {
        session.setSending(true);
        run(2);
    }

    void run(
        double duration_s, const std::function<bool()>& isDone = [] { return false; })
    {
        for (const double end_s = time_s + duration_s; time_s < end_s && !isDone();) {
            time_s += 0.1;
            const LinkTime now{.monotonic_s = time_s, .unix_us = std::llround(1e6 * time_s)};
            vehicle.advance(now);
            for (const LinkEvent& event : session.advance(now).events)
                if (event.kind == LinkEvent::Kind::ItemReached)
                    reached.push_back(event.value);
            for (std::size_t i = 0; i < targets.size(); ++i)
                nearest_m[i] = std::min(nearest_m[i], distanceTo(targets[i]));
        }
    }

    [[nodiscard]] double distanceTo(const LinkMissionItem& item) const
    {
        return greatCircle_m(vehicle.readings().place,
                             {.latitude_deg = item.x / 1e7, .longitude_deg = item.y / 1e7});
    }

    [[nodiscard]] double distanceHome() const
    {
        return greatCircle_m(vehicle.readings().place, kHome);
    }

    bool upload(const std::vector<LinkMissionItem>& items)
    {
        targets = items;
        nearest_m.assign(items.size(), 1e9);
        session.startSync(kUav, {{.items = items}}, MissionSync::Task::UploadAndCompare);
        run(30, [&] { return session.findVehicle(kUav)->sync->phase == SyncPhase::Equal; });
        return session.findVehicle(kUav)->sync->phase == SyncPhase::Equal;
    }

    void command(std::uint16_t id, std::array<double, 7> params,
                 std::optional<ItemFrame> frame = std::nullopt)
    {
        QVERIFY(session.sendCommand(kUav, {.command = id, .params = params, .frame = frame}));
        run(0.5);
    }

    static constexpr LinkAddress kUav{.system = 1, .component = 1};
    double time_s = 0;
    std::pair<MemoryLink, MemoryLink> ends = MemoryLink::pair();
    RehearsalVehicle vehicle;
    LinkSession session;
    std::vector<int> reached; ///< Numbered as on the link.
    std::vector<LinkMissionItem> targets;
    std::vector<double> nearest_m;
};

std::vector<LinkMissionItem> squareMission()
{
    std::vector<LinkMissionItem> items;
    for (const auto& [x, y] : {std::pair(470'100'000, -480'000'000),
                               {470'100'000, -479'850'000},
                               {470'000'000, -479'850'000}})
        items.push_back({.params = {0, 30, 0, 0}, .x = x, .y = y, .z = 150});
    return items;
}

constexpr std::array<double, 7> kArduPilotAuto{1, 10, 0, 0, 0, 0, 0};

} // namespace

class TestRehearsalVehicle : public QObject
{
    Q_OBJECT

private slots:
    void missionIsFlownAsUploaded_data()
    {
        QTest::addColumn<bool>("isPx4");
        QTest::addColumn<double>("wind_mps");
        QTest::newRow("ArduPilot") << false << 0.0;
        QTest::newRow("PX4") << true << 0.0;
        QTest::newRow("ArduPilot, wind") << false << 10.0;
    }

    void missionIsFlownAsUploaded()
    {
        QFETCH(bool, isPx4);
        QFETCH(double, wind_mps);
        Rehearsal rehearsal(isPx4 ? AutopilotKind::Px4 : AutopilotKind::ArduPilot,
                            Point(wind_mps, 0));
        QVERIFY(rehearsal.upload(squareMission()));
        QVERIFY(rehearsal.reached.empty()); // it circles until an order
        rehearsal.command(LinkCommandId::kSetMode,
                          isPx4 ? std::array<double, 7>{1, 4, 4, 0, 0, 0, 0} : kArduPilotAuto);
        rehearsal.run(600, [&] { return rehearsal.reached.size() == 3; });
        const int first = isPx4 ? 0 : 1;
        QVERIFY((rehearsal.reached == std::vector<int>{first, first + 1, first + 2}));
        for (double nearest_m : rehearsal.nearest_m)
            QVERIFY2(nearest_m <= 33, std::to_string(nearest_m).c_str()); // 30 m and a step
        COMPARE_NEAR(rehearsal.vehicle.readings().altitude_m, 155, 1e-6);
        rehearsal.run(300); // ArduPilot flies home, PX4 circles at its position
        const double home_m = rehearsal.distanceHome();
        QVERIFY2(isPx4 ? home_m > 900 : home_m < 250, std::to_string(home_m).c_str());
        const AircraftState& state = rehearsal.session.findVehicle(Rehearsal::kUav)->state;
        COMPARE_NEAR(greatCircle_m(state.position->place, rehearsal.vehicle.readings().place), 0,
                     20); // a telemetry interval
        COMPARE_NEAR(*state.battery->remaining, 1 - rehearsal.time_s / 3600, 0.02);
    }

    void jumpsSpeedsAndCirclesAreFlown()
    {
        Rehearsal rehearsal(AutopilotKind::ArduPilot);
        std::vector<LinkMissionItem> items = squareMission();
        const auto noPosition = static_cast<std::uint8_t>(ItemFrame::NoPosition);
        items.push_back({.command = LinkCommandId::kChangeSpeed,
                         .frame = noPosition,
                         .params = {0, 25, -1, 0}});
        items.push_back(
            {.command = LinkCommandId::kJump, .frame = noPosition, .params = {1, 1, 0, 0}});
        LinkMissionItem circle = items[0];
        circle.command = LinkCommandId::kLoiterTurns;
        circle.params = {1, 0, 200, 0};
        items.push_back(circle);
        QVERIFY(rehearsal.upload(items));
        rehearsal.command(LinkCommandId::kSetMode, kArduPilotAuto);
        rehearsal.run(1500, [&] { return rehearsal.reached.size() == 6; });
        QVERIFY((rehearsal.reached == std::vector<int>{1, 2, 3, 2, 3, 6}));
        COMPARE_NEAR(rehearsal.vehicle.readings().airspeed_mps, 25, 1e-6);
        COMPARE_NEAR(rehearsal.distanceTo(circle), 200, 25);
    }

    /** A jump to itself must not hang the program. */
    void endlessJumpsEnd()
    {
        Rehearsal rehearsal(AutopilotKind::ArduPilot);
        const auto noPosition = static_cast<std::uint8_t>(ItemFrame::NoPosition);
        QVERIFY(rehearsal.upload(
            {{.command = LinkCommandId::kJump, .frame = noPosition, .params = {0, -1, 0, 0}}}));
        rehearsal.command(LinkCommandId::kSetMode, kArduPilotAuto);
        rehearsal.run(5);
        QCOMPARE(rehearsal.vehicle.readings().mode, 11U);
    }

    void guidedTargetsAndItemsAreObeyed()
    {
        Rehearsal rehearsal(AutopilotKind::ArduPilot);
        QVERIFY(rehearsal.upload(squareMission()));
        const LinkMissionItem target = squareMission()[1];
        rehearsal.command(
            LinkCommandId::kReposition,
            {-1, 1, 300, 0, static_cast<double>(target.x), static_cast<double>(target.y), 80},
            ItemFrame::AboveHome);
        QCOMPARE(rehearsal.vehicle.readings().mode, 15U);
        rehearsal.run(300);
        COMPARE_NEAR(rehearsal.distanceTo(target), 300, 30); // it circles and does not fly past
        COMPARE_NEAR(rehearsal.vehicle.readings().altitude_m, 85, 1e-6);
        rehearsal.command(LinkCommandId::kSetCurrentItem, {3, 0, 0, 0, 0, 0, 0});
        rehearsal.command(LinkCommandId::kSetMode, kArduPilotAuto);
        rehearsal.run(200, [&] { return !rehearsal.reached.empty(); });
        QVERIFY(rehearsal.reached == std::vector<int>{3});
    }

    /** At ten times the speed, 22 m/s for 5 s of the link are 1100 m. */
    void planOnBoardIsFlownFromTheStart()
    {
        auto [station, aircraft] = MemoryLink::pair();
        const LatLon start{.latitude_deg = 47.1, .longitude_deg = -48};
        RehearsalVehicle vehicle(aircraft,
                                 {.home = kHome, .start = start, .heading_deg = 0, .speed = 10});
        COMPARE_NEAR(greatCircle_m(vehicle.readings().place, start), 0, 0.01);
        COMPARE_NEAR(vehicle.readings().heading_rad, 0, 1e-9);
        LinkMissionItem item{.x = 473'000'000, .y = -480'000'000, .z = 120};
        vehicle.load(MissionType::Mission, std::span(&item, 1));
        vehicle.flyMission();
        QCOMPARE(vehicle.readings().mode, 10U);
        for (int i = 1; i <= 51; ++i)
            vehicle.advance({.monotonic_s = 0.1 * i, .unix_us = 100'000 * i});
        COMPARE_NEAR(greatCircle_m(vehicle.readings().place, start), 1100, 1);
        COMPARE_NEAR(vehicle.readings().place.longitude_deg, -48, 1e-4);
        QCOMPARE(vehicle.side().missions().items(MissionType::Mission).size(), std::size_t{1});
    }

    /** NaN means the vehicle's own value: its altitude, its circle, no time to wait. */
    void valuesThatAreMissingAreTheVehiclesOwn_data()
    {
        constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
        QTest::addColumn<LinkMissionItem>("item");
        QTest::addColumn<bool>("isDone");
        const LinkMissionItem waypoint{
            .params = {0, 30, 0, kNan}, .x = 470'000'000, .y = -479'950'000, .z = 120};
        LinkMissionItem item = waypoint;
        item.command = LinkCommandId::kLoiterUnlimited;
        item.params[2] = kNan;
        QTest::newRow("radius") << item << false;
        item.command = LinkCommandId::kLoiterTime;
        item.params[0] = kNan;
        QTest::newRow("time") << item << true;
        item.command = LinkCommandId::kLoiterTurns;
        QTest::newRow("turns") << item << true;
        item.command = LinkCommandId::kLoiterToAltitude;
        item.params[1] = kNan;
        QTest::newRow("radius of a climb") << item << true;
        item = waypoint;
        item.z = kNan;
        QTest::newRow("altitude") << item << true;
        item = waypoint;
        item.params.fill(kNan);
        QTest::newRow("acceptance radius") << item << true;
        item = waypoint;
        item.x = 2'000'000'000;
        QTest::newRow("place that is none") << item << true; // it counts as the present one
    }

    void valuesThatAreMissingAreTheVehiclesOwn()
    {
        QFETCH(LinkMissionItem, item);
        QFETCH(bool, isDone);
        auto [station, aircraft] = MemoryLink::pair();
        RehearsalVehicle vehicle(aircraft, {.home = kHome});
        vehicle.load(MissionType::Mission, std::span(&item, 1));
        vehicle.flyMission();
        for (int i = 1; i <= 100; ++i)
            vehicle.advance({.monotonic_s = static_cast<double>(i), .unix_us = 1'000'000 * i});
        const VehicleReadings& readings = vehicle.readings();
        QVERIFY(greatCircle_m(readings.place, kHome) < 1000); // not if it is NaN
        COMPARE_NEAR(readings.altitude_m, 120, 1e-3);
        QVERIFY(std::isfinite(readings.roll_rad));
        QCOMPARE(readings.mode, isDone ? 11U : 10U); // it flies home after its last item
    }

    /** A circle of no time is over on arrival, not before. */
    void circleWithoutTimeIsFlownTo()
    {
        auto [station, aircraft] = MemoryLink::pair();
        RehearsalVehicle vehicle(aircraft, {.home = kHome});
        const LinkMissionItem item{
            .command = LinkCommandId::kLoiterTime, .x = 470'000'000, .y = -479'800'000, .z = 120};
        vehicle.load(MissionType::Mission, std::span(&item, 1));
        vehicle.flyMission();
        for (int i = 1; i <= 50; ++i)
            vehicle.advance({.monotonic_s = static_cast<double>(i), .unix_us = 1'000'000 * i});
        QCOMPARE(vehicle.readings().mode, 10U);
        for (int i = 51; i <= 100; ++i)
            vehicle.advance({.monotonic_s = static_cast<double>(i), .unix_us = 1'000'000 * i});
        QCOMPARE(vehicle.readings().mode, 11U); // it is 1520 m away, 70 s at 22 m/s
    }

    void guidedTargetMayLeaveTheAltitude()
    {
        Rehearsal rehearsal(AutopilotKind::ArduPilot);
        const LinkMissionItem target = squareMission()[0];
        const auto x = static_cast<double>(target.x);
        const auto y = static_cast<double>(target.y);
        rehearsal.command(LinkCommandId::kReposition, {-1, 1, std::nan(""), 0, x, y, std::nan("")},
                          ItemFrame::AboveHome);
        rehearsal.run(200);
        COMPARE_NEAR(rehearsal.vehicle.readings().altitude_m, 125, 1e-6);
        QVERIFY(rehearsal.distanceTo(target) < 200);
        // Altitudes above terrain are taken as above home, as those of items.
        rehearsal.command(LinkCommandId::kReposition, {-1, 1, 0, 0, x, y, 80},
                          ItemFrame::AboveTerrain);
        rehearsal.run(60);
        COMPARE_NEAR(rehearsal.vehicle.readings().altitude_m, 85, 1e-6);
    }

    /** The radius that a station reads among the parameters is that of the circle. */
    void circlesHaveTheRadiusOfTheAutopilot()
    {
        auto [station, aircraft] = MemoryLink::pair();
        const RehearsalOptions options{.home = kHome, .loiterRadius_m = 350};
        RehearsalVehicle vehicle(aircraft, options);
        for (int i = 1; i <= 300; ++i)
            vehicle.advance({.monotonic_s = static_cast<double>(i), .unix_us = 1'000'000 * i});
        COMPARE_NEAR(greatCircle_m(vehicle.readings().place, kHome), 350, 20);
        RehearsalVehicle tight(aircraft, {.home = kHome, .loiterRadius_m = 1});
        for (int i = 1; i <= 300; ++i)
            tight.advance({.monotonic_s = static_cast<double>(i), .unix_us = 1'000'000 * i});
        COMPARE_NEAR(greatCircle_m(tight.readings().place, kHome), smallestCircle_m(options.uav),
                     20);
    }

    /** The station sees the pilot's mode, and no item is flown in it. */
    void pilotTakesOver()
    {
        Rehearsal rehearsal(AutopilotKind::ArduPilot);
        QVERIFY(rehearsal.upload(squareMission()));
        rehearsal.command(LinkCommandId::kSetMode, kArduPilotAuto);
        rehearsal.run(5);
        rehearsal.vehicle.setMode(5); // FBWA
        rehearsal.run(60);
        QCOMPARE(rehearsal.session.findVehicle(Rehearsal::kUav)->mode, 5U);
        QVERIFY(rehearsal.reached.empty());
    }
};

QTEST_APPLESS_MAIN(TestRehearsalVehicle)
#include "tst_rehearsal_vehicle.moc"
