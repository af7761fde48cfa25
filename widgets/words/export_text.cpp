#include "widgets/words/export_text.h"

#include "core/base/error.h"
#include "widgets/words/error_text.h"
#include "widgets/words/issue_text.h"

#include <QCoreApplication>

#include <stdexcept>
#include <string_view>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

struct ExportText
{
    Q_DECLARE_TR_FUNCTIONS(ExportText)
};

QString stringOf(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

ExportFormatText missionText(std::string_view id)
{
    const ExportGroup group = ExportGroup::Autopilots;
    if (id == "plan")
        return {.group = group,
                .name = ExportText::tr("Mission plan"),
                .tool = u"QGroundControl"_s,
                .about = ExportText::tr("Mission items from take-off to landing for the "
                                        "autopilot of the UAV, the geofence and a rally point at "
                                        "home. Also read by Mission Planner and MAVSDK. One file "
                                        "per UAV.")};
    return {.group = group,
            .name = ExportText::tr("Waypoint list"),
            .tool = u"ArduPilot"_s,
            .about = ExportText::tr("Mission items as QGC WPL 110, the first row home, for Mission "
                                    "Planner and MAVProxy. No geofence. One file per UAV.")};
}

ExportFormatText mapText(std::string_view id)
{
    const ExportGroup group = ExportGroup::Maps;
    if (id == "geojson")
        return {.group = group,
                .name = u"GeoJSON"_s,
                .tool = ExportText::tr("QGIS and other map programs"),
                .about = ExportText::tr("Icebergs, UAVs, paths and area as features with their "
                                        "numbers, longitude and latitude of WGS 84.")};
    if (id == "gpx")
        return {.group = group,
                .name = u"GPX"_s,
                .tool = ExportText::tr("Chart plotters, Garmin"),
                .about = ExportText::tr("Icebergs as waypoints, the order as a route, a path or "
                                        "what was flown as a track with times.")};
    if (id == "czml")
        return {.group = group,
                .name = u"CZML"_s,
                .tool = u"Cesium"_s,
                .about = ExportText::tr("UAVs and icebergs moving in time over the globe, with "
                                        "paths, area and asset.")};
    if (id == "shapefile")
        return {.group = group,
                .name = u"Shapefile"_s,
                .tool = ExportText::tr("ArcGIS and other GIS, through ogr2ogr"),
                .about = ExportText::tr("Everything on the map as zipped Shapefiles of points, "
                                        "lines and areas. Needs ogr2ogr (package gdal-bin).")};
    if (id == "gpkg" || id == "fgb")
        return {.group = group,
                .name = id == "gpkg" ? u"GeoPackage"_s : u"FlatGeobuf"_s,
                .tool = ExportText::tr("QGIS and other GIS, through ogr2ogr"),
                .about = ExportText::tr("Everything on the map in one layer. Needs ogr2ogr "
                                        "(package gdal-bin).")};
    if (id == "gml")
        return {.group = group,
                .name = u"GML"_s,
                .tool = ExportText::tr("Other GIS, through ogr2ogr"),
                .about = ExportText::tr("Everything on the map in one layer. Needs ogr2ogr "
                                        "(package gdal-bin).")};
    if (id == "dxf")
        return {.group = group,
                .name = u"DXF"_s,
                .tool = ExportText::tr("CAD programs, through ogr2ogr"),
                .about = ExportText::tr("A drawing in metres: places, lines and outlines in "
                                        "layers, without names and numbers. Needs ogr2ogr "
                                        "(package gdal-bin).")};
    return {.group = group,
            .name = id == "kmz" ? u"KMZ"_s : u"KML"_s,
            .tool = u"Google Earth"_s,
            .about = id == "kmz"
                         ? ExportText::tr("The same as KML, packed into one small file.")
                         : ExportText::tr("Paths in the colours of the UAVs, with times if the "
                                          "scenario has a start; icebergs with their numbers.")};
}

ExportFormatText tableText(std::string_view id)
{
    if (id == "sigma-csv")
        return {.name = ExportText::tr("Uncertainty"),
                .tool = ExportText::tr("Spreadsheets"),
                .about = ExportText::tr("Table with the uncertainty of every iceberg over the "
                                        "time of the flight.")};
    if (id == "decisions-csv")
        return {.name = ExportText::tr("Decisions"),
                .tool = ExportText::tr("Spreadsheets"),
                .about = ExportText::tr("Table with plans, visits and what else happened in the "
                                        "flight.")};
    if (id == "log-html")
        return {.name = ExportText::tr("Flight log"),
                .tool = ExportText::tr("Browsers"),
                .about = ExportText::tr("Page with planned and flown, zeta against prediction, all "
                                        "sightings and deviations.")};
    if (id == "sightings")
        return {.name = ExportText::tr("Sightings"),
                .tool = ExportText::tr("Ice services"),
                .about = ExportText::tr("Table of the sightings of the flight in the columns of "
                                        "the International Ice Patrol.")};
    if (id == "zeta-csv")
        return {.name = ExportText::tr("Zeta"),
                .tool = ExportText::tr("Spreadsheets"),
                .about = ExportText::tr("Table with zeta over the time of the flight.")};
    return {.name = ExportText::tr("Path"),
            .tool = ExportText::tr("Spreadsheets"),
            .about = ExportText::tr("Table of the order with legs, coordinates and arrivals; of a "
                                    "path or what was flown one row for each point.")};
}

QString pageName(std::string_view id)
{
    const QString ending = stringOf(id.substr(id.find('-') + 1)).toUpper();
    return (id.starts_with("map") ? ExportText::tr("Map as %1") : ExportText::tr("Charts as %1"))
        .arg(ending);
}

ExportFormatText pageText(std::string_view id)
{
    const ExportGroup group = ExportGroup::Pages;
    if (id == "brief")
        return {.group = group,
                .name = ExportText::tr("Flight brief"),
                .tool = ExportText::tr("Paper"),
                .about = ExportText::tr("To print and carry: map, order with coordinates, legs and "
                                        "times, wind, warnings; plus a second page if there is an "
                                        "operation volume.")};
    if (id == "log")
        return {.group = group,
                .name = ExportText::tr("Flight log"),
                .tool = ExportText::tr("Paper"),
                .about = ExportText::tr("Two or three pages: planned and flown, map, zeta against "
                                        "prediction, sightings, deviations.")};
    const QString tool = id.ends_with("pdf")   ? ExportText::tr("Paper")
                         : id.ends_with("svg") ? ExportText::tr("Drawing programs")
                                               : ExportText::tr("Documents and messages");
    const QString about = id.starts_with("map")
                              ? ExportText::tr("The map with icebergs, paths and area, light, with "
                                               "scale and legend.")
                              : ExportText::tr("Zeta and the uncertainty of every iceberg over "
                                               "the time of the flight.");
    return {.group = group, .name = pageName(id), .tool = tool, .about = about};
}

} // namespace

QString exportGroupText(ExportGroup group)
{
    switch (group) {
    case ExportGroup::Autopilots:
        return ExportText::tr("Autopilots");
    case ExportGroup::Maps:
        return ExportText::tr("Maps and globes");
    case ExportGroup::Pages:
        return ExportText::tr("Pictures and print");
    case ExportGroup::Tables:
        return ExportText::tr("Tables");
    }
    throw std::logic_error("exportGroupText: unknown group");
}

ExportFormatText exportFormatText(const ExportFormat& format)
{
    if (format.holds.mission)
        return missionText(format.id);
    if (format.holds.painted)
        return pageText(format.id);
    return format.holds.icebergs ? mapText(format.id) : tableText(format.id);
}

ExportEffect effectOf(ExportNoteKind kind)
{
    switch (kind) {
    case ExportNoteKind::OneFileEach:
    case ExportNoteKind::ChoiceNotUsed:
    case ExportNoteKind::NothingToFly:
    case ExportNoteKind::LegsCross:
    case ExportNoteKind::OptionNotUsed:
    case ExportNoteKind::EndsLoitering:
    case ExportNoteKind::FenceOff:
    case ExportNoteKind::HomeRowForOther:
        return ExportEffect::Note;
    case ExportNoteKind::ClimbTooShort:
    case ExportNoteKind::FirstLegFar:
    case ExportNoteKind::EndsCross:
    case ExportNoteKind::ApproachOverLand:
    case ExportNoteKind::ApproachSteep:
    case ExportNoteKind::WaypointsClose:
    case ExportNoteKind::TooManyItems:
    case ExportNoteKind::AirspaceOnTheWay:
    case ExportNoteKind::EnduranceShort:
        return ExportEffect::Check;
    case ExportNoteKind::ReturnAdded:
    case ExportNoteKind::LoiterAsTime:
    case ExportNoteKind::AcceptanceIgnored:
    case ExportNoteKind::FenceAcross180:
    case ExportNoteKind::NoHeights:
    case ExportNoteKind::PathAsWaypoints:
    case ExportNoteKind::AcceptanceCut:
    case ExportNoteKind::LoiterInSteps:
    case ExportNoteKind::WholeSpeed:
    case ExportNoteKind::ShapefileNames:
        return ExportEffect::Changed;
    case ExportNoteKind::NoTimes:
    case ExportNoteKind::NoFence:
    case ExportNoteKind::NoNoFly:
    case ExportNoteKind::VisitsOnly:
    case ExportNoteKind::LaterSorties:
    case ExportNoteKind::NoTakeOffItem:
    case ExportNoteKind::NoLoiterTurns:
    case ExportNoteKind::LineTimesLeft:
    case ExportNoteKind::DrawingOnly:
        return ExportEffect::LeftOut;
    }
    throw std::logic_error("effectOf: unknown kind");
}

QString exportEffectText(ExportEffect effect)
{
    switch (effect) {
    case ExportEffect::Check:
        return ExportText::tr("Check before the flight");
    case ExportEffect::Note:
        return ExportText::tr("Good to know");
    case ExportEffect::Changed:
        return ExportText::tr("Changed");
    case ExportEffect::LeftOut:
        return ExportText::tr("Left out");
    }
    throw std::logic_error("exportEffectText: unknown effect");
}

QString exportNoteText(const ExportNote& note, const QLocale& locale)
{
    std::vector<IssueArgument> arguments = noteArguments(note);
    if (note.kind == ExportNoteKind::OptionNotUsed)
        arguments = {FieldPath{"export." + std::string(note.tool)}};
    return coreText(notePattern(note.kind), arguments, locale);
}

QString exportRefusalText(const Error& error)
{
    const QStringList lines = optionIssueLines(error, "export");
    return lines.empty() ? errorReport(error) : lines.join(u'\n');
}

} // namespace berg
