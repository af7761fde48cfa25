#pragma once

#include "core/base/error.h"
#include "core/io/import/import_formats.h"
#include "core/io/import/import_scenario.h"

#include <QString>
#include <QStringList>

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace berg {

/** What is to be imported, and how. */
struct ImportRequest
{
    QString path;
    ReadOptions reading;
    std::optional<bool> oneIceberg;       ///< none: as the file suggests
    std::shared_ptr<const Scenario> base; ///< that the icebergs are added to
    ImportOptions options;
};

/** How a table begins, cell by cell; empty for a file that is none. */
struct TableHead
{
    QStringList columns;
    std::vector<QStringList> rows; ///< the first twenty
};

/** What the file says, whatever of it is imported. */
struct SightingSummary
{
    std::string format;
    QStringList columns;
    ColumnMapping mapping; ///< as used
    std::size_t sightings = 0;
    std::string guessedDate; ///< as in `SightingTable`
    std::size_t guessedLine = 0;
    bool namesIcebergs = false;
    bool oneIceberg = false;
    double positionSd_m = 0;      ///< of a sighting that does not tell
    std::optional<UtcTime> first; ///< sighting; none: the file tells no times
    std::optional<UtcTime> last;
};

/** One iceberg of the file and what it is in the scenario that comes out. */
struct ImportRow
{
    ImportedIceberg report;
    bool taken = false;                 ///< otherwise what follows means nothing
    Point velocity_mps = Point::Zero(); ///< over ground
    double sigma_m2 = 0;                ///< at t = 0
    double q_m2ps = 0;
};

/** What an import would do. */
struct ImportPreview
{
    TableHead head;
    std::optional<SightingSummary> file; ///< none: it could not be read
    std::optional<Error> error;          ///< why there is no result
    ImportResult result;                 ///< its `icebergs` are the rows
    std::vector<ImportRow> rows;         ///< the first thousands
    std::size_t moreRows = 0;

    /** There is something to be imported. */
    [[nodiscard]] bool isUsable() const;
};

/** A scenario for icebergs that belong to none yet: one aircraft, named after the file. */
[[nodiscard]] Scenario scenarioFor(const QString& path);

/**
 * Computes previews one after the other; keeps the file's bytes and its sightings, so that only
 * what depends on a change is done again and a file that changes meanwhile is seen as it was.
 */
class ImportLoader
{
public:
    /** None: stopped, soon. Failures are in the preview. A large file takes seconds to read. */
    [[nodiscard]] std::optional<ImportPreview> preview(const ImportRequest& request,
                                                       const std::stop_token& stop);
    /** Lets the file go. */
    void forget();

private:
    void readTable(const ImportRequest& request, const std::stop_token& stop);

    QString m_path; ///< of `m_bytes`; empty: none
    std::string m_bytes;
    TableHead m_head;
    std::optional<ReadOptions> m_reading; ///< of `m_table`
    SightingTable m_table;
    bool m_suggestsOne = false; ///< `oneIceberg` of the table as it was read
};

} // namespace berg
