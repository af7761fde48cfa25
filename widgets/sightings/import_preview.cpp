#include "widgets/sightings/import_preview.h"

#include "core/io/import/import_file.h"
#include "core/io/import/import_formats.h"
#include "core/io/import/tables/table_readers.h"
#include "core/io/text/atomic_file.h"
#include "core/io/text/csv_reader.h"
#include "core/scenario/text_checks.h"
#include "widgets/tasks/work_failure.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <unordered_map>

namespace berg {
namespace {

constexpr std::size_t kHeadRows = 20;
constexpr std::size_t kMostRows = 2000;
constexpr std::size_t kLongestCell = 80; ///< longest text of a cell on screen, bytes

QString textOf(std::string_view cell)
{
    const std::string_view text = cell.substr(0, kLongestCell);
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())).simplified();
}

/** Returns the beginning of a file as UTF-8, or an empty text if it is not text. */
std::string beginningOf(std::string_view bytes)
{
    constexpr std::size_t kMost = 1'000'000;
    std::string_view start = bytes.substr(0, kMost);
    if (start.size() < bytes.size())
        start = start.substr(0, start.find_last_of('\n') + 1);
    if (start.size() % 2 != 0 && (start.starts_with("\xFF\xFE") || start.starts_with("\xFE\xFF")))
        start.remove_suffix(1); // drops half of a UTF-16 character
    try {
        const std::string text = textOfBytes(start, {});
        return text.empty() ? std::string(start) : text;
    } catch (const Error&) {
        return {};
    }
}

bool mayBeTable(std::string_view bytes)
{
    const std::size_t first = bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    return first != std::string_view::npos &&
           std::string_view("{[<").find(bytes[first]) == std::string_view::npos &&
           bytes.substr(0, 4096).find('\0') == std::string_view::npos;
}

SightingSummary summaryOf(const SightingTable& table)
{
    SightingSummary summary{.format = table.format,
                            .columns = {},
                            .mapping = table.mapping,
                            .sightings = table.sightings.size(),
                            .headerLine = table.headerLine,
                            .guessedDate = table.guessedDate,
                            .guessedLine = table.guessedLine,
                            .positionSd_m = table.positionSd_m};
    for (const std::string& column : table.columns)
        summary.columns << QString::fromStdString(column);
    for (const Sighting& sighting : table.sightings) {
        if (!sighting.time)
            continue;
        summary.first = std::min(summary.first.value_or(*sighting.time), *sighting.time);
        summary.last = std::max(summary.last.value_or(*sighting.time), *sighting.time);
    }
    return summary;
}

/** Moves the imported icebergs of the result into rows. */
void takeRows(ImportPreview& preview)
{
    ImportResult& result = preview.result;
    std::unordered_map<std::string_view, const Iceberg*> byId;
    for (const Iceberg& iceberg : result.scenario.icebergs)
        byId.emplace(iceberg.id, &iceberg);
    preview.needsConsent = needsConsent(result);
    const std::size_t count = std::min(result.icebergs.size(), kMostRows);
    preview.moreRows = result.icebergs.size() - count;
    for (std::size_t i = 0; i < count; ++i) {
        ImportRow row{.report = std::move(result.icebergs[i])};
        const auto found = byId.find(row.report.id);
        row.taken = row.report.outcome != ImportOutcome::LeftOut && found != byId.end();
        if (row.taken) {
            const Iceberg& iceberg = *found->second;
            row.velocity_mps = iceberg.velocity_mps + result.scenario.current_mps;
            row.sigma_m2 = initialSigma_m2(iceberg);
            row.q_m2ps = iceberg.q_m2ps;
        }
        preview.rows.push_back(std::move(row));
    }
    result.icebergs = {};
}

/** Readers detect some faults only when all rows are read, so rejections come unsorted. */
void sortByLine(Rejections& rejected)
{
    std::ranges::stable_sort(rejected.first, {}, &RejectedRow::line);
}

/** Returns the first rows of a text if it may be a table, whether it can be imported or not. */
TableHead tableHead(std::string_view bytes, const ReadOptions& options)
{
    TableHead head;
    const std::string text = beginningOf(bytes);
    if (!mayBeTable(text))
        return head;
    CsvReader reader = tableReader(text, options);
    CsvRow row;
    bool first = true;
    while (head.rows.size() < kHeadRows && reader.next(row)) {
        QStringList cells;
        for (std::size_t i = 0; i < std::min(row.cells.size(), kMostColumns); ++i)
            cells << textOf(row.cells[i]);
        if (cells.join(QString()).isEmpty())
            continue;
        if (first)
            head.columns = cells;
        else
            head.rows.push_back(cells);
        first = false;
    }
    return head;
}

} // namespace

bool ImportPreview::isUsable() const
{
    return !error && file && !file->isUnclear &&
           result.added + result.updated + result.unchanged > 0;
}

Scenario scenarioFor(const QString& path)
{
    return newScenarioForImport(QFileInfo(path).completeBaseName().toStdString());
}

void ImportLoader::forget()
{
    *this = {};
}

void ImportLoader::readTable(const ImportRequest& request, const std::stop_token& stop)
{
    if (m_reading == request.reading && m_identity == request.identity)
        return;
    const std::string name = QFileInfo(request.path).fileName().toStdString();
    const bool isAnswer = m_reading == request.reading && !m_choices.empty();
    m_reading.reset();
    if (!isAnswer) {
        m_table = {};
        m_table = readSightingRows(m_bytes, name, request.reading, stop);
        m_choices = m_table.isIdentityUnclear
                        ? identityChoices(m_bytes, name, request.reading, m_table, stop)
                        : std::vector<IdentityChoice>();
    }
    const auto answer = std::find(m_choices.begin(), m_choices.end(), request.identity);
    if (isAnswer || answer != m_choices.end()) {
        ReadOptions reading = request.reading;
        if (answer != m_choices.end())
            reading = withIdentity(reading, *answer);
        m_table = {};
        m_table = readSightingRows(m_bytes, name, reading, stop);
    }
    m_identity = request.identity;
    m_reading = request.reading;
}

std::optional<ImportPreview> ImportLoader::preview(const ImportRequest& request,
                                                   const std::stop_token& stop)
{
    if (stop.stop_requested())
        return std::nullopt;
    ImportPreview preview;
    const auto failure = failureOf([&] {
        if (m_path != request.path) {
            forget();
            m_bytes = readImportFile(QFile::encodeName(request.path).toStdString(),
                                     QFileInfo(request.path).fileName().toStdString(), stop);
            m_path = request.path;
        }
        preview.head = tableHead(m_bytes, request.reading);
        readTable(request, stop);
        sortByLine(m_table.rejected);
        sortByLine(m_table.noted);
        preview.result.rejected = m_table.rejected; // reported even if no row is left
        requireSightings(m_table, QFileInfo(request.path).fileName().toStdString());
        preview.file = summaryOf(m_table);
        preview.file->choices = m_choices;
        preview.file->isUnclear = m_table.isIdentityUnclear;
        if (m_table.isIdentityUnclear)
            return;
        preview.result = importSightings(*request.base, m_table, request.options, stop);
        for (Rejections* rows :
             {&preview.result.rejected, &preview.result.noted, &preview.result.outside})
            sortByLine(*rows);
        takeRows(preview);
    });
    if (stop.stop_requested())
        return std::nullopt;
    if (failure) {
        if (!failure->isExpected)
            forget(); // it may be incomplete
        preview.error = failure->error;
    }
    return preview;
}

} // namespace berg
