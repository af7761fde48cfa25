#include "core/mission/flight_places.h"
#include "core/presets/presets.h"
#include "tests/support/approx.h"

#include <QTest>

using namespace berg;

namespace {

Scenario oneIceberg()
{
    Scenario scenario;
    scenario.duration_s = 600;
    scenario.noise = false;
    Uav& uav = scenario.uavs.emplace_back();
    uav.id = "uav-1";
    uav.heading_deg = 90;
    uav.spec.airspeed_mps = 20;
    scenario.icebergs.push_back({.id = "berg-1", .position_m = {4000, 0}});
    return scenario;
}

} // namespace

class TestFlightPlaces : public QObject
{
    Q_OBJECT

private slots:
    /** 4 km at 20 m/s take 200 s; the UAV then stays until the run ends. */
    void plannedFlightGoesToEachIceberg()
    {
        const Scenario scenario = oneIceberg();
        const auto flights = plannedFlights(scenario, planFromStart(scenario));
        QCOMPARE(flights.size(), 1U);
        QCOMPARE(flights[0].size(), 3U);
        COMPARE_NEAR(flights[0][1].time_s, 200, 1e-6);
        COMPARE_NEAR(flights[0][1].position_m.x(), 4000, 1e-6);
        QCOMPARE(flights[0][2].time_s, 600.0);
    }

    void plannedFlightEndsWithRunOrEndurance()
    {
        Scenario scenario = oneIceberg();
        scenario.duration_s = 100; // the half
        const auto flights = plannedFlights(scenario, planFromStart(scenario));
        QCOMPARE(flights[0].back().time_s, 100.0);
        COMPARE_NEAR(flights[0].back().position_m.x(), 2000, 1e-6);
    }

    void placesAreNotedEachMinute()
    {
        const Scenario scenario = oneIceberg();
        Mission mission(scenario, {.record = false});
        FlightPlaces places;
        places.note(mission.simulation());
        mission.advance(150, {}, [&](double) { places.note(mission.simulation()); });
        places.finish(mission.simulation());
        const std::vector<FlightPlace>& flight = places.flights().at(0);
        QCOMPARE(flight.size(), 4U); // 0, 60, 120 and 150 s
        COMPARE_NEAR(flight[1].time_s, 60, 1e-6);
        COMPARE_NEAR(flight[1].position_m.x(), 1200, 1);
        COMPARE_NEAR(flight.back().time_s, 150, 1e-6);
        QVERIFY(!flight.back().isLanding);
    }

    void samplesOnTheGroundEndTheFlight()
    {
        FlightPlaces places;
        Sample sample{.uavs = {UavSample{}}};
        places.note(sample);
        sample.time_s = 60;
        sample.uavs[0].onGround = true;
        places.note(sample);
        sample.time_s = 90; // too soon after the last one
        sample.uavs[0].onGround = false;
        places.note(sample);
        sample.time_s = 120;
        places.note(sample);
        const std::vector<FlightPlace>& flight = places.flights().at(0);
        QCOMPARE(flight.size(), 2U);
        QVERIFY(flight[0].isLanding);
        QCOMPARE(flight[1].time_s, 120.0);
    }
};

QTEST_APPLESS_MAIN(TestFlightPlaces)
#include "tst_flight_places.moc"
