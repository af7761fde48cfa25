#include "core/base/angles.h"
#include "core/base/random.h"
#include "core/sim/departure.h"
#include "core/sim/holding.h"

#include <QTest>

#include <cmath>
#include <deque>

using namespace berg;

namespace {

/**
 * Two to five UAVs at one place, or departing near it, in wind and with different autopilot rates.
 */
class StartCase
{
public:
    explicit StartCase(std::uint64_t seed)
    {
        Random random(seed, 77);
        separation_m = random.uniform(50, 200);
        const double from_rad = random.uniform(-kPi, kPi);
        const Point wind_mps = random.uniform(0, 8) * Point(std::cos(from_rad), std::sin(from_rad));
        const auto count = 2 + random.below(4);
        const bool isOnePlace = random.below(2) == 0;
        for (std::uint64_t i = 0; i < count; ++i) {
            const double airspeed_mps = random.uniform(18, 26);
            m_guards.emplace_back(GuardedUav{.motion = {.airspeed_mps = airspeed_mps,
                                                        .limit_radps = 4.6 / airspeed_mps,
                                                        .wind_mps = wind_mps},
                                             .sortie = {},
                                             .fence = nullptr,
                                             .clock = {.steps = random.below(3) == 0 ? 10 : 1}});
            const double away_rad = random.uniform(-kPi, kPi);
            const double away_m = isOnePlace ? 0 : random.uniform(0, 400);
            uavs.push_back(
                {.guard = m_guards.back(),
                 .pose = {.position_m = away_m * Point(std::cos(away_rad), std::sin(away_rad)),
                          .psi_rad = away_rad + random.uniform(-kPi / 2, kPi / 2)},
                 .radius_m = holdingRadius_m(m_guards.back())});
        }
    }

    double separation_m = 0;
    std::vector<Departing> uavs;

private:
    std::deque<SafetyGuard> m_guards; // addresses must not change
};

} // namespace

class TestDeparture : public QObject
{
    Q_OBJECT

private slots:
    /** Flown command by command, UAVs that were once apart stay so and end in clear discs. */
    void onceApartTheyStayApart()
    {
        int found = 0;
        constexpr int kCases = 100;
        for (std::uint64_t seed = 1; seed <= kCases; ++seed) {
            const StartCase start(seed);
            std::vector<Departure> departures = departuresOf(
                start.uavs, start.separation_m, [](std::size_t, const Departure&) { return true; });
            found += departures.empty() ? 0 : 1;
            std::vector<std::vector<DubinsState>> flown(departures.size());
            for (std::size_t i = 0; i < departures.size(); ++i) {
                const Departing& uav = start.uavs[i];
                Departure left = departures[i];
                flown[i].push_back(uav.pose);
                while (const auto rate_radps = left.takeNext_radps(uav.guard.uav().clock.steps))
                    for (std::int64_t step = 0; step < uav.guard.uav().clock.steps; ++step)
                        flown[i].push_back(uav.guard.heldFor(flown[i].back(), *rate_radps, 1));
                QVERIFY(left.path_m.empty());
                QVERIFY(
                    (middleBeside_m(flown[i].back(), uav.guard.uav().motion, departures[i].side) -
                     departures[i].middle_m)
                        .norm() < 1e-6);
            }
            for (std::size_t a = 0; a < flown.size(); ++a)
                for (std::size_t b = 0; b < a; ++b) {
                    QCOMPARE(flown[a].size(), flown[b].size());
                    bool wereApart = false;
                    for (std::size_t step = 0; step < flown[a].size(); ++step) {
                        const bool areApart =
                            (flown[a][step].position_m - flown[b][step].position_m).norm() >=
                            start.separation_m;
                        QVERIFY(areApart || !wereApart);
                        wereApart = areApart;
                    }
                    QVERIFY((departures[a].middle_m - departures[b].middle_m).norm() >=
                            start.uavs[a].radius_m + start.uavs[b].radius_m + start.separation_m);
                }
        }
        QCOMPARE(found, kCases);
    }
};

QTEST_APPLESS_MAIN(TestDeparture)
#include "tst_departure.moc"
