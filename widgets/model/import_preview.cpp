#include "widgets/model/import_preview.h"

#include "core/io/text/atomic_file.h"
#include "core/io/text/csv_reader.h"
#include "core/scenario/checks.h"
#include "widgets/model/work_failure.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <unordered_map>

namespace berg {
namespace {

constexpr std::size_t kHeadRows = 20;
constexpr std::size_t kMostRows = 2000;
constexpr std::size_t kLongestCell = 80; ///< bytes, on screen

QString textOf(std::string_view bytes)
{
    const std::string_view text = bytes.substr(0, kLongestCell);
    const auto size = static_cast<qsizetype>(text.size());
    return (isUtf8(bytes) ? QString::fromUtf8(text.data(), size)
                          : QString::fromLatin1(text.data(), size))
        .simplified();
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
                            .guessedDate = table.guessedDate,
                            .guessedLine = table.guessedLine,
                            .oneIceberg = table.oneIceberg,
                            .positionSd_m = table.positionSd_m};
    for (const std::string& column : table.columns)
        summary.columns << QString::fromStdString(column);
    for (const Sighting& sighting : table.sightings) {
        summary.namesIcebergs = summary.namesIcebergs || !sighting.id.empty();
        if (!sighting.time)
            continue;
        summary.first = std::min(summary.first.value_or(*sighting.time), *sighting.time);
        summary.last = std::max(summary.last.value_or(*sighting.time), *sighting.time);
    }
    return summary;
}

/** Moves the reports of the result into rows. */
void takeRows(ImportPreview& preview)
{
    ImportResult& result = preview.result;
    std::unordered_map<std::string_view, const Iceberg*> byId;
    for (const Iceberg& iceberg : result.scenario.icebergs)
        byId.emplace(iceberg.id, &iceberg);
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

/** Readers find some faults only when all rows are read. */
void sortByLine(Rejections& rejected)
{
    std::ranges::stable_sort(rejected.first, {}, &RejectedRow::line);
}

/** The first rows of a text if it may be a table, whether it can be imported or not. */
TableHead tableHead(std::string_view bytes)
{
    TableHead head;
    if (!mayBeTable(bytes))
        return head;
    CsvReader reader = tableReader(bytes);
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
    return !error && result.added + result.updated + result.unchanged > 0;
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
    if (m_reading && m_reading->format == request.reading.format &&
        m_reading->mapping == request.reading.mapping && m_reading->dates == request.reading.dates)
        return;
    m_reading.reset();
    m_table = {};
    m_table = readSightingRows(m_bytes, QFileInfo(request.path).fileName().toStdString(),
                               request.reading, stop);
    m_suggestsOne = m_table.oneIceberg;
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
            m_bytes = readFile(QFile::encodeName(request.path).toStdString(), stop);
            m_head = tableHead(m_bytes);
            m_path = request.path;
        }
        preview.head = m_head;
        readTable(request, stop);
        sortByLine(m_table.rejected);
        preview.result.rejected = m_table.rejected; // told even if no row is left
        requireSightings(m_table, QFileInfo(request.path).fileName().toStdString());
        m_table.oneIceberg = request.oneIceberg.value_or(m_suggestsOne);
        preview.file = summaryOf(m_table);
        preview.result = importSightings(*request.base, m_table, request.options, stop);
        sortByLine(preview.result.rejected);
        takeRows(preview);
    });
    if (stop.stop_requested())
        return std::nullopt;
    if (failure) {
        if (!failure->isExpected)
            forget(); // half of it may be there
        preview.error = failure->error;
    }
    return preview;
}

} // namespace berg
