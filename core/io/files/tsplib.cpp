#include "core/io/files/tsplib.h"

#include "core/io/files/tsplib_weights.h"
#include "core/io/text/byte_order_mark.h"
#include "core/io/text/json_reader.h"
#include "core/io/text/text_encoding.h"
#include "core/io/text/text_lines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

namespace berg {

namespace {

constexpr Limits kEdgeWeight{.low = 0, .high = kLargestProblemNumber};
constexpr std::string_view kEnd = "EOF";
constexpr std::string_view kSectionEnding = "_SECTION";
constexpr std::string_view kComment = "COMMENT";
constexpr std::string_view kNodes = "NODE_COORD_SECTION";
constexpr std::string_view kWeights = "EDGE_WEIGHT_SECTION";
/**
 * Other sections belong to tasks that are not solved here, such as tours with fixed edges, and are
 * rejected.
 */
constexpr std::array kSections{kNodes, kWeights, std::string_view("DISPLAY_DATA_SECTION")};
constexpr std::array<std::string_view, 9> kEntries{"NAME",
                                                   kComment,
                                                   "TYPE",
                                                   "DIMENSION",
                                                   "EDGE_WEIGHT_TYPE",
                                                   "EDGE_WEIGHT_FORMAT",
                                                   "NODE_COORD_TYPE",
                                                   "DISPLAY_DATA_TYPE",
                                                   "CAPACITY"};

enum class ProblemType : std::uint8_t
{
    Symmetric,
    Asymmetric
};
constexpr std::array<Named<ProblemType>, 2> kProblemTypes{{
    {ProblemType::Symmetric, "TSP"},
    {ProblemType::Asymmetric, "ATSP"},
}};

/** Limits of the two coordinates of a node. */
std::array<Limits, 2> coordinateLimits(TsplibWeight type)
{
    constexpr Limits kLatitude{.low = -90, .high = 90};
    constexpr Limits kLongitude{.low = -360, .high = 360};
    constexpr Limits kPlane{.low = -kLargestProblemNumber, .high = kLargestProblemNumber};
    return type == TsplibWeight::Geographic ? std::array{kLatitude, kLongitude}
                                            : std::array{kPlane, kPlane};
}

std::string lineField(std::size_t line, std::string_view what = {})
{
    return "line " + std::to_string(line) + (what.empty() ? "" : ", " + std::string(what));
}

bool isKeyword(std::string_view word)
{
    return word.ends_with(kSectionEnding) || std::ranges::find(kEntries, word) != kEntries.end();
}

/** Returns the first word of the line, up to a blank or colon. */
std::string_view keywordOf(std::string_view line)
{
    const std::string_view word = takeWord(line);
    return word.substr(0, word.find(':'));
}

bool isBlankOrComment(std::string_view line)
{
    const std::string_view word = takeWord(line);
    return word.empty() || word.starts_with('#');
}

class TsplibReading
{
public:
    TsplibReading(std::string_view text, ReadBudget& budget) : m_budget(budget), m_faults(&budget)
    {
        split(text);
    }

    ProblemFile take()
    {
        static_cast<void>(choice("TYPE", kProblemTypes, ProblemType::Symmetric));
        const std::optional<TsplibWeight> type = choice("EDGE_WEIGHT_TYPE", kTsplibWeightNames);
        const std::optional<Eigen::Index> nodes = dimension();
        ProblemFile file{
            .problem = {.distance_m = {}, .sigma_m2 = {}, .mu = 1, .route = Route::Closed},
            .tau = {},
            .hints = std::move(m_hints),
            .isTsplib = true};
        if (type && nodes) {
            m_budget.take(static_cast<std::size_t>(*nodes * *nodes) * sizeof(double));
            file.problem.sigma_m2.assign(static_cast<std::size_t>(*nodes), 0.0);
            file.problem.distance_m =
                *type == TsplibWeight::Explicit ? readWeights(*nodes) : readPlaces(*nodes, *type);
        }
        m_faults.throwIfAny(m_budget.subject());
        return file;
    }

private:
    struct Entry
    {
        std::size_t line = 0;
        std::string_view value;
    };
    struct Section
    {
        std::size_t line = 0; ///< line of the name of the section
        std::string_view rows;
    };

    /** Finds entries and sections; their content is read when all are known. */
    void split(std::string_view rest)
    {
        Section* open = nullptr;
        for (std::size_t number = 1; !rest.empty(); ++number) {
            m_budget.throwIfStopped();
            const std::string_view before = rest;
            const std::string_view line = takeLine(rest);
            const std::string_view word = keywordOf(line);
            if (word == kEnd)
                return;
            if (isEntryOrSection(line, word))
                open = begin(number, word, line);
            else if (open != nullptr)
                extend(*open, before.substr(0, before.size() - rest.size()));
            else if (!isBlankOrComment(line))
                throw Error(ErrorCode::SyntaxError, m_budget.subject(),
                            {{Severity::Error,
                              lineField(number),
                              {IssueId::NotFormat, {"KEYWORD: value"}}}});
        }
    }

    /**
     * Whether a line is an entry or section of the format, or looks like an entry: capitals and a
     * colon.
     */
    static bool isEntryOrSection(std::string_view line, std::string_view word)
    {
        constexpr std::string_view kCapitals = "ABCDEFGHIJKLMNOPQRSTUVWXYZ_";
        if (isKeyword(word))
            return true;
        const bool isGlued = takeWord(line).size() > word.size();
        const bool hasColon = isGlued || takeWord(line).starts_with(':');
        return hasColon && !word.empty() &&
               word.find_first_not_of(kCapitals) == std::string_view::npos;
    }

    /**
     * Stores the name of an entry or section. Returns the section that it opens, or null for an
     * entry.
     */
    Section* begin(std::size_t number, std::string_view word, std::string_view line)
    {
        const std::string name(word);
        if (m_entries.contains(name) || m_sections.contains(name))
            m_faults.add(lineField(number, name), {IssueId::GivenTwice});
        if (std::ranges::find(kSections, word) != kSections.end())
            return &(m_sections[name] = {.line = number, .rows = {}});
        if (word.ends_with(kSectionEnding)) {
            m_faults.add(lineField(number, printable(word)),
                         {IssueId::NotOneOf, {joined(kSections, ", ")}});
            return &(m_refused = {.line = number, .rows = {}});
        }
        if (!isKeyword(word)) {
            if (m_hints.empty())
                m_hints.push_back({Severity::Hint,
                                   lineField(number),
                                   {IssueId::UnknownMembers, {printable(word)}}});
        } else if (word != kComment) { // a file may have several comments
            m_entries[name] = {.line = number, .value = valueOfLine(line)};
        }
        return nullptr;
    }

    /** Returns the first word after the name of an entry. */
    static std::string_view valueOfLine(std::string_view line)
    {
        const std::size_t colon = line.find(':');
        if (colon != std::string_view::npos)
            line.remove_prefix(colon + 1);
        else
            static_cast<void>(takeWord(line));
        return takeWord(line);
    }

    /** Appends a row, which must directly follow the section's rows in the text. */
    static void extend(Section& section, std::string_view row)
    {
        const char* const first = section.rows.empty() ? row.data() : section.rows.data();
        section.rows = {first, section.rows.size() + row.size()};
    }

    /** Returns the value of a required entry, or null after adding a fault. */
    const Entry* needed(const std::string& name)
    {
        const auto found = m_entries.find(name);
        if (found != m_entries.end() && !found->second.value.empty())
            return &found->second;
        m_faults.add(found == m_entries.end() ? name : lineField(found->second.line, name),
                     {IssueId::Missing});
        return nullptr;
    }

    /** Returns the value that `names` gives an entry, or `usual` if the entry is missing. */
    template <class Enum, std::size_t Size>
    std::optional<Enum> choice(const std::string& name, const std::array<Named<Enum>, Size>& names,
                               std::optional<std::type_identity_t<Enum>> usual = {})
    {
        if (usual && !m_entries.contains(name))
            return usual;
        const Entry* const entry = needed(name);
        if (entry == nullptr)
            return std::nullopt;
        const std::optional<Enum> value = valueOf(names, entry->value);
        if (!value)
            m_faults.add(lineField(entry->line, name), {IssueId::NotOneOf, {allowedNames(names)}});
        return value;
    }

    std::optional<Eigen::Index> dimension()
    {
        const std::string name = "DIMENSION";
        const Entry* const entry = needed(name);
        return entry == nullptr ? std::nullopt
                                : wholeNumber(entry->value, lineField(entry->line, name),
                                              Eigen::Index{kMostProblemNodes});
    }

    /** Reads a whole number from 1 to `most`, or returns nullopt after adding a fault. */
    std::optional<Eigen::Index> wholeNumber(std::string_view word, const std::string& field,
                                            Eigen::Index most)
    {
        Eigen::Index value = 0;
        const auto [last, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (failure == std::errc() && last == word.data() + word.size() && value >= 1 &&
            value <= most)
            return value;
        m_faults.add(field,
                     {IssueId::NotWhole, {std::int64_t{1}, std::int64_t{most}, printable(word)}});
        return std::nullopt;
    }

    /** Reads a number within limits, or returns 0 after adding a fault for this line. */
    double number(std::string_view word, const Limits& limits, std::size_t line)
    {
        std::string_view digits = word;
        if (digits.starts_with('+'))
            digits.remove_prefix(1);
        double value = 0;
        const auto [last, failure] =
            std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (failure != std::errc() || last != digits.data() + digits.size() ||
            !std::isfinite(value)) {
            m_faults.add(lineField(line), {IssueId::NotANumber, {printable(word)}});
            return 0;
        }
        if (std::optional<IssueReason> fault = outOfLimits(value, limits)) {
            m_faults.add(lineField(line), std::move(*fault));
            return 0;
        }
        return value;
    }

    const Section* neededSection(std::string_view name)
    {
        const auto found = m_sections.find(std::string(name));
        if (found != m_sections.end())
            return &found->second;
        m_faults.add(std::string(name), {IssueId::Missing});
        return nullptr;
    }

    void expectCount(const Section& section, std::string_view name, std::size_t expected,
                     std::size_t given)
    {
        if (given != expected)
            m_faults.add(lineField(section.line, name),
                         {IssueId::EntryCount, {countOf(expected), countOf(given)}});
    }

    /** Calls `take` with each row of a section that is not blank, and its line number. */
    template <class Take>
    void forEachRow(const Section& section, const Take& take)
    {
        std::string_view rest = section.rows;
        for (std::size_t line = section.line + 1; !rest.empty(); ++line) {
            m_budget.throwIfStopped();
            const std::string_view row = takeLine(rest);
            if (!isBlankOrComment(row))
                take(row, line);
        }
    }

    Eigen::MatrixXd readWeights(Eigen::Index nodes)
    {
        Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(nodes, nodes);
        const std::optional<TsplibMatrix> part = choice("EDGE_WEIGHT_FORMAT", kTsplibMatrixNames);
        const Section* const section = neededSection(kWeights);
        if (!part || section == nullptr)
            return weights;
        TsplibCells cells(*part, nodes);
        std::size_t given = 0;
        forEachRow(*section, [&](std::string_view row, std::size_t line) {
            for (std::string_view word = takeWord(row); !word.empty(); word = takeWord(row)) {
                m_budget.throwIfStopped();
                ++given;
                if (cells.atEnd())
                    continue;
                if (cells.row() != cells.column()) { // the diagonal may hold anything
                    const double weight = number(word, kEdgeWeight, line);
                    weights(cells.row(), cells.column()) = weight;
                    if (*part != TsplibMatrix::Full)
                        weights(cells.column(), cells.row()) = weight;
                }
                cells.advance();
            }
        });
        expectCount(*section, kWeights, cells.count(), given);
        return weights;
    }

    Eigen::MatrixXd readPlaces(Eigen::Index nodes, TsplibWeight type)
    {
        Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(nodes, nodes);
        const Section* const section = neededSection(kNodes);
        if (section == nullptr)
            return weights;
        const std::array<Limits, 2> limits = coordinateLimits(type);
        std::vector<std::optional<Point>> places(static_cast<std::size_t>(nodes));
        std::size_t given = 0;
        forEachRow(*section, [&](std::string_view row, std::size_t line) {
            ++given;
            readPlace(row, line, limits, places);
        });
        if (given < places.size()) // with too many rows, one has a wrong node number
            expectCount(*section, kNodes, places.size(), given);
        if (!m_faults.empty())
            return weights;
        for (Eigen::Index j = 0; j < nodes; ++j) {
            m_budget.throwIfStopped();
            for (Eigen::Index i = 0; i < j; ++i)
                weights(i, j) = weights(j, i) =
                    tsplibWeight(*places[static_cast<std::size_t>(i)],
                                 *places[static_cast<std::size_t>(j)], type);
        }
        return weights;
    }

    /** Reads a row: the number of a node, from 1, and its two coordinates. */
    void readPlace(std::string_view row, std::size_t line, const std::array<Limits, 2>& limits,
                   std::vector<std::optional<Point>>& places)
    {
        constexpr std::size_t kColumns = 3;
        std::array<std::string_view, kColumns> words;
        std::size_t count = 0;
        for (std::string_view word = takeWord(row); !word.empty(); word = takeWord(row), ++count) {
            m_budget.throwIfStopped();
            if (count < kColumns)
                words.at(count) = word;
        }
        if (count != kColumns) {
            m_faults.add(lineField(line),
                         {IssueId::EntryCount, {countOf(kColumns), countOf(count)}});
            return;
        }
        const std::optional<Eigen::Index> node =
            wholeNumber(words[0], lineField(line), static_cast<Eigen::Index>(places.size()));
        const Point place(number(words[1], limits[0], line), number(words[2], limits[1], line));
        if (!node)
            return;
        std::optional<Point>& kept = places[static_cast<std::size_t>(*node - 1)];
        if (kept)
            m_faults.add(lineField(line, printable(words[0])), {IssueId::GivenTwice});
        kept = place;
    }

    ReadBudget& m_budget;
    Faults m_faults;
    std::vector<Issue> m_hints;
    std::map<std::string, Entry> m_entries;
    std::map<std::string, Section> m_sections;
    Section m_refused; ///< receives the rows of rejected sections
};

} // namespace

bool isTsplib(std::string_view text, std::string_view path)
{
    if (path.ends_with(".tsp") || path.ends_with(".atsp"))
        return true;
    text = withoutByteOrderMark(text);
    while (!text.empty()) {
        const std::string_view line = takeLine(text);
        if (!isBlankOrComment(line))
            return isKeyword(keywordOf(line));
    }
    return false;
}

ProblemFile problemFromTsplib(std::string_view text, const std::string& subject,
                              const std::stop_token& stop)
{
    ReadBudget budget(subject, text.size(), stop);
    if (isUtf16(text))
        throw Error(ErrorCode::WrongFormat, subject, {IssueId::Utf16});
    ProblemFile file = TsplibReading(withoutByteOrderMark(text), budget).take();
    if (std::vector<Issue> issues = validate(file.problem); !issues.empty())
        throw Error(ErrorCode::InvalidInput, subject, std::move(issues));
    return file;
}

} // namespace berg
