#include "core/io/export/formats.h"

#include "core/base/find_by_id.h"
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

constexpr std::array kFormats{
    ExportFormat{"plan",
                 "plan",
                 "QGroundControl, Mission Planner, MAVSDK",
                 {.order = true,
                  .fence = true,
                  .mission = true,
                  .radii = true,
                  .altitude = true,
                  .airspeed = true},
                 putText<qgcPlan>},
    ExportFormat{"wpl", "waypoints", "ArduPilot: Mission Planner, MAVProxy (home row)",
                 kMissionHolds, putText<wplText>},
    ExportFormat{"geojson", "geojson", "QGIS and other map programs", kMapHolds, writeGeoJson},
    ExportFormat{"csv",
                 "csv",
                 "spreadsheets and scripts",
                 {.order = true, .path = true, .fleet = true},
                 csvPieces},
    ExportFormat{"sigma-csv", "csv", "spreadsheets: sigma of every iceberg over time",
                 kFlightTableHolds, flightPieces<writeSigma>, &kSigmaTable},
    ExportFormat{"decisions-csv", "csv", "spreadsheets: plans, visits and other events",
                 kFlightTableHolds, flightPieces<writeEvents>},
    ExportFormat{"zeta-csv", "csv", "spreadsheets: zeta over time", kFlightTableHolds,
                 flightPieces<writeZeta>, &kZetaTable},
    ExportFormat{"sightings", "csv", "ice services: sightings in the columns of the Ice Patrol",
                 kFlightTableHolds, writeSightings},
    ExportFormat{"gpx",
                 "gpx",
                 "chart plotters, Garmin devices, GPSBabel",
                 {.order = true,
                  .path = true,
                  .fleet = true,
                  .times = true,
                  .icebergs = true,
                  .altitude = true,
                  .airspeed = true,
                  .legHome = true},
                 writeGpx},
    ExportFormat{"kml", "kml", "Google Earth and other globes", kMapHolds, writeKml},
    ExportFormat{"kmz", "kmz", "Google Earth, packed", kMapHolds, writeKmz},
    ExportFormat{"czml", "czml", "Cesium", kMapHolds, writeCzml},
    ExportFormat{"shapefile", "zip", "ArcGIS and other GIS programs: zipped Shapefiles", kGisHolds,
                 writeShapefiles},
    ExportFormat{"gpkg", "gpkg", "QGIS and other GIS programs: GeoPackage", kGisHolds,
                 writeGeoPackage},
    ExportFormat{"gml", "gml", "GIS programs: GML 3.2", kGisHolds, writeGml},
    ExportFormat{"dxf", "dxf", "CAD programs: outlines and places in metres", kDrawingHolds,
                 writeDxf},
    ExportFormat{"fgb", "fgb", "web maps and GIS programs: FlatGeobuf", kGisHolds, writeFlatGeobuf},
    ExportFormat{"brief", "pdf", "paper: flight brief on one page", kBriefHolds},
    ExportFormat{"map-pdf", "pdf", "paper: the map", kPictureHolds},
    ExportFormat{"map-svg", "svg", "drawing programs: the map", kPictureHolds},
    ExportFormat{"map-png", "png", "documents and messages: the map", kPictureHolds},
    ExportFormat{"log",
                 "pdf",
                 "paper: log of a flight",
                 {.fleet = true, .flownOnly = true, .painted = true, .predicted = true}},
    ExportFormat{"log-html",
                 "html",
                 "browsers: log of a flight",
                 {.fleet = true, .flownOnly = true, .predicted = true},
                 putText<flightLogHtml>},
    ExportFormat{"charts-pdf", "pdf", "paper: zeta and sigma over time", kChartsHold},
    ExportFormat{"charts-svg", "svg", "drawing programs: zeta and sigma over time", kChartsHold},
    ExportFormat{"charts-png", "png", "documents and messages: zeta and sigma over time",
                 kChartsHold}};

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
