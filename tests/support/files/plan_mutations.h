#pragma once

#include "tests/support/files/plan_rules.h"

#include <QStringList>

#include <functional>

// Common reasons for which readers reject `.plan` files of other programs, each with the rules of
// plan_rules.h that must detect it ("reader: rule").

namespace berg::test {

inline void editMission(QJsonObject& root, const std::function<void(QJsonObject&)>& edit)
{
    QJsonObject mission = root["mission"_L1].toObject();
    edit(mission);
    root["mission"_L1] = mission;
}

inline void editItem(QJsonObject& root, int row, const std::function<void(QJsonObject&)>& edit)
{
    editMission(root, [&](QJsonObject& mission) {
        QJsonArray items = mission["items"_L1].toArray();
        QJsonObject item = items[row].toObject();
        edit(item);
        items[row] = item;
        mission["items"_L1] = items;
    });
}

inline void editParams(QJsonObject& root, int row, const std::function<void(QJsonArray&)>& edit)
{
    editItem(root, row, [&](QJsonObject& item) {
        QJsonArray params = item["params"_L1].toArray();
        edit(params);
        item["params"_L1] = params;
    });
}

inline void editFencePolygon(QJsonObject& root, const std::function<void(QJsonObject&)>& edit)
{
    QJsonObject fence = root["geoFence"_L1].toObject();
    QJsonObject polygon = fence["polygons"_L1].toArray().first().toObject();
    edit(polygon);
    fence["polygons"_L1] = QJsonArray{polygon};
    root["geoFence"_L1] = fence;
}

/** One such fault, and the rules that detect it. */
struct Mutation
{
    const char* name;
    std::function<void(QJsonObject&)> edit;
    QStringList broken;
};

inline QStringList everywhere(const QString& rule)
{
    return {u"QGroundControl: "_s + rule, u"MAVSDK: "_s + rule, u"Mission Planner: "_s + rule};
}

inline std::vector<Mutation> headMutations()
{
    return {
        {"no geoFence",
         [](QJsonObject& o) { o.remove("geoFence"_L1); },
         {u"QGroundControl: geoFence"_s, u"QGroundControl: fence version"_s, u"MAVSDK: geoFence"_s,
          u"MAVSDK: fence version"_s}},
        {"no rallyPoints",
         [](QJsonObject& o) { o.remove("rallyPoints"_L1); },
         {u"QGroundControl: rallyPoints"_s, u"QGroundControl: rally version"_s,
          u"QGroundControl: rally points"_s, u"MAVSDK: rallyPoints"_s, u"MAVSDK: rally version"_s}},
        {"version as string",
         [](QJsonObject& o) { o["version"_L1] = u"1"_s; },
         {u"QGroundControl: version"_s, u"MAVSDK: version"_s, u"Mission Planner: integers"_s}},
        {"version 2",
         [](QJsonObject& o) { o["version"_L1] = 2; },
         {u"QGroundControl: version"_s, u"MAVSDK: version"_s}},
        {"wrong fileType",
         [](QJsonObject& o) { o["fileType"_L1] = u"Mission"_s; },
         {u"QGroundControl: fileType"_s}},
        {"no groundStation",
         [](QJsonObject& o) { o.remove("groundStation"_L1); },
         {u"QGroundControl: groundStation"_s}},
        {"rally point of two values",
         [](QJsonObject& o) {
             o["rallyPoints"_L1] =
                 QJsonObject{{u"version"_s, 2}, {u"points"_s, QJsonArray{QJsonArray{47, -48}}}};
         },
         {u"QGroundControl: rally points"_s}},
        {"rally points of version 1",
         [](QJsonObject& o) {
             o["rallyPoints"_L1] = QJsonObject{{u"version"_s, 1}, {u"points"_s, QJsonArray{}}};
         },
         {u"QGroundControl: rally version"_s, u"MAVSDK: rally version"_s}},
        {"fence of version 1",
         [](QJsonObject& o) {
             QJsonObject fence = o["geoFence"_L1].toObject();
             fence["version"_L1] = 1;
             o["geoFence"_L1] = fence;
         },
         {u"QGroundControl: fence version"_s, u"MAVSDK: fence version"_s}},
        {"fence corner with altitude",
         [](QJsonObject& o) {
             editFencePolygon(o, [](QJsonObject& polygon) {
                 QJsonArray corners = polygon["polygon"_L1].toArray();
                 corners[0] = QJsonArray{47, -48, 100};
                 polygon["polygon"_L1] = corners;
             });
         },
         {u"QGroundControl: fence polygons"_s}},
        {"fence without inclusion",
         [](QJsonObject& o) {
             editFencePolygon(o, [](QJsonObject& polygon) { polygon.remove("inclusion"_L1); });
         },
         {u"QGroundControl: fence polygons"_s}}};
}

inline std::vector<Mutation> missionMutations()
{
    const auto inMission = [](auto edit) {
        return [edit](QJsonObject& o) { editMission(o, edit); };
    };
    return {
        {"no mission",
         [](QJsonObject& o) { o.remove("mission"_L1); },
         {u"QGroundControl: mission"_s, u"QGroundControl: home"_s, u"QGroundControl: items"_s,
          u"QGroundControl: firmwareType"_s, u"MAVSDK: mission"_s, u"MAVSDK: mission version"_s,
          u"MAVSDK: home for ArduPilot"_s, u"Mission Planner: mission"_s,
          u"Mission Planner: home"_s, u"Mission Planner: items"_s}},
        {"home of two values",
         inMission([](QJsonObject& m) {
             m["plannedHomePosition"_L1] = QJsonArray{47, -48};
         }),
         {u"QGroundControl: home"_s, u"MAVSDK: home for ArduPilot"_s, u"Mission Planner: home"_s}},
        {"home of strings",
         inMission([](QJsonObject& m) {
             m["plannedHomePosition"_L1] = QJsonArray{u"47"_s, u"-48"_s, u"0"_s};
         }),
         {u"QGroundControl: home"_s, u"MAVSDK: home for ArduPilot"_s, u"Mission Planner: home"_s}},
        {"mission of version 1",
         inMission([](QJsonObject& m) { m["version"_L1] = 1; }),
         {u"MAVSDK: mission version"_s}},
        {"no firmwareType",
         inMission([](QJsonObject& m) { m.remove("firmwareType"_L1); }),
         {u"QGroundControl: firmwareType"_s}},
        {"no items",
         inMission([](QJsonObject& m) { m["items"_L1] = QJsonArray{}; }),
         {u"QGroundControl: items"_s, u"Mission Planner: items"_s}},
        {"speed as string",
         inMission([](QJsonObject& m) { m["cruiseSpeed"_L1] = u"22"_s; }),
         {u"QGroundControl: optional numbers"_s, u"Mission Planner: integers"_s}},
        {"cruiseSpeed 22.5",
         inMission([](QJsonObject& m) { m["cruiseSpeed"_L1] = 22.5; }),
         {u"Mission Planner: integers"_s}}};
}

inline std::vector<Mutation> itemMutations()
{
    const auto inItem = [](int row, auto edit) {
        return [row, edit](QJsonObject& o) { editItem(o, row, edit); };
    };
    const auto without = [&](QLatin1StringView key) {
        return inItem(1, [key](QJsonObject& item) { item.remove(key); });
    };
    return {
        {"six params",
         [](QJsonObject& o) { editParams(o, 1, [](QJsonArray& p) { p.removeLast(); }); },
         {u"QGroundControl: seven params"_s}},
        {"eight params",
         [](QJsonObject& o) { editParams(o, 1, [](QJsonArray& p) { p.append(0); }); },
         {u"QGroundControl: seven params"_s}},
        {"null latitude",
         [](QJsonObject& o) { editParams(o, 1, [](QJsonArray& p) { p[4] = QJsonValue::Null; }); },
         {u"QGroundControl: seven params"_s, u"Mission Planner: params"_s}},
        {"null yaw",
         [](QJsonObject& o) { editParams(o, 1, [](QJsonArray& p) { p[3] = QJsonValue::Null; }); },
         {u"Mission Planner: params"_s}},
        {"autoContinue 1",
         inItem(1, [](QJsonObject& item) { item["autoContinue"_L1] = 1; }),
         {u"QGroundControl: autoContinue boolean"_s, u"QGroundControl: autoContinue on"_s}},
        {"autoContinue false",
         inItem(1, [](QJsonObject& item) { item["autoContinue"_L1] = false; }),
         {u"QGroundControl: autoContinue on"_s}},
        {"no autoContinue",
         without("autoContinue"_L1),
         {u"QGroundControl: autoContinue boolean"_s, u"QGroundControl: autoContinue on"_s,
          u"MAVSDK: item members"_s}},
        {"no command",
         without("command"_L1),
         {u"QGroundControl: command and frame"_s, u"MAVSDK: item members"_s}},
        {"no frame",
         without("frame"_L1),
         {u"QGroundControl: command and frame"_s, u"QGroundControl: frames"_s,
          u"MAVSDK: item members"_s}},
        {"no params",
         without("params"_L1),
         {u"QGroundControl: seven params"_s, u"MAVSDK: item members"_s}},
        {"part of the altitude trio",
         without("AMSLAltAboveTerrain"_L1),
         {u"QGroundControl: altitude trio"_s}},
        {"AltitudeMode as string",
         inItem(1, [](QJsonObject& item) { item["AltitudeMode"_L1] = u"1"_s; }),
         {u"QGroundControl: altitude trio"_s}},
        {"unknown item type", inItem(1, [](QJsonObject& item) { item["type"_L1] = u"Waypoint"_s; }),
         everywhere(u"item type"_s)},
        {"complex item",
         inItem(1,
                [](QJsonObject& item) {
                    item["type"_L1] = u"ComplexItem"_s;
                    item["complexItemType"_L1] = u"CorridorScan"_s;
                }),
         everywhere(u"item type"_s)},
        {"deprecated frame 6",
         inItem(1, [](QJsonObject& item) { item["frame"_L1] = 6; }),
         {u"QGroundControl: frames"_s}},
        {"DO_CHANGE_SPEED in frame 3",
         inItem(0, [](QJsonObject& item) { item["frame"_L1] = 3; }),
         {u"QGroundControl: frames"_s}},
        {"doJumpId from 0",
         inItem(0, [](QJsonObject& item) { item["doJumpId"_L1] = 0; }),
         {u"QGroundControl: doJumpId"_s}},
        {"DO_JUMP to no item",
         inItem(0,
                [](QJsonObject& item) {
                    item["command"_L1] = 177;
                    item["params"_L1] = QJsonArray{99, -1, 0, 0, 0, 0, 0};
                }),
         {u"QGroundControl: DO_JUMP target"_s}}};
}

inline std::vector<Mutation> mutations()
{
    std::vector<Mutation> all = headMutations();
    for (const std::vector<Mutation>& more : {missionMutations(), itemMutations()})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

} // namespace berg::test
