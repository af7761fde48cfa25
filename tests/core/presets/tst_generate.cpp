#include "core/base/angles.h"
#include "core/base/random.h"
#include "core/checks/validate.h"
#include "core/presets/generate.h"
#include "core/presets/presets.h"
#include "tests/support/expect_error.h"
#include "tests/support/flight/scenario_builder.h"

#include <QPointF>
#include <QTest>

#include <cmath>
#include <functional>
#include <set>

using namespace berg;
using namespace berg::test;

namespace {

std::vector<Point> rectangle(double width_m, double height_m)
{
    return {{0, 0}, {width_m, 0}, {width_m, height_m}, {0, height_m}};
}

FieldRequest request(int icebergs, std::vector<Point> area_m = rectangle(5000, 4000))
{
    FieldRequest r;
    r.icebergs = icebergs;
    r.area_m = std::move(area_m);
    return r;
}

/**
 * Returns true if a mean over n draws is within five standard errors of that of a uniform variable.
 */
bool isMeanOfUniform(double sum, int n, double low, double high)
{
    return std::abs(sum / n - (low + high) / 2) < 5 * (high - low) / std::sqrt(12.0 * n);
}

double heading_deg(const Point& velocity_mps)
{
    return degFromRad(std::atan2(velocity_mps.x(), velocity_mps.y()));
}

} // namespace

class TestGenerate : public QObject
{
    Q_OBJECT

private slots:
    void theDefaultFieldIsThePreset()
    {
        for (std::int64_t seed = 1; seed <= 20; ++seed) {
            FieldRequest r = request(12);
            r.seed = seed;
            QVERIFY(generateIcebergs(emptySea(), r) == randomScenario(seed).icebergs);
        }
    }

    /** Positions are the same; velocities are unknown except for their variation. */
    void driftAsFittedIsNotKnown()
    {
        FieldRequest r = request(12);
        r.fittedDrift = true;
        const Scenario expected = withFittedDrift(randomScenario(r.seed));
        QVERIFY(generateIcebergs(emptySea(), r) == expected.icebergs);
        QVERIFY(expected.observer.model == ObserverModel::Kalman);
        QVERIFY(expected.icebergs[3].velocity_mps.isZero(0));
        QCOMPARE(expected.icebergs[3].velocitySd_mps, 0.15);
        QCOMPARE(expected.icebergs[3].velocityTime_s, 36'000.0);
    }

    void seedsDiffer()
    {
        FieldRequest r = request(30);
        const std::vector<Iceberg> first = generateIcebergs(emptySea(), r);
        QVERIFY(first == generateIcebergs(emptySea(), r));
        r.seed = 2;
        QVERIFY(!(first == generateIcebergs(emptySea(), r)));
    }

    void everyNumberKeepsItsRange()
    {
        FieldRequest r = request(1000);
        r.speedMin_mps = 0.2;
        r.speedMax_mps = 0.3;
        r.towards_deg = 350; // across north
        r.spread_deg = 20;
        r.sigmaMin_m2 = 4;
        r.sigmaMax_m2 = 6;
        r.q_m2ps = 0.5;
        constexpr double kStep_mps = 1e-4; // velocities are rounded to it
        double heading = 0;
        double sigma_m2 = 0;
        for (const Iceberg& iceberg : generateIcebergs(emptySea(), r)) {
            const double speed_mps = iceberg.velocity_mps.norm();
            QVERIFY(speed_mps > 0.2 - kStep_mps && speed_mps < 0.3 + kStep_mps);
            const double off_deg =
                std::remainder(heading_deg(iceberg.velocity_mps) - r.towards_deg, 360.0);
            QVERIFY(std::abs(off_deg) < 20 + degFromRad(kStep_mps / 0.2));
            QVERIFY(iceberg.sigma0_m2 >= 4 && iceberg.sigma0_m2 <= 6);
            QCOMPARE(iceberg.q_m2ps, 0.5);
            heading += off_deg;
            sigma_m2 += iceberg.sigma0_m2;
        }
        QVERIFY(isMeanOfUniform(heading, 1000, -20, 20));
        QVERIFY(isMeanOfUniform(sigma_m2, 1000, 4, 6));
    }

    void areasAreFilledEvenlyAndKept_data()
    {
        QTest::addColumn<QList<QPointF>>("corners");
        QTest::newRow("triangle") << QList<QPointF>{{0, 0}, {3000, 0}, {0, 3000}};
        QTest::newRow("L") << QList<QPointF>{{0, 0},       {3000, 0},    {3000, 1000},
                                             {1000, 1000}, {1000, 3000}, {0, 3000}};
        QTest::newRow("tiny") << QList<QPointF>{{10, 10}, {10.5, 10}, {10.5, 10.5}, {10, 10.5}};
        QTest::newRow("far corner")
            << QList<QPointF>{{1e6, 1e6}, {1e6 - 2000, 1e6}, {1e6, 1e6 - 2000}};
        QTest::newRow("thin") << QList<QPointF>{{0, 0}, {5000, 4900}, {5000, 5000}, {0, 100}};
    }
    void areasAreFilledEvenlyAndKept()
    {
        QFETCH(const QList<QPointF>, corners);
        std::vector<Point> area_m;
        Point centre_m = Point::Zero();
        for (const QPointF& corner : corners) {
            area_m.emplace_back(corner.x(), corner.y());
            centre_m += area_m.back() / static_cast<double>(corners.size());
        }
        Scenario scenario = emptySea();
        scenario.icebergs = generateIcebergs(scenario, request(1000, area_m));
        int west = 0;
        int expectedWest = 0;
        Random random(99);
        for (const Iceberg& iceberg : scenario.icebergs) {
            QVERIFY(insidePolygon(area_m, iceberg.position_m));
            west += iceberg.position_m.x() < centre_m.x() ? 1 : 0;
        }
        // The share west of the mean corner, by rejection in the rectangle round the area.
        Point lowest_m = area_m.front();
        Point highest_m = area_m.front();
        for (const Point& corner_m : area_m) {
            lowest_m = lowest_m.cwiseMin(corner_m);
            highest_m = highest_m.cwiseMax(corner_m);
        }
        for (int n = 0; n < 20000;) {
            const Point p_m(random.uniform(lowest_m.x(), highest_m.x()),
                            random.uniform(lowest_m.y(), highest_m.y()));
            if (!insidePolygon(area_m, p_m))
                continue;
            ++n;
            expectedWest += p_m.x() < centre_m.x() ? 1 : 0;
        }
        // Five standard deviations of a share of n = 1000.
        QVERIFY(std::abs(west / 1000.0 - expectedWest / 20000.0) < 5 * 0.5 / std::sqrt(1000.0));
        QVERIFY(!hasErrors(validate(scenario)));
    }

    void idsAreFresh()
    {
        Scenario scenario = emptySea();
        addIceberg(scenario, 100, 100).id = "berg-4";
        scenario.uavs[0].id = "berg-3";
        const std::vector<Iceberg> icebergs = generateIcebergs(scenario, request(3));
        QCOMPARE(icebergs[0].id, std::string("berg-2"));
        QCOMPARE(icebergs[1].id, std::string("berg-5"));
        QCOMPARE(icebergs[2].id, std::string("berg-6"));
        scenario.icebergs.insert(scenario.icebergs.end(), icebergs.begin(), icebergs.end());
        QVERIFY(!hasErrors(validate(scenario)));
    }

    void spacingIsKeptToAll()
    {
        Scenario scenario = emptySea();
        addIceberg(scenario, 2500, 2000);
        FieldRequest r = request(40);
        r.spacing_m = 400;
        std::vector<Iceberg> all = generateIcebergs(scenario, r);
        QCOMPARE(all.size(), std::size_t{40});
        all.push_back(scenario.icebergs.front());
        for (std::size_t i = 0; i < all.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                QVERIFY((all[i].position_m - all[k].position_m).norm() >= 400);
    }

    void impossibleSpacingIsRefused()
    {
        FieldRequest r = request(100, rectangle(1000, 1000));
        r.spacing_m = 300; // room for about 16
        const auto error = errorOf([&] { (void)generateIcebergs(emptySea(), r); });
        QVERIFY(error.has_value());
        QCOMPARE(codeName(error->code()), std::string("InvalidInput"));
        QCOMPARE(error->issues().size(), std::size_t{1});
        QCOMPARE(error->issues()[0].field, std::string("spacing_m"));
        QVERIFY(error->issues()[0].message().find("of 100 icebergs") != std::string::npos);
    }

    void hairlineAreaIsRefused()
    {
        const FieldRequest r = request(100, {{0, 0}, {5000, 5000}, {5000, 5000.001}});
        const auto error = errorOf([&] { (void)generateIcebergs(emptySea(), r); });
        QVERIFY(error && names(error->issues(), "area_m"));
    }

    void faultsAreNamed_data()
    {
        using Change = std::function<void(FieldRequest&)>;
        QTest::addColumn<Change>("change");
        QTest::addColumn<QString>("field");
        const auto row = [](const char* field, const Change& change) {
            QTest::newRow(field) << change << QString(field);
        };
        row("icebergs", [](FieldRequest& r) { r.icebergs = 0; });
        row("area_m", [](FieldRequest& r) { r.area_m.resize(2); });
        row("speedMax_mps", [](FieldRequest& r) { r.speedMax_mps = 5.1; });
        row("speedMin_mps", [](FieldRequest& r) { r.speedMin_mps = -0.1; });
        row("spread_deg", [](FieldRequest& r) { r.spread_deg = 181; });
        row("towards_deg", [](FieldRequest& r) { r.towards_deg = std::nan(""); });
        row("sigmaMax_m2", [](FieldRequest& r) { r.sigmaMax_m2 = 0.5; });
        row("q_m2ps", [](FieldRequest& r) { r.q_m2ps = -1; });
        row("seed", [](FieldRequest& r) { r.seed = -1; });
        row("spacing_m", [](FieldRequest& r) { r.spacing_m = -1; });
    }
    void faultsAreNamed()
    {
        QFETCH(const std::function<void(FieldRequest&)>, change);
        QFETCH(const QString, field);
        FieldRequest r = request(5);
        change(r);
        const auto error = errorOf([&] { (void)generateIcebergs(emptySea(), r); });
        QVERIFY(error.has_value());
        QCOMPARE(error->issues().size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(error->issues()[0].field), field);
    }

    void crossedAreaIsRefused()
    {
        const FieldRequest r = request(5, {{0, 0}, {9, 9}, {9, 0}, {0, 9}});
        const auto error = errorOf([&] { (void)generateIcebergs(emptySea(), r); });
        QVERIFY(error && names(error->issues(), "area_m"));
    }

    void roomIsLimited()
    {
        Scenario scenario = emptySea();
        scenario.icebergs = generateIcebergs(scenario, request(999));
        QCOMPARE(generateIcebergs(scenario, request(1)).size(), std::size_t{1});
        for (const int more : {2, 1000}) {
            const auto error = errorOf([&] { (void)generateIcebergs(scenario, request(more)); });
            QVERIFY(error && names(error->issues(), "icebergs"));
        }
    }
};

QTEST_APPLESS_MAIN(TestGenerate)
#include "tst_generate.moc"
