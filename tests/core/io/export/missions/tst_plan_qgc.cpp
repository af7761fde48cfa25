#include "core/io/export/missions/plan_qgc.h"
#include "core/mission/visits.h"
#include "core/scenario/fence.h"
#include "tests/support/files/golden.h"
#include "tests/support/files/plan_mutations.h"
#include "tests/support/flight/mission_builder.h"

#include <QTest>

using namespace berg;
using namespace berg::test;

namespace {

struct Reader
{
    const char* name;
    std::vector<PlanRule> rules;
};

std::vector<Reader> readers()
{
    return {{"QGroundControl", qgroundcontrolRules()},
            {"MAVSDK", mavsdkRules()},
            {"Mission Planner", missionPlannerRules()}};
}

/** Returns "reader: rule" for every rule that the text breaks. */
QStringList brokenRules(const PlanText& plan)
{
    QStringList broken;
    for (const Reader& reader : readers())
        for (const PlanRule& rule : reader.rules)
            if (!rule.fault(plan).isEmpty())
                broken << QLatin1StringView(reader.name) + u": "_s + QLatin1StringView(rule.name);
    return broken;
}

/** Returns the scenario with its area as a geofence. */
Scenario fenced()
{
    return changed([](Scenario& s) { s.geofence = true; });
}

/** Returns a scenario with two no-fly areas, one of them above the UAV, and a stand-off ring. */
Scenario withAreas()
{
    return changed([](Scenario& s) {
        s.geofence = true;
        s.noFly = {{.corners_m = {{9000, 0}, {9500, 0}, {9500, 500}}},
                   {.corners_m = {{9000, 900}, {9500, 900}, {9500, 1500}}, .floor_m = 1000}};
        s.asset = Asset{.position_m = {8000, 8000}, .standoff_m = 300};
    });
}

Scenario withoutIcebergs()
{
    Scenario scenario = fourIcebergs();
    scenario.icebergs.clear();
    return scenario;
}

QByteArray planFileText(const Scenario& scenario, const Plan& plan = fourIcebergPlan())
{
    return bytes(qgcPlan(planContent(scenario, plan)));
}

QByteArray runText(const Scenario& scenario, double until_s = 1e9)
{
    const Mission mission = flown(scenario, until_s);
    return bytes(qgcPlan(runContent(mission)));
}

std::vector<std::pair<const char*, QByteArray>> documents()
{
    ExportOptions path{.what = ExportScope::Path};
    ExportOptions loiter{.altitude_m = 80.5, .loiterTurns = 3, .returnHome = true};
    return {{"plan", planFileText(fourIcebergs())},
            {"geofence", planFileText(fenced())},
            {"no-fly areas", planFileText(withAreas())},
            {"path", bytes(qgcPlan(planContent(fourIcebergs(), fourIcebergPlan(), path)))},
            {"loiter", bytes(qgcPlan(planContent(fourIcebergs(), fourIcebergPlan(), loiter)))},
            {"no icebergs", planFileText(withoutIcebergs(), planOf({}))},
            {"no area", planFileText(changed([](Scenario& s) { s.area_m.clear(); }))},
            {"closed route", planFileText(changed([](Scenario& s) {
                 s.planner.policy = PolicyKind::Visitation;
                 s.planner.route = Route::Closed;
             }))},
            {"fractional speed, wind", planFileText(changed([](Scenario& s) {
                 s.uavs[0].spec.airspeed_mps = 22.5;
                 s.wind_mps = Point(7.25, -3.5);
             }))},
            {"slow", planFileText(changed([](Scenario& s) { s.uavs[0].spec.airspeed_mps = 1.3; }))},
            {"on the equator at 0 E", planFileText(changed([](Scenario& s) {
                 s.origin = {.latitude_deg = 0, .longitude_deg = 0};
                 s.uavs[0].position_m = Point::Zero();
             }))},
            {"run", runText(fourIcebergs())},
            {"run without a visit", runText(fourIcebergs(), 1)}};
}

QJsonArray itemsOf(const QByteArray& text)
{
    return plan_rules::items(berg::test::planText(text));
}

} // namespace

class TestPlanQgc : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(u".*"_s)); }

    void everyReaderAccepts_data()
    {
        QTest::addColumn<QByteArray>("text");
        for (const auto& [name, text] : documents())
            QTest::newRow(name) << text;
    }

    void everyReaderAccepts()
    {
        QFETCH(QByteArray, text);
        const PlanText plan = berg::test::planText(text);
        for (const Reader& reader : readers())
            for (const PlanRule& rule : reader.rules)
                QVERIFY2(rule.fault(plan).isEmpty(),
                         qPrintable(QLatin1StringView(reader.name) + u", "_s +
                                    QLatin1StringView(rule.name) + u": "_s + rule.fault(plan)));
    }

    void noFlyAreasAreExclusions()
    {
        const QJsonArray polygons = berg::test::planText(planFileText(withAreas()))
                                        .root["geoFence"_L1]["polygons"_L1]
                                        .toArray();
        QCOMPARE(polygons.size(), 3);
        QVERIFY(polygons[0]["inclusion"_L1].toBool());
        QVERIFY(!polygons[1]["inclusion"_L1].toBool(true));
        QCOMPARE(polygons[1]["polygon"_L1].toArray().size(), 3);
        QVERIFY(!polygons[2]["inclusion"_L1].toBool(true));
        QCOMPARE(polygons[2]["polygon"_L1].toArray().size(), kRingCorners);
    }

    void rejectionIsCaught_data()
    {
        QTest::addColumn<int>("index");
        int index = 0;
        for (const Mutation& mutation : mutations())
            QTest::newRow(mutation.name) << index++;
    }

    void rejectionIsCaught()
    {
        QFETCH(int, index);
        const Mutation mutation = mutations()[static_cast<std::size_t>(index)];
        // The mutations count on a change of speed in row 0 and waypoints from row 1.
        Scenario scenario = fenced();
        scenario.uavs[0].aircraft.takeOff = TakeOffMethod::Hand;
        QJsonObject root = berg::test::planText(planFileText(scenario)).root;
        mutation.edit(root);
        const QByteArray text = QJsonDocument(root).toJson();
        QStringList expected = mutation.broken;
        QStringList broken = brokenRules({.text = text, .root = root});
        expected.sort();
        broken.sort();
        QCOMPARE(broken, expected);
    }

    void rejectedTextIsCaught_data()
    {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<QStringList>("broken");
        const QByteArray speed = "\"cruiseSpeed\": 22";
        QTest::newRow("NaN") << speed << QByteArray("\"cruiseSpeed\": NaN")
                             << everywhere(u"JSON"_s);
        QTest::newRow("Infinity") << speed << QByteArray("\"cruiseSpeed\": Infinity")
                                  << everywhere(u"JSON"_s);
        QTest::newRow("cruiseSpeed 22.0") << speed << QByteArray("\"cruiseSpeed\": 22.0")
                                          << QStringList{u"Mission Planner: integers"_s};
    }

    void rejectedTextIsCaught()
    {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QFETCH(QStringList, broken);
        QByteArray text = planFileText(fourIcebergs());
        QVERIFY(text.contains(from));
        text.replace(from, to);
        const QStringList found = brokenRules(berg::test::planText(text));
        for (const QString& rule : broken)
            QVERIFY2(found.contains(rule), qPrintable(rule));
    }

    void everyRuleIsBrokenBySomeMutation()
    {
        QStringList caught = everywhere(u"JSON"_s);
        for (const Mutation& mutation : mutations())
            caught << mutation.broken;
        for (const Reader& reader : readers())
            for (const PlanRule& rule : reader.rules) {
                const QString name =
                    QLatin1StringView(reader.name) + u": "_s + QLatin1StringView(rule.name);
                QVERIFY2(caught.contains(name), qPrintable(name));
            }
    }

    void suffixIsTheOneReadAsJson()
    {
        QVERIFY(findExportFormat("plan") != nullptr);
        QCOMPARE(findExportFormat("plan")->extension, std::string_view("plan"));
        QVERIFY(findExportFormat("mission") == nullptr);
    }

    void itemsFlyThePlan()
    {
        const Scenario scenario = fourIcebergs();
        const Plan plan = fourIcebergPlan();
        const QJsonArray items = itemsOf(planFileText(scenario, plan));
        const std::vector<Visit> visits = plannedVisits(scenario, plan);
        QCOMPARE(items.size(), 7);
        QCOMPARE(items[0]["command"_L1].toInt(), 22);
        QCOMPARE(items[0]["params"_L1][0].toInt(), 15); // pitch
        QCOMPARE(items[0]["params"_L1][6].toInt(), 50);
        QCOMPARE(items[1]["command"_L1].toInt(), 178);
        QCOMPARE(items[1]["params"_L1].toArray(), (QJsonArray{0, 22, -1, 0, 0, 0, 0}));
        const LocalFrame frame(scenario.origin);
        for (qsizetype row = 2; row <= 5; ++row) {
            const QJsonArray params = items[row]["params"_L1].toArray();
            QCOMPARE(items[row]["command"_L1].toInt(), 16);
            // The field of view is 600 m, half of which exceeds 8 bits.
            QCOMPARE(params[1].toInt(), 255);
            QCOMPARE(params[2].toInt(), 0);
            QCOMPARE(params[6].toInt(), 120);
            QCOMPARE(items[row]["Altitude"_L1].toInt(), 120);
            const Visit& visit = visits[static_cast<std::size_t>(row - 2)];
            const Point placed_m = frame.toPlane(
                {.latitude_deg = params[4].toDouble(), .longitude_deg = params[5].toDouble()});
            // Nine decimals of a degree are 0.06 mm at most.
            QVERIFY((placed_m - visit.position_m).norm() < 1e-4);
        }
        QCOMPARE(items[6]["command"_L1].toInt(), 20);
        QCOMPARE(items[6]["frame"_L1].toInt(), 2);
    }

    void speedsAreRoundedButExactInTheMission_data()
    {
        QTest::addColumn<double>("airspeed_mps");
        QTest::addColumn<int>("cruise_mps");
        QTest::newRow("whole") << 22.0 << 22;
        QTest::newRow("rounded up") << 22.6 << 23;
        QTest::newRow("rounded down") << 22.4 << 22;
        QTest::newRow("never 0") << 0.3 << 1;
    }

    void speedsAreRoundedButExactInTheMission()
    {
        QFETCH(double, airspeed_mps);
        QFETCH(int, cruise_mps);
        const QByteArray text =
            planFileText(changed([&](Scenario& s) { s.uavs[0].spec.airspeed_mps = airspeed_mps; }));
        const QJsonValue mission = berg::test::planText(text).root["mission"_L1];
        QCOMPARE(mission["cruiseSpeed"_L1].toInt(-1), cruise_mps);
        QCOMPARE(mission["hoverSpeed"_L1].toInt(-1), cruise_mps);
        QCOMPARE(itemsOf(text)[1]["params"_L1][1].toDouble(), airspeed_mps);
        QVERIFY(!text.contains(".0,") && !text.contains(".0\n")); // whole numbers as integers
    }

    void emptyPlanReturns()
    {
        const QByteArray text = planFileText(withoutIcebergs(), planOf({}));
        const QJsonArray items = itemsOf(text);
        QCOMPARE(items.size(), 3);
        QCOMPARE(items[2]["command"_L1].toInt(), 20);
        const QJsonArray home =
            berg::test::planText(text).root["mission"_L1]["plannedHomePosition"_L1].toArray();
        QCOMPARE(home[2].toDouble(), 0.0);
    }

    void closedRouteLoitersAtHome()
    {
        const QByteArray text = planFileText(changed([](Scenario& s) {
            s.planner.policy = PolicyKind::Visitation;
            s.planner.route = Route::Closed;
            s.uavs[0].aircraft.end = MissionEnd::Loiter;
        }));
        const QJsonArray items = itemsOf(text);
        QCOMPARE(items.size(), 7);
        const QJsonArray home =
            berg::test::planText(text).root["mission"_L1]["plannedHomePosition"_L1].toArray();
        QCOMPARE(items[6]["command"_L1].toInt(), 17);
        QCOMPARE(items[6]["params"_L1].toArray()[4], home[0]);
        QCOMPARE(items[6]["params"_L1].toArray()[5], home[1]);
    }

    void runExportsWhatWasReached()
    {
        const Scenario scenario = fourIcebergs();
        const Mission mission = flown(scenario);
        const std::vector<Visit> visits = flownVisits(mission);
        QVERIFY(visits.size() >= 4);
        const QJsonArray items = itemsOf(runText(scenario));
        QCOMPARE(items.size(), static_cast<qsizetype>(visits.size()) + 3);
        const LocalFrame frame(scenario.origin);
        for (std::size_t i = 0; i < visits.size(); ++i) {
            const QJsonArray params = items[static_cast<qsizetype>(i) + 2]["params"_L1].toArray();
            const Point placed_m = frame.toPlane(
                {.latitude_deg = params[4].toDouble(), .longitude_deg = params[5].toDouble()});
            QVERIFY((placed_m - visits[i].position_m).norm() < 1e-4);
        }
    }

    void areaIsTheFence()
    {
        const Scenario scenario = fenced();
        const QJsonObject fence =
            berg::test::planText(planFileText(scenario)).root["geoFence"_L1].toObject();
        const QJsonArray corners = fence["polygons"_L1][0]["polygon"_L1].toArray();
        QCOMPARE(corners.size(), 4);
        QVERIFY(fence["polygons"_L1][0]["inclusion"_L1].toBool());
        const LocalFrame frame(scenario.origin);
        for (qsizetype i = 0; i < 4; ++i) {
            const Point corner_m = frame.toPlane({.latitude_deg = corners[i][0].toDouble(),
                                                  .longitude_deg = corners[i][1].toDouble()});
            QVERIFY((corner_m - scenario.area_m[static_cast<std::size_t>(i)]).norm() < 1e-4);
        }
        const QByteArray open = planFileText(fourIcebergs()); // an area, but no fence
        QVERIFY(berg::test::planText(open).root["geoFence"_L1]["polygons"_L1].toArray().isEmpty());
    }

    void homeIsTheRallyPoint()
    {
        const QJsonObject root = berg::test::planText(planFileText(fourIcebergs())).root;
        const QJsonArray home = root["mission"_L1]["plannedHomePosition"_L1].toArray();
        QCOMPARE(root["rallyPoints"_L1]["points"_L1].toArray(),
                 (QJsonArray{QJsonArray{home[0], home[1], 120}}));
    }

    void textMatchesTheGoldenFile()
    {
        const QByteArray actual = planFileText(fenced());
        const QByteArray expected = berg::test::golden(u"four_icebergs.plan"_s, actual);
        // 1e-9 of 47 degrees is 5 mm: rounding of another processor, not another place.
        const QString found = difference(QJsonDocument::fromJson(actual).object(),
                                         QJsonDocument::fromJson(expected).object(), 1e-9);
        QVERIFY2(found.isEmpty(), qPrintable(found));
    }
};

QTEST_APPLESS_MAIN(TestPlanQgc)
#include "tst_plan_qgc.moc"
