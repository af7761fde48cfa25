#include "core/io/import/import_formats.h"

#include "core/base/error.h"
#include "core/base/find_by_id.h"
#include "core/io/import/import_fields.h"
#include "core/io/import/import_readers.h"
#include "core/io/text/json_reader.h"
#include "core/io/text/zip_file.h"
#include "core/scenario/checks.h"

#include <algorithm>

namespace berg {

namespace {

constexpr std::array kFormats{
    ImportFormat{"kml", "Google Earth and other map programs", true, kGps_m, isKml, readKml},
    ImportFormat{"kmz", "the same, packed", true, kGps_m, isZip, readKml},
    ImportFormat{"czml", "Cesium: places and tracks", true, kGps_m, isCzml, readCzml},
    ImportFormat{"gpx", "satellite navigation: waypoints, routes and tracks", false, kGps_m, isGpx,
                 readGpx},
    ImportFormat{"plan", "QGroundControl: the places of a mission", false, kGps_m, isPlan,
                 readPlan},
    ImportFormat{"wpl", "ArduPilot: the places of a mission (QGC WPL)", false, kGps_m, isWpl,
                 readWpl},
    ImportFormat{"metno", "MET Norway and Copernicus: icebergs seen by radar", true, kRadar_m,
                 isMetno, readGeoJson},
    ImportFormat{"geojson", "QGIS and other map programs: points and tracks", true, kGps_m,
                 isGeoJson, readGeoJson},
    ImportFormat{"iip", "International Ice Patrol sightings (NSIDC G00807)", false, kAircraft_m,
                 isIip, readIip},
    ImportFormat{"cis-beacon", "Canadian Ice Service beacons", true, kArgos_m, isCisBeacon,
                 readCisBeacon},
    ImportFormat{"usnic", "US National Ice Center, Antarctic icebergs", true, kAircraft_m, isUsnic,
                 readUsnic},
    ImportFormat{"csv", "any table with a header", true, kGps_m, isAnyCsv, readAnyCsv}};

std::string formatIds()
{
    return joined(kFormats, ", ", &ImportFormat::id);
}

/** What is not text is told apart as far as it helps the user. */
void requireText(std::string_view bytes, const std::string& subject)
{
    const auto fail = [&](IssueId reason) {
        throw Error(ErrorCode::WrongFormat, subject, {reason});
    };
    if (trimmed(bytes).empty())
        fail(IssueId::FileEmpty);
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
        fail(IssueId::Utf16);
    if (bytes.find('\0') != std::string_view::npos)
        fail(IssueId::NotText);
}

std::string utf8FromLatin1(std::string_view bytes)
{
    std::string text;
    text.reserve(bytes.size() + bytes.size() / 8);
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80U) {
            text += c;
        } else {
            text += static_cast<char>(0xC0U | (byte >> 6U));
            text += static_cast<char>(0x80U | (byte & 0x3FU));
        }
    }
    return text;
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
    // Whoever names columns says that it is a table, unless it is plainly something else.
    const auto it = std::find_if(kFormats.begin(), kFormats.end(), [&](const ImportFormat& format) {
        return format.matches(text) && (format.namedColumns || options.mapping.empty());
    });
    if (it != kFormats.end())
        return *it;
    if (!options.mapping.empty())
        return *findImportFormat("csv");
    if (trimmed(text).starts_with('{'))
        (void)parseJson(text, budget); // what is broken says where
    throw Error(ErrorCode::WrongFormat, subject, {IssueId::UnknownFormat, {formatIds()}});
}

/** Reasons of the first rejected rows, for a file without a usable one. */
std::vector<Issue> issuesOf(const Rejections& rejected)
{
    constexpr std::size_t kMostTold = 20;
    std::vector<Issue> issues;
    for (const RejectedRow& row : rejected.first) {
        if (issues.size() == kMostTold)
            break;
        issues.push_back({Severity::Error, placeOf(rejected, row.line), reasonOf(row)});
    }
    return issues;
}

/** Where the place is that of a geometry, no property can be. */
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
    if (isZip(bytes)) {
        const bool isAny = options.format == "auto" || options.format == "kmz";
        ReadOptions inside = options;
        inside.format = isAny ? "kml" : options.format;
        const std::string text = unzipped(bytes, ".kml", budget);
        if (isZip(text)) // some archives hold themselves
            throw Error(ErrorCode::WrongFormat, subject, {IssueId::ArchiveInArchive});
        SightingTable table = sightingsOf(text, inside, budget);
        table.format = isAny ? "kmz" : table.format;
        return table;
    }
    std::string decoded = textOfBytes(bytes, subject);
    if (isKml(bytes) || isGpx(bytes)) // which say themselves what they are written in
        decoded.clear();
    const std::string_view text = decoded.empty() ? bytes : std::string_view(decoded);
    const ImportFormat& format = chosenFormat(text, options, budget);
    if (!format.namedColumns && !options.mapping.empty())
        throw Error(ErrorCode::InvalidInput, subject,
                    {IssueId::ColumnsFixed, {std::string(format.id)}});
    requireFreePlaces(format, options.mapping, subject);
    const ReadBudget before = budget;
    ImportText source{
        .text = text, .budget = budget, .mapping = options.mapping, .dates = options.dates};
    SightingTable table = format.read(source);
    if (!source.dates && table.toldDates == DateOrder::DayFirst) { // told too late for the first
        table = {};
        budget = before;
        source.dates = DateOrder::DayFirst;
        table = format.read(source);
    }
    if (source.dates || table.toldDates)
        table.guessedDate.clear();
    table.format = format.id;
    table.positionSd_m = format.positionSd_m;
    return table;
}

} // namespace

std::string textOfBytes(std::string_view bytes, const std::string& subject)
{
    requireText(bytes, subject);
    return isUtf8(bytes) ? std::string() : utf8FromLatin1(bytes);
}

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
