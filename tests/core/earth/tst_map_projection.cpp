#include "core/earth/map_projection.h"

#include <QtTest>

#include <cmath>

using namespace berg;

/** Places that PROJ 9.1 (gdaltransform) returns for the same coordinates. */
class TestMapProjection : public QObject
{
    Q_OBJECT

private slots:
    void placesMatchProj_data()
    {
        QTest::addColumn<int>("epsg");
        QTest::addColumn<double>("latitude_deg");
        QTest::addColumn<double>("longitude_deg");
        const auto row = [](int epsg, double longitude_deg, double latitude_deg) {
            QTest::addRow("%d", epsg) << epsg << latitude_deg << longitude_deg;
        };
        row(3031, 121.798928244996, -76.6885607653568);
        row(3032, -74.8399109031059, -22.5613533023062);
        row(3411, 13.2010717550039, 76.6492342117747); // on the ellipsoid of Hughes
        row(3413, 13.2010717550039, 76.6489551473028);
        row(3976, 121.798928244996, -76.6489551473028);
        row(3995, 58.2010717550039, 76.6885607653568);
        row(3996, 58.2010717550039, 76.8254878743675);
        row(5041, -15.4713460351841, 64.5642843274539);
        row(5042, -164.528653964816, -64.5642843274539);
        row(32661, -15.4713460351841, 64.5642843274539);
        row(32761, -164.528653964816, -64.5642843274539);
        row(32633, 21.6343644405381, -6.87853485665772);
        row(32733, 151.123214031585, -80.504900007918);
        row(25833, 21.6343644405392, -6.87853485688142);
        row(26918, -68.3656355594608, -6.87853485688142);
        row(3857, 11.0903040536959, -6.859547045579);
        row(900913, 11.0903040536959, -6.859547045579);
    }

    void placesMatchProj()
    {
        QFETCH(int, epsg);
        QFETCH(double, latitude_deg);
        QFETCH(double, longitude_deg);
        const std::optional<Unprojection> unprojected = unprojectionOf(epsg);
        QVERIFY(unprojected);
        const LatLon place = (*unprojected)(Point(1234567, -765432));
        // A tenth of a metre; the ellipsoids of ETRS89 and NAD83 differ from WGS 84 by less.
        QVERIFY2(std::abs(place.latitude_deg - latitude_deg) < 1e-6,
                 qPrintable(QString::number(place.latitude_deg, 'f', 9)));
        QVERIFY2(std::abs(place.longitude_deg - longitude_deg) < 1e-6,
                 qPrintable(QString::number(place.longitude_deg, 'f', 9)));
    }

    void unknownCodesAreRejected()
    {
        for (const int epsg : {0, -1, 2154, 3571, 6931, 32600, 32699, 25827, 26924, 4326})
            QVERIFY2(!unprojectionOf(epsg), qPrintable(QString::number(epsg)));
        QVERIFY(isGeographic(4326) && isGeographic(4269));
        QVERIFY(!isGeographic(3413) && !isGeographic(27700));
    }

    void longitudesStayInTheirRange()
    {
        const LatLon place = (*unprojectionOf(3413))(Point(0, 1e6)); // the meridian 135 E
        QVERIFY(std::abs(place.longitude_deg - 135) < 1e-9);
        const LatLon west = (*unprojectionOf(3413))(Point(-1e6, 1e6)); // 180 E
        QVERIFY(west.longitude_deg >= -180 && west.longitude_deg < 180);
    }
};

QTEST_APPLESS_MAIN(TestMapProjection)
#include "tst_map_projection.moc"
