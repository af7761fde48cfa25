#pragma once

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QString>

#include <cmath>

// Rules of RFC 7946, written from its text; the section is named in each fault.

namespace berg::test {

using namespace Qt::StringLiterals;

namespace geojson_rules {

inline QString position(const QJsonValue& value)
{
    const QJsonArray numbers = value.toArray();
    if (numbers.size() < 2 || numbers.size() > 3)
        return u"3.1.1 position of %1 values"_s.arg(numbers.size());
    for (const QJsonValue& number : numbers)
        if (!number.isDouble() || !std::isfinite(number.toDouble()))
            return u"3.1.1 position is no number"_s;
    if (std::abs(numbers[0].toDouble()) > 180 || std::abs(numbers[1].toDouble()) > 90)
        return u"4 longitude or latitude out of range"_s;
    return {};
}

inline QString line(const QJsonArray& positions)
{
    if (positions.size() < 2)
        return u"3.1.4 line of less than two positions"_s;
    for (qsizetype i = 0; i < positions.size(); ++i) {
        const QString fault = position(positions[i]);
        if (!fault.isEmpty())
            return fault;
        if (i > 0 && std::abs(positions[i][0].toDouble() - positions[i - 1][0].toDouble()) > 180 &&
            std::abs(positions[i][1].toDouble()) < 90)
            return u"3.1.9 crosses the antimeridian"_s;
    }
    return {};
}

inline double signedArea(const QJsonArray& ring)
{
    double twice = 0;
    for (qsizetype i = 1; i < ring.size(); ++i)
        twice += ring[i - 1][0].toDouble() * ring[i][1].toDouble() -
                 ring[i][0].toDouble() * ring[i - 1][1].toDouble();
    return twice / 2;
}

inline QString polygon(const QJsonArray& rings)
{
    if (rings.isEmpty())
        return u"3.1.6 no rings"_s;
    for (qsizetype i = 0; i < rings.size(); ++i) {
        const QJsonArray ring = rings[i].toArray();
        if (ring.size() < 4)
            return u"3.1.6 ring of less than four positions"_s;
        if (ring.first() != ring.last())
            return u"3.1.6 ring is not closed"_s;
        if ((signedArea(ring) > 0) != (i == 0))
            return u"3.1.6 ring does not follow the right-hand rule"_s;
        const QString fault = line(ring);
        if (!fault.isEmpty())
            return fault;
    }
    return {};
}

template <class Check>
QString each(const QJsonArray& parts, const Check& check)
{
    for (const QJsonValue& part : parts) {
        const QString fault = check(part.toArray());
        if (!fault.isEmpty())
            return fault;
    }
    return parts.isEmpty() ? u"3.1 no parts"_s : QString();
}

inline QString geometry(const QJsonObject& object)
{
    const QString type = object["type"_L1].toString();
    const QJsonArray coordinates = object["coordinates"_L1].toArray();
    if (!object["coordinates"_L1].isArray())
        return u"3.1 no coordinates"_s;
    if (type == "Point"_L1)
        return position(coordinates);
    if (type == "LineString"_L1)
        return line(coordinates);
    if (type == "MultiLineString"_L1)
        return each(coordinates, line);
    if (type == "Polygon"_L1)
        return polygon(coordinates);
    if (type == "MultiPolygon"_L1)
        return each(coordinates, polygon);
    return u"3.1 unknown geometry "_s + type;
}

/**
 * Checks that there are as many times as positions, nested alike (a convention, not in the RFC).
 */
inline QString times(const QJsonObject& feature)
{
    const QJsonObject properties = feature["properties"_L1]["coordinateProperties"_L1].toObject();
    if (properties.isEmpty())
        return {};
    const QJsonArray times = properties.begin()->toArray();
    const QJsonArray coordinates = feature["geometry"_L1]["coordinates"_L1].toArray();
    if (times.size() != coordinates.size())
        return u"times do not match the coordinates"_s;
    if (feature["geometry"_L1]["type"_L1].toString() == "MultiLineString"_L1)
        for (qsizetype i = 0; i < times.size(); ++i)
            if (times[i].toArray().size() != coordinates[i].toArray().size())
                return u"times do not match the coordinates"_s;
    return {};
}

} // namespace geojson_rules

/**
 * Returns the first rule that the text breaks, or an empty text for a FeatureCollection of RFC
 * 7946.
 */
inline QString geojsonFault(const QByteArray& text)
{
    QJsonParseError error{};
    const QJsonObject root = QJsonDocument::fromJson(text, &error).object();
    if (error.error != QJsonParseError::NoError)
        return u"2 not JSON: "_s + error.errorString();
    if (root["type"_L1].toString() != "FeatureCollection"_L1 || !root["features"_L1].isArray())
        return u"3.3 no FeatureCollection"_s;
    if (root.contains("crs"_L1))
        return u"4 crs member"_s;
    for (const QJsonValue& value : root["features"_L1].toArray()) {
        const QJsonObject feature = value.toObject();
        if (feature["type"_L1].toString() != "Feature"_L1)
            return u"3.2 no Feature"_s;
        if (!feature["geometry"_L1].isObject() || !feature["properties"_L1].isObject())
            return u"3.2 no geometry or no properties"_s;
        for (const QLatin1StringView key : {"coordinates"_L1, "geometries"_L1, "features"_L1})
            if (feature.contains(key))
                return u"7.1 Feature with "_s + key;
        QString fault = geojson_rules::geometry(feature["geometry"_L1].toObject());
        if (fault.isEmpty())
            fault = geojson_rules::times(feature);
        if (!fault.isEmpty())
            return fault;
    }
    return {};
}

} // namespace berg::test
