#include "core/base/random.h"
#include "core/tracking/position_error.h"
#include "tests/support/approx.h"

#include <QtTest>

#include <cmath>
#include <set>
#include <string>

using namespace berg;

class TestPositionError : public QObject
{
    Q_OBJECT

private slots:
    /** 1 - exp(-r^2 / (2 sigma)) of a normal distribution in two dimensions lies inside r. */
    void radiusHolds95Percent()
    {
        COMPARE_NEAR(kChiSquare95, -2 * std::log(0.05), 1e-14); // a unit of the last place
        for (const double sigma_m2 : {0.0, 5.0, 250.0, 1e6}) {
            const double radius_m = radius95_m(sigma_m2);
            if (sigma_m2 > 0)
                COMPARE_NEAR(1 - std::exp(-radius_m * radius_m / (2 * sigma_m2)), 0.95, 1e-12);
            COMPARE_NEAR(sigmaOfRadius95_m2(radius_m), sigma_m2, 1e-12 * (1 + sigma_m2));
        }
    }

    /** sigma is the variance along each axis, as the noise of the drift draws it. */
    void drawnPositionsAreInside()
    {
        constexpr int kDrawn = 20000;
        const double sd_m = 30;
        Random random(7, 1);
        int inside = 0;
        for (int i = 0; i < kDrawn; ++i) {
            const double east_m = sd_m * random.normal();
            const double north_m = sd_m * random.normal();
            inside += std::hypot(east_m, north_m) <= radius95_m(sd_m * sd_m) ? 1 : 0;
        }
        // Four standard deviations of a share of 20,000: 4 sqrt(0.95 0.05 / n) = 0.006.
        COMPARE_NEAR(static_cast<double>(inside) / kDrawn, 0.95, 0.006);
    }

    void everySourceIsFoundAgain()
    {
        std::set<std::string_view> names;
        for (const SightingSource source : kSightingSources) {
            const SourceError& error = errorOf(source);
            QVERIFY(error.sd_m > 0);
            QVERIFY(error.reason.size() > 20);
            QVERIFY(names.insert(error.name).second);
            QVERIFY(sourceNamed(error.name) == source);
            QVERIFY(sourceWith(error.sigma_m2()) == source); // no two have the same
        }
        QVERIFY(!sourceNamed("crystal ball"));
        QVERIFY(!sourceNamed(""));
        QVERIFY(!sourceWith(5));
    }
};

QTEST_APPLESS_MAIN(TestPositionError)
#include "tst_position_error.moc"
