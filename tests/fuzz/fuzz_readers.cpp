// Feeds mutated files to every reader of foreign files in one process; see usage().

#include "core/checks/validate.h"
#include "core/earth/coordinates.h"
#include "core/io/files/iceberg_json.h"
#include "core/io/files/problem_json.h"
#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/io/files/tsplib.h"
#include "core/io/import/airspace/import_airspace.h"
#include "core/io/import/import_forecast.h"
#include "core/io/import/import_forecast_file.h"
#include "core/io/import/import_formats.h"
#include "core/io/import/maps/import_ice_chart.h"
#include "core/io/import/maps/map_shapes.h"
#include "core/io/import/scenario/import_scenario.h"
#include "core/io/study/study_json.h"
#include "core/io/study/study_report.h"
#include "core/io/text/atomic_file.h"
#include "core/link/logs/nmea_log.h"
#include "core/plan/solve/latency_problem.h"
#include "core/presets/presets.h"
#include "tests/fuzz/fuzz_mutator.h"
#include "tests/support/files/export_text.h"
#include "tests/support/files/file_texts.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <filesystem>
#include <map>
#include <set>
#include <sys/mman.h>
#include <unistd.h>

using namespace berg;
using berg::fuzz::Mutator;

namespace {

const std::string kSubject = "mutated";

[[noreturn]] void fail(const std::string& what)
{
    std::fprintf(stderr, "fuzz_readers: %s\n", what.c_str());
    std::abort();
}

/** Returns the file, with the field or the line unless the issue concerns the whole file. */
void checkMessage(const Error& error)
{
    const bool isWhole = error.code() == ErrorCode::WrongFormat ||
                         error.code() == ErrorCode::UnsupportedVersion ||
                         error.code() == ErrorCode::FileTooLarge ||
                         error.code() == ErrorCode::FileUnreadable || // its library gave up
                         error.code() == ErrorCode::Unsupported;      // a build without it
    if (error.subject() != kSubject || !std::string_view(error.what()).starts_with(kSubject + ": "))
        fail(std::string("a message without its file: ") + error.what());
    if (error.issues().empty())
        fail(std::string("nothing found: ") + error.what());
    const Issue& first = error.issues().front();
    if (first.reason.id == IssueId::Verbatim)
        fail(std::string("words of no id: ") + error.what());
    const bool isAboutAll =
        first.reason.id == IssueId::NoSightings || first.reason.id == IssueId::NoAirspace ||
        first.reason.id == IssueId::NoIceNear || first.reason.id == IssueId::ColumnsFixed ||
        first.reason.id == IssueId::HeaderColumns || first.reason.id == IssueId::JsonDepth ||
        first.reason.id == IssueId::NoQuantity;
    if (!isWhole && !isAboutAll && first.field.empty() && !first.message().starts_with("line "))
        fail(std::string("neither field nor line: ") + error.what());
    if (std::string_view(error.what()).find('\x1b') != std::string_view::npos)
        fail("a raw escape in a message");
}

/** Writes what was read, and checks that it is read again unchanged. */
template <class Read, class Write>
void readTwice(const std::string& text, const Read& read, const Write& write)
{
    const auto first = read(text);
    const std::string written = write(first);
    if (!(read(written) == first) || write(read(written)) != written)
        fail("not the same again");
}

Scenario sea()
{
    Scenario scenario;
    scenario.uavs.emplace_back().id = "uav-1";
    return scenario;
}

void readAsSightings(const std::string& text)
{
    const SightingTable table = readSightings(text, kSubject);
    const ImportResult result = importSightings(sea(), table);
    if (!unreadable(result.scenario).empty())
        fail("an import that cannot be opened");
}

void readAsAirspace(const std::string& text)
{
    const AirspaceResult result = importAirspace(sea(), text, kSubject);
    if (!unreadable(result.scenario).empty())
        fail("an import that cannot be opened");
}

void readAsMap(const std::string& text)
{
    for (const MapShape& shape : readMapShapes(text, kSubject))
        for (const std::vector<LatLon>& part : shape.parts)
            if (part.empty())
                fail("a shape without places");
    if (isIceChart(text) && !unreadable(importIceChart(sea(), text, kSubject).scenario).empty())
        fail("an ice chart that cannot be opened");
}

void readAsForecast(const std::string& text)
{
    const Forecast forecast = forecastFromJson(text, kSubject);
    if (cut(forecast, std::nullopt, std::nullopt).series.size() != forecast.series.size())
        fail("a forecast whose times do not rise");
}

/** NetCDF and GRIB, whose libraries run in a process of their own: they may fail, we may not. */
void readAsGrid(const std::string& text)
{
    const ForecastReading reading = forecastFromBytes(text, kSubject);
    if (!isGrid(reading.field))
        fail("a forecast that is no grid");
}

/** NMEA sentences and AIS messages, as they are replayed. */
void readAsNmeaLog(const std::string& text)
{
    constexpr std::size_t kPiece = 100;
    NmeaLogReader log;
    std::size_t frames = 0;
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    for (std::size_t at = 0; at < bytes.size(); at += kPiece)
        frames +=
            log.feed(std::span(bytes).subspan(at, std::min(kPiece, bytes.size() - at))).size();
    frames += log.finish().size();
    if (frames > text.size())
        fail("more sentences than bytes");
}

void readAsStudy(const std::string& text)
{
    if (isReport(text))
        static_cast<void>(studyFromJson(studyOfReport(text, kSubject), kSubject));
    else
        static_cast<void>(studyFromJson(text, kSubject));
}

void readAsScenario(const std::string& text)
{
    readTwice(
        text, [](const std::string& t) { return scenarioFromJson(t, kSubject); },
        [](const Scenario& s) { return scenarioToJson(s); });
}

void readAsRun(const std::string& text)
{
    readTwice(
        text, [](const std::string& t) { return runFromJson(t, kSubject); },
        [](const RunFile& run) { return runToJson(run); });
}

void readAsProblem(const std::string& text)
{
    static_cast<void>(problemFromJson(text, kSubject));
}

void readAsTsplib(const std::string& text)
{
    const TvpProblem problem = problemFromTsplib(text, kSubject).problem;
    if (!validate(problem).empty() || !validate(latencyProblem(problem)).empty())
        fail("a problem that nobody can solve");
}

void readAsIcebergs(const std::string& text)
{
    static_cast<void>(icebergsFromJson(text, kSubject));
}

void readAsPlace(const std::string& text)
{
    static_cast<void>(parsePlace(text.substr(0, 200)));
    static_cast<void>(parseUtc(text.substr(0, 40)));
}

void readAsFormat(const std::string& text)
{
    static_cast<void>(formatOf(text, kSubject));
}

/** Sometimes also tries the other readers of text, whatever the file is called. */
constexpr std::array kReaders{readAsScenario, readAsRun,       readAsProblem,  readAsStudy,
                              readAsFormat,   readAsSightings, readAsIcebergs, readAsPlace,
                              readAsAirspace, readAsMap,       readAsTsplib,   readAsForecast,
                              readAsGrid,     readAsNmeaLog};

using Reader = void (*)(const std::string&);

Reader readerOf(const std::filesystem::path& file)
{
    static const std::map<std::string, Reader> kByEnding{
        {".berg", readAsScenario},   {".bergrun", readAsRun}, {".bergstudy", readAsStudy},
        {".json", readAsProblem},    {".tsp", readAsTsplib},  {".atsp", readAsTsplib},
        {".openair", readAsAirspace}};
    if (file.parent_path().filename() == "forecast")
        return file.extension() == ".json" ? readAsForecast : readAsGrid;
    const auto it = kByEnding.find(file.extension().string());
    return it == kByEnding.end() ? readAsSightings : it->second;
}

struct Corpus
{
    std::vector<std::string> texts;
    std::vector<Reader> readers;
    std::vector<bool> packed; ///< whether the input is a KMZ with the text

    void add(const std::filesystem::path& file)
    {
        constexpr std::size_t kLargest = 40'000;
        std::string text = readFile(file.string());
        const bool isPacked = isZip(text);
        if (isPacked) {
            ReadBudget budget(file.string(), text.size());
            text = unzipped(text, ".kml", budget);
        }
        if (text.empty() || text.size() > kLargest)
            return;
        add(std::move(text), readerOf(file), isPacked);
    }

    void add(std::string text, Reader reader, bool isPacked = false)
    {
        texts.push_back(std::move(text));
        readers.push_back(reader);
        packed.push_back(isPacked);
    }

    /** Adds inputs without files: icebergs of the clipboard, studies and their reports, places. */
    void addOthers()
    {
        const Scenario field = randomScenario(1, {.icebergs = 4});
        add(icebergsToJson(field.icebergs), readAsIcebergs);
        Study study{.spec = {.name = "s", .scenarios = {field}, .random = 2, .taus = {0.5, 1}}};
        study.spec.policies = {PolicyKind::Visitation, PolicyKind::Tour};
        study.outcomes = {missionCount(study.spec), MissionOutcome{}};
        study.outcomes[1].reset();
        add(studyToJson(study), readAsStudy);
        add("<html><script type=\"application/json\" id=\"study\">" + studyToJson(study) +
                "</script></html>",
            readAsStudy);
        for (const char* const place :
             {"47\u00b0 03.2\u2032 N, 52\u00b0 41.5\u2032 W", "-47.0533 52.69",
              "47 03 12 N 052 41 30 W", "21X VG 74594 43594", "21 N 430000 5210000",
              "2021-05-02T03:04:05.678Z"})
            add(place, readAsPlace);
    }
};

/** The current input, stored in a file that survives a crash of this process. */
class Keeper
{
public:
    explicit Keeper(const std::string& path)
    {
        const int fd = ::open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC, 0666);
        if (fd < 0 || ::ftruncate(fd, kSize) != 0)
            fail("cannot write " + path);
        m_map =
            static_cast<char*>(::mmap(nullptr, kSize, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0));
        ::close(fd);
        if (m_map == MAP_FAILED)
            fail("cannot map " + path);
    }
    /** Reader, size, bytes. */
    void keep(std::size_t reader, const std::string& text)
    {
        const std::size_t size = std::min(text.size(), kSize - 2 * sizeof(std::size_t));
        std::memcpy(m_map, &reader, sizeof reader);
        std::memcpy(m_map + sizeof reader, &size, sizeof size);
        std::memcpy(m_map + 2 * sizeof size, text.data(), size);
    }

private:
    static constexpr std::size_t kSize = 1U << 18U;
    char* m_map = nullptr;
};

/** Returns whether the input was accepted. */
bool feed(Reader reader, const std::string& text)
{
    try {
        reader(text);
        return true;
    } catch (const Error& error) {
        checkMessage(error);
        return false;
    }
}

double processor_s()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Options
{
    double seconds = 1e9;
    std::uint64_t inputs = 10'000'000;
    std::uint64_t seed = 1;
    std::string keep = "fuzz-input";
    std::string again; ///< a stored input to repeat
    std::string map;   ///< a file for the map background
    std::vector<std::string> folders;
};

int feedAgain(const std::string& path)
{
    const std::string kept = readFile(path);
    std::size_t reader = 0;
    std::size_t size = 0;
    std::memcpy(&reader, kept.data(), sizeof reader);
    std::memcpy(&size, kept.data() + sizeof reader, sizeof size);
    std::printf("%s\n", feed(kReaders.at(reader), kept.substr(2 * sizeof size, size)) ? "taken"
                                                                                      : "refused");
    return 0;
}

int feedMap(const std::string& path)
{
    std::printf("%s\n", feed(readAsMap, readFile(path)) ? "taken" : "refused");
    return 0;
}

int feedMany(const Options& options)
{
    constexpr double kLongest_s = 20; // usually 80 ms; longer means an endless loop
    Corpus corpus;
    std::set<std::filesystem::path> files; // a set, for a fixed order
    for (const std::string& folder : options.folders)
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
            if (entry.is_regular_file())
                files.insert(entry.path());
    for (const std::filesystem::path& file : files)
        corpus.add(file);
    if (corpus.texts.empty())
        fail("no files to mutate");
    corpus.addOthers();
    Mutator mutator(options.seed, corpus.texts);
    Keeper keeper(options.keep);
    const auto start = std::chrono::steady_clock::now();
    std::uint64_t done = 0;
    std::uint64_t taken = 0;
    double slowest_s = 0;
    const auto elapsed_s = [&start] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    for (; done < options.inputs && (done % 64 != 0 || elapsed_s() < options.seconds); ++done) {
        const std::size_t which = mutator.below(corpus.texts.size());
        std::string text = mutator.mutated(corpus.texts[which]);
        if (corpus.packed[which]) {
            text = zipFile("doc.kml", text);
            if (mutator.below(2) == 0)
                text = mutator.mutated(text);
        }
        Reader reader = corpus.readers[which];
        if (reader == readAsSightings && mutator.below(4) == 0)
            reader = readAsMap; // for the same files
        if (reader == readAsSightings && text.starts_with('$') && mutator.below(2) == 0)
            reader = readAsNmeaLog;
        if (mutator.below(8) == 0)
            reader = kReaders[mutator.below(kReaders.size())];
        keeper.keep(
            static_cast<std::size_t>(std::ranges::find(kReaders, reader) - kReaders.begin()), text);
        const double before_s = processor_s();
        taken += feed(reader, text) ? 1U : 0U;
        slowest_s = std::max(slowest_s, processor_s() - before_s);
        if (slowest_s > kLongest_s)
            fail("an input took " + std::to_string(slowest_s) + " s");
    }
    std::printf("seed %llu: %llu inputs of %zu files in %.0f s, %llu taken, the slowest %.0f ms\n",
                static_cast<unsigned long long>(options.seed),
                static_cast<unsigned long long>(done), corpus.texts.size(), elapsed_s(),
                static_cast<unsigned long long>(taken), slowest_s * 1e3);
    return 0;
}

int usage()
{
    std::fputs(
        "Usage: fuzz_readers [--seconds S] [--inputs N] [--seed K] [--keep FILE] FOLDER...\n"
        "       fuzz_readers --again FILE\n"
        "       fuzz_readers --map FILE\n"
        "Mutates the files of the folders and reads them. The input in work is in FILE; what\n"
        "ends the program is read from it once more with --again. --map reads a file as it is, as\n"
        "the background of the map.\n",
        stderr);
    return 2;
}

} // namespace

int main(int argc, char** argv)
{
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const bool hasValue = word.starts_with("--") && i + 1 < argc;
        if (!word.starts_with("--"))
            options.folders.push_back(word);
        else if (word == "--seconds" && hasValue)
            options.seconds = std::strtod(argv[++i], nullptr);
        else if (word == "--inputs" && hasValue)
            options.inputs = std::strtoull(argv[++i], nullptr, 10);
        else if (word == "--seed" && hasValue)
            options.seed = std::strtoull(argv[++i], nullptr, 10);
        else if (word == "--keep" && hasValue)
            options.keep = argv[++i];
        else if (word == "--again" && hasValue)
            options.again = argv[++i];
        else if (word == "--map" && hasValue)
            options.map = argv[++i];
        else
            return usage();
    }
    if (!options.again.empty())
        return feedAgain(options.again);
    if (!options.map.empty())
        return feedMap(options.map);
    return options.folders.empty() ? usage() : feedMany(options);
}
