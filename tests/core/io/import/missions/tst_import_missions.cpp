#include "core/geometry/geometry.h"
#include "core/io/import/import_formats.h"
#include "core/io/import/scenario/import_scenario.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/import_fixtures.h"

#include <QtTest>

#include <cmath>
#include <set>

using namespace berg;
using namespace berg::test;

namespace {

bool isAt(const LatLon& place, double latitude_deg, double longitude_deg)
{
    return place.latitude_deg == latitude_deg && place.longitude_deg == longitude_deg;
}

/** Returns a plan with these members of its mission. */
std::string plan(const std::string& mission)
{
    return R"({"fileType": "Plan", "version": 1, "groundStation": "x", "mission": {)" + mission +
           "}}";
}

/** Returns a plan with one more item behind a valid one. */
std::string planWith(const std::string& item)
{
    return plan(R"("items": [{"type": "SimpleItem", "command": 16, "frame": 3,
                    "params": [0, 0, 0, null, 60, -50, 0]}, )" +
                item + "]");
}

std::string simple(const char* command, const char* frame, const char* params)
{
    return std::string(R"({"type": "SimpleItem", "command": )") + command + R"(, "frame": )" +
           frame + R"(, "params": )" + params + "}";
}

/** Returns a mission of ArduPilot with its home and these rows. */
std::string wplFile(const std::string& rows)
{
    return "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t60\t-50\t0\t1\n" + rows;
}

std::optional<LatLon> homeOf(const SightingTable& table)
{
    return table.scene.uavs.empty() ? std::nullopt : table.scene.uavs.front().home;
}

SightingTable read(const std::string& text)
{
    return readSightings(text, "mission");
}

} // namespace

/** Tests of missions and routes of ground stations, whose waypoints become icebergs. */
class TestImportMissions : public QObject
{
    Q_OBJECT

private slots:
    void planOfQGroundControlIsRead()
    {
        const SightingTable table = readFixture("qgc.plan");
        QVERIFY(isAt(table.sightings[0].place, 69.25, -51.2));
        QVERIFY(isAt(table.sightings[1].place, 69.3, -51.35));
        QVERIFY(isAt(table.sightings[2].place, 69.35, -51.1));
        QCOMPARE(table.sightings[2].line, std::size_t{9});
        QCOMPARE(faultAt(table, 5), std::string("is no point: \"survey\""));
        QCOMPARE(faultAt(table, 7), std::string("has no position"));
        QCOMPARE(faultAt(table, 8), std::string("has no position: \"frame 1\""));
        const SceneUav& uav = table.scene.uavs.at(0);
        QVERIFY(isAt(uav.home.value(), 69.22, -51.1) && uav.start == uav.home);
        QCOMPARE(uav.altitude_m, std::optional(50.0));
        QCOMPARE(uav.airspeed_mps, std::optional(22.0)); // instead of its cruise speed
    }

    void rowsOfArduPilotAreRead()
    {
        const SightingTable table = readFixture("ardupilot.waypoints");
        QVERIFY(isAt(table.sightings[0].place, 69.25, -51.2));
        QCOMPARE(table.sightings[0].name, std::string("Tabular \"B\""));
        QVERIFY(isAt(table.sightings[1].place, 69.3, -51.35));
        QCOMPARE(table.sightings[1].name, std::string("two, \xC3\x85rn"));
        QVERIFY(isAt(table.sightings[2].place, 69.35, -51.1));
        QCOMPARE(table.sightings[2].name, std::string());
        QVERIFY(faultAt(table, 13).starts_with(
            "latitude must be between -90 and 90, minutes below 60"));
        QCOMPARE(faultAt(table, 14), std::string("has no position"));
        QCOMPARE(faultAt(table, 15), std::string("has no position: \"frame 1\""));
        const SceneUav& uav = table.scene.uavs.at(0);
        QVERIFY(isAt(uav.start.value(), 69.22, -51.1) && uav.start == uav.home);
        QCOMPARE(uav.altitude_m, std::optional(50.0));
        QCOMPARE(uav.airspeed_mps, std::optional(22.0));
    }

    /** Version 120 has no home row, and neither have some files that declare 110. */
    void rowsWithoutHomeAreRead()
    {
        const std::string row = "0\t1\t3\t16\t0\t0\t0\t0\t60.5\t-50\t0\t1\n";
        QCOMPARE(read("QGC WPL 120\n" + row).sightings.size(), std::size_t{1});
        QVERIFY(!homeOf(read("QGC WPL 120\n" + row)));
        const SightingTable one = read("QGC WPL 110\n1\t0\t3\t16\t0\t0\t0\t0\t60.5\t-50\t0\t1\n");
        QCOMPARE(one.sightings.size(), std::size_t{1});
        QVERIFY(!homeOf(one));
        const SightingTable takeOff =
            read("\xEF\xBB\xBFQGC WPL 110\n0\t1\t3\t22\t0\t0\t0\t0\t60\t-50\t0\t1\n" +
                 std::string("1\t0\t3\t16\t0\t0\t0\t0\t60.5\t-50\t0\t1\n"));
        QCOMPARE(takeOff.sightings.size(), std::size_t{1});
        QVERIFY(!homeOf(takeOff));
    }

    /** Mission Planner writes 0, 0 for an unknown home; the return to a home is not an iceberg. */
    void unknownHomesAreIgnored()
    {
        const std::string nowhere = "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t0\t0\t0\t1\n";
        const std::string row = "1\t0\t3\t16\t0\t0\t0\t0\t60.5\t-50\t0\t1\n";
        QVERIFY(!homeOf(read(nowhere + row)));
        const SightingTable back = read(wplFile(row + "2\t0\t3\t17\t0\t0\t0\t0\t60\t-50\t0\t1\n"));
        QCOMPARE(back.sightings.size(), std::size_t{1});
        QCOMPARE(back.rejected.count, std::size_t{0});
    }

    void homeBecomesTheStartOfTheAircraft()
    {
        const Scenario scenario =
            importSightings(newScenarioForImport("new"), readFixture("qgc.plan")).scenario;
        const LatLon start =
            LocalFrame(scenario.origin).toGeographic(scenario.uavs.front().position_m);
        COMPARE_NEAR(start.latitude_deg, 69.22, 1e-6); // a centimetre is 1e-7 degrees
        COMPARE_NEAR(start.longitude_deg, -51.1, 1e-6);
        QVERIFY(!scenario.uavs.front().home_m);
        QCOMPARE(scenario.icebergs.size(), std::size_t{3});
        QCOMPARE(scenario.icebergs[0].id, std::string("69.25N 51.2W"));
    }

    /** An import does not move existing objects of a scenario in use. */
    void homeIsNotTakenIntoAScenarioInUse()
    {
        const Scenario used = importSightings(openSea(), readFixture("points.geojson")).scenario;
        const ImportResult result = importSightings(used, readFixture("qgc.plan"));
        QCOMPARE(result.added, std::size_t{3});
        QVERIFY(result.scenario.uavs == used.uavs);
        QVERIFY((result.scene == std::vector{SceneFinding{.note = SceneNote::InUse}}));
    }

    void homeFarAwayIsLeftOut()
    {
        const std::string text = "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t-60\t-50\t0\t1\n"
                                 "1\t0\t3\t16\t0\t0\t0\t0\t60.5\t-50\t0\t1\n";
        const ImportResult result = importSightings(openSea(), read(text));
        QVERIFY((result.scene == std::vector{SceneFinding{.note = SceneNote::UavsTooFar}}));
        QCOMPARE(result.rejected.count, std::size_t{0});
        QVERIFY(result.scenario.uavs == openSea().uavs);
    }

    /** Climb speeds are ignored; altitudes above the sea are converted to above home. */
    void speedAndAltitudeAreThoseOfTheFlight()
    {
        const auto uav = [](const std::string& rows) {
            return read("QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t60\t-50\t30\t1\n" + rows +
                        "9\t0\t0\t16\t0\t0\t0\t0\t60.5\t-50\t130\t1\n")
                .scene.uavs.at(0);
        };
        const auto speed = [](const char* params) {
            return std::string("1\t0\t2\t178\t") + params + "\t-1\t0\t0\t0\t0\t1\n";
        };
        QCOMPARE(uav({}).altitude_m, std::optional(100.0));
        QCOMPARE(uav({}).airspeed_mps, std::nullopt);
        QCOMPARE(uav(speed("1\t17.5")).airspeed_mps, std::optional(17.5));
        QCOMPARE(uav(speed("2\t3") + speed("0\t-1") + speed("0\t19") + speed("0\t25")).airspeed_mps,
                 std::optional(19.0));
        QCOMPARE(uav("1\t0\t10\t16\t0\t0\t0\t0\t60.4\t-50\t0\t1\n").altitude_m,
                 std::optional(100.0));
    }

    /** For a fence of another program, unsupported parts are reported. */
    void fenceOfQGroundControlIsRead()
    {
        const SightingTable table = readFixture("fence.plan");
        const SceneArea& area = table.scene.area.value();
        QVERIFY(area.geofence && area.rings.at(0).size() == 5);
        QVERIFY(isAt(area.rings[0][1], 69.1, -50.9));
        const SceneUav& uav = table.scene.uavs.at(0);
        QVERIFY(isAt(uav.start.value(), 69.22, -51.1) && isAt(uav.home.value(), 69.21, -51.15));
        QCOMPARE(uav.airspeed_mps, std::optional(15.0));
        const ImportResult result = importSightings(newScenarioForImport("new"), table);
        QVERIFY(result.scenario.geofence && result.scenario.area_m.size() == 5);
        QVERIFY(result.scenario.uavs.at(0).home_m);
        QVERIFY((result.scene ==
                 std::vector<SceneFinding>{{.note = SceneNote::UavsTaken},
                                           {.note = SceneNote::FenceTaken},
                                           {.note = SceneNote::NoFlyTaken, .count = 2},
                                           {.note = SceneNote::AreaUnreadable, .count = 2},
                                           {.note = SceneNote::AreasMore, .count = 2}}));
        QCOMPARE(sceneFindingText(result.scene[2]), std::string("2 no-fly areas taken over"));
        QCOMPARE(result.scenario.noFly.size(), std::size_t{2});
    }

    /** An exclusion circle is covered by its polygon; an inclusion circle contains its polygon. */
    void circlesOfAFenceBecomePolygons()
    {
        for (const bool isInside : {false, true}) {
            std::string text = plan(R"("plannedHomePosition": [60.1, -50, 0], "items": [
                {"type": "SimpleItem", "command": 16, "frame": 3,
                 "params": [0, 0, 0, null, 60.1, -50.01, 0]}])");
            text.insert(1, std::string(R"("geoFence": {"version": 2, "circles": [{"inclusion": )") +
                               (isInside ? "true" : "false") +
                               R"(, "circle": {"center": [60, -50], "radius": 2000}}]}, )");
            const SightingTable table = read(text);
            const std::vector<SceneArea> areas =
                isInside ? std::vector{table.scene.area.value()} : table.scene.noFly;
            QCOMPARE(areas.size(), std::size_t{1});
            const LocalFrame frame({60, -50});
            std::vector<Point> corners_m;
            for (const LatLon& corner : areas[0].rings.at(0))
                corners_m.push_back(frame.toPlane(corner));
            for (int i = 0; i < 360; ++i) {
                const Point rim_m = turned({2000, 0}, i * std::acos(-1.0) / 180);
                QCOMPARE(insidePolygon(corners_m, 0.999 * rim_m) ||
                             distanceToEdges(corners_m, 0.999 * rim_m) < 10,
                         true);
                QCOMPARE(insidePolygon(corners_m, (isInside ? 1.0001 : 0.9999) * rim_m), !isInside);
            }
        }
    }

    /** A fence written by QGroundControl in 2018: a polygon without a name. */
    void fenceOfVersionOneIsRead()
    {
        std::string text = plan(R"("items": [{"type": "SimpleItem", "command": 16, "frame": 3,
            "params": [0, 0, 0, null, 60.1, -50, 0]}])");
        text.insert(1, R"("geoFence": {"breachReturn": [60, -50], "polygon": [[60, -50.2],
            [60.2, -50.2], [60.2, -49.8], [60, -49.8]], "version": 1}, )");
        const SceneArea area = read(text).scene.area.value();
        QVERIFY(area.geofence && area.rings.at(0).size() == 4);
        QVERIFY(isAt(area.rings[0][2], 60.2, -49.8));
    }

    /**
     * Multirotors fly at the hover speed, others at the cruise speed, VTOLs at that of their flight
     * mode.
     */
    void speedDependsOnTheVehicleType()
    {
        const auto speed = [](const std::string& members, const std::string& item = {}) {
            return read(plan(members + R"("items": [)" + item +
                             R"({"type": "SimpleItem", "command": 16, "frame": 3,
                             "params": [0, 0, 0, null, 60, -50, 50]}])"))
                .scene.uavs.at(0)
                .airspeed_mps;
        };
        const std::string both = R"("cruiseSpeed": 15, "hoverSpeed": 5, )";
        QCOMPARE(speed(both), std::optional(15.0));
        for (const int type : {2, 3, 4, 13, 14, 15, 29, 20, 22})
            QCOMPARE(speed(both + "\"vehicleType\": " + std::to_string(type) + ", "),
                     std::optional(5.0));
        for (const int type : {0, 1, 10, 11})
            QCOMPARE(speed(both + "\"vehicleType\": " + std::to_string(type) + ", "),
                     std::optional(15.0));
        const std::string vtol = both + R"("vehicleType": 20, )";
        const auto item = [](const char* command, const char* param) {
            return std::string(R"({"type": "SimpleItem", "command": )") + command +
                   R"(, "frame": 2, "params": [)" + param + ", 7, 0, 0, 0, 0, 0]}, ";
        };
        QCOMPARE(speed(vtol, item("84", "0")), std::optional(15.0));
        QCOMPARE(speed(vtol, item("3000", "4")), std::optional(15.0));
        QCOMPARE(speed(vtol, item("3000", "3")), std::optional(5.0));
        QCOMPARE(speed(both + R"("vehicleType": 2, )", item("178", "1")), std::optional(7.0));
        QCOMPARE(speed(R"("cruiseSpeed": 15, "vehicleType": 2, )"), std::optional(15.0));
    }

    /** Items and missions that QGroundControl wrote before plans had a version. */
    void olderMissionsAreRead()
    {
        const char* const first = R"({"MAV_AUTOPILOT": 3, "complexItems": [],
            "groundStation": "QGroundControl", "items": [{"autoContinue": true, "command": 16,
            "coordinate": [60.1, -50.2, 70], "frame": 3, "id": 1, "param1": 0, "param2": 0,
            "param3": 0, "param4": 0, "type": "missionItem"}], "plannedHomePosition":
            {"autoContinue": true, "command": 16, "coordinate": [60, -50, 0], "frame": 0, "id": 0,
            "param1": 0, "param2": 0, "param3": 0, "param4": 0, "type": "missionItem"},
            "version": "1.0"})";
        const char* const second = R"({"fileType": "Mission", "groundStation": "QGroundControl",
            "items": [{"autoContinue": true, "command": 16, "coordinate": [60.1, -50.2, 70],
            "frame": 3, "doJumpId": 1, "params": [0, 0, 0, 0], "type": "SimpleItem"}],
            "plannedHomePosition": [60, -50, 0], "version": 2})";
        for (const char* text : {first, second}) {
            const SightingTable table = read(text);
            QCOMPARE(table.sightings.size(), std::size_t{1});
            QVERIFY(isAt(table.sightings[0].place, 60.1, -50.2));
            QVERIFY(isAt(homeOf(table).value(), 60, -50));
            QCOMPARE(table.scene.uavs.at(0).altitude_m, std::optional(70.0));
        }
    }

    /** A faulty fence does not affect the mission. */
    void brokenFencesDoNotAffectTheMission()
    {
        const std::string places = R"("items": [{"type": "SimpleItem", "command": 16, "frame": 3,
            "params": [0, 0, 0, null, 60, -50, 0]}])";
        for (const char* fence :
             {"7", "[]", "{}", R"({"polygons": 3, "circles": {}})",
              R"({"polygons": [[], 4, null]})",
              R"({"polygons": [{"polygon": [[60, -50], [60], "x"]}]})",
              R"({"polygons": [{"polygon": [[1e300, 0], [0, 1e300], [0, 0]]}]})",
              R"({"polygons": [{"inclusion": "no", "polygon": []}]})"}) {
            std::string text = plan(places);
            text.insert(1, "\"geoFence\": " + std::string(fence) + R"(, "rallyPoints": )" + fence +
                               ", ");
            const ImportResult result = importSightings(newScenarioForImport("new"), read(text));
            QCOMPARE(result.added, std::size_t{1});
            QVERIFY(result.scenario.area_m.empty() && !result.scenario.geofence);
        }
    }

    void severalRallyPointsAreReported()
    {
        std::string text = plan(R"("plannedHomePosition": [60, -50, 0], "items": [
            {"type": "SimpleItem", "command": 16, "frame": 3,
             "params": [0, 0, 0, null, 60.1, -50, 0]}])");
        text.insert(1, R"("rallyPoints": {"points": [[60.2, -50, 0], [60.3, -50, 0]]}, )");
        const SightingTable table = read(text);
        QVERIFY(isAt(homeOf(table).value(), 60, -50));
        QVERIFY((table.scene.findings ==
                 std::vector<SceneFinding>{{.note = SceneNote::RallyPoints, .count = 2}}));
    }

    void cornersOfRoutesAreIcebergs()
    {
        for (const char* file : {"route.gpx", "route.geojson"}) {
            const SightingTable table = readFixture(file);
            QVERIFY(isAt(table.sightings[0].place, 69.25, -51.2));
            QVERIFY(isAt(table.sightings[1].place, 69.3, -51.35));
            QVERIFY(isAt(table.sightings[2].place, 69.35, -51.1));
            QVERIFY(!table.sightings[0].time && !table.oneIceberg);
            QCOMPARE(importSightings(openSea(), table).added, std::size_t{3});
        }
        QCOMPARE(readFixture("route.gpx").sightings[0].id, std::string("North <1>"));
    }

    void faultyMissionsAreRejected_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("code");
        QTest::addColumn<QByteArray>("says");
        const auto row = [](const char* name, const std::string& text, const char* code,
                            const char* says) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(code)
                                << QByteArray(says);
        };
        const std::string params = "[0, 0, 0, 0, 61, -50, 0]";
        row("other file", R"({"fileType": "Parameters", "groundStation": ""})", "WrongFormat",
            "fileType");
        row("old mission without items", R"({"fileType": "Mission", "groundStation": ""})",
            "InvalidInput", "items");
        row("short coordinate",
            planWith(
                R"({"type": "SimpleItem", "command": 16, "frame": 3, "coordinate": [61, -50]})"),
            "InvalidInput", "mission.items[1].coordinate");
        row("newer plan", R"({"fileType": "Plan", "groundStation": "", "version": 2})",
            "UnsupportedVersion", "version");
        row("no mission", R"({"fileType": "Plan", "groundStation": "", "version": 1})",
            "InvalidInput", "mission");
        row("no items", plan(""), "InvalidInput", "mission.items");
        row("items are no array", plan(R"("items": {})"), "InvalidInput", "mission.items");
        row("empty mission", plan(R"("items": [])"), "InvalidInput", "holds no sightings");
        row("short home", plan(R"("items": [], "plannedHomePosition": [1])"), "InvalidInput",
            "mission.plannedHomePosition");
        row("home in words", plan(R"("items": [], "plannedHomePosition": ["N", 2, 0])"),
            "InvalidInput", "mission.plannedHomePosition[0]");
        row("item is a number", planWith("7"), "InvalidInput", "mission.items[1]");
        row("unknown item", planWith(R"({"type": "Odd"})"), "InvalidInput",
            "mission.items[1].type");
        row("six params", planWith(simple("16", "3", "[0, 0, 0, 0, 61, -50]")), "InvalidInput",
            "mission.items[1].params");
        row("param in words", planWith(simple("16", "3", R"([0, 0, 0, 0, "61", -50, 0])")),
            "InvalidInput", "mission.items[1].params[4]");
        row("half a command", planWith(simple("16.5", "3", params.c_str())), "InvalidInput",
            "mission.items[1].command");
        row("frame out of range", planWith(simple("16", "-1", params.c_str())), "InvalidInput",
            "mission.items[1].frame");
        row("only a survey",
            plan(R"("items": [{"type": "ComplexItem", "complexItemType": "survey"}])"),
            "InvalidInput", "survey");
        row("half a plan", plan("").substr(0, 70), "SyntaxError", "line 1");
        row(
            "hundred thousand faults",
            [] {
                std::string items = "7";
                for (int i = 0; i < 100000; ++i)
                    items += ",7";
                return planWith(items);
            }(),
            "InvalidInput", "mission.items[1]");

        row("old rows", "QGC WPL 100\n", "UnsupportedVersion", "line 1");
        row("no version", "QGC WPL\n", "UnsupportedVersion", "line 1");
        row("home only", wplFile(""), "InvalidInput", "holds no sightings");
        row("eleven columns", wplFile("1\t0\t3\t16\t0\t0\t0\t0\t60.5\t-50\t0\n"), "SyntaxError",
            "line 3: has 11 columns");
        row("thirteen columns", wplFile("1\t0\t3\t16\t0\t0\t0\t0\t60.5\t-50\t0\t1\t2\n"),
            "SyntaxError", "line 3: has 13 columns");
        row("decimal commas", wplFile("1\t0\t3\t16\t0\t0\t0\t0\t60,5\t-50\t0\t1\n"), "SyntaxError",
            "line 3: \"60,5\" is no number: decimals follow a point");
        row("words", wplFile("\n1\t0\t3\tWAYPOINT\t0\t0\t0\t0\t60.5\t-50\t0\t1\n"), "SyntaxError",
            "line 4: \"WAYPOINT\" is no number");
        row("command out of range", wplFile("1\t0\t3\t16e9\t0\t0\t0\t0\t60.5\t-50\t0\t1\n"),
            "SyntaxError", "line 3: must be a whole number from 0 to 65535, not \"16e9\"");
        row("number without end",
            wplFile("1\t0\t3\t16\t0\t0\t0\t0\t" + std::string(5000, '9') + "x\n"), "SyntaxError",
            "line 3: has 9 columns");
        row("no place in order", wplFile("1\t0\t3\t16\t0\t0\t0\t0\t91\t-50\t0\t1\n"),
            "InvalidInput", "line 3: latitude");
    }

    void faultyMissionsAreRejected()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, code);
        QFETCH(QByteArray, says);
        const std::optional<Error> error = errorOf([&] { (void)read(text.toStdString()); });
        QVERIFY(error);
        QCOMPARE(QByteArray::fromStdString(codeName(error->code())), code);
        QCOMPARE(error->subject(), std::string("mission"));
        QVERIFY2(QByteArray(error->what()).contains(says), error->what());
    }

    void tooManyItemsAreRejected()
    {
        std::string rows;
        for (std::size_t i = 0; i <= 1'000'000; ++i)
            rows += "1 0 3 16 0 0 0 0 0 0 0 1\n";
        QCOMPARE(codeOf([&] { (void)read(wplFile(rows)); }), std::string("FileTooLarge"));
    }

    /** Ids contain the place to 11 m, but nearer waypoints are separate icebergs all the same. */
    void nearWaypointsAreSeparateIcebergs()
    {
        const std::string row = "\t0\t3\t16\t0\t0\t0\t0\t";
        const std::string text = "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t47\t-48\t0\t1\n1" + row +
                                 "47.018\t-48.000013\t120\t1\n2" + row +
                                 "47.018\t-47.999991\t120\t1\n3" + row + "47.02\t-48\t120\t1\n";
        const ImportResult result = importSightings(newScenarioForImport("near"),
                                                    readSightings(text, "near.waypoints"), {});
        QCOMPARE(result.added, std::size_t{3});
        std::set<std::string> ids;
        for (const Iceberg& iceberg : result.scenario.icebergs)
            ids.insert(iceberg.id);
        QCOMPARE(ids.size(), std::size_t{3});
    }
};

QTEST_APPLESS_MAIN(TestImportMissions)
#include "tst_import_missions.moc"
