#include "core/io/export/formats.h"

#include "core/base/find_by_id.h"
#include "core/base/translate_noop.h"
#include "core/io/export/export_files.h"
#include "core/io/export/flight_log.h"
#include "core/io/export/maps/map_writers.h"
#include "core/io/export/missions/plan_csv.h"
#include "core/io/export/missions/plan_qgc.h"
#include "core/io/export/missions/plan_wpl.h"
#include "core/io/export/sightings_csv.h"
#include "core/io/results/result_csv.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace berg {

namespace {

void csvPieces(const ExportContent& content, const TextSink& put)
{
    if (content.what == ExportScope::Path || content.what == ExportScope::Track)
        writeTrackCsv(content, put);
    else
        put(planCsv(content));
}

/** Writes a table of a flight. */
template <void (*Write)(const Mission&, const TextSink&)>
void flightPieces(const ExportContent& content, const TextSink& put)
{
    if (content.mission == nullptr)
        throw Error(ErrorCode::InvalidInput, "format", {IssueId::NothingFlown});
    Write(*content.mission, put);
}

/** Writes a text that is never long. */
template <std::string (*Text)(const ExportContent&)>
void putText(const ExportContent& content, const TextSink& put)
{
    put(Text(content));
}

constexpr SampleTable kSigmaTable{
    &SampleTables::sigmaHeader,
    [](const SampleTables& tables, std::string& text, const Sample& sample,
       std::span<const IcebergSample> icebergs) { tables.addSigma(text, sample, icebergs); }};
constexpr SampleTable kZetaTable{
    &SampleTables::zetaHeader,
    [](const SampleTables& tables, std::string& text, const Sample& sample,
       std::span<const IcebergSample> /*icebergs*/) { tables.addZeta(text, sample); }};

constexpr ExportCapabilities kMissionHolds{
    .order = true, .mission = true, .radii = true, .altitude = true, .airspeed = true};
constexpr ExportCapabilities kMapHolds{.order = true,
                                       .path = true,
                                       .fleet = true,
                                       .times = true,
                                       .icebergs = true,
                                       .fence = true,
                                       .altitude = true,
                                       .airspeed = true,
                                       .legHome = true};
constexpr ExportCapabilities kGisHolds{.order = true,
                                       .path = true,
                                       .fleet = true,
                                       .times = true,
                                       .icebergs = true,
                                       .fence = true,
                                       .altitude = true,
                                       .airspeed = true,
                                       .legHome = true,
                                       .gis = true};
constexpr ExportCapabilities kDrawingHolds{.order = true,
                                           .path = true,
                                           .fleet = true,
                                           .icebergs = true,
                                           .fence = true,
                                           .legHome = true,
                                           .gis = true};
constexpr ExportCapabilities kFlightTableHolds{.fleet = true, .flownOnly = true};
constexpr ExportCapabilities kPictureHolds{.order = true,
                                           .path = true,
                                           .fleet = true,
                                           .icebergs = true,
                                           .fence = true,
                                           .airspeed = true, // the wind dial depends on it
                                           .legHome = true,
                                           .painted = true};
constexpr ExportCapabilities kBriefHolds{.order = true,
                                         .path = true,
                                         .fleet = true,
                                         .times = true,
                                         .icebergs = true,
                                         .fence = true,
                                         .radii = true,
                                         .altitude = true,
                                         .airspeed = true,
                                         .legHome = true,
                                         .painted = true};
constexpr ExportCapabilities kChartsHold{.fleet = true, .flownOnly = true, .painted = true};

constexpr const char* kOneLayerAbout = QT_TRANSLATE_NOOP(
    "ExportText", "Everything on the map in one layer. Needs ogr2ogr (package gdal-bin).");
constexpr const char* kMapAbout = QT_TRANSLATE_NOOP(
    "ExportText", "The map with icebergs, paths and area, light, with scale and legend.");
constexpr const char* kChartsAbout = QT_TRANSLATE_NOOP(
    "ExportText", "Zeta and the uncertainty of every iceberg over the time of the flight.");
// clang-format off
constexpr std::array kFormats{
    ExportFormat{"plan", "plan", "QGroundControl, Mission Planner, MAVSDK",
                 {.order = true, .fence = true, .mission = true, .radii = true, .altitude = true,
                  .airspeed = true}, putText<qgcPlan>, nullptr,
                 {ExportGroup::Autopilots, QT_TRANSLATE_NOOP("ExportText", "Mission plan"),
                  "QGroundControl",
                  QT_TRANSLATE_NOOP("ExportText", "Mission items from take-off to landing for "
                                      "the autopilot of the UAV, the geofence and a rally point "
                                      "at home. Also read by Mission Planner and MAVSDK. One "
                                      "file per UAV.")}},
    ExportFormat{"wpl", "waypoints", "ArduPilot: Mission Planner, MAVProxy (home row)",
                 kMissionHolds, putText<wplText>, nullptr,
                 {ExportGroup::Autopilots, QT_TRANSLATE_NOOP("ExportText", "Waypoint list"),
                  "ArduPilot",
                  QT_TRANSLATE_NOOP("ExportText", "Mission items as QGC WPL 110, the first row "
                                      "home, for Mission Planner and MAVProxy. No geofence. One "
                                      "file per UAV.")}},
    ExportFormat{"geojson", "geojson", "QGIS and other map programs", kMapHolds, writeGeoJson,
                 nullptr,
                 {ExportGroup::Maps, "GeoJSON",
                  QT_TRANSLATE_NOOP("ExportText", "QGIS and other map programs"),
                  QT_TRANSLATE_NOOP("ExportText", "Icebergs, UAVs, paths and area as features "
                                      "with their numbers, longitude and latitude of WGS 84.")}},
    ExportFormat{"csv", "csv", "spreadsheets and scripts",
                 {.order = true, .path = true, .fleet = true}, csvPieces, nullptr,
                 {ExportGroup::Tables, QT_TRANSLATE_NOOP("ExportText", "Path"),
                  QT_TRANSLATE_NOOP("ExportText", "Spreadsheets"),
                  QT_TRANSLATE_NOOP("ExportText", "Table of the order with legs, coordinates and "
                                      "arrivals; of a path or what was flown one row for each "
                                      "point.")}},
    ExportFormat{"sigma-csv", "csv", "spreadsheets: sigma of every iceberg over time",
                 kFlightTableHolds, flightPieces<writeSigma>, &kSigmaTable,
                 {ExportGroup::Tables, QT_TRANSLATE_NOOP("ExportText", "Uncertainty"),
                  QT_TRANSLATE_NOOP("ExportText", "Spreadsheets"),
                  QT_TRANSLATE_NOOP("ExportText", "Table with the uncertainty of every iceberg "
                                      "over the time of the flight.")}},
    ExportFormat{"decisions-csv", "csv", "spreadsheets: plans, visits and other events",
                 kFlightTableHolds, flightPieces<writeEvents>, nullptr,
                 {ExportGroup::Tables, QT_TRANSLATE_NOOP("ExportText", "Decisions"),
                  QT_TRANSLATE_NOOP("ExportText", "Spreadsheets"),
                  QT_TRANSLATE_NOOP("ExportText", "Table with plans, visits and what else "
                                      "happened in the flight.")}},
    ExportFormat{"zeta-csv", "csv", "spreadsheets: zeta over time", kFlightTableHolds,
                 flightPieces<writeZeta>, &kZetaTable,
                 {ExportGroup::Tables, QT_TRANSLATE_NOOP("ExportText", "Zeta"),
                  QT_TRANSLATE_NOOP("ExportText", "Spreadsheets"),
                  QT_TRANSLATE_NOOP("ExportText", "Table with zeta over the time of the flight.")}},
    ExportFormat{"sightings", "csv", "ice services: sightings in the columns of the Ice Patrol",
                 kFlightTableHolds, writeSightings, nullptr,
                 {ExportGroup::Tables, QT_TRANSLATE_NOOP("ExportText", "Sightings"),
                  QT_TRANSLATE_NOOP("ExportText", "Ice services"),
                  QT_TRANSLATE_NOOP("ExportText", "Table of the sightings of the flight in the "
                                      "columns of the International Ice Patrol.")}},
    ExportFormat{"gpx", "gpx", "chart plotters, Garmin devices, GPSBabel",
                 {.order = true, .path = true, .fleet = true, .times = true, .icebergs = true,
                  .altitude = true, .airspeed = true, .legHome = true}, writeGpx, nullptr,
                 {ExportGroup::Maps, "GPX",
                  QT_TRANSLATE_NOOP("ExportText", "Chart plotters, Garmin"),
                  QT_TRANSLATE_NOOP("ExportText", "Icebergs as waypoints, the order as a route, "
                                      "a path or what was flown as a track with times.")}},
    ExportFormat{"kml", "kml", "Google Earth and other globes", kMapHolds, writeKml, nullptr,
                 {ExportGroup::Maps, "KML", "Google Earth",
                  QT_TRANSLATE_NOOP("ExportText", "Paths in the colours of the UAVs, with times "
                                      "if the scenario has a start; icebergs with their "
                                      "numbers.")}},
    ExportFormat{"kmz", "kmz", "Google Earth, packed", kMapHolds, writeKmz, nullptr,
                 {ExportGroup::Maps, "KMZ", "Google Earth",
                  QT_TRANSLATE_NOOP("ExportText", "The same as KML, packed into one small file.")}},
    ExportFormat{"czml", "czml", "Cesium", kMapHolds, writeCzml, nullptr,
                 {ExportGroup::Maps, "CZML", "Cesium",
                  QT_TRANSLATE_NOOP("ExportText", "UAVs and icebergs moving in time over the "
                                      "globe, with paths, area and asset.")}},
    ExportFormat{"shapefile", "zip", "ArcGIS and other GIS programs: zipped Shapefiles", kGisHolds,
                 writeShapefiles, nullptr,
                 {ExportGroup::Maps, "Shapefile",
                  QT_TRANSLATE_NOOP("ExportText", "ArcGIS and other GIS"),
                  QT_TRANSLATE_NOOP("ExportText", "Everything on the map as zipped Shapefiles of "
                                      "points, lines and areas. Needs ogr2ogr (package "
                                      "gdal-bin).")}},
    ExportFormat{"gpkg", "gpkg", "QGIS and other GIS programs: GeoPackage", kGisHolds,
                 writeGeoPackage, nullptr,
                 {ExportGroup::Maps, "GeoPackage",
                  QT_TRANSLATE_NOOP("ExportText", "QGIS and other GIS"),
                  kOneLayerAbout}},
    ExportFormat{"gml", "gml", "GIS programs: GML 3.2", kGisHolds, writeGml, nullptr,
                 {ExportGroup::Maps, "GML",
                  QT_TRANSLATE_NOOP("ExportText", "Other GIS"),
                  kOneLayerAbout}},
    ExportFormat{"dxf", "dxf", "CAD programs: outlines and places in metres", kDrawingHolds,
                 writeDxf, nullptr,
                 {ExportGroup::Maps, "DXF",
                  QT_TRANSLATE_NOOP("ExportText", "CAD programs"),
                  QT_TRANSLATE_NOOP("ExportText", "A drawing in metres: places, lines and outlines "
                                      "in layers, without names and numbers. Needs ogr2ogr "
                                      "(package gdal-bin).")}},
    ExportFormat{"fgb", "fgb", "web maps and GIS programs: FlatGeobuf", kGisHolds,
                 writeFlatGeobuf, nullptr,
                 {ExportGroup::Maps, "FlatGeobuf",
                  QT_TRANSLATE_NOOP("ExportText", "QGIS and other GIS"),
                  kOneLayerAbout}},
    ExportFormat{"brief", "pdf", "paper: flight brief on one page", kBriefHolds, nullptr, nullptr,
                 {ExportGroup::Pages, QT_TRANSLATE_NOOP("ExportText", "Flight brief"),
                  QT_TRANSLATE_NOOP("ExportText", "Paper"),
                  QT_TRANSLATE_NOOP("ExportText", "To print and carry: map, order with "
                                      "coordinates, legs and times, wind, warnings; plus a "
                                      "second page if there is an operation volume.")}},
    ExportFormat{"map-pdf", "pdf", "paper: the map", kPictureHolds, nullptr, nullptr,
                 {ExportGroup::Pages, QT_TRANSLATE_NOOP("ExportText", "Map as %1"),
                  QT_TRANSLATE_NOOP("ExportText", "Paper"),
                  kMapAbout}},
    ExportFormat{"map-svg", "svg", "drawing programs: the map", kPictureHolds, nullptr, nullptr,
                 {ExportGroup::Pages, QT_TRANSLATE_NOOP("ExportText", "Map as %1"),
                  QT_TRANSLATE_NOOP("ExportText", "Drawing programs"),
                  kMapAbout}},
    ExportFormat{"map-png", "png", "documents and messages: the map", kPictureHolds, nullptr,
                 nullptr,
                 {ExportGroup::Pages, QT_TRANSLATE_NOOP("ExportText", "Map as %1"),
                  QT_TRANSLATE_NOOP("ExportText", "Documents and messages"),
                  kMapAbout}},
    ExportFormat{"log", "pdf", "paper: log of a flight",
                 {.fleet = true, .flownOnly = true, .painted = true, .predicted = true}, nullptr,
                  nullptr,
                 {ExportGroup::Pages, QT_TRANSLATE_NOOP("ExportText", "Flight log"),
                  QT_TRANSLATE_NOOP("ExportText", "Paper"),
                  QT_TRANSLATE_NOOP("ExportText", "Two or three pages: planned and flown, map, "
                                      "zeta against prediction, sightings, deviations.")}},
    ExportFormat{"log-html", "html", "browsers: log of a flight",
                 {.fleet = true, .flownOnly = true, .predicted = true}, putText<flightLogHtml>,
                  nullptr,
                 {ExportGroup::Tables, QT_TRANSLATE_NOOP("ExportText", "Flight log"),
                  QT_TRANSLATE_NOOP("ExportText", "Browsers"),
                  QT_TRANSLATE_NOOP("ExportText", "Page with planned and flown, zeta against "
                                      "prediction, all sightings and deviations.")}},
    ExportFormat{"charts-pdf", "pdf", "paper: zeta and sigma over time", kChartsHold, nullptr,
                 nullptr,
                 {ExportGroup::Pages, QT_TRANSLATE_NOOP("ExportText", "Charts as %1"),
                  QT_TRANSLATE_NOOP("ExportText", "Paper"),
                  kChartsAbout}},
    ExportFormat{"charts-svg", "svg", "drawing programs: zeta and sigma over time", kChartsHold,
                 nullptr, nullptr,
                 {ExportGroup::Pages, QT_TRANSLATE_NOOP("ExportText", "Charts as %1"),
                  QT_TRANSLATE_NOOP("ExportText", "Drawing programs"),
                  kChartsAbout}},
    ExportFormat{"charts-png", "png", "documents and messages: zeta and sigma over time",
                 kChartsHold, nullptr, nullptr,
                 {ExportGroup::Pages, QT_TRANSLATE_NOOP("ExportText", "Charts as %1"),
                  QT_TRANSLATE_NOOP("ExportText", "Documents and messages"),
                  kChartsAbout}}};
// clang-format on

/** Returns true if a mission would end otherwise without the choice of a return. */
bool changesTheEnd(const ExportContent& content)
{
    const bool isFirstLeg = content.what == ExportScope::FirstLeg;
    const auto loiters = [](const ExportUav& uav) {
        return uav.uav.aircraft.end == MissionEnd::Loiter;
    };
    return content.options.returnHome.value_or(true)
               ? isFirstLeg || std::ranges::any_of(content.uavs, loiters)
               : !isFirstLeg;
}

} // namespace

bool ExportCapabilities::dependsOn(ExportOption option, const ExportContent& content) const
{
    const bool isPath = content.what == ExportScope::Path;
    const bool isTrack = content.what == ExportScope::Track;
    const bool hasCircles = std::ranges::any_of(content.uavs, [](const ExportUav& uav) {
        return uav.uav.aircraft.airframe == Airframe::FixedWing;
    });
    const bool drawsVolume = content.operation && fence && !mission;
    if (flownOnly)
        return false;
    switch (option) {
    case ExportOption::Uav:
        return true;
    case ExportOption::Altitude: // a path avoids areas that are closed at its altitude
        return altitude || drawsVolume ||
               (isPath && std::ranges::any_of(closedAreas(content), hasHeights));
    case ExportOption::Airspeed:
        return airspeed || drawsVolume || !isTrack;
    case ExportOption::Acceptance:
        return radii && (!mission || isPath || !hasCircles || content.options.loiterTurns == 0);
    case ExportOption::Loiter:
        return radii && (!mission || (!isPath && hasCircles));
    case ExportOption::ReturnHome:
        if (mission && !isPath)
            return changesTheEnd(content);
        return !isTrack && (isPath || legHome);
    }
    throw std::logic_error("dependsOn: unknown option");
}

std::string ExportFormat::text(const ExportContent& content) const
{
    std::string text;
    put(content, [&text](std::string_view piece) { text += piece; });
    return text;
}

ExportContent ExportFormat::content(const ExportSource& source, const ExportOptions& options) const
{
    if (!holds.flownOnly)
        return exportContent(source, options);
    checkExportOptions(source, options);
    ExportContent whole = exportContent(source);
    whole.options = options; // for the notes about unused options
    return whole;
}

std::string ExportFormat::write(const ExportSource& source, const ExportOptions& options) const
{
    const ExportContent written = content(source, options);
    if (fileCount(*this, written) > 1)
        throw Error(ErrorCode::InvalidInput, "uav", {IssueId::OneUavOnly, {std::string(id)}});
    return exportFiles(*this, written, "").front().content;
}

std::span<const ExportFormat> exportFormats()
{
    return kFormats;
}

const ExportFormat* findExportFormat(std::string_view id)
{
    return findById(kFormats, id);
}

} // namespace berg
