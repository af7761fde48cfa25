#pragma once

#include "tests/support/files/export_text.h"
#include "tests/support/files/golden.h"
#include "tests/support/flight/mission_builder.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QList>

#include <vector>

// GeoJSON of a scenario, and access to its parts.

namespace berg::test {

using namespace Qt::StringLiterals;

inline QByteArray planText(const Scenario& scenario, const Plan& plan = fourIcebergPlan())
{
    return bytes(geoJson(planContent(scenario, plan)));
}

inline QByteArray runText(const Mission& mission)
{
    return bytes(geoJson(runContent(mission)));
}

/** Returns `fourIcebergs` at another place. */
inline Scenario at(double latitude_deg, double longitude_deg)
{
    return changed([&](Scenario& s) {
        s.origin = {.latitude_deg = latitude_deg, .longitude_deg = longitude_deg};
    });
}

inline QList<QJsonObject> features(const QByteArray& text, const QString& kind)
{
    QList<QJsonObject> found;
    for (const QJsonValue& feature : QJsonDocument::fromJson(text)["features"_L1].toArray())
        if (feature["properties"_L1]["kind"_L1].toString() == kind)
            found << feature.toObject();
    return found;
}

inline LatLon placeOf(const QJsonValue& position)
{
    return {.latitude_deg = position[1].toDouble(), .longitude_deg = position[0].toDouble()};
}

/** The parts of a line or the exterior rings of a polygon. */
inline QList<QJsonArray> parts(const QJsonObject& feature)
{
    const QString type = feature["geometry"_L1]["type"_L1].toString();
    const QJsonArray coordinates = feature["geometry"_L1]["coordinates"_L1].toArray();
    if (type == "LineString"_L1)
        return {coordinates};
    QList<QJsonArray> all;
    if (type == "Polygon"_L1)
        return {coordinates[0].toArray()};
    for (const QJsonValue& part : coordinates)
        all << (type == "MultiPolygon"_L1 ? part[0].toArray() : part.toArray());
    return all;
}

inline std::vector<Point> planePoints(const LocalFrame& frame, const QJsonArray& positions)
{
    std::vector<Point> points;
    for (const QJsonValue& position : positions)
        points.push_back(frame.toPlane(placeOf(position)));
    return points;
}

} // namespace berg::test
