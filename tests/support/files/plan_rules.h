#pragma once

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QString>

#include <vector>

// Rules of the readers of `.plan` files, taken from their sources: QGroundControl
// (PlanMasterController, MissionController, SimpleMissionItem, GeoFenceController,
// RallyPointController), MAVSDK (mission_import.cpp), Mission Planner (MissionFile.cs). Each rule
// is one check that returns the fault, or an empty text.

namespace berg::test {

using namespace Qt::StringLiterals;

struct PlanText
{
    QByteArray text;
    QJsonObject root;
};

inline PlanText planText(const QByteArray& text)
{
    return {.text = text, .root = QJsonDocument::fromJson(text).object()};
}

struct PlanRule
{
    const char* name;
    QString (*fault)(const PlanText&);
};

namespace plan_rules {

inline QString unless(bool good, const QString& fault)
{
    return good ? QString() : fault;
}

inline QJsonObject mission(const PlanText& plan)
{
    return plan.root["mission"_L1].toObject();
}

inline QJsonArray items(const PlanText& plan)
{
    return mission(plan)["items"_L1].toArray();
}

/** Returns the first fault that `check(item)` finds. */
template <class Check>
QString eachItem(const PlanText& plan, const Check& check)
{
    int row = 0;
    for (const QJsonValue& value : items(plan)) {
        const QString fault = check(value.toObject());
        if (!fault.isEmpty())
            return u"items[%1]: "_s.arg(row) + fault;
        ++row;
    }
    return {};
}

inline bool allNumbers(const QJsonArray& values)
{
    for (const QJsonValue& value : values)
        if (!value.isDouble())
            return false;
    return true;
}

inline bool numberIfPresent(const QJsonObject& object, QLatin1StringView key)
{
    return !object.contains(key) || object[key].isDouble();
}

inline QString json(const PlanText& plan)
{
    QJsonParseError error{};
    const QJsonDocument document = QJsonDocument::fromJson(plan.text, &error);
    return unless(error.error == QJsonParseError::NoError && document.isObject(),
                  error.errorString());
}

inline QString fileType(const PlanText& plan)
{
    return unless(plan.root["fileType"_L1].toString() == "Plan"_L1, u"fileType is not Plan"_s);
}

inline QString rootVersion(const PlanText& plan)
{
    return unless(plan.root["version"_L1].isDouble() && plan.root["version"_L1].toInt() == 1,
                  u"version is not the number 1"_s);
}

inline QString groundStation(const PlanText& plan)
{
    return unless(plan.root["groundStation"_L1].isString(), u"no groundStation"_s);
}

inline QString missionObject(const PlanText& plan)
{
    return unless(plan.root["mission"_L1].isObject(), u"no mission object"_s);
}

inline QString fenceObject(const PlanText& plan)
{
    return unless(plan.root["geoFence"_L1].isObject(), u"no geoFence object"_s);
}

inline QString rallyObject(const PlanText& plan)
{
    return unless(plan.root["rallyPoints"_L1].isObject(), u"no rallyPoints object"_s);
}

inline QString home(const PlanText& plan)
{
    const QJsonArray home = mission(plan)["plannedHomePosition"_L1].toArray();
    return unless(home.size() == 3 && allNumbers(home), u"home is not three numbers"_s);
}

inline QString itemsArray(const PlanText& plan)
{
    return unless(mission(plan)["items"_L1].isArray() && !items(plan).isEmpty(), u"no items"_s);
}

inline QString firmwareType(const PlanText& plan)
{
    return unless(mission(plan)["firmwareType"_L1].isDouble(), u"no firmwareType"_s);
}

inline QString optionalNumbers(const PlanText& plan)
{
    for (const QLatin1StringView key :
         {"vehicleType"_L1, "cruiseSpeed"_L1, "hoverSpeed"_L1, "globalPlanAltitudeMode"_L1})
        if (!numberIfPresent(mission(plan), key))
            return key + u" is not a number"_s;
    return {};
}

inline QString itemType(const PlanText& plan)
{
    return eachItem(plan, [](const QJsonObject& item) {
        return unless(item["type"_L1].toString() == "SimpleItem"_L1, u"type unknown"_s);
    });
}

inline QString commandAndFrame(const PlanText& plan)
{
    return eachItem(plan, [](const QJsonObject& item) {
        return unless(item["command"_L1].isDouble() && item["frame"_L1].isDouble(),
                      u"command or frame is not a number"_s);
    });
}

inline QString sevenParams(const PlanText& plan)
{
    return eachItem(plan, [](const QJsonObject& item) {
        const QJsonArray params = item["params"_L1].toArray();
        if (params.size() != 7)
            return u"%1 params"_s.arg(params.size());
        for (int i = 0; i < 7; ++i)
            if (!params[i].isDouble() && !(i < 4 && params[i].isNull()))
                return u"param %1 is no number"_s.arg(i + 1);
        return QString();
    });
}

inline QString autoContinueBool(const PlanText& plan)
{
    return eachItem(plan, [](const QJsonObject& item) {
        return unless(item["autoContinue"_L1].isBool(), u"autoContinue is not a boolean"_s);
    });
}

/** Other values are read, but the item can then be edited in raw form only. */
inline QString autoContinueTrue(const PlanText& plan)
{
    return eachItem(plan, [](const QJsonObject& item) {
        return unless(item["autoContinue"_L1] == QJsonValue(true), u"autoContinue is off"_s);
    });
}

inline QString altitudeTrio(const PlanText& plan)
{
    return eachItem(plan, [](const QJsonObject& item) {
        int present = 0;
        for (const QLatin1StringView key :
             {"AltitudeMode"_L1, "Altitude"_L1, "AMSLAltAboveTerrain"_L1}) {
            if (!item.contains(key))
                continue;
            ++present;
            if (!item[key].isDouble() && !item[key].isNull())
                return key + u" is no number"_s;
        }
        return unless(present == 0 || present == 3, u"part of the altitude trio"_s);
    });
}

/** 0 or 3 for positions, 2 for DO_* and a return; the *_INT frames open as raw edit only. */
inline QString frames(const PlanText& plan)
{
    constexpr int kFirstDoCommand = 176;
    constexpr int kReturnToLaunch = 20;
    return eachItem(plan, [](const QJsonObject& item) {
        const int frame = item["frame"_L1].toInt(-1);
        const int command = item["command"_L1].toInt();
        const bool isDo = command >= kFirstDoCommand || command == kReturnToLaunch;
        return unless(isDo ? frame == 2 : frame == 0 || frame == 3, u"frame %1"_s.arg(frame));
    });
}

inline QString jumpIds(const PlanText& plan)
{
    int expected = 1;
    return eachItem(plan, [&](const QJsonObject& item) {
        return unless(item["doJumpId"_L1].toInt(-1) == expected++, u"doJumpId out of sequence"_s);
    });
}

inline QString jumpTargets(const PlanText& plan)
{
    constexpr int kDoJump = 177;
    std::vector<int> ids;
    for (const QJsonValue& item : items(plan))
        ids.push_back(item["doJumpId"_L1].toInt());
    return eachItem(plan, [&](const QJsonObject& item) {
        if (item["command"_L1].toInt() != kDoJump)
            return QString();
        const int target = item["params"_L1].toArray().at(0).toInt(-1);
        for (const int id : ids)
            if (id == target)
                return QString();
        return u"jump to no item"_s;
    });
}

inline QString fence(const PlanText& plan)
{
    for (const QJsonValue& polygon : plan.root["geoFence"_L1]["polygons"_L1].toArray()) {
        if (polygon["version"_L1].toInt() != 1 || !polygon["inclusion"_L1].isBool())
            return u"polygon without version 1 or inclusion"_s;
        const QJsonArray corners = polygon["polygon"_L1].toArray();
        if (corners.size() < 3)
            return u"polygon of less than three corners"_s;
        for (const QJsonValue& corner : corners)
            if (corner.toArray().size() != 2 || !allNumbers(corner.toArray()))
                return u"corner is not two numbers"_s;
    }
    return {};
}

/** QGroundControl ignores the whole fence without it, silently; MAVSDK refuses the file. */
inline QString fenceVersion(const PlanText& plan)
{
    return unless(plan.root["geoFence"_L1]["version"_L1].toInt(-1) == 2, u"not 2"_s);
}

inline QString rallyVersion(const PlanText& plan)
{
    return unless(plan.root["rallyPoints"_L1]["version"_L1].toInt(-1) == 2, u"not 2"_s);
}

inline QString rallyPoints(const PlanText& plan)
{
    const QJsonValue points = plan.root["rallyPoints"_L1]["points"_L1];
    if (!points.isArray())
        return u"no points"_s;
    for (const QJsonValue& point : points.toArray())
        if (point.toArray().size() != 3)
            return u"point is not three values"_s;
    return {};
}

inline QString missionVersion(const PlanText& plan)
{
    return unless(mission(plan)["version"_L1].toInt(-1) == 2, u"not 2"_s);
}

inline QString mavsdkItemMembers(const PlanText& plan)
{
    return eachItem(plan, [](const QJsonObject& item) {
        for (const QLatin1StringView key :
             {"command"_L1, "autoContinue"_L1, "frame"_L1, "params"_L1})
            if (!item.contains(key) || item[key].isNull())
                return QString(key);
        return unless(item["params"_L1].isArray(), u"params"_s);
    });
}

/** Only surveys of version 5 among the complex items. */
inline QString mavsdkItemType(const PlanText& plan)
{
    return eachItem(plan, [](const QJsonObject& item) {
        const bool survey = item["type"_L1].toString() == "ComplexItem"_L1 &&
                            item["complexItemType"_L1].toString() == "survey"_L1 &&
                            item["version"_L1].toInt() == 5;
        return unless(survey || item["type"_L1].toString() == "SimpleItem"_L1, u"type"_s);
    });
}

/** Members read into integers: a decimal point or exponent makes the whole file unreadable. */
inline QString missionPlannerIntegers(const PlanText& plan)
{
    static const QRegularExpression member(
        uR"re("(cruiseSpeed|hoverSpeed|firmwareType|vehicleType|version|command|doJumpId|frame)"\s*:\s*([^,}\s]*))re"_s);
    static const QRegularExpression integer(u"^-?[0-9]{1,9}$"_s);
    QRegularExpressionMatchIterator it = member.globalMatch(QString::fromUtf8(plan.text));
    while (it.hasNext()) {
        const QRegularExpressionMatch match = it.next();
        if (!integer.match(match.captured(2)).hasMatch())
            return match.captured(1) + u" = "_s + match.captured(2);
    }
    return {};
}

/** Plain doubles: a null does not convert. */
inline QString missionPlannerParams(const PlanText& plan)
{
    return eachItem(plan, [](const QJsonObject& item) {
        return unless(allNumbers(item["params"_L1].toArray()), u"a param is no number"_s);
    });
}

} // namespace plan_rules

inline std::vector<PlanRule> qgroundcontrolRules()
{
    using namespace plan_rules;
    return {{"JSON", json},
            {"fileType", fileType},
            {"version", rootVersion},
            {"groundStation", groundStation},
            {"mission", missionObject},
            {"geoFence", fenceObject},
            {"rallyPoints", rallyObject},
            {"home", home},
            {"items", itemsArray},
            {"firmwareType", firmwareType},
            {"optional numbers", optionalNumbers},
            {"item type", itemType},
            {"command and frame", commandAndFrame},
            {"seven params", sevenParams},
            {"autoContinue boolean", autoContinueBool},
            {"autoContinue on", autoContinueTrue},
            {"altitude trio", altitudeTrio},
            {"frames", frames},
            {"doJumpId", jumpIds},
            {"DO_JUMP target", jumpTargets},
            {"fence version", fenceVersion},
            {"fence polygons", fence},
            {"rally version", rallyVersion},
            {"rally points", rallyPoints}};
}

inline std::vector<PlanRule> mavsdkRules()
{
    using namespace plan_rules;
    return {{"JSON", json},
            {"version", rootVersion},
            {"mission", missionObject},
            {"geoFence", fenceObject},
            {"rallyPoints", rallyObject},
            {"mission version", missionVersion},
            {"fence version", fenceVersion},
            {"rally version", rallyVersion},
            {"item members", mavsdkItemMembers},
            {"item type", mavsdkItemType},
            {"home for ArduPilot", home}};
}

inline std::vector<PlanRule> missionPlannerRules()
{
    using namespace plan_rules;
    return {{"JSON", json},
            {"mission", missionObject},
            {"home", home},
            {"items", itemsArray},
            {"item type", itemType},
            {"integers", missionPlannerIntegers},
            {"params", missionPlannerParams}};
}

} // namespace berg::test
