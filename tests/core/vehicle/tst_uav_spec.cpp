#include "core/base/angles.h"
#include "core/vehicle/uav_spec.h"
#include "tests/support/approx.h"

using namespace berg;

class TestUavSpec : public QObject
{
    Q_OBJECT

private slots:
    /** Table 3: U = 22 m/s, g/U tan(5 pi/36). */
    void limitsOfThePaper()
    {
        const UavSpec spec;
        COMPARE_NEAR(maxTurnRate_radps(spec), 0.2079, 5e-5); // four figures
        COMPARE_NEAR(turnRadius_m(spec), 105.8, 0.05);
        COMPARE_NEAR(maxTurnRate_radps(spec), 9.81 / 22 * std::tan(5 * kPi / 36), 1e-15);
    }

    /** R = U^2 / (g tan(bank)). */
    void limitsFollowSpeedAndBank_data()
    {
        QTest::addColumn<double>("airspeed_mps");
        QTest::addColumn<double>("bank_deg");
        QTest::addColumn<double>("radius_m");
        QTest::newRow("bank 45: U^2/g") << 30.0 << 45.0 << 900 / 9.81;
        QTest::newRow("bank 60") << 20.0 << 60.0 << 400 / 9.81 / std::sqrt(3.0);
        QTest::newRow("bank 30") << 12.0 << 30.0 << 144 / 9.81 * std::sqrt(3.0);
    }

    void limitsFollowSpeedAndBank()
    {
        QFETCH(double, airspeed_mps);
        QFETCH(double, bank_deg);
        QFETCH(double, radius_m);
        const UavSpec spec{.airspeed_mps = airspeed_mps, .maxBank_deg = bank_deg};
        COMPARE_NEAR(turnRadius_m(spec), radius_m, 1e-10);
        COMPARE_NEAR(maxTurnRate_radps(spec), airspeed_mps / radius_m, 1e-13);
    }
};

QTEST_APPLESS_MAIN(TestUavSpec)
#include "tst_uav_spec.moc"
