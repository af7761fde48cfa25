#pragma once

#include "core/io/export/formats.h"
#include "core/io/text/ogr2ogr.h"
#include "tests/support/files/czml_rules.h"
#include "tests/support/files/geojson_rules.h"
#include "tests/support/files/golden.h"
#include "tests/support/files/plan_rules.h"
#include "tests/support/files/wpl_readers.h"
#include "tests/support/flight/mission_builder.h"

#include <QTest>
#include <QXmlStreamReader>

// Fixtures for exports, and checks of their results by the rules of their readers.

namespace berg::test {

/**
 * Returns names that break files: markup, quotes, line ends, controls, both directions, broken
 * UTF-8.
 */
inline Scenario hostile()
{
    return changed([](Scenario& s) {
        s.name = "<name>&amp;\"'\n\x01]]>";
        s.uavs[0].name = "\xE2\x80\xAE"
                         "desrever, \xF0\x9F\x9B\xA9 <b>";
        s.icebergs[0].name = "a,b;\"c\"\r\n\t</kml>";
        s.icebergs[1].name = "\xF0\x9F\xA7\x8A \xD7\xA7\xD7\xA8\xD7\x97\xD7\x95\xD7\x9F";
        s.icebergs[2].name = "\xFF\xFE broken, \xC2\x85 and \x7F";
        s.icebergs[3].id = "<&>\"'\n";
        s.asset = Asset{
            .name = "]]><!--", .position_m = Point(9000, 100), .standoff_m = 300, .extraJson = {}};
        s.geofence = true;
        s.noFly = {{.name = "]]></name>, \"b\"",
                    .corners_m = {{8000, 0}, {8500, 0}, {8500, 500}},
                    .floor_m = 50,
                    .ceiling_m = 500}};
        s.airspace = {{.name = "]]></name>, \"b\"",
                       .kind = "<&",
                       .corners_m = {{0, 8000}, {500, 8000}, {500, 8500}},
                       .floor_m = 900,
                       .fromUtc = "2026-01-01T00:00Z"}};
        s.operation = Operation{.crew = "</kml> \x01", .checklist = "\n\n<b>\r\x7F"};
    });
}

/** Returns `fourIcebergs` with the antimeridian through the middle of its area. */
inline Scenario at180()
{
    return changed([](Scenario& s) {
        s.origin = {.latitude_deg = 70, .longitude_deg = 179.95};
        s.geofence = true;
        s.noFly = {{.corners_m = {{1000, 8000}, {4000, 8000}, {4000, 8500}, {1000, 8500}}}};
        s.operation = Operation{};
    });
}

inline Scenario fiveHundred()
{
    return changed([](Scenario& s) {
        s.icebergs.resize(500, s.icebergs[0]);
        for (std::size_t i = 4; i < s.icebergs.size(); ++i) {
            const double row = double(i / 25);
            const double column = double(i % 25);
            s.icebergs[i].id = "berg-" + std::to_string(i + 1);
            s.icebergs[i].position_m = Point(700 * column, 700 * row);
        }
    });
}

/**
 * Adds a row for every format that writes plans, with scenario and option. Pages and images have
 * tests of their own with fonts and paper.
 */
inline void exportRows()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<Scenario>("scenario");
    QTest::addColumn<ExportOptions>("options");
    const Scenario north = changed([](Scenario& s) {
        s.origin = {.latitude_deg = 90, .longitude_deg = 0};
        s.operation = Operation{}; // its volume contains the pole
    });
    const Scenario south =
        changed([](Scenario& s) { s.origin = {.latitude_deg = -89.99, .longitude_deg = 180}; });
    const Scenario timeless = changed([](Scenario& s) { s.startUtc.clear(); });
    const Scenario empty = changed([](Scenario& s) { s.icebergs.clear(); });
    const std::vector<std::pair<const char*, Scenario>> scenarios{
        {"hostile names", hostile()},   {"across 180", at180()}, {"North Pole", north},
        {"South Pole", south},          {"no start", timeless},  {"no icebergs", empty},
        {"500 icebergs", fiveHundred()}};
    for (const ExportFormat& row : exportFormats()) {
        if (row.holds.flownOnly || row.holds.painted || (row.holds.gis && ogr2ogrPath().empty()))
            continue;
        const QString id = QString::fromLatin1(row.id.data(), qsizetype(row.id.size()));
        for (const auto& [name, scenario] : scenarios) {
            QTest::addRow("%s, %s", qPrintable(id), name) << id << scenario << ExportOptions{};
            QTest::addRow("%s, %s, path", qPrintable(id), name)
                << id << scenario << ExportOptions{.what = ExportScope::Path, .returnHome = true};
        }
    }
}

/** Checks that a text is well-formed XML with latitudes and longitudes within range. */
inline QString xmlFault(const QByteArray& text)
{
    QXmlStreamReader xml(text);
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement() || !xml.attributes().hasAttribute("lat"_L1))
            continue;
        const double latitude_deg = xml.attributes().value("lat"_L1).toDouble();
        const double longitude_deg = xml.attributes().value("lon"_L1).toDouble();
        if (std::abs(latitude_deg) > 90 || longitude_deg < -180 || longitude_deg >= 180)
            return u"place out of range in line %1"_s.arg(xml.lineNumber());
    }
    return xml.hasError() ? xml.errorString() : QString();
}

inline QString planFault(const QByteArray& text)
{
    const PlanText plan = planText(text);
    for (const std::vector<PlanRule>& rules :
         {qgroundcontrolRules(), mavsdkRules(), missionPlannerRules()})
        for (const PlanRule& rule : rules)
            if (const QString fault = rule.fault(plan); !fault.isEmpty())
                return QLatin1StringView(rule.name) + u": "_s + fault;
    return {};
}

inline QString wplFault(const QByteArray& text)
{
    for (const WplReader& reader : readers())
        if (const WplMission mission = reader.read(text); !mission.fault.isEmpty())
            return reader.name + u": "_s + mission.fault;
    return {};
}

/** Returns what readers of the format would refuse, or an empty text. */
inline QString faultOf(const QString& id, const std::string& text)
{
    const QByteArray file = bytes(text);
    if (id == "plan"_L1)
        return planFault(file);
    if (id == "wpl"_L1)
        return wplFault(file);
    if (id == "geojson"_L1)
        return geojsonFault(file);
    if (id == "gpx"_L1 || id == "kml"_L1)
        return xmlFault(file);
    if (id == "shapefile"_L1)
        return file.startsWith("PK\x03\x04") ? QString() : u"no archive"_s;
    if (id == "gpkg"_L1)
        return file.startsWith("SQLite format 3") ? QString() : u"no GeoPackage"_s;
    if (id == "fgb"_L1)
        return file.startsWith("fgb\x03") ? QString() : u"no FlatGeobuf"_s;
    if (id == "gml"_L1)
        return xmlFault(file);
    if (id == "dxf"_L1)
        return file.trimmed().endsWith("EOF") ? QString() : u"no DXF"_s;
    if (id == "czml"_L1)
        return czmlFault(file);
    if (id == "kmz"_L1) // the shell test unpacks it
        return file.startsWith("PK\x03\x04") ? QString() : u"no zip"_s;
    return file.contains('\0') || !file.endsWith('\n') ? u"no table"_s : QString();
}

/** Returns the first difference of two texts whose numbers may differ by `tolerance`. */
inline QString numbersDifference(const QByteArray& a, const QByteArray& b, double tolerance)
{
    static const QRegularExpression number(u"-?\\d+(\\.\\d+)?"_s);
    const QString left = QString::fromUtf8(a);
    const QString right = QString::fromUtf8(b);
    if (QString(left).replace(number, u"#"_s) != QString(right).replace(number, u"#"_s))
        return u"texts differ"_s;
    QRegularExpressionMatchIterator ours = number.globalMatch(left);
    QRegularExpressionMatchIterator theirs = number.globalMatch(right);
    while (ours.hasNext() && theirs.hasNext()) {
        const QString x = ours.next().captured();
        const QString y = theirs.next().captured();
        if (!near(x.toDouble(), y.toDouble(), tolerance))
            return x + u" and "_s + y;
    }
    return {};
}

} // namespace berg::test
