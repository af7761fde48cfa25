#pragma once

// Decides which rows of a file are one iceberg.

#include "core/io/import/fields/import_source.h"

namespace berg {

/** Result of one choice of identity: the number of icebergs and their greatest speed. */
struct IdentityOutcome
{
    std::size_t icebergs = 0;
    /**
     * Greatest speed between two consecutive sightings of one iceberg; times less than a minute
     * apart count as a minute.
     */
    double fastest_mps = 0;
    bool operator==(const IdentityOutcome&) const = default;
};

/** A choice of identity that the user may make. */
struct IdentityChoice
{
    std::string column;              ///< column that holds the ids, if `rows` is nullopt
    std::optional<RowIdentity> rows; ///< nullopt if the column decides
    IdentityOutcome outcome;
    bool operator==(const IdentityChoice&) const = default;
};

/**
 * Chooses the ids of a table that was just read, by the order of `idTrust`.
 *
 * A candidate is the column, name or feature id of one rank. It *repeats* if two rows have the same
 * value; it is *possible* if no two sightings of one value are farther apart than an iceberg drifts
 * in the time between (`TrackRules`); it is no id at all if its values are fractions. A column that
 * the user has mapped is the id. Otherwise it is the first possible candidate if its name says
 * iceberg; else the first candidate that is possible and repeats, where one whose word may mean
 * something else (`IdTrust::Weak`) needs at least two values; else the first possible one; else the
 * first. Rows without a value of it have that of the next. Only rows that also have a value of the
 * first possible candidate count for another one to repeat.
 *
 * Sets `isIdentityUnclear` if rows have different times and nothing shows which belong together:
 * there is no candidate; or a weak one has a different value in each row (unless it is a name that
 * is neither number nor time), or one value in rows that cannot be one iceberg; or a bare "id" has
 * a different value in each row, beside something that repeats.
 */
void decideIdentity(SightingTable& table, const ReadOptions& options);

/** Largest number of columns that `identityChoices` tries. */
inline constexpr std::size_t kMostIdentityColumns = 8;
/**
 * Returns the choices for a table whose identity is unclear: columns that group the rows
 * differently, by increasing speed of the icebergs, then all rows as one iceberg, then one iceberg
 * for each row. Reads the file once for each candidate column, until `kMostIdentityColumns` have
 * been found. Throws as `readSightingRows`.
 */
[[nodiscard]] std::vector<IdentityChoice>
identityChoices(std::string_view bytes, const std::string& subject, const ReadOptions& options,
                const SightingTable& table, const std::stop_token& stop = {});

/** Returns the options that read the file according to the choice. */
[[nodiscard]] ReadOptions withIdentity(ReadOptions options, const IdentityChoice& choice);

/**
 * Throws `Error{InvalidInput}` with an issue for each choice if the identity is unclear; throws as
 * `identityChoices` then.
 */
void requireIdentity(const SightingTable& table, std::string_view bytes, const std::string& subject,
                     const ReadOptions& options);

} // namespace berg
