#include "core/base/random.h"
#include "core/checks/validate.h"
#include "core/scenario/limits.h"
#include "core/scenario/recovery.h"
#include "core/scenario/text_checks.h"
#include "core/vehicle/uav_spec.h"
#include "tests/support/flight/scenario_builder.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace berg;
using namespace berg::test;

namespace {

/** UAVs of two pads, 1 km apart, and two altitude layers, with endurances between 400 and 900 s. */
Scenario randomPads(std::uint64_t seed)
{
    Random random(seed, 5);
    Scenario s = emptySea();
    const Uav first = s.uavs.front();
    s.uavs.clear();
    const auto count = 1 + random.below(6);
    for (std::uint64_t i = 0; i < count; ++i) {
        Uav uav = first;
        uav.id = "uav-" + std::to_string(i + 1);
        uav.home_m = Point(1000.0 * static_cast<double>(random.below(2)), 0);
        uav.spec.altitude_m += kLayerHeight_m * static_cast<double>(random.below(2));
        uav.spec.endurance_s = random.below(3) == 0 ? 900 : random.uniform(400, 900);
        s.uavs.push_back(uav);
    }
    return s;
}

} // namespace

class TestRecovery : public QObject
{
    Q_OBJECT

private slots:
    void slotsOfMatesAreApart()
    {
        for (std::uint64_t seed = 1; seed <= 500; ++seed) {
            const Scenario s = randomPads(seed);
            const std::vector<double> withheld_s = withheldAtStart_s(s);
            const auto arrival_s = [&](std::size_t uav) {
                return usableEndurance_s(s.uavs[uav].spec) - withheld_s[uav];
            };
            for (std::size_t uav = 0; uav < s.uavs.size(); ++uav) {
                const std::vector<int> mates = padMates(s, uav);
                QVERIFY(withheld_s[uav] >= 0);
                QCOMPARE(slotOfSortie_s(s, uav, withheld_s[uav]).has_value(), !mates.empty());
                if (mates.empty())
                    QCOMPARE(withheld_s[uav], 0.0);
                for (const int mate : mates) {
                    const Uav& other = s.uavs[static_cast<std::size_t>(mate)];
                    QVERIFY(*other.home_m == *s.uavs[uav].home_m);
                    QCOMPARE(other.spec.altitude_m, s.uavs[uav].spec.altitude_m);
                    QVERIFY(std::abs(arrival_s(uav) - arrival_s(static_cast<std::size_t>(mate))) >=
                            kRecoverySlot_s - 1e-9);
                }
            }
        }
    }

    /**
     * Six equal UAVs: the first is home a slot before its endurance ends, each further one a slot
     * earlier.
     */
    void alikeOnesLandOneAfterAnother()
    {
        Scenario s = emptySea();
        s.uavs.front().spec.endurance_s = 900;
        while (s.uavs.size() < 6)
            s.uavs.push_back(s.uavs.front());
        const std::vector<double> withheld_s = withheldAtStart_s(s);
        for (std::size_t k = 0; k < withheld_s.size(); ++k)
            QCOMPARE(withheld_s[k], kRecoverySlot_s * static_cast<double>(k + 1));
        s.separation_m = 0;
        QVERIFY(
            std::ranges::all_of(withheldAtStart_s(s), [](double time_s) { return time_s == 0; }));
    }

    /** A fleet too large for its endurance leaves at least half of it to each UAV. */
    void halfOfTheEnduranceIsLeft()
    {
        Scenario s = emptySea();
        s.uavs.front().spec.endurance_s = 100;
        s.uavs.front().spec.reserve_s = 0;
        while (s.uavs.size() < 6)
            s.uavs.push_back(s.uavs.front());
        const std::vector<double> withheld_s = withheldAtStart_s(s);
        QCOMPARE(std::ranges::max(withheld_s), 50.0);
    }

    /** Each UAV is planned home a slot earlier than the one before. */
    void validateWarnsOfThem()
    {
        Scenario s = emptySea();
        addIceberg(s, 500, 0);
        s.uavs[0].spec.endurance_s = 1000;
        s.uavs.push_back(s.uavs[0]);
        s.uavs[1].id = "second";
        s.uavs[1].position_m = {1000, 0};
        s.uavs[1].home_m = s.uavs[0].position_m;
        const auto warnings = [](const Scenario& scenario) {
            std::vector<Issue> found = validate(scenario);
            std::erase_if(
                found, [](const Issue& issue) { return issue.reason.id != IssueId::RecoverySlot; });
            return found;
        };
        std::vector<Issue> expected;
        for (const double withheld_s : {30.0, 60.0})
            expected.push_back({Severity::Warning,
                                entryPath("uavs", expected.size()) + ".endurance_s",
                                {.id = IssueId::RecoverySlot,
                                 .arguments = {Amount{withheld_s, Quantity::Seconds}}}});
        QVERIFY(warnings(s) == expected);
        Scenario layered = s;
        layered.uavs[1].spec.altitude_m += kLayerHeight_m;
        QVERIFY(warnings(layered).empty());
        s.uavs[1].home_m.reset();
        QVERIFY(warnings(s).empty());
    }
};

QTEST_APPLESS_MAIN(TestRecovery)
#include "tst_recovery.moc"
