#include "core/io/results/drift_result.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace berg;

namespace {

const std::vector<DriftPoint> kPath{
    {.time_s = 1777636800, .place = {64.5, -59.8}, .velocity_mps = {0.3, -0.4}},
    {.time_s = 1777640400, .place = {64.4871234, -59.7775}, .velocity_mps = Point::Zero()}};
const std::vector<DriftLeadError> kErrors{
    {.lead_s = 21600, .starts = 3, .moved_m = 6480, .drift_m = 1234.4, .lastVelocity_m = 50},
    {.lead_s = 43200}};

QJsonObject read(const DriftReport& report)
{
    return QJsonDocument::fromJson(QByteArray::fromStdString(driftJson(report))).object();
}

} // namespace

class TestDriftResult : public QObject
{
    Q_OBJECT

private slots:
    void pathAsTable()
    {
        QCOMPARE(driftPathCsv(kPath),
                 std::string("time,latitude_deg,longitude_deg,speed_mps,direction_deg\n"
                             "2026-05-01T12:00:00Z,64.50000,-59.80000,0.5000,143.1\n"
                             "2026-05-01T13:00:00Z,64.48712,-59.77750,0.0000,0.0\n"));
    }

    void errorsAsTable()
    {
        QCOMPARE(driftErrorsCsv(kErrors),
                 std::string("lead_h,starts,moved_km,drift_km,last_velocity_km\n"
                             "6,3,6.480,1.234,0.050\n"
                             "12,0,,,\n"));
    }

    void reportAsJson()
    {
        DriftReport report{.dimensions = dimensionsOfLength(100), .law = driftLaw(100)};
        QVERIFY(!read(report).contains("speed_mps") && !read(report).contains("path") &&
                !read(report).contains("errors"));
        report.velocity_mps = Point(0, 2);
        report.path = kPath;
        report.errors = kErrors;
        const QJsonObject json = read(report);
        QCOMPARE(json["length_m"].toDouble(), 100.0);
        QCOMPARE(json["speed_mps"].toDouble(), 2.0);
        QCOMPARE(json["path"].toArray().size(), 2);
        QCOMPARE(json["path"][0]["time"].toString(), QString("2026-05-01T12:00:00Z"));
        QCOMPARE(json["errors"][0]["drift_km"].toDouble(), 1.234);
        QVERIFY(json["errors"][1]["drift_km"].isNull());
    }
};

QTEST_APPLESS_MAIN(TestDriftResult)
#include "tst_drift_result.moc"
