#pragma once

#include "core/base/error.h"
#include "core/io/import/fields/import_source.h"
#include "core/io/import/import_identity.h"
#include "core/io/import/scenario/import_scenario.h"

#include <QString>
#include <QStringList>

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace berg {

/** An import: file, reading options and target. */
struct ImportRequest
{
    QString path;
    ReadOptions reading;
    /** The user's answer if the file leaves iceberg identity open. */
    std::optional<IdentityChoice> identity;
    std::shared_ptr<const Scenario> base; ///< scenario to which the icebergs are added
    ImportOptions options;
};

/** First cells of a table; empty if the file is not a table. */
struct TableHead
{
    QStringList columns;
    std::vector<QStringList> rows; ///< the first twenty rows
};

/** Content of the file, whether imported or not. */
struct SightingSummary
{
    std::string format;
    QStringList columns;
    ColumnMapping mapping; ///< mapping in use
    std::size_t sightings = 0;
    std::optional<std::size_t> headerLine; ///< as in `SightingTable`
    std::string guessedDate;               ///< as in `SightingTable`
    std::size_t guessedLine = 0;           ///< line of the guessed date
    /** Choices of iceberg identity if the file leaves it open; else empty. */
    std::vector<IdentityChoice> choices;
    bool isUnclear = false;       ///< whether a choice is needed and none is made
    double positionSd_m = 0;      ///< position error of sightings that state none, m
    std::optional<UtcTime> first; ///< time of the first sighting; nullopt if the file has no times
    std::optional<UtcTime> last;
};

/** An iceberg of the file and its values in the resulting scenario. */
struct ImportRow
{
    ImportedIceberg report;
    bool taken = false; ///< whether it is imported; otherwise the fields below are unset
    Point velocity_mps = Point::Zero(); ///< over ground
    double sigma_m2 = 0;                ///< at t = 0
    double q_m2ps = 0;
};

/** Result of an import before it is applied. */
struct ImportPreview
{
    TableHead head;
    std::optional<SightingSummary> file; ///< nullopt if the file could not be read
    std::optional<Error> error;          ///< reason for which there is no result
    ImportResult result;                 ///< its `icebergs` are moved to `rows`
    std::vector<ImportRow> rows;         ///< the first 2000 icebergs
    std::size_t moreRows = 0;
    bool needsConsent = false; ///< whether any iceberg needs the user's consent

    /** Returns whether there is something to import. */
    [[nodiscard]] bool isUsable() const;
};

/** Returns a new scenario for an import, with one UAV and named after the file. */
[[nodiscard]] Scenario scenarioFor(const QString& path);

/**
 * Computes previews one after the other. It stores the bytes and sightings of the file, so that
 * only what depends on a change is recomputed and a file that changes meanwhile is treated as first
 * read.
 */
class ImportLoader
{
public:
    /**
     * Returns the preview, or nullopt if it was stopped. Errors are in the preview. A large file
     * takes seconds to read.
     */
    [[nodiscard]] std::optional<ImportPreview> preview(const ImportRequest& request,
                                                       const std::stop_token& stop);
    /** Releases the stored file. */
    void forget();

private:
    void readTable(const ImportRequest& request, const std::stop_token& stop);

    QString m_path; ///< path of `m_bytes`; empty without a file
    std::string m_bytes;
    std::optional<ReadOptions> m_reading;     ///< reading options of `m_table`
    std::optional<IdentityChoice> m_identity; ///< identity choice of `m_table`
    SightingTable m_table;
    std::vector<IdentityChoice> m_choices; ///< choices of the table read without an answer
};

} // namespace berg
