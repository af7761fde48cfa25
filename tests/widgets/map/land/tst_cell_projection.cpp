#include "widgets/map/land/cell_projection.h"

#include <QtTest>

using namespace berg;

class TestCellProjection : public QObject
{
    Q_OBJECT

private slots:
    void isExactWithinReach_data()
    {
        QTest::addColumn<MapPlane>("plane");
        QTest::newRow("Grand Banks") << MapPlane(LocalFrame({47, -48}));
        QTest::newRow("89.9 N") << MapPlane(LocalFrame({89.9, 10}));
        QTest::newRow("South Pole") << MapPlane(LocalFrame({-90, 0}));
        QTest::newRow("antimeridian") << MapPlane(LocalFrame({-75, 180}));
        QTest::newRow("equator") << MapPlane(LocalFrame({0, 0}));
        QTest::newRow("chart") << MapPlane(PolarFrame(Pole::North, -45));
    }

    void isExactWithinReach()
    {
        QFETCH(MapPlane, plane);
        double worst_m = 0;
        int cells = 0;
        for (double south_deg = -90; south_deg < 90; south_deg += 5)
            for (double west_deg = -180; west_deg < 180; west_deg += 15) {
                const LatLon middle{south_deg + 2.5, west_deg + 2.5};
                if (toPlane(plane, middle).norm() > mapReach_m(plane))
                    continue;
                ++cells;
                const CellProjection project(plane, {south_deg, west_deg}, 5);
                for (const double north : {0.0, 0.3, 1.7, 4.9})
                    for (const double east : {0.0, 1.1, 3.9, 5.0}) {
                        const LatLon place{south_deg + north, west_deg + east};
                        worst_m =
                            std::max(worst_m, (project(place) - toPlane(plane, place)).norm());
                    }
            }
        QVERIFY(cells > 100);
        QVERIFY(worst_m < 1e-3); // accuracy stated by the class
    }
};

QTEST_APPLESS_MAIN(TestCellProjection)
#include "tst_cell_projection.moc"
