#include "core/io/import/import_identity.h"

#include "core/base/angles.h"
#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/io/import/fields/import_fields.h"
#include "core/io/import/import_formats.h"
#include "core/io/import/scenario/import_selection.h"
#include "core/scenario/text_checks.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace berg {

namespace {

/** A sighting with a value that may be its id. */
struct Keyed
{
    std::string_view key;
    const Sighting* sighting = nullptr;
};

struct Figures
{
    IdentityOutcome outcome;
    bool possible = true; ///< see `decideIdentity`
};

Figures figuresOf(std::vector<Keyed> rows)
{
    constexpr double kShortest_s = 60;
    const TrackRules rules;
    std::ranges::stable_sort(rows, [](const Keyed& a, const Keyed& b) {
        return a.key != b.key ? a.key < b.key : a.sighting->time < b.sighting->time;
    });
    Figures figures{.outcome = {.icebergs = rows.empty() ? std::size_t{0} : std::size_t{1}}};
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const Sighting& before = *rows[i - 1].sighting;
        const Sighting& after = *rows[i].sighting;
        if (rows[i].key != rows[i - 1].key) {
            ++figures.outcome.icebergs;
            continue;
        }
        if (!before.time || !after.time)
            continue;
        const double path_m = greatCircle_m(before.place, after.place);
        const double time_s = secondsBetween(*before.time, *after.time);
        figures.outcome.fastest_mps =
            std::max(figures.outcome.fastest_mps, path_m / std::max(kShortest_s, time_s));
        figures.possible =
            figures.possible && path_m <= rules.jumpSlack_m + rules.fastest_mps * time_s;
    }
    return figures;
}

bool isFraction(std::string_view text)
{
    return text.find_first_of(".,") != std::string_view::npos && decimalOf(text);
}

/** Whether the text is a number or a time: such names count rows and do not name icebergs. */
bool isCount(const std::string& text)
{
    return decimalOf(text) || parseSightingTime(text, DateOrder::MonthFirst) ||
           parseSightingTime(text, DateOrder::DayFirst);
}

/** Values of one rank that may be the ids of the rows. */
struct Candidate
{
    std::size_t rank = 0;
    std::vector<Keyed> rows = {};
    std::size_t values = 0;
    bool possible = true;
    bool areCounts = true; ///< all values are numbers or times

    [[nodiscard]] bool repeats() const { return values < rows.size(); }
    [[nodiscard]] bool isWeak() const { return idTrust(rank) == IdTrust::Weak; }
};

std::vector<Candidate> candidatesOf(const SightingTable& table)
{
    std::map<std::size_t, Candidate> byRank;
    for (const Sighting& sighting : table.sightings)
        for (const IdText& id : sighting.ids) {
            Candidate& candidate = byRank[id.rank];
            candidate.rank = id.rank;
            candidate.rows.push_back({.key = id.text, .sighting = &sighting});
        }
    std::vector<Candidate> candidates;
    for (auto& [rank, candidate] : byRank) {
        const auto all = [&rows = candidate.rows](const auto& test) {
            return std::ranges::all_of(
                rows, [&](const Keyed& row) { return test(std::string(row.key)); });
        };
        if (rank > 0 && all([](const std::string& text) { return isFraction(text); }))
            continue;
        const Figures figures = figuresOf(candidate.rows);
        candidate.values = figures.outcome.icebergs;
        candidate.possible = figures.possible;
        candidate.areCounts = all(isCount);
        candidates.push_back(std::move(candidate));
    }
    return candidates;
}

/** Returns the rows of `one` in which `other` has a value too. */
std::vector<Keyed> rowsBeside(const Candidate& one, const Candidate& other)
{
    std::vector<Keyed> rows;
    for (const Keyed& row : one.rows)
        if (std::ranges::find(row.sighting->ids, other.rank, &IdText::rank) !=
            row.sighting->ids.end())
            rows.push_back(row);
    return rows;
}

/** Returns the candidate that `decideIdentity` describes, or null if there is none. */
const Candidate* chosenOf(const std::vector<Candidate>& candidates)
{
    if (candidates.empty() || candidates.front().rank == 0)
        return candidates.empty() ? nullptr : &candidates.front();
    const auto first = [&](const auto& test) {
        const auto found = std::ranges::find_if(candidates, test);
        return found == candidates.end() ? nullptr : &*found;
    };
    const Candidate* possible = first([](const Candidate& one) { return one.possible; });
    if (possible != nullptr && idTrust(possible->rank) == IdTrust::Iceberg)
        return possible;
    const Candidate* const best = possible != nullptr ? possible : &candidates.front();
    const Candidate* repeating = first([&](const Candidate& one) {
        const std::vector<Keyed> rows = rowsBeside(one, *best);
        const std::size_t values = figuresOf(rows).outcome.icebergs;
        return one.possible && values < rows.size() && (!one.isWeak() || values > 1);
    });
    return repeating != nullptr ? repeating : best;
}

/** Whether `chosen` leaves open which rows belong together, in a table whose times differ. */
bool isUnclear(const Candidate* chosen, const std::vector<Candidate>& candidates)
{
    if (chosen == nullptr)
        return true;
    if (chosen->rank == 0)
        return false;
    const bool isName = chosen->rank == kNameRank;
    if (chosen->isWeak() && !chosen->repeats())
        return !isName || chosen->areCounts;
    if (chosen->isWeak() && !chosen->possible && chosen->values == 1)
        return true;
    return idTrust(chosen->rank) == IdTrust::Tracker && !chosen->repeats() &&
           std::ranges::any_of(candidates, [&](const Candidate& other) {
               return &other != chosen && other.possible && other.repeats();
           });
}

bool timesDiffer(const SightingTable& table)
{
    const Sighting* first = nullptr;
    for (const Sighting& sighting : table.sightings) {
        if (!sighting.time)
            continue;
        if (first != nullptr && *first->time != *sighting.time)
            return true;
        first = &sighting;
    }
    return false;
}

/** Makes names candidates if each row has one that is not a candidate yet. */
void offerNames(SightingTable& table)
{
    const bool allNamed =
        table.sightings.size() > 1 && std::ranges::all_of(table.sightings, [](const Sighting& row) {
            return !row.name.empty() && row.name.size() <= kLongestId && !row.track &&
                   std::ranges::none_of(row.ids,
                                        [](const IdText& id) { return id.rank == kNameRank; });
        });
    if (!allNamed)
        return;
    for (Sighting& row : table.sightings) {
        const auto at = std::ranges::lower_bound(row.ids, kNameRank, {}, &IdText::rank);
        row.ids.insert(at, {.rank = kNameRank, .text = row.name});
    }
}

void takeIds(SightingTable& table, std::size_t rank)
{
    for (Sighting& row : table.sightings) {
        const auto found = std::ranges::find(row.ids, rank, &IdText::rank);
        if (found != row.ids.end())
            row.id = found->text;
        else if (row.id.empty() && !row.ids.empty())
            row.id = row.ids.front().text;
        if (row.id == row.name)
            row.name.clear();
    }
}

/** Marks columns that turned out not to hold the id as unused; they may be chosen. */
void sortColumns(SightingTable& table, std::optional<std::size_t> rank)
{
    if (table.columns.empty())
        return;
    std::erase_if(table.mapping, [&](const FieldColumn& mapped) {
        const std::optional<FieldUse> use = fieldOfColumn(mapped.column);
        const bool isGuess = use && use->field == SightingField::Id;
        const bool isOther =
            mapped.field == SightingField::Id && isGuess && rank != 0 && use->rank != rank;
        if (isOther)
            table.unused.push_back(mapped.column);
        return isOther;
    });
    table.idCandidates = table.unused;
    for (const FieldColumn& mapped : table.mapping)
        if (mapped.field == SightingField::Id || mapped.field == SightingField::Name)
            table.idCandidates.push_back(mapped.column);
}

/** Clears ids that come from candidates; those of tracks stay. */
void dropCandidateIds(SightingTable& table)
{
    for (Sighting& row : table.sightings)
        if (!row.ids.empty())
            row.id.clear();
}

void forgetCandidates(SightingTable& table)
{
    for (Sighting& row : table.sightings)
        row.ids = {};
}

} // namespace

void decideIdentity(SightingTable& table, const ReadOptions& options)
{
    if (options.rows) {
        for (Sighting& row : table.sightings)
            row.id.clear();
        forgetCandidates(table);
        table.oneIceberg = *options.rows == RowIdentity::OneIceberg;
        return;
    }
    offerNames(table);
    const std::vector<Candidate> candidates = candidatesOf(table);
    const Candidate* const chosen = chosenOf(candidates);
    const bool areTracks = std::ranges::any_of(table.sightings, [](const Sighting& row) {
        return row.track || (row.ids.empty() && !row.id.empty());
    });
    const bool anyTimes = timesDiffer(table);
    table.isIdentityUnclear = anyTimes && !areTracks && isUnclear(chosen, candidates);
    // A name shared by all rows that cannot be one iceberg does not name an iceberg.
    const bool isUsed =
        chosen != nullptr && !(table.isIdentityUnclear && chosen->isWeak() && !chosen->possible);
    if (isUsed)
        takeIds(table, chosen->rank);
    else
        dropCandidateIds(table);
    sortColumns(table, isUsed ? std::optional(chosen->rank) : std::nullopt);
    forgetCandidates(table);
    // A table of places at different times is probably the track of a beacon; marks on a map are
    // not.
    table.oneIceberg = anyTimes && !table.columns.empty() &&
                       std::ranges::all_of(table.sightings, [](const Sighting& row) {
                           return row.id.empty() && row.time.has_value();
                       });
}

std::vector<IdentityChoice> identityChoices(std::string_view bytes, const std::string& subject,
                                            const ReadOptions& options, const SightingTable& table,
                                            const std::stop_token& stop)
{
    std::vector<Keyed> all;
    for (const Sighting& sighting : table.sightings)
        all.push_back({.key = {}, .sighting = &sighting});
    const IdentityChoice one{
        .column = {}, .rows = RowIdentity::OneIceberg, .outcome = figuresOf(all).outcome};
    const IdentityChoice each{
        .column = {}, .rows = RowIdentity::EachRow, .outcome = {.icebergs = all.size()}};
    std::vector<IdentityChoice> choices;
    for (const std::string& column : table.idCandidates) {
        if (choices.size() == kMostIdentityColumns)
            break;
        const SightingTable read = readSightingRows(
            bytes, subject, withIdentity(options, {.column = column, .rows = {}, .outcome = {}}),
            stop);
        std::vector<Keyed> rows;
        for (const Sighting& sighting : read.sightings)
            if (!sighting.id.empty())
                rows.push_back({.key = sighting.id, .sighting = &sighting});
        const IdentityOutcome outcome = figuresOf(rows).outcome;
        const bool isGuess =
            fieldOfColumn(column) && fieldOfColumn(column)->field == SightingField::Id;
        const bool distinguishes = outcome.icebergs > 1 && outcome.icebergs < rows.size();
        const bool areFractions =
            std::ranges::all_of(rows, [](const Keyed& row) { return isFraction(row.key); });
        if (rows.size() == all.size() && !areFractions && (distinguishes || isGuess))
            choices.push_back({.column = column, .rows = {}, .outcome = outcome});
    }
    std::ranges::stable_sort(
        choices, {}, [](const IdentityChoice& choice) { return choice.outcome.fastest_mps; });
    choices.push_back(one);
    choices.push_back(each);
    return choices;
}

ReadOptions withIdentity(ReadOptions options, const IdentityChoice& choice)
{
    options.rows = choice.rows;
    if (choice.rows)
        return options;
    std::erase_if(options.mapping, [&](const FieldColumn& mapped) {
        return mapped.field == SightingField::Id || mapped.column == choice.column;
    });
    options.mapping.push_back({.field = SightingField::Id, .column = choice.column});
    return options;
}

void requireIdentity(const SightingTable& table, std::string_view bytes, const std::string& subject,
                     const ReadOptions& options)
{
    if (!table.isIdentityUnclear)
        return;
    std::vector<Issue> issues{{Severity::Error, "id", {IssueId::RowsUnclear}}};
    for (const IdentityChoice& choice : identityChoices(bytes, subject, options, table)) {
        const std::string option = !choice.rows ? "--map id=" + printable(choice.column)
                                   : *choice.rows == RowIdentity::OneIceberg ? "--one-iceberg"
                                                                             : "--each-row";
        issues.push_back({Severity::Error,
                          option,
                          {IssueId::RowsWouldGive,
                           {countOf(choice.outcome.icebergs),
                            numberText(std::round(choice.outcome.fastest_mps * 100) / 100)}}});
    }
    throw Error(ErrorCode::InvalidInput, subject, std::move(issues));
}

} // namespace berg
