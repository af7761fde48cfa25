#include "core/io/figure/wind_barb.h"
#include "tests/support/approx.h"

#include <QtTest>

using namespace berg;

namespace {

constexpr double kShaft_px = 20;

Point westerly_mps(double speed_kn)
{
    return {speed_kn * 1852 / 3600, 0};
}

/** Length of a line. */
double length_px(const std::vector<Pixel>& line)
{
    return std::hypot(line.back().x - line.front().x, line.back().y - line.front().y);
}

} // namespace

/** Wind barbs and arrows in pixels. */
class TestWindBarb : public QObject
{
    Q_OBJECT

private slots:
    void speedsAreInBarbs_data()
    {
        QTest::addColumn<double>("speed_kn");
        QTest::addColumn<int>("pennants");
        QTest::addColumn<int>("barbs");
        QTest::addColumn<int>("halves");
        QTest::newRow("3 is rounded up") << 3.0 << 0 << 0 << 1;
        QTest::newRow("5") << 5.0 << 0 << 0 << 1;
        QTest::newRow("10") << 10.0 << 0 << 1 << 0;
        QTest::newRow("17") << 17.0 << 0 << 1 << 1;
        QTest::newRow("48 is a pennant") << 48.0 << 1 << 0 << 0;
        QTest::newRow("65") << 65.0 << 1 << 1 << 1;
        QTest::newRow("120") << 120.0 << 2 << 2 << 0;
        QTest::newRow("250, beyond all storms") << 250.0 << 5 << 0 << 0;
    }

    void speedsAreInBarbs()
    {
        QFETCH(double, speed_kn);
        QFETCH(int, pennants);
        QFETCH(int, barbs);
        QFETCH(int, halves);
        const WindBarb barb = windBarb(westerly_mps(speed_kn), kShaft_px, false);
        QVERIFY(!barb.calm_px);
        QCOMPARE(static_cast<int>(barb.pennants.size()), pennants);
        QCOMPARE(static_cast<int>(barb.lines.size()), 1 + barbs + halves);
        if (halves > 0)
            QVERIFY(length_px(barb.lines.back()) < 0.6 * kShaft_px * 0.5);
        for (std::size_t i = 1; i < barb.lines.size(); ++i) // on the shaft, apart from each other
            QVERIFY(barb.lines[i].front().x < 0 &&
                    barb.lines[i].front().x >= barb.lines[0].back().x);
    }

    void calmIsACircle()
    {
        for (const double speed_kn : {0.0, 2.4}) {
            const WindBarb barb = windBarb(westerly_mps(speed_kn), kShaft_px, false);
            QVERIFY(barb.calm_px.has_value());
            QVERIFY(barb.lines.empty() && barb.pennants.empty());
        }
    }

    /** The shaft of a west wind points to the west; its barbs are to the north, in the south to the
     * south. */
    void shaftPointsIntoTheWind()
    {
        const WindBarb north = windBarb(westerly_mps(20), kShaft_px, false);
        COMPARE_NEAR(north.lines[0].back().x, -kShaft_px, 1e-9);
        COMPARE_NEAR(north.lines[0].back().y, 0, 1e-9);
        QVERIFY(north.lines[1].back().y < -5); // pixels go down
        const WindBarb south = windBarb(westerly_mps(20), kShaft_px, true);
        COMPARE_NEAR(south.lines[1].back().y, -north.lines[1].back().y, 1e-9);
        COMPARE_NEAR(south.lines[1].back().x, north.lines[1].back().x, 1e-9);
        const WindBarb northerly = windBarb(Point(0, -10), kShaft_px, false);
        COMPARE_NEAR(northerly.lines[0].back().y, -kShaft_px, 1e-9);
        QVERIFY(northerly.lines[1].back().x > 5); // to the east
    }

    void aHalfBarbAloneIsInsideTheShaft()
    {
        const WindBarb barb = windBarb(westerly_mps(5), kShaft_px, false);
        QVERIFY(barb.lines[1].front().x > barb.lines[0].back().x + 2);
    }

    void arrowsPointWhereTheWaterFlows()
    {
        const auto paths = velocityArrow(Point(0, 0.5), 12); // to the north
        COMPARE_NEAR(paths[0].front().y, 6, 1e-9);
        COMPARE_NEAR(paths[0].back().y, -6, 1e-9);
        COMPARE_NEAR(paths[1][1].y, -6, 1e-9);
        QVERIFY(paths[1][0].y > -6 && paths[1][2].y > -6);
    }
};

QTEST_APPLESS_MAIN(TestWindBarb)
#include "tst_wind_barb.moc"
