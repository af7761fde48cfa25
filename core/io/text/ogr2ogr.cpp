#include "core/io/text/ogr2ogr.h"

#include "core/base/error.h"
#include "core/io/text/atomic_file.h"
#include "core/io/text/read_budget.h"
#include "core/io/text/stop_scope.h"
#include "core/io/text/zip_file.h"
#include "core/scenario/text_checks.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <initializer_list>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace berg {

namespace {

namespace fs = std::filesystem;

/** Drivers that read from networks or databases, or follow names of other files in a file. */
constexpr const char* kSkippedDrivers =
    "OGR_SKIP=OGR_VRT,SQLite,ODBC,PGeo,MSSQLSpatial,OGR_OGDI,PostgreSQL,MySQL,OCI,HANA,PGDUMP,WFS,"
    "OAPIF,OGCAPI,EEDA,HTTP,Elasticsearch,Carto,AmigoCloud,PLSCENES,CSW,NGW,GMLAS,GPSBabel,"
    "MongoDBv3,DODS,TIGER,PDF,GeoRSS,MBTiles,MVT,netCDF";

/** Endings of formats, each with those of the files that belong to it. */
struct GisEnding
{
    std::string_view ending;
    std::initializer_list<std::string_view> others = {};
};
const std::array<GisEnding, 13>& gisEndings()
{
    static const std::array<GisEnding, 13> kEndings{{{"shp", {"shx", "dbf", "prj", "cpg"}},
                                                     {"gpkg"},
                                                     {"gml", {"xsd", "gfs"}},
                                                     {"dxf"},
                                                     {"fgb"},
                                                     {"tab", {"dat", "map", "id", "ind"}},
                                                     {"mif", {"mid"}},
                                                     {"e00"},
                                                     {"000"}, // S-57
                                                     {"dgn"},
                                                     {"gmt"},
                                                     {"jml"},
                                                     {"shz"}}};
    return kEndings;
}

std::string lowerEnding(std::string_view name)
{
    const std::size_t dot = name.rfind('.');
    std::string ending(dot == std::string_view::npos ? std::string_view() : name.substr(dot + 1));
    for (char& c : ending)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

const GisEnding* gisEndingOf(std::string_view name)
{
    const auto it = std::ranges::find(gisEndings(), lowerEnding(name), &GisEnding::ending);
    return it == gisEndings().end() ? nullptr : &*it;
}

/** A new folder that is removed with its content. */
class ScratchFolder
{
public:
    explicit ScratchFolder(const std::string& subject)
    {
        std::error_code error;
        std::string name = (fs::temp_directory_path(error) / "bergwatch-gis-XXXXXX").string();
        if (error || mkdtemp(name.data()) == nullptr)
            throw Error(ErrorCode::FileUnreadable, subject, std::generic_category().message(errno));
        m_path = name;
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder()
    {
        std::error_code ignored;
        fs::remove_all(m_path, ignored);
    }

    [[nodiscard]] const fs::path& path() const { return m_path; }

private:
    fs::path m_path;
};

std::vector<std::string> environmentFor(const fs::path& folder)
{
    std::vector<std::string> environment{
        "PATH=/usr/bin:/bin",
        "LANG=C.UTF-8",
        "LC_ALL=C.UTF-8",
        "HOME=" + folder.string(),
        "TMPDIR=" + folder.string(),
        "CPL_TMPDIR=" + folder.string(),
        kSkippedDrivers,
        "PROJ_NETWORK=OFF",
        "CPL_VSIL_CURL_ALLOWED_EXTENSIONS=.none",
        "GDAL_HTTP_TIMEOUT=1",
        "GML_SKIP_RESOLVE_ELEMS=ALL",
        "GML_DOWNLOAD_SCHEMA=NO",
        "GDAL_PAM_ENABLED=NO",
        "OGR_CURRENT_DATE=2000-01-01T00:00:00.000Z", // equal contents give equal files
        "GDAL_NUM_THREADS=1"};
    for (const char* name : {"GDAL_DATA", "PROJ_LIB", "PROJ_DATA", "LD_LIBRARY_PATH"})
        // NOLINTNEXTLINE(concurrency-mt-unsafe): nothing here sets the environment
        if (const char* const value = std::getenv(name); value != nullptr && *value != 0)
            environment.push_back(std::string(name) + '=' + value);
    return environment;
}

/** Returns the last lines that say something, without the names of our folder. */
std::string lastLines(const std::string& errors, const fs::path& folder, std::string_view named)
{
    constexpr std::size_t kMostLines = 4;
    constexpr std::size_t kLongest = 400;
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < errors.size();) {
        const std::size_t end = std::min(errors.find('\n', at), errors.size());
        std::string line = errors.substr(at, end - at);
        at = end + 1;
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first == std::string::npos || line.starts_with("FAILURE") ||
            line.starts_with("Warning") || line.find("-> `") != std::string::npos)
            continue; // lists of all drivers
        lines.push_back(line.substr(first));
    }
    std::string text;
    const std::size_t skipped = lines.size() - std::min(lines.size(), kMostLines);
    for (std::size_t i = skipped; i < lines.size(); ++i)
        text += (text.empty() ? "" : "; ") + lines[i];
    const std::string own = folder.string() + '/';
    for (std::size_t at = text.find(own); at != std::string::npos; at = text.find(own, at))
        text.replace(at, own.size(), named);
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20U || c == 0x7F)
            c = ' ';
    if (text.size() > kLongest)
        text.erase(0, text.size() - kLongest);
    while (!text.empty() && (static_cast<unsigned char>(text.front()) & 0xC0U) == 0x80U)
        text.erase(0, 1); // a character that was cut
    return isUtf8(text) ? text : std::string();
}

/** Runs ogr2ogr in the folder; failures are errors of this code. */
class Ogr2ogrRun
{
public:
    Ogr2ogrRun(const fs::path& folder, std::string subject, ErrorCode code,
               const ChildLimits& limits)
        : m_folder(folder)
        , m_program(ogr2ogrPath())
        , m_subject(std::move(subject))
        , m_code(code)
        , m_limits(limits)
    {
        if (m_program.empty())
            throw Error(ErrorCode::Unsupported, m_subject, {missing()});
    }

    /** Returns the standard output. */
    [[nodiscard]] std::string output(std::vector<std::string> arguments,
                                     const std::stop_token& stop = {}) const
    {
        ChildResult result = run(std::move(arguments), stop);
        using End = ChildResult::End;
        if (result.end == End::TooMuchOutput)
            failTooLarge(m_subject, IssueId::FileTooLarge, m_limits.output >> 20U);
        if (result.end == End::TooSlow)
            fail({IssueId::GisTooSlow,
                  {static_cast<std::int64_t>(
                      std::chrono::ceil<std::chrono::seconds>(m_limits.wall).count())}});
        const std::string lines = lastLines(result.errors, m_folder, "");
        const bool isDone = result.end == End::Exited && result.code == 0;
        // It ends with 0 after reading half of a damaged file.
        const bool hasErrors = result.errors.find("ERROR ") != std::string::npos;
        if (isDone && !hasErrors)
            return std::move(result.output);
        if (result.end == End::Exited && result.code == 127 && lines.empty())
            throw Error(ErrorCode::Unsupported, m_subject, {missing()});
        if (result.end == End::Exited && !lines.empty())
            fail({IssueId::GisFailed, {lines}});
        fail({IssueId::GisCrashed,
              {(result.end == End::Exited ? "exit " : "signal ") + std::to_string(result.code)}});
    }

    [[noreturn]] void fail(IssueReason reason) const
    {
        throw Error(m_code, m_subject, std::move(reason));
    }

private:
    [[nodiscard]] IssueId missing() const
    {
        return m_code == ErrorCode::FileUnwritable ? IssueId::GisWriteNeedsProgram
                                                   : IssueId::GisNeedsProgram;
    }

    [[nodiscard]] ChildResult run(std::vector<std::string> arguments,
                                  const std::stop_token& stop) const
    try {
        return runChild({.program = m_program,
                         .arguments = std::move(arguments),
                         .environment = environmentFor(m_folder),
                         .folder = m_folder},
                        m_limits, stop);
    } catch (const std::system_error& error) {
        throw Error(m_code, m_subject, std::string(error.what()));
    }

    const fs::path& m_folder;
    fs::path m_program;
    std::string m_subject;
    ErrorCode m_code;
    const ChildLimits& m_limits;
};

/** Links a file of the same name with another ending, in capitals or not, if it exists. */
void linkBeside(const fs::path& file, std::string_view ending, const fs::path& folder)
{
    std::string capitals(ending);
    for (char& c : capitals)
        c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    for (const std::string& spelled : {std::string(ending), capitals}) {
        const fs::path beside = fs::path(file).replace_extension(spelled);
        std::error_code error;
        if (!fs::is_regular_file(beside, error))
            continue;
        fs::create_symlink(beside, folder / ("input." + std::string(ending)), error);
        return;
    }
}

std::string folderIn(const std::string& name)
{
    return name.substr(0, name.find_last_of('/') + 1); // npos + 1 is 0
}

/**
 * Returns what of a zip archive is read: a name in it, or the folder of several Shapefiles; the
 * start is the same for all.
 */
std::string partOfArchive(const std::string& path, const std::string& subject,
                          const std::stop_token& stop)
{
    const std::string bytes = readFile(path, stop);
    ReadBudget budget(subject, bytes.size(), stop);
    const ZipReader archive(bytes, budget);
    std::vector<std::string> found;
    for (const GisEnding& gis : gisEndings())
        for (std::string& name : archive.names('.' + std::string(gis.ending)))
            found.push_back(std::move(name));
    if (found.empty())
        throw Error(ErrorCode::WrongFormat, subject, {IssueId::ArchiveWithout, {".shp"}});
    if (found.size() == 1)
        return found.front();
    const bool isOneFolder = std::ranges::all_of(found, [&](const std::string& name) {
        return lowerEnding(name) == "shp" && folderIn(name) == folderIn(found.front());
    });
    if (isOneFolder) {
        std::string part = folderIn(found.front());
        if (!part.empty())
            part.pop_back(); // with a slash at its end ogr2ogr does not take it for a folder
        return part;
    }
    constexpr std::size_t kMostNamed = 5;
    std::string names;
    for (std::size_t i = 0; i < std::min(found.size(), kMostNamed); ++i)
        names += (i > 0 ? ", " : "") + found[i];
    if (found.size() > kMostNamed)
        names += ", ...";
    throw Error(ErrorCode::InvalidInput, subject, {IssueId::GisSeveral, {names}});
}

/** Links the file and what belongs to it into the folder; returns its name for ogr2ogr. */
std::string linkedInput(const std::string& path, const std::string& subject, const fs::path& folder,
                        const std::stop_token& stop)
{
    std::error_code error;
    const fs::path file = fs::canonical(path, error);
    if (error)
        throw Error(ErrorCode::FileNotFound, subject, error.message());
    const GisEnding* const gis = gisEndingOf(path);
    const bool isArchive = lowerEnding(path) == "zip";
    const std::string ending = isArchive        ? "zip"
                               : gis == nullptr ? "gis"
                                                : std::string(gis->ending);
    const fs::path linked = folder / ("input." + ending);
    fs::create_symlink(file, linked, error);
    if (error)
        throw Error(ErrorCode::FileUnreadable, subject, error.message());
    if (gis != nullptr)
        for (const std::string_view other : gis->others)
            linkBeside(fs::absolute(path), other, folder);
    if (!isArchive)
        return linked.string();
    const std::string part = partOfArchive(path, subject, stop);
    return "/vsizip/{" + linked.string() + '}' + (part.empty() ? "" : '/' + part);
}

/** Makes a collection of one feature on each line. */
std::string collectionOf(const std::string& lines, const Ogr2ogrRun& run,
                         const std::string& subject)
{
    std::string collection = R"({"type":"FeatureCollection","features":[)"
                             "\n";
    collection.reserve(lines.size() + 100);
    bool isFirst = true;
    for (std::size_t at = 0; at < lines.size();) {
        const std::size_t end = std::min(lines.find('\n', at), lines.size());
        const std::string_view line = std::string_view(lines).substr(at, end - at);
        at = end + 1;
        if (line.find_first_not_of(" \r\t") == std::string_view::npos)
            continue;
        if (line.front() != '{' || line.find_last_of('}') == std::string_view::npos)
            run.fail({IssueId::GisNotGeoJson});
        collection += isFirst ? "" : ",\n";
        collection += line;
        isFirst = false;
    }
    if (isFirst)
        throw Error(ErrorCode::InvalidInput, subject, {IssueId::GisEmpty});
    return collection + "\n]}\n";
}

struct GisDriver
{
    GisFormat format;
    const char* name;
    const char* file;
};
constexpr std::array kDrivers{GisDriver{GisFormat::Shapefile, "ESRI Shapefile", ""},
                              GisDriver{GisFormat::GeoPackage, "GPKG", "bergwatch.gpkg"},
                              GisDriver{GisFormat::Gml, "GML", "bergwatch.gml"},
                              GisDriver{GisFormat::Dxf, "DXF", "bergwatch.dxf"},
                              GisDriver{GisFormat::FlatGeobuf, "FlatGeobuf", "bergwatch.fgb"}};

/** Options of ogr2ogr for the format. */
std::vector<std::string> writeOptions(GisFormat format, int epsg)
{
    const GisDriver& driver = *std::ranges::find(kDrivers, format, &GisDriver::format);
    std::vector<std::string> options{"-f", driver.name, "-t_srs", "EPSG:" + std::to_string(epsg)};
    const auto add = [&options](std::initializer_list<const char*> more) {
        options.insert(options.end(), more.begin(), more.end());
    };
    if (format == GisFormat::Gml)
        add({"-dsco", "FORMAT=GML3.2", "-dsco", "XSISCHEMA=OFF"});
    else if (format != GisFormat::Dxf)
        add({"-mapFieldType", "DateTime=String,Date=String,Time=String"});
    if (format == GisFormat::Shapefile)
        add({"-lco", "ENCODING=UTF-8", "-lco", "DBF_DATE_LAST_UPDATE=2000-01-01"});
    return options;
}

std::string contentOf(const fs::path& file)
{
    return readFile(file.string());
}

/** Runs once for each type of geometry. */
std::string zippedShapefiles(const Ogr2ogrRun& run, const fs::path& folder, int epsg,
                             const std::string& input)
{
    constexpr std::size_t kEmptyShapefile = 100; // its header alone
    constexpr std::array<std::pair<const char*, const char*>, 3> kTypes{
        {{"points", "POINT"}, {"lines", "LINESTRING"}, {"areas", "POLYGON"}}};
    std::vector<ZipEntry> entries;
    for (const auto& [name, type] : kTypes) {
        const std::string stem = std::string("bergwatch-") + name;
        const fs::path file = folder / (stem + ".shp");
        std::vector<std::string> arguments = writeOptions(GisFormat::Shapefile, epsg);
        const std::string quoted = std::string("'") + type + "'";
        for (std::string& argument : std::vector<std::string>{
                 "-where",
                 "OGR_GEOMETRY=" + quoted + " OR OGR_GEOMETRY='MULTI" + std::string(type) + "'",
                 "-nlt", std::string(type), file.string(), input})
            arguments.push_back(std::move(argument));
        (void)run.output(std::move(arguments), StopScope::current());
        std::error_code error;
        if (const auto size = fs::file_size(file, error); error || size <= kEmptyShapefile)
            continue;
        for (const char* ending : {".shp", ".shx", ".dbf", ".prj", ".cpg"})
            if (const fs::path part = folder / (stem + ending); fs::exists(part, error))
                entries.push_back({.name = stem + ending, .content = contentOf(part)});
    }
    return zipOf(entries);
}

} // namespace

std::filesystem::path ogr2ogrPath()
{
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nothing here sets the environment
    const char* const variable = std::getenv("PATH");
    const std::string folders = variable == nullptr ? "/usr/bin:/bin" : variable;
    for (std::size_t at = 0; at < folders.size();) {
        const std::size_t end = std::min(folders.find(':', at), folders.size());
        fs::path program = fs::path(folders.substr(at, end - at)) / "ogr2ogr";
        at = end + 1;
        std::error_code error;
        if (program.is_absolute() && fs::is_regular_file(program, error) &&
            access(program.c_str(), X_OK) == 0)
            return program;
    }
    return {};
}

bool hasGisContent(std::string_view head)
{
    using namespace std::string_view_literals;
    if (head.starts_with("\x00\x00\x27\x0A\x00\x00\x00\x00"sv) || head.starts_with("fgb\x03"sv))
        return true;
    constexpr std::size_t kApplicationAt = 68;
    return head.starts_with("SQLite format 3\0"sv) && head.size() > kApplicationAt + 4 &&
           (head.substr(kApplicationAt, 2) == "GP"sv);
}

bool hasGisEnding(std::string_view name)
{
    return gisEndingOf(name) != nullptr || lowerEnding(name) == "zip";
}

std::string geoJsonOfGisFile(const std::string& path, const std::string& subject,
                             const std::stop_token& stop, const ChildLimits& limits)
{
    const ScratchFolder scratch(subject);
    ChildLimits own = limits;
    own.output = std::min(own.output, readLimit(kLargestFile));
    const Ogr2ogrRun run(scratch.path(), subject, ErrorCode::WrongFormat, own);
    const std::string input = linkedInput(path, subject, scratch.path(), stop);
    // GeoJSON holds one layer, a sequence all of them; a sequence is always in WGS 84.
    const std::string lines = run.output(
        {"-f", "GeoJSONSeq", "-dim", "XY", "-lco", "COORDINATE_PRECISION=8", "/vsistdout/", input},
        stop);
    return collectionOf(lines, run, subject);
}

std::string gisFileOfGeoJson(std::string_view geoJson, GisFormat format, int epsg,
                             const std::string& subject, const ChildLimits& limits)
{
    const ScratchFolder scratch(subject);
    const Ogr2ogrRun run(scratch.path(), subject, ErrorCode::FileUnwritable, limits);
    const std::string input = (scratch.path() / "bergwatch.geojson").string();
    writeFileAtomically(input, geoJson);
    if (format == GisFormat::Shapefile)
        return zippedShapefiles(run, scratch.path(), epsg, input);
    std::vector<std::string> arguments = writeOptions(format, epsg);
    const GisDriver& driver = *std::ranges::find(kDrivers, format, &GisDriver::format);
    const fs::path file = scratch.path() / driver.file;
    arguments.push_back(file.string());
    arguments.push_back(input);
    (void)run.output(std::move(arguments), StopScope::current());
    return contentOf(file);
}

} // namespace berg
