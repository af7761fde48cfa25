#include "core/base/angles.h"
#include "core/vehicle/safety_guard.h"

#include <QTest>

using namespace berg;

namespace {

const std::vector<Point> kSquare_m{{0, 0}, {3000, 0}, {3000, 3000}, {0, 3000}};

/** A UAV with all data of its guard. */
struct Guarded
{
    Motion motion;
    std::optional<SortieSpec> sortie;
    std::shared_ptr<const Geofence> fence = std::make_shared<Geofence>(kSquare_m, motion);

    [[nodiscard]] SafetyGuard guard(bool isFenced = true) const
    {
        return SafetyGuard({.motion = motion,
                            .sortie = sortie,
                            .fence = isFenced ? fence : nullptr,
                            .clock = {.dt_s = 0.1}});
    }
};

} // namespace

class TestSafetyGuard : public QObject
{
    Q_OBJECT

private slots:
    void commandsFarFromTheFenceStay()
    {
        const Guarded uav;
        const DubinsState middle{.position_m = {1500, 1500}};
        for (const double u_radps : {-0.2, 0.0, 0.03})
            QCOMPARE(uav.guard().limitedToFence_radps(middle, u_radps), u_radps);
    }

    void commandsStraightAtTheFenceAreTurnedAway()
    {
        const Guarded uav;
        const SafetyGuard guard = uav.guard();
        DubinsState at{.position_m = {1500, 1500}, .psi_rad = 0.1};
        for (int step = 0; step < 3000; ++step) {
            at = guard.heldFor(at, guard.limitedToFence_radps(at, 0), 1);
            QVERIFY(uav.fence->contains(at.position_m));
        }
    }

    void withoutAFenceNothingIsLimited()
    {
        const DubinsState atTheEdge{.position_m = {2999, 1500}};
        QCOMPARE(Guarded().guard(false).limitedToFence_radps(atTheEdge, 0), 0.0);
    }

    /** The reserve is ten seconds in addition to the flight itself. */
    void homeInTimeIsThePathAndTheReserve()
    {
        const Guarded uav{.sortie = SortieSpec{.endurance_s = 600, .home_m = {0, 0}}};
        const SafetyGuard guard = uav.guard(false);
        const DubinsState towardsHome{.position_m = {2200, 0}, .psi_rad = kPi};
        QVERIFY(std::abs(guard.timeHome_s(towardsHome).value() - 100) < 1e-9);
        QVERIFY(!guard.homeInTimeAfter(towardsHome, 0, 100 + kHomeReserve_s - 0.1));
        QVERIFY(guard.homeInTimeAfter(towardsHome, 0, 100 + kHomeReserve_s + 0.1));
        QVERIFY(std::abs(guard.homeRate_radps(towardsHome)) < 1e-9);
    }
};

QTEST_APPLESS_MAIN(TestSafetyGuard)
#include "tst_safety_guard.moc"
