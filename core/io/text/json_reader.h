#pragma once

// Private to core/io: the one header that includes the JSON library.

#include "core/base/error.h"
#include "core/geometry/geometry.h"
#include "core/io/text/read_budget.h"
#include "core/plan/solve/names.h"
#include "core/scenario/text_checks.h"

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

/** JSON value whose members keep the order of the file. */
using Json = nlohmann::ordered_json;

/** Members of a JSON object. */
using Members = std::vector<Json::object_t::value_type>;

/**
 * Returns the members of an object, to append names that are known to be new without searching for
 * each.
 */
[[nodiscard]] inline Members& membersOf(Json& object)
{
    return object.get_ref<Json::object_t&>();
}

/**
 * Collects the faults of one file until all of it is read. Beyond a hundred they are only counted.
 */
class Faults
{
public:
    /**
     * `budget`, if not null, is checked for stop requests and charged for memory; it must outlive
     * this object.
     */
    explicit Faults(ReadBudget* budget = nullptr) : m_budget(budget) {}

    void add(std::string field, IssueReason reason);
    void add(Issue issue) { add(std::move(issue.field), std::move(issue.reason)); }
    [[nodiscard]] bool empty() const { return m_issues.empty(); }
    /** Returns true if one of the first hundred faults is of exactly this field. */
    [[nodiscard]] bool has(const std::string& field) const;
    /** Throws `Error{InvalidInput}` with all faults if there is any. */
    void throwIfAny(const std::string& subject) const;
    /** Throws `Stopped` if the budget's stop was requested. */
    void throwIfStopped() const
    {
        if (m_budget != nullptr)
            m_budget->throwIfStopped();
    }
    /** Charges the budget for the memory of objects made from the file. */
    void take(std::size_t bytes) const
    {
        if (m_budget != nullptr)
            m_budget->take(bytes);
    }

private:
    ReadBudget* m_budget;
    std::vector<Issue> m_issues;
    std::size_t m_notKept = 0; ///< faults beyond the hundredth
};

/**
 * Reserves memory for one entry per element of `list` (which may be null) and charges the budget
 * for it.
 */
template <class Entry>
void makeRoom(std::vector<Entry>& entries, const Json* list, const Faults& faults)
{
    const std::size_t count = list == nullptr ? 0 : list->size();
    faults.take(count * sizeof(Entry));
    entries.reserve(count);
}

/** Content of a file and the faults found so far (duplicate members). */
struct ParsedJson
{
    Json root;
    Faults faults;

    ~ParsedJson();
};

/**
 * Parses JSON by RFC 8259; a UTF-8 byte order mark is skipped. Throws `Error` SyntaxError with line
 * and column (UTF-16 is WrongFormat; comments, NaN, numbers beyond a double and nesting deeper than
 * 64 are syntax errors) and whatever the budget throws. `budget` must outlive the result. A member
 * given twice is a fault that names it.
 */
[[nodiscard]] ParsedJson parseJson(std::string_view text, ReadBudget& budget);

/**
 * Returns the text of a root member and reads no further, or nullopt if the root has no such member
 * or it is not a text. Throws as `parseJson`.
 */
[[nodiscard]] std::optional<std::string> rootText(std::string_view text, const std::string& member,
                                                  ReadBudget& budget);

/** Frees the memory of a value list by list; its lists and objects are empty afterwards. */
void release(Json& value);

/**
 * Checks `format` and `version` of a file. Throws `Error` WrongFormat if the root is not an object
 * of that format, UnsupportedVersion if the version is another number than 1. A version that is
 * missing or not a number is a fault.
 */
void requireFormat(ParsedJson& file, std::string_view format, const std::string& subject);

/** Returns the path of a member, e.g. `asset.name`; `object` is empty for the file's root. */
[[nodiscard]] std::string memberPath(const std::string& object, const std::string& member);

/** Returns the type of the value, for error texts. */
[[nodiscard]] ValueKind kindOf(const Json& value);
/** Returns the number of entries of a list, or the type of any other value, for "must be ..., not
 * ...". */
[[nodiscard]] IssueArgument entriesOf(const Json& value);

/** Range of a whole number, within +-2^53. */
struct WholeLimits
{
    std::int64_t low = 0;
    std::int64_t high = 0;
};

/**
 * Returns `value` as a number within the limits (any finite number without limits), or nullopt
 * after adding a fault for `path`.
 */
[[nodiscard]] std::optional<double> numberOf(const Json& value, const std::string& path,
                                             Faults& faults,
                                             const std::optional<Limits>& limits = {});
/**
 * Returns `value` as a whole number within the limits, or nullopt after adding a fault for `path`.
 */
[[nodiscard]] std::optional<std::int64_t> wholeOf(const Json& value, const std::string& path,
                                                  Faults& faults, const WholeLimits& limits);
/**
 * Returns `value` as a point of two numbers (east, north), or nullopt after adding a fault for
 * `path`.
 */
[[nodiscard]] std::optional<Point> pointOf(const Json& value, const std::string& path,
                                           Faults& faults);

/**
 * Reads one object of a file member by member. Every fault is added under the member's path and the
 * fallback returned, so that reading continues. Members that were never requested are `unknown()`.
 */
class ObjectReader
{
public:
    /**
     * Adds a fault if `value` is not an object; the reader then behaves like that of an empty
     * object.
     */
    ObjectReader(const Json& value, std::string path, Faults& faults);

    /** Returns the path of a member of this object, for faults. */
    [[nodiscard]] std::string path(std::string_view member) const;
    [[nodiscard]] Faults& faults() { return *m_faults; }
    [[nodiscard]] bool isObject() const { return m_object != nullptr; }

    /** Returns the member or null if it is missing, and marks it as read. */
    [[nodiscard]] const Json* find(const char* member);
    /** Returns the member; adds a fault and returns null if it is missing. */
    [[nodiscard]] const Json* need(const char* member);
    /** Returns the member if it is an array, null if it is missing; another type adds a fault. */
    [[nodiscard]] const Json* array(const char* member);
    /** Returns the member if it is an array; a missing one or another type adds a fault. */
    [[nodiscard]] const Json* neededArray(const char* member);

    /** The following return the value of a member, or `fallback` (nullopt) if missing or faulty. */
    [[nodiscard]] double number(const char* member, double fallback,
                                const std::optional<Limits>& limits = {});
    [[nodiscard]] std::optional<double> optionalNumber(const char* member,
                                                       const std::optional<Limits>& limits = {});
    [[nodiscard]] std::int64_t whole(const char* member, std::int64_t fallback,
                                     const WholeLimits& limits);
    [[nodiscard]] bool boolean(const char* member, bool fallback);
    [[nodiscard]] std::string text(const char* member, std::string fallback = {});
    [[nodiscard]] Point point(const char* member, const Point& fallback);

    /**
     * Returns the value that `names` gives the member's text, or `fallback` if the member is
     * missing. Any other text or type adds a fault and returns `fallback`.
     */
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

    /** Returns the JSON text of an object with the members that were not read, empty if there are
     * none. */
    [[nodiscard]] std::string unknown() const;

private:
    const Json* m_object; ///< null if the value is not an object
    std::string m_path;
    Faults* m_faults;
    std::set<std::string, std::less<>> m_read;
};

/**
 * Adds faults for a wrong `format` or `version` of an object inside a file; both may be missing.
 */
void checkFormat(ObjectReader& object, std::string_view format);

/** Returns `read(entry, path)` of every entry of a list member; an empty list if it is missing. */
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
