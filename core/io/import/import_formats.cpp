#include "core/io/import/import_formats.h"

#include "core/base/error.h"
#include "core/base/find_by_id.h"
#include "core/base/translate_noop.h"
#include "core/io/import/fields/import_clock.h"
#include "core/io/import/fields/import_fields.h"
#include "core/io/import/fields/import_xml.h"
#include "core/io/import/import_identity.h"
#include "core/io/import/maps/map_readers.h"
#include "core/io/import/missions/mission_readers.h"
#include "core/io/import/receivers/receiver_readers.h"
#include "core/io/import/shared_ids.h"
#include "core/io/import/tables/table_readers.h"
#include "core/io/import/tables/table_text.h"
#include "core/io/text/json_reader.h"
#include "core/io/text/text_encoding.h"
#include "core/io/text/zip_file.h"
#include "core/scenario/text_checks.h"

#include <algorithm>

namespace berg {

namespace {

// clang-format off
constexpr std::array kFormats{
    ImportFormat{"kml", QT_TRANSLATE_NOOP("ImportWords", "KML (Google Earth)"),
                 "Google Earth and other map programs", true, {}, isKml, readKml},
    ImportFormat{"kmz", QT_TRANSLATE_NOOP("ImportWords", "KMZ (KML, packed)"),
                 "KML in a zip archive", true, {}, isZip, readKml},
    ImportFormat{"czml", QT_TRANSLATE_NOOP("ImportWords", "CZML (Cesium)"),
                 "Cesium: places and tracks", true, {}, isCzml, readCzml},
    ImportFormat{"gpx", QT_TRANSLATE_NOOP("ImportWords", "GPX (waypoints, routes and tracks)"),
                 "GPS devices: waypoints, routes and tracks", false, {}, isGpx, readGpx},
    ImportFormat{"plan", QT_TRANSLATE_NOOP("ImportWords", "QGroundControl plan"),
                 "QGroundControl: places of a mission", false, {}, isPlan, readPlan},
    ImportFormat{"wpl", QT_TRANSLATE_NOOP("ImportWords", "ArduPilot mission (QGC WPL)"),
                 "ArduPilot: places of a mission (QGC WPL)", false, {}, isWpl, readWpl},
    ImportFormat{"nmea", QT_TRANSLATE_NOOP("ImportWords", "Radar and AIS of a ship (NMEA log)"),
                 "NMEA 0183 and AIS: logs of a ship's radar", false, SightingSource::Radar, isNmea,
                 readNmea},
    ImportFormat{"photo", QT_TRANSLATE_NOOP("ImportWords", "Photograph with GPS (JPEG)"),
                 "Photographs with GPS (JPEG with EXIF)", false, SightingSource::Camera, isPhoto,
                 readPhoto},
    ImportFormat{"metno", QT_TRANSLATE_NOOP("ImportWords", "MET Norway (GeoJSON)"),
                 "MET Norway and Copernicus: icebergs seen by radar", true,
                 SightingSource::Satellite, isMetno, readGeoJson},
    ImportFormat{"geojson", QT_TRANSLATE_NOOP("ImportWords", "GeoJSON (QGIS)"),
                 "QGIS and other map programs: points and tracks", true, {}, isGeoJson,
                 readGeoJson},
    ImportFormat{"iip", QT_TRANSLATE_NOOP("ImportWords", "International Ice Patrol (CSV)"),
                 "International Ice Patrol sightings (NSIDC G00807)", false,
                 SightingSource::Aircraft, isIip, readIip},
    ImportFormat{"cis-beacon", QT_TRANSLATE_NOOP("ImportWords", "Canadian Ice Service (CSV)"),
                 "Canadian Ice Service beacons", true, SightingSource::ArgosBeacon, isCisBeacon,
                 readCisBeacon},
    ImportFormat{"usnic", QT_TRANSLATE_NOOP("ImportWords", "US National Ice Center (CSV)"),
                 "US National Ice Center, Antarctic icebergs", true, SightingSource::Aircraft,
                 isUsnic, readUsnic},
    ImportFormat{"csv", QT_TRANSLATE_NOOP("ImportWords", "Any table (CSV)"),
                 "any table with a header", true, {}, isAnyCsv, readAnyCsv}};
// clang-format on

std::string formatIds()
{
    return joined(kFormats, ", ", &ImportFormat::id);
}

const ImportFormat& chosenFormat(std::string_view text, const ReadOptions& options,
                                 ReadBudget& budget)
{
    const std::string& subject = budget.subject();
    if (options.format != "auto") {
        if (const ImportFormat* format = findImportFormat(options.format))
            return *format;
        throw Error(ErrorCode::Unsupported, subject,
                    {IssueId::NoImportFormat, {printable(options.format), formatIds()}});
    }
    // A mapping of columns means that the file is a table, unless it clearly has another format.
    const auto it = std::find_if(kFormats.begin(), kFormats.end(), [&](const ImportFormat& format) {
        return format.matches(text) && (format.namedColumns || options.mapping.empty());
    });
    if (it != kFormats.end())
        return *it;
    if (!options.mapping.empty() || options.headerLine)
        return *findImportFormat("csv");
    if (trimmed(text).starts_with('{'))
        (void)parseJson(text, budget); // throws with the place of the error
    throw Error(ErrorCode::WrongFormat, subject, {IssueId::UnknownFormat, {formatIds()}});
}

/** Returns the reasons of the first rejected rows, for a file without a usable one. */
std::vector<Issue> issuesOf(const Rejections& rejected)
{
    constexpr std::size_t kMostListed = 20;
    std::vector<Issue> issues;
    for (const RejectedRow& row : rejected.first) {
        if (issues.size() == kMostListed)
            break;
        issues.push_back({Severity::Error, placeOf(rejected, row.line), reasonOf(row)});
    }
    return issues;
}

/** Throws if a property is mapped to the place in a format whose geometry determines it. */
void requireFreePlaces(const ImportFormat& format, const ColumnMapping& mapping,
                       const std::string& subject)
{
    if (format.read != readGeoJson && format.read != readCzml)
        return;
    for (const FieldColumn& mapped : mapping)
        if (mapped.field == SightingField::Latitude || mapped.field == SightingField::Longitude)
            throw Error(ErrorCode::InvalidInput, subject,
                        {{Severity::Error,
                          nameOf(kSightingFieldNames, mapped.field),
                          {IssueId::ColumnsFixed, {std::string(format.id)}}}});
}

SightingTable sightingsOf(std::string_view bytes, const ReadOptions& options, ReadBudget& budget)
{
    const std::string& subject = budget.subject();
    const bool isPacked = isZip(bytes);
    if (isPacked && options.format != "auto" && options.format != "kmz" && options.format != "kml")
        throw Error(ErrorCode::WrongFormat, subject,
                    {IssueId::ArchiveWithout, {'.' + options.format}});
    const bool isBinary = isPacked || isPhoto(bytes);
    if (isPhoto(bytes) && options.format != "auto" && options.format != "photo")
        throw Error(ErrorCode::WrongFormat, subject, {IssueId::NotFormat, {options.format}});
    const std::string decoded = isBinary ? std::string() : textOfXml(bytes, subject);
    std::string_view text = decoded.empty() ? bytes : std::string_view(decoded);
    std::optional<std::size_t> linesAbove;
    if (options.headerLine) {
        text = fromLine(text, *options.headerLine);
        linesAbove = *options.headerLine - 1;
        if (trimmed(text).empty())
            throw Error(ErrorCode::InvalidInput, subject,
                        {IssueId::NoSuchLine, {countOf(*options.headerLine)}});
    }
    const ImportFormat& format = chosenFormat(text, options, budget);
    if (!format.namedColumns && !options.mapping.empty())
        throw Error(ErrorCode::InvalidInput, subject,
                    {IssueId::ColumnsFixed, {std::string(format.id)}});
    requireFreePlaces(format, options.mapping, subject);
    const ReadBudget before = budget;
    ImportText source{.text = text,
                      .budget = budget,
                      .mapping = options.mapping,
                      .dates = options.dates,
                      .linesAbove = linesAbove};
    SightingTable table = format.read(source);
    if (!source.dates && table.shownOrder == DateOrder::DayFirst) { // rows were read before
        table = {};
        budget = before;
        source.dates = DateOrder::DayFirst;
        table = format.read(source);
    }
    if (source.dates || table.shownOrder)
        table.guessedDate.clear();
    table.format = format.id;
    table.noted.place = table.rejected.place;
    correctTimes(table);
    if (format.source)
        table.positionSd_m = errorOf(*format.source).sd_m;
    decideIdentity(table, options);
    separateSharedIds(table, budget);
    return table;
}

} // namespace

std::span<const ImportFormat> importFormats()
{
    return kFormats;
}

const ImportFormat* findImportFormat(std::string_view id)
{
    return findById(kFormats, id);
}

SightingTable readSightings(std::string_view bytes, const std::string& subject,
                            const ReadOptions& options, const std::stop_token& stop)
{
    SightingTable table = readSightingRows(bytes, subject, options, stop);
    requireSightings(table, subject);
    return table;
}

SightingTable readSightingRows(std::string_view bytes, const std::string& subject,
                               const ReadOptions& options, const std::stop_token& stop)
{
    ReadBudget budget(subject, bytes.size(), stop);
    return sightingsOf(bytes, options, budget);
}

void requireSightings(const SightingTable& table, const std::string& subject)
{
    if (!table.sightings.empty())
        return;
    if (table.rejected.count > 0)
        throw Error(ErrorCode::InvalidInput, subject, issuesOf(table.rejected));
    throw Error(ErrorCode::InvalidInput, subject, {IssueId::NoSightings});
}

} // namespace berg
