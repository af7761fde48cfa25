// A whole mission over a link: plans are uploaded to simulated aircraft, which fly them, and the
// flight follows their telemetry. Nothing here waits for a clock.

#include "core/base/angles.h"
#include "core/io/export/missions/mission_upload.h"
#include "core/io/files/scenario_json.h"
#include "core/io/text/atomic_file.h"
#include "core/mission/mission.h"
#include "core/sim/rehearsal_vehicle.h"
#include "core/sim/steering.h"
#include "tests/support/flight/link_scene.h"

#include <QtTest>

#include <algorithm>
#include <map>

using namespace berg;
using namespace berg::test;

namespace {

/** The mission of one UAV of a plan, as the window uploads it. */
struct UploadedPlan
{
    std::vector<MissionPart> parts;
    std::vector<std::string> order; ///< ids of the icebergs
};

std::vector<UploadedPlan> uploadsOf(const Mission& mission)
{
    const bool isBegun = mission.simulation().time_s() > 0;
    const ExportSource source{.scenario = mission.scenario(),
                              .plan = *mission.plans().front(),
                              .mission = isBegun ? &mission : nullptr};
    const ExportContent content =
        exportContent(source, {.what = ExportScope::Order, .returnHome = true});
    std::vector<UploadedPlan> all;
    for (const ExportUav& uav : content.uavs) {
        UploadedPlan& one = all.emplace_back(UploadedPlan{.parts = missionParts(content, uav)});
        for (const Visit& visit : uav.visits)
            if (visit.iceberg)
                std::ranges::move(idsOf(content, visit), std::back_inserter(one.order));
    }
    return all;
}

/** Returns true if the next three icebergs of a plan are next on board, too. */
bool isAheadOnBoard(const std::vector<std::string>& onBoard, const std::vector<std::string>& plan)
{
    if (plan.empty())
        return true;
    const auto first = std::ranges::find(onBoard, plan.front());
    const auto count = std::min<std::ptrdiff_t>(3, std::ssize(plan));
    return onBoard.end() - first >= count && std::equal(plan.begin(), plan.begin() + count, first);
}

/** Returns the direction of true north at a place on the plane of the scenario, rad. */
double northAt(const LocalFrame& frame, LatLon place)
{
    const Point here_m = frame.toPlane(place);
    place.latitude_deg += 0.001;
    const Point path_m = frame.toPlane(place) - here_m;
    return std::atan2(path_m.y(), path_m.x());
}

/** The UAVs of a scenario as aircraft, and the ground station that flies the mission with them. */
class RehearsedFlight
{
public:
    RehearsedFlight(const Scenario& scenario, AutopilotKind kind, LinkImpairment impairment)
        : m_scenario(scenario), m_session(m_hub, {})
    {
        const LocalFrame frame(scenario.origin);
        for (const Uav& uav : scenario.uavs) {
            const auto system = static_cast<std::uint8_t>(m_aircraft.size() + 1);
            const LatLon start = frame.toGeographic(uav.position_m);
            ++impairment.seed;
            m_aircraft.push_back(std::make_unique<Aircraft>(
                m_hub.addPeer(), impairment,
                RehearsalOptions{
                    .side = {.self = {.system = system, .component = 1}, .autopilot = kind},
                    .uav = uav.spec,
                    .home = frame.toGeographic(uav.home_m.value_or(uav.position_m)),
                    .wind_mps = scenario.wind_mps,
                    .start = start,
                    .heading_deg =
                        degFromRad(northAt(frame, start) - psiFromHeading(uav.heading_deg))}));
        }
        m_session.setSending(true);
    }

    /** Uploads the plan, then flies it from where the aircraft are. Returns false if that fails. */
    [[nodiscard]] bool fly()
    {
        if (!runUntil([this] { return hasPositions(); }, 60))
            return false;
        Mission planned(m_scenario);
        planned.advance(0);
        const std::vector<UploadedPlan> uploads = uploadsOf(planned);
        for (std::size_t i = 0; i < m_aircraft.size(); ++i)
            upload(i, uploads[i]);
        if (!runUntil([this] { return isEveryUploadEqual(); }, 300))
            return false;
        for (std::size_t i = 0; i < m_aircraft.size(); ++i) {
            const DubinsState pose = poseOf(*vehicle(i));
            m_scenario.uavs[i].position_m = pose.position_m;
            m_scenario.uavs[i].heading_deg = headingFromPsi(pose.psi_rad);
            m_session.sendCommand(addressOf(i), modeCommand(vehicle(i)->autopilot,
                                                            steeringMode(SteeringKind::Mission,
                                                                         vehicle(i)->autopilot)));
        }
        m_zero_s = m_time_s;
        m_mission = std::make_unique<Mission>(m_scenario);
        m_mission->advance(0);
        return runUntil([this] { return m_mission->simulation().finished(); },
                        m_scenario.duration_s + 60);
    }

    /** The scenario that was flown: its UAVs start where the aircraft were. */
    [[nodiscard]] const Scenario& scenario() const { return m_scenario; }
    [[nodiscard]] const Mission& mission() const { return *m_mission; }
    [[nodiscard]] int uploads() const { return m_uploads; }
    [[nodiscard]] int failedUploads() const { return m_failedUploads; }

    /** Returns the largest distance between a UAV of the mission and its aircraft now, m. */
    [[nodiscard]] double largestError_m() const
    {
        const LocalFrame frame(m_scenario.origin);
        double largest_m = 0;
        for (std::size_t i = 0; i < m_aircraft.size(); ++i) {
            const Point flown_m = m_mission->simulation().uav(static_cast<int>(i)).pose.position_m;
            const Point real_m = frame.toPlane(m_aircraft[i]->vehicle.readings().place);
            largest_m = std::max(largest_m, (flown_m - real_m).norm());
        }
        return largest_m;
    }

private:
    struct Aircraft
    {
        Aircraft(std::unique_ptr<MemoryLink> far, LinkImpairment impairment,
                 const RehearsalOptions& options)
            : end(std::move(far)), radio(*end, impairment), vehicle(radio, options)
        {
        }
        std::unique_ptr<MemoryLink> end;
        ImpairedLink radio;
        RehearsalVehicle vehicle;
        std::vector<std::string> order; ///< of the last upload
        double lastFix_s = 0;
    };

    [[nodiscard]] LinkAddress addressOf(std::size_t i) const
    {
        return {.system = static_cast<std::uint8_t>(i + 1), .component = 1};
    }
    [[nodiscard]] const LinkVehicle* vehicle(std::size_t i) const
    {
        return m_session.findVehicle(addressOf(i));
    }

    [[nodiscard]] bool hasPositions() const
    {
        for (std::size_t i = 0; i < m_aircraft.size(); ++i)
            if (vehicle(i) == nullptr || !vehicle(i)->state.position || !vehicle(i)->state.attitude)
                return false;
        return true;
    }

    [[nodiscard]] bool isEveryUploadEqual() const
    {
        for (std::size_t i = 0; i < m_aircraft.size(); ++i)
            if (!vehicle(i)->sync || vehicle(i)->sync->phase != SyncPhase::Equal)
                return false;
        return true;
    }

    void upload(std::size_t i, const UploadedPlan& plan)
    {
        ++m_uploads;
        m_aircraft[i]->order = plan.order;
        m_session.startSync(addressOf(i), plan.parts, MissionSync::Task::UploadAndCompare);
    }

    [[nodiscard]] DubinsState poseOf(const LinkVehicle& vehicle) const
    {
        const LocalFrame frame(m_scenario.origin);
        return {.position_m = frame.toPlane(vehicle.state.position->place),
                .psi_rad = wrapPi(northAt(frame, vehicle.state.position->place) -
                                  vehicle.state.attitude->heading_rad)};
    }

    bool runUntil(const std::function<bool()>& isDone, double most_s)
    {
        for (const double end_s = m_time_s + most_s; m_time_s < end_s;) {
            step();
            if (isDone())
                return true;
        }
        return false;
    }

    void step()
    {
        m_time_s += 0.05;
        const LinkTime now = linkTime(m_time_s);
        for (const auto& aircraft : m_aircraft) {
            aircraft->radio.setTime(m_time_s);
            aircraft->vehicle.advance(now);
            aircraft->radio.setTime(m_time_s);
        }
        for (const LinkEvent& event : m_session.advance(now).events)
            if (event.kind == LinkEvent::Kind::SyncEnded)
                endSync(event.vehicle);
        if (!m_mission)
            return;
        for (std::size_t i = 0; i < m_aircraft.size(); ++i) {
            const AircraftPosition& position = *vehicle(i)->state.position;
            if (position.received_s <= std::max(m_aircraft[i]->lastFix_s, m_zero_s))
                continue;
            m_aircraft[i]->lastFix_s = position.received_s;
            m_mission->addFix({.time_s = position.received_s - m_zero_s,
                               .uav = static_cast<int>(i),
                               .pose = poseOf(*vehicle(i))});
        }
        const double dt_s = m_scenario.dt_s;
        if (const std::optional<double> known_s = m_mission->poseTracks().knownUntil_s())
            m_mission->advance(std::floor(*known_s / dt_s) * dt_s);
        replaceMissions();
    }

    /** ArduPilot flies on to the old item after an upload; PX4 begins with the first. */
    void endSync(LinkAddress address)
    {
        const LinkVehicle& vehicle = *m_session.findVehicle(address);
        if (vehicle.sync->phase != SyncPhase::Equal)
            ++m_failedUploads;
        else if (m_mission && vehicle.autopilot == AutopilotKind::ArduPilot)
            m_session.sendCommand(address, itemCommand(vehicle.autopilot, 0));
    }

    /** Uploads a plan again when the next icebergs have changed. */
    void replaceMissions()
    {
        if (m_mission->simulation().finished())
            return;
        for (std::size_t i = 0; i < m_aircraft.size(); ++i) {
            const PlanPointer& plan = m_mission->plans().back();
            const UavPlan* own = plan->of(static_cast<int>(i));
            const std::optional<SyncStatus>& sync = vehicle(i)->sync;
            if (own == nullptr || (sync && (sync->phase == SyncPhase::Uploading ||
                                            sync->phase == SyncPhase::ReadingBack)))
                continue;
            std::vector<std::string> order;
            for (const IcebergIndex iceberg : own->order)
                order.push_back(m_mission->icebergs()[toIndex(iceberg)].id);
            if (!isAheadOnBoard(m_aircraft[i]->order, order))
                upload(i, uploadsOf(*m_mission)[i]);
        }
    }

    Scenario m_scenario;
    HubLink m_hub;
    LinkSession m_session;
    std::vector<std::unique_ptr<Aircraft>> m_aircraft;
    double m_time_s = 0;
    double m_zero_s = 0;
    std::unique_ptr<Mission> m_mission;
    int m_uploads = 0;
    int m_failedUploads = 0;
};

Scenario exampleNamed(const std::string& name)
{
    const std::string path = BERG_SOURCE_DIR "/resources/scenarios/" + name;
    return scenarioFromJson(readFile(path), path);
}

} // namespace

class TestRehearsedMission : public QObject
{
    Q_OBJECT

private slots:
    void zetaIsThatOfTheSimulation_data()
    {
        QTest::addColumn<bool>("isPx4");
        QTest::addColumn<double>("loss");
        QTest::addColumn<double>("limit");
        QTest::newRow("ArduPilot") << false << 0.0 << 0.02;
        QTest::newRow("PX4") << true << 0.0 << 0.02;
        // Each of the three uploads takes longer, and the aircraft flies the old order meanwhile.
        QTest::newRow("ArduPilot, 5 % lost") << false << 0.05 << 0.04;
    }

    /**
     * Twelve icebergs. The aircraft flies waypoints, with its own guidance and acceptance radius,
     * to where the icebergs were expected at the last upload. The simulated UAV flies towards
     * their present estimates. Both have the same drift.
     */
    void zetaIsThatOfTheSimulation()
    {
        QFETCH(bool, isPx4);
        QFETCH(double, loss);
        QFETCH(double, limit);
        RehearsedFlight flight(exampleNamed("grand-banks-12.berg"),
                               isPx4 ? AutopilotKind::Px4 : AutopilotKind::ArduPilot,
                               {.loss = loss, .delay_s = 0.1, .seed = 3});
        QVERIFY(flight.fly());
        Mission simulated(flight.scenario());
        simulated.advance(flight.scenario().duration_s);
        const double live_m2s = flight.mission().metrics().zeta_m2s;
        const double simulated_m2s = simulated.metrics().zeta_m2s;
        const double difference = live_m2s / simulated_m2s - 1;
        qInfo("zeta %.0f and %.0f m2 s (%+.2f %%), visits %d and %d, plans %d and %d, %d uploads",
              live_m2s, simulated_m2s, 100 * difference, flight.mission().metrics().visits,
              simulated.metrics().visits, flight.mission().metrics().replans,
              simulated.metrics().replans, flight.uploads());
        QVERIFY2(std::abs(difference) < limit, std::to_string(difference).c_str());
        QVERIFY(flight.largestError_m() < 15); // the delay of the link and a telemetry interval
        QVERIFY(flight.mission().metrics().visits >= 12);
    }

    /** Three aircraft on one link: each flies the plan of its UAV. */
    void threeAircraftAtOnce()
    {
        Scenario scenario = exampleNamed("melville-bay-three-uavs.berg");
        RehearsedFlight flight(scenario, AutopilotKind::ArduPilot, {.delay_s = 0.1});
        QVERIFY(flight.fly());
        Mission simulated(flight.scenario());
        simulated.advance(flight.scenario().duration_s);
        const double difference =
            flight.mission().metrics().zeta_m2s / simulated.metrics().zeta_m2s - 1;
        qInfo("zeta %+.2f %%, visits %d and %d, %d uploads, %d failed, error %.1f m",
              100 * difference, flight.mission().metrics().visits, simulated.metrics().visits,
              flight.uploads(), flight.failedUploads(), flight.largestError_m());
        QCOMPARE(flight.failedUploads(), 0);
        QVERIFY2(std::abs(difference) < 0.05, std::to_string(difference).c_str());
    }
};

QTEST_APPLESS_MAIN(TestRehearsedMission)
#include "tst_rehearsed_mission.moc"
