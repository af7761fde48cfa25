#pragma once

// Private to core/io: the one header that knows the JSON library.

#include "core/base/error.h"
#include "core/base/geometry.h"
#include "core/io/text/read_budget.h"
#include "core/plan/solve/names.h"
#include "core/scenario/checks.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** Members in the order of the file. */
using Json = nlohmann::ordered_json;

using Members = std::vector<Json::object_t::value_type>;

/** Members of an object, to append names known to be new without a search for each of them. */
[[nodiscard]] inline Members& membersOf(Json& object)
{
    return object.get_ref<Json::object_t&>();
}

/** Faults of one file, gathered until all of it is read. Beyond a hundred they are only counted. */
class Faults
{
public:
    /** `budget`, when not null, is asked whether to go on; it must live as long. */
    explicit Faults(ReadBudget* budget = nullptr) : m_budget(budget) {}

    void add(std::string field, IssueReason reason);
    void add(Issue issue) { add(std::move(issue.field), std::move(issue.reason)); }
    [[nodiscard]] bool empty() const { return m_issues.empty(); }
    /** True when a fault of exactly this field was noted. */
    [[nodiscard]] bool has(const std::string& field) const;
    /** Throws `Error{InvalidInput}` with all of them when there is one. */
    void throwIfAny(const std::string& subject) const;
    /** Throws `Stopped` when the reading is to end. */
    void goOn() const
    {
        if (m_budget != nullptr)
            m_budget->goOn();
    }
    /** Memory of what is made of the file. */
    void take(std::size_t bytes) const
    {
        if (m_budget != nullptr)
            m_budget->take(bytes);
    }

private:
    ReadBudget* m_budget;
    std::vector<Issue> m_issues;
    std::size_t m_notKept = 0;
};

/** Makes room for what is made of the list's entries, counted as memory of the reading. */
template <class Entry>
void makeRoom(std::vector<Entry>& entries, const Json* list, const Faults& faults)
{
    const std::size_t count = list == nullptr ? 0 : list->size();
    faults.take(count * sizeof(Entry));
    entries.reserve(count);
}

/** A file's content and the faults found so far (duplicate members). */
struct ParsedJson
{
    Json root;
    Faults faults;

    ~ParsedJson();
};

/**
 * Parses JSON as RFC 8259 has it; a UTF-8 byte order mark is skipped. Throws `Error` SyntaxError
 * with line and column (byte order, comments, NaN, numbers no double can hold, nesting deeper than
 * 64), and what the budget throws, which must outlive the result. A member given twice is a fault
 * that names it.
 */
[[nodiscard]] ParsedJson parseJson(std::string_view text, ReadBudget& budget);

/** A member of the root that is a text, read no further; none without one. Errors as above. */
[[nodiscard]] std::optional<std::string> rootText(std::string_view text, const std::string& member,
                                                  ReadBudget& budget);

/** Gives the memory of a value back, list by list; those are empty then. */
void release(Json& value);

/**
 * Checks `format` and `version` of a file. Throws WrongFormat when it is not an object of that
 * format, UnsupportedVersion when it is not version 1.
 */
void requireFormat(ParsedJson& file, std::string_view format, const std::string& subject);

/** Path of a member: `asset.name`; `object` is empty for the file's root. */
[[nodiscard]] std::string memberPath(const std::string& object, const std::string& member);

[[nodiscard]] ValueKind kindOf(const Json& value);
/** For "must be ..., not ...": how many entries it has, what it is when it is no list. */
[[nodiscard]] IssueArgument entriesOf(const Json& value);

/** A whole number's range, within +-2^53. */
struct WholeLimits
{
    std::int64_t low = 0;
    std::int64_t high = 0;
};

/** `value` as a number in the limits (any finite number without them); a fault otherwise. */
[[nodiscard]] std::optional<double> numberOf(const Json& value, const std::string& path,
                                             Faults& faults,
                                             const std::optional<Limits>& limits = {});
[[nodiscard]] std::optional<std::int64_t> wholeOf(const Json& value, const std::string& path,
                                                  Faults& faults, const WholeLimits& limits);
/** Two numbers, east and north. */
[[nodiscard]] std::optional<Point> pointOf(const Json& value, const std::string& path,
                                           Faults& faults);

/**
 * One object of a file read member by member. Every fault is noted under the member's path and the
 * fallback returned, so that reading goes on. Members never asked for are `unknown()`.
 */
class ObjectReader
{
public:
    /** When `value` is no object, that is noted and the reader stands for an empty one. */
    ObjectReader(const Json& value, std::string path, Faults& faults);

    [[nodiscard]] std::string path(std::string_view member) const;
    [[nodiscard]] Faults& faults() { return *m_faults; }
    [[nodiscard]] bool isObject() const { return m_object != nullptr; }

    /** The member, null when it is missing. Counts as read. */
    [[nodiscard]] const Json* find(const char* member);
    /** The same, and a missing one is a fault. */
    [[nodiscard]] const Json* need(const char* member);
    /** The member when it is an array; another type is a fault. */
    [[nodiscard]] const Json* array(const char* member);
    /** The same, and a missing one is a fault. */
    [[nodiscard]] const Json* neededArray(const char* member);

    [[nodiscard]] double number(const char* member, double fallback,
                                const std::optional<Limits>& limits = {});
    [[nodiscard]] std::optional<double> optionalNumber(const char* member,
                                                       const std::optional<Limits>& limits = {});
    [[nodiscard]] std::int64_t whole(const char* member, std::int64_t fallback,
                                     const WholeLimits& limits);
    [[nodiscard]] bool boolean(const char* member, bool fallback);
    [[nodiscard]] std::string text(const char* member, std::string fallback = {});
    [[nodiscard]] Point point(const char* member, const Point& fallback);

    template <class Enum, std::size_t Size>
    [[nodiscard]] Enum choice(const char* member, Enum fallback,
                              const std::array<Named<Enum>, Size>& names)
    {
        const Json* value = find(member);
        if (value == nullptr)
            return fallback;
        std::optional<Enum> chosen;
        if (value->is_string())
            chosen = valueOf(names, value->get_ref<const std::string&>());
        if (!chosen)
            m_faults->add(path(member), {IssueId::NotOneOf, {allowedNames(names)}});
        return chosen.value_or(fallback);
    }

    /** Text of an object with the members that were not read, empty when there are none. */
    [[nodiscard]] std::string unknown() const;

private:
    const Json* m_object; ///< null: was no object
    std::string m_path;
    Faults* m_faults;
    std::set<std::string, std::less<>> m_read;
};

/** As `requireFormat`, of an object inside a file, which may lack both: what is wrong is a fault.
 */
void checkFormat(ObjectReader& object, std::string_view format);

/** What `read` makes of each entry of a list, given the entry and its path; none without one. */
template <class Read>
[[nodiscard]] auto readEach(ObjectReader& object, const char* member, const Read& read)
{
    std::vector<decltype(read(Json(), std::string()))> entries;
    const Json* list = object.array(member);
    makeRoom(entries, list, object.faults());
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i)
        entries.push_back(read((*list)[i], entryPath(object.path(member), i)));
    return entries;
}

} // namespace berg
