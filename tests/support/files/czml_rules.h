#pragma once

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QSet>
#include <QString>

// Rules of CZML 1.0 after the CZML guide of Cesium (structure, packets, intervals, positions).

namespace berg::test {

using namespace Qt::StringLiterals;

namespace czml {

/**
 * Checks repeated groups of [longitude, latitude, height], or [time, longitude, latitude, height].
 */
inline QString degreesFault(const QJsonArray& numbers, bool timed)
{
    const qsizetype step = timed ? 4 : 3;
    if (numbers.isEmpty() || numbers.size() % step != 0)
        return u"%1 numbers"_s.arg(numbers.size());
    double last_s = -1e300;
    for (qsizetype i = 0; i < numbers.size(); i += step) {
        for (qsizetype part = 0; part < step; ++part)
            if (!numbers[i + part].isDouble())
                return u"not a number"_s;
        if (timed && numbers[i].toDouble() <= last_s)
            return u"times do not rise"_s;
        if (timed)
            last_s = numbers[i].toDouble();
        const qsizetype place = i + step - 3;
        if (std::abs(numbers[place].toDouble()) > 180 ||
            std::abs(numbers[place + 1].toDouble()) > 90)
            return u"out of range"_s;
    }
    return {};
}

inline bool isInterval(const QJsonValue& value)
{
    static const QRegularExpression pattern(
        u"^(\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\d(\\.\\d+)?Z)/(\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\d(\\.\\d+)?Z)$"_s);
    const QRegularExpressionMatch match = pattern.match(value.toString());
    return match.hasMatch() && match.captured(1) < match.captured(3);
}

inline QString packetFault(const QJsonObject& packet)
{
    if (packet.contains("availability"_L1) && !isInterval(packet["availability"_L1]))
        return u"availability"_s;
    const QJsonObject position = packet["position"_L1].toObject();
    const bool timed = position.contains("epoch"_L1);
    if (timed && !packet.contains("availability"_L1))
        return u"moves, but is never there"_s;
    QString fault;
    if (packet.contains("position"_L1))
        fault = degreesFault(position["cartographicDegrees"_L1].toArray(), timed);
    if (fault.isEmpty() && packet.contains("polyline"_L1))
        fault = degreesFault(
            packet["polyline"_L1]["positions"_L1]["cartographicDegrees"_L1].toArray(), false);
    return fault;
}

} // namespace czml

/** Returns the first broken rule, or an empty text. */
inline QString czmlFault(const QByteArray& text)
{
    const QJsonDocument document = QJsonDocument::fromJson(text);
    if (!document.isArray() || document.array().isEmpty())
        return u"not a JSON array of packets"_s;
    const QJsonObject first = document.array().first().toObject();
    if (first["id"_L1] != "document"_L1 || first["version"_L1] != "1.0"_L1)
        return u"the first packet is not the document"_s;
    if (first.contains("clock"_L1) && !czml::isInterval(first["clock"_L1]["interval"_L1]))
        return u"clock"_s;
    QSet<QString> ids;
    for (const QJsonValue& value : document.array()) {
        const QString id = value["id"_L1].toString();
        if (id.isEmpty() || ids.contains(id))
            return u"id "_s + id;
        ids << id;
        if (const QString fault = czml::packetFault(value.toObject()); !fault.isEmpty())
            return id + u": "_s + fault;
    }
    return {};
}

} // namespace berg::test
