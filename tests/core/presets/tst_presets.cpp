#include "core/base/angles.h"
#include "core/presets/presets.h"

#include <QTest>

#include <array>
#include <cmath>
#include <set>
#include <utility>

using namespace berg;

namespace {

/**
 * Returns true if a mean over n draws is within five standard errors of that of a uniform variable.
 */
bool isMeanOfUniform(double sum, int n, double low, double high)
{
    const double standardError = (high - low) / std::sqrt(12.0 * n);
    return std::abs(sum / n - (low + high) / 2) < 5 * standardError;
}

} // namespace

class TestPresets : public QObject
{
    Q_OBJECT

private slots:
    void valuesOfTheModel()
    {
        const Scenario s = randomScenario(7);
        QCOMPARE(s.icebergs.size(), std::size_t{12});
        QCOMPARE(s.uavs.size(), std::size_t{1});
        QCOMPARE(s.uavs[0].id, std::string("uav-1"));
        QVERIFY(s.uavs[0].position_m == Point(-500, 500));
        QCOMPARE(s.uavs[0].heading_deg, 45.0);
        QCOMPARE(s.uavs[0].spec.airspeed_mps, 22.0);
        QCOMPARE(s.uavs[0].spec.maxBank_deg, 25.0);
        QVERIFY(s.uavs[0].fov_m == Point(600, 600));
        QCOMPARE(s.duration_s, 1000.0);
        QCOMPARE(s.dt_s, 0.1);
        QCOMPARE(s.seed, std::int64_t{7});
        QVERIFY(s.noise);
        QCOMPARE(s.planner.tau, 1.0);
        for (std::size_t i = 0; i < s.icebergs.size(); ++i) {
            QCOMPARE(s.icebergs[i].id, "berg-" + std::to_string(i + 1));
            QCOMPARE(s.icebergs[i].q_m2ps, 0.025);
            QCOMPARE(s.icebergs[i].observed_s, 0.0);
            QCOMPARE(s.icebergs[i].appears_s, 0.0);
        }
    }

    /** Regimes have the same icebergs with other knowledge and observations. */
    void regimesDifferInTheirObserverAndVelocities()
    {
        const Scenario published = randomScenario(7);
        QVERIFY(published.observer.model == ObserverModel::Simple);
        Scenario measured = randomScenario(7, {.regime = FieldRegime::Measured});
        QVERIFY(measured.observer.model == ObserverModel::Kalman);
        QVERIFY(measured.icebergs == published.icebergs);
        Scenario unknown = randomScenario(7, {.regime = FieldRegime::UnknownVelocity});
        QVERIFY(unknown.observer == measured.observer);
        for (Iceberg& iceberg : unknown.icebergs)
            QCOMPARE(std::exchange(iceberg.velocitySd_mps, 0.0), 0.1);
        QVERIFY(unknown.icebergs == published.icebergs);
        QVERIFY(randomScenario(7, {.regime = FieldRegime::FittedDrift}) ==
                withFittedDrift(published));
    }

    void drawsAreUniform()
    {
        double x_m = 0;
        double y_m = 0;
        double speed_mps = 0;
        double sigma_m2 = 0;
        std::array<int, 4> quadrants{};
        int n = 0;
        for (std::int64_t seed = 0; seed < 200; ++seed)
            for (const Iceberg& iceberg : randomScenario(seed).icebergs) {
                ++n;
                const Point& p_m = iceberg.position_m;
                const Point& v_mps = iceberg.velocity_mps;
                QVERIFY(p_m.x() >= 0 && p_m.x() <= 5000 && p_m.y() >= 0 && p_m.y() <= 4000);
                // 0.0001: components are rounded to 0.0001 m/s.
                QVERIFY(v_mps.norm() <= 0.4 + 1e-4);
                QVERIFY(iceberg.sigma0_m2 >= 1 && iceberg.sigma0_m2 <= 10);
                x_m += p_m.x();
                y_m += p_m.y();
                speed_mps += v_mps.norm();
                sigma_m2 += iceberg.sigma0_m2;
                quadrants[(v_mps.x() < 0 ? 1U : 0U) + (v_mps.y() < 0 ? 2U : 0U)]++;
            }
        QCOMPARE(n, 2400);
        QVERIFY(isMeanOfUniform(x_m, n, 0, 5000));
        QVERIFY(isMeanOfUniform(y_m, n, 0, 4000));
        QVERIFY(isMeanOfUniform(speed_mps, n, 0, 0.4));
        QVERIFY(isMeanOfUniform(sigma_m2, n, 1, 10));
        // Five standard deviations of a binomial share of one quarter.
        for (const int count : quadrants)
            QVERIFY(std::abs(count - n / 4.0) < 5 * std::sqrt(n * 0.25 * 0.75));
    }

    void sameSeedSameScenario()
    {
        QVERIFY(randomScenario(5) == randomScenario(5));
        std::set<double> firstX_m;
        for (std::int64_t seed = 0; seed < 100; ++seed)
            firstX_m.insert(randomScenario(seed).icebergs[0].position_m.x());
        QVERIFY(firstX_m.size() >= 99); // centimetres in 5 km: one collision is likely enough
    }

    void moreIcebergsKeepTheFirst()
    {
        const Scenario few = randomScenario(3, {.icebergs = 5});
        const Scenario many = randomScenario(3, {.icebergs = 40});
        QCOMPARE(many.icebergs.size(), std::size_t{40});
        for (std::size_t i = 0; i < few.icebergs.size(); ++i)
            QVERIFY(few.icebergs[i] == many.icebergs[i]);
    }

    void specIsObeyed()
    {
        const FieldSpec spec{.icebergs = 30,
                             .size_m = Point(100, 200),
                             .speedMax_mps = 0,
                             .sigmaMin_m2 = 3,
                             .sigmaMax_m2 = 3,
                             .q_m2ps = 0.5};
        for (const Iceberg& iceberg : randomScenario(1, spec).icebergs) {
            QVERIFY(iceberg.position_m.x() <= 100 && iceberg.position_m.y() <= 200);
            QVERIFY(iceberg.velocity_mps.isZero(0));
            QCOMPARE(iceberg.sigma0_m2, 3.0);
            QCOMPARE(iceberg.q_m2ps, 0.5);
        }
        QVERIFY(randomScenario(1, {.icebergs = 0}).icebergs.empty());
        QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)randomScenario(1, {.icebergs = -1}));
        QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)randomScenario(-1));
    }

    void numbersAreShort()
    {
        for (const Iceberg& iceberg : randomScenario(2).icebergs) {
            const double east_cm = iceberg.position_m.x() * 100;
            const double sigma_1000 = iceberg.sigma0_m2 * 1000;
            // 1e-6: rounding of the product, far below the step of 1.
            QVERIFY(std::abs(east_cm - std::round(east_cm)) < 1e-6);
            QVERIFY(std::abs(sigma_1000 - std::round(sigma_1000)) < 1e-6);
        }
    }

    void defaultIsTheFirstOnTheGrandBanks()
    {
        const Scenario s = defaultScenario();
        QCOMPARE(s.name, std::string("Grand Banks, 12 icebergs"));
        QVERIFY(s.origin == (LatLon{.latitude_deg = 47, .longitude_deg = -48}));
        Scenario same = randomScenario(1);
        same.name = s.name;
        same.origin = s.origin;
        QVERIFY(s == same);
    }
};

QTEST_APPLESS_MAIN(TestPresets)
#include "tst_presets.moc"
