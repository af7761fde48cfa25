#include "core/base/angles.h"
#include "core/mission/visits.h"
#include "tests/support/files/geojson_rules.h"
#include "tests/support/files/geojson_view.h"

#include <QTest>

using namespace berg;
using namespace berg::test;

namespace {

Point vectorOf(const QJsonValue& pair)
{
    return {pair[0].toDouble(), pair[1].toDouble()};
}

/**
 * First-order direction of true north: meridians converge by the sine of the latitude, so it is
 * left of the y axis east of the origin.
 */
Point alongTrueNorth(const Point& vector, const LatLon& place, const LatLon& origin)
{
    const double turn_rad = radFromDeg(place.longitude_deg - origin.longitude_deg) *
                            std::sin(radFromDeg(place.latitude_deg));
    return {vector.x() + turn_rad * vector.y(), vector.y() - turn_rad * vector.x()};
}

} // namespace

class TestGeojson : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(u".*"_s)); }

    void validByRfc7946_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("plan") << planText(fourIcebergs());
        QTest::newRow("run") << runText(flown(fourIcebergs()));
        QTest::newRow("run that has not begun") << runText(Mission(fourIcebergs()));
        QTest::newRow("nothing but a UAV") << planText(changed([](Scenario& s) {
                                                           s.icebergs.clear();
                                                           s.area_m.clear();
                                                       }),
                                                       planOf({}));
        QTest::newRow("closed") << planText(changed([](Scenario& s) {
            s.planner.policy = PolicyKind::Visitation;
            s.planner.route = Route::Closed;
        }));
        QTest::newRow("names that are not UTF-8")
            << planText(changed([](Scenario& s) { s.icebergs[0].name = "\xFF\xFE"; }));
        for (const double latitude_deg : {0.0, 47.0, -60.0, 84.0, 89.0, 89.99, 90.0, -90.0})
            for (const double longitude_deg : {0.0, 179.99, -179.99, 180.0, -180.0}) {
                const Scenario scenario = at(latitude_deg, longitude_deg);
                const QByteArray name = QByteArray::number(latitude_deg) + " N, " +
                                        QByteArray::number(longitude_deg) + " E";
                QTest::newRow(name + ", plan") << planText(scenario);
                QTest::newRow(name + ", run") << runText(flown(scenario));
            }
    }

    void validByRfc7946()
    {
        QFETCH(QByteArray, text);
        const QString fault = geojsonFault(text);
        QVERIFY2(fault.isEmpty(), qPrintable(fault));
    }

    void checkerCatches_data()
    {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<QString>("fault");
        using Bytes = QByteArray;
        QTest::newRow("not JSON") << Bytes("]}\n") << Bytes("]") << u"2 "_s;
        QTest::newRow("no collection")
            << Bytes("FeatureCollection") << Bytes("Features") << u"3.3"_s;
        QTest::newRow("crs") << Bytes("\"features\":") << Bytes("\"crs\":null,\"features\":")
                             << u"4 crs"_s;
        QTest::newRow("no properties")
            << Bytes("\"properties\"") << Bytes("\"values\"") << u"3.2"_s;
        QTest::newRow("geometry type") << Bytes("\"Point\"") << Bytes("\"Place\"") << u"3.1"_s;
        QTest::newRow("latitude first")
            << Bytes("\"Point\",\"coordinates\":[-48")
            << Bytes("\"Point\",\"coordinates\":[47.1,-148") << u"4 long"_s;
        QTest::newRow("ring not closed")
            << Bytes("]]]},\"properties\":{\"kind\":\"area\"")
            << Bytes(",0]]]},\"properties\":{\"kind\":\"area\"") << u"3.1.6 ring is not closed"_s;
        QTest::newRow("ring the wrong way")
            << Bytes("\"Polygon\",\"coordinates\":[[")
            << Bytes("\"Polygon\",\"coordinates\":[[[0,0],[0,1],[1,1],[0,0]],[")
            << u"3.1.6 ring d"_s;
        QTest::newRow("line of one position")
            << Bytes("\"LineString\",\"coordinates\":[")
            << Bytes("\"LineString\",\"coordinates\":[[0,0]],\"was\":[") << u"3.1.4"_s;
        QTest::newRow("across the antimeridian")
            << Bytes("\"LineString\",\"coordinates\":[")
            << Bytes("\"LineString\",\"coordinates\":[[179,0],[-179,0],") << u"3.1.9"_s;
        QTest::newRow("a time too many")
            << Bytes("\"times\":[") << Bytes("\"times\":[\"\",") << u"times"_s;
    }

    void checkerCatches()
    {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QFETCH(QString, fault);
        QByteArray text = planText(fourIcebergs());
        QVERIFY(text.contains(from));
        text.replace(from, to);
        const QString found = geojsonFault(text);
        QVERIFY2(found.startsWith(fault), qPrintable(u"found: "_s + found));
    }

    void planHasItsFeatures()
    {
        const Scenario scenario = fourIcebergs();
        const QByteArray text = planText(scenario);
        const LocalFrame frame(scenario.origin);
        QCOMPARE(features(text, u"uav"_s).size(), 1);
        QCOMPARE(features(text, u"track"_s).size(), 0);
        const QList<QJsonObject> icebergs = features(text, u"iceberg"_s);
        QCOMPARE(icebergs.size(), 4);
        const QJsonObject fourth = icebergs[3]["properties"_L1].toObject();
        QCOMPARE(fourth["id"_L1].toString(), u"berg-4"_s);
        QCOMPARE(fourth["sigma_m2"_L1].toDouble(), 8.0); // 5.5 + 0.025 x 100
        const LatLon place = placeOf(icebergs[3]["geometry"_L1]["coordinates"_L1]);
        QVERIFY((vectorOf(fourth["velocity_mps"_L1]) -
                 alongTrueNorth({-0.2, -0.2}, place, scenario.origin))
                    .norm() < 1e-6);
        QVERIFY((vectorOf(fourth["drift_mps"_L1]) -
                 alongTrueNorth({-0.2 + 0.1, -0.2}, place, scenario.origin))
                    .norm() < 1e-6);
        QCOMPARE(fourth["time_s"_L1].toDouble(), 0.0);
        QCOMPARE(fourth["time"_L1].toString(), u"2026-05-01T23:59:30Z"_s);
        QCOMPARE(icebergs[1]["properties"_L1]["name"_L1].toString(),
                 u"Tabular \"B\", grounded\nsince May"_s);
        const Point placed_m = frame.toPlane(place);
        QVERIFY((placed_m - Point(4200, 500)).norm() < 1e-4); // nine decimals

        const QJsonObject plan = features(text, u"plan"_s).value(0);
        QCOMPARE(plan["properties"_L1]["order"_L1].toArray(),
                 (QJsonArray{u"berg-1"_s, u"berg-4"_s, u"berg-2"_s, u"berg-3"_s}));
        QCOMPARE(plan["geometry"_L1]["type"_L1].toString(), u"LineString"_s);
        QCOMPARE(plan["geometry"_L1]["coordinates"_L1].toArray().size(), 5);
        const QJsonArray times =
            plan["properties"_L1]["coordinateProperties"_L1]["times"_L1].toArray();
        QCOMPARE(times[0].toString(), u"2026-05-01T23:59:30Z"_s);
        const QList<QJsonObject> visits = features(text, u"visit"_s);
        QCOMPARE(visits.size(), 4);
        for (qsizetype i = 0; i < 4; ++i) {
            QCOMPARE(visits[i]["properties"_L1]["sequence"_L1].toInt(), i + 1);
            QCOMPARE(visits[i]["properties"_L1]["time"_L1], times[i + 1]);
            QCOMPARE(visits[i]["geometry"_L1]["coordinates"_L1],
                     plan["geometry"_L1]["coordinates"_L1][i + 1]);
        }
        // The visit is past midnight, and its time agrees to the second.
        const QDateTime first = QDateTime::fromString(times[1].toString(), Qt::ISODateWithMs);
        QCOMPARE(first.date(), QDate(2026, 5, 2));
        const QDateTime start = QDateTime::fromString(times[0].toString(), Qt::ISODateWithMs);
        QVERIFY(std::abs(static_cast<double>(start.msecsTo(first)) / 1e3 -
                         plannedVisits(scenario, fourIcebergPlan())[0].time_s) <= 0.0005);
    }

    void relativeTimesWithoutStart()
    {
        const Scenario scenario = changed([](Scenario& s) { s.startUtc.clear(); });
        const QByteArray text = planText(scenario);
        QVERIFY(!text.contains("\"time\":") && !text.contains("\"times\":"));
        const QJsonArray times =
            features(text, u"plan"_s)
                .value(0)["properties"_L1]["coordinateProperties"_L1]["times_s"_L1]
                .toArray();
        const std::vector<Visit> visits = plannedVisits(scenario, fourIcebergPlan());
        QCOMPARE(times.size(), 5);
        QCOMPARE(times[0].toDouble(), 0.0);
        for (qsizetype i = 0; i < 4; ++i) // milliseconds
            QVERIFY(std::abs(times[i + 1].toDouble() -
                             visits[static_cast<std::size_t>(i)].time_s) <= 0.00051);
    }

    void runHasItsFeatures()
    {
        const Mission mission = flown(fourIcebergs());
        const QByteArray text = runText(mission);
        const LocalFrame frame(mission.scenario().origin);
        const std::vector<Sample>& samples = mission.recorder().samples();
        const QJsonObject track = features(text, u"track"_s).value(0);
        const QJsonArray line = track["geometry"_L1]["coordinates"_L1].toArray();
        QCOMPARE(line.size(), static_cast<qsizetype>(samples.size()));
        for (std::size_t i = 0; i < samples.size(); ++i)
            QVERIFY((frame.toPlane(placeOf(line[static_cast<qsizetype>(i)])) -
                     samples[i].uavs[0].pose.position_m)
                        .norm() < 1e-4);
        QCOMPARE(track["properties"_L1]["coordinateProperties"_L1]["times"_L1][400].toString(),
                 u"2026-05-02T00:06:10Z"_s);
        QCOMPARE(track["properties"_L1]["zeta_m2s"_L1].toDouble(), mission.metrics().zeta_m2s);
        QCOMPARE(features(text, u"visit"_s).size(), mission.metrics().visits);
        QCOMPARE(features(text, u"plan"_s).size(), 0);
        const QList<QJsonObject> icebergs = features(text, u"iceberg"_s);
        QCOMPARE(icebergs.size(), 4);
        for (int i = 0; i < 4; ++i) {
            QCOMPARE(icebergs[i]["properties"_L1]["sigma_m2"_L1].toDouble(),
                     mission.simulation().track(IcebergIndex::of(i)).sigma_m2);
            QCOMPARE(icebergs[i]["properties"_L1]["time_s"_L1].toDouble(), 400.0);
            QVERIFY((frame.toPlane(placeOf(icebergs[i]["geometry"_L1]["coordinates"_L1])) -
                     mission.simulation().truth_m(IcebergIndex::of(i)))
                        .norm() < 1e-4);
        }
    }

    void icebergsStillToAppearAreNotInARun()
    {
        const Mission mission =
            flown(changed([](Scenario& s) { s.icebergs[2].appears_s = 300; }), 100);
        QCOMPARE(features(runText(mission), u"iceberg"_s).size(), 3);
    }

    void textMatchesTheGoldenFile()
    {
        const QByteArray actual = planText(fourIcebergs());
        const QByteArray expected = berg::test::golden(u"four_icebergs.geojson"_s, actual);
        // 1e-9 of 48 degrees is 5 mm: rounding of another processor, not another place.
        const QString found = difference(QJsonDocument::fromJson(actual).object(),
                                         QJsonDocument::fromJson(expected).object(), 1e-9);
        QVERIFY2(found.isEmpty(), qPrintable(found));
    }
};

QTEST_APPLESS_MAIN(TestGeojson)
#include "tst_geojson.moc"
