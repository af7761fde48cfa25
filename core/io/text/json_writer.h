#pragma once

// Private to core/io: all JSON output. Objects with members known in advance are built from texts,
// others as trees of the library; numbers and texts are written by the same functions.

#include "core/base/index.h"
#include "core/geometry/geometry.h"
#include "core/io/text/text_sink.h"

#include <nlohmann/json_fwd.hpp>

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** Returns a number as JSON text (`numberText`, but -0.0 for -0), or `null` if it is not finite. */
[[nodiscard]] std::string jsonText(double value);
template <std::integral Whole>
[[nodiscard]] std::string jsonText(Whole value)
{
    return std::to_string(value);
}
/** Returns the JSON text of a boolean. */
[[nodiscard]] std::string jsonText(bool value);
template <class Kind>
[[nodiscard]] std::string jsonText(Index<Kind> value)
{
    return jsonText(value.number());
}
/**
 * Returns the JSON text of a string: quoted and escaped, including terminal control characters;
 * bytes that are not UTF-8 become U+FFFD.
 */
[[nodiscard]] std::string jsonText(std::string_view value);
[[nodiscard]] std::string jsonText(const std::string& value);
[[nodiscard]] std::string jsonText(const char* value);
/** Returns the JSON text `[east, north]`. */
[[nodiscard]] std::string jsonText(const Point& value);

/**
 * Returns the JSON text of a tree: on one line if `indent` is negative, else one entry per line,
 * each level indented by `indent`. Doubles with whole values end in ".0", because geographic
 * programs take the type of a column from that.
 */
[[nodiscard]] std::string jsonText(const nlohmann::ordered_json& tree, int indent = -1);

/**
 * Takes a tree apart piece by piece at the end of a scope. The library's own destructor allocates
 * memory for that and ends the program if there is none.
 */
class JsonTreeGuard
{
public:
    explicit JsonTreeGuard(nlohmann::ordered_json& tree) : m_tree(tree) {}
    JsonTreeGuard(const JsonTreeGuard&) = delete;
    JsonTreeGuard& operator=(const JsonTreeGuard&) = delete;
    ~JsonTreeGuard();

private:
    nlohmann::ordered_json& m_tree;
};

/**
 * Returns the number of bytes of the UTF-8 character at the front, or 0 if there is no valid one.
 */
[[nodiscard]] std::size_t characterSize(std::string_view text);

/** Returns a JSON array `[a, b, c]` on one line; the entries are JSON texts. */
[[nodiscard]] std::string jsonArray(const std::vector<std::string>& entries);
/** Returns a JSON array with each entry on its own line, one blank further in than `indent`. */
[[nodiscard]] std::string jsonLines(const std::vector<std::string>& entries, int indent);

/**
 * Passes the text of `jsonLines` to `put` piece by piece; `text` makes each entry when it is due.
 */
template <class Entry>
void putJsonLines(const TextSink& put, const std::vector<Entry>& entries, int indent,
                  std::string (*text)(const Entry&))
{
    const std::string line = '\n' + std::string(static_cast<std::size_t>(indent), ' ');
    const char* before = "[";
    for (const Entry& entry : entries) {
        put(before + line + ' ' + text(entry));
        before = ",";
    }
    put(entries.empty() ? "[]" : line + ']');
}

/** Returns `text(entry)` for each entry of a list. */
template <class Entries, class Text>
[[nodiscard]] std::vector<std::string> textsOf(const Entries& entries, const Text& text)
{
    std::vector<std::string> texts;
    texts.reserve(entries.size());
    for (const auto& entry : entries)
        texts.push_back(text(entry));
    return texts;
}

/** Returns a JSON array of the values on one line. */
template <class T>
[[nodiscard]] std::string jsonArrayOf(const std::vector<T>& values)
{
    return jsonArray(textsOf(values, [](const T& value) { return jsonText(value); }));
}

/** Builds a JSON object; its members keep the order in which they are added. */
class JsonObject
{
public:
    template <class T>
    void add(std::string_view name, const T& value)
    {
        addText(name, jsonText(value));
    }
    /** Adds the member unless it has the fallback value, which readers assume. */
    template <class T>
    void addUnless(std::string_view name, const T& value, const T& fallback)
    {
        if (!(value == fallback))
            add(name, value);
    }
    /** Adds the member if it has a value. */
    template <class T>
    void addOptional(std::string_view name, const std::optional<T>& value)
    {
        if (value)
            add(name, *value);
    }
    /** Adds a member whose value is JSON text already. */
    void addText(std::string_view name, const std::string& json);
    /**
     * Adds the members of an `extraJson` text, which is empty or an object that is not empty;
     * throws `std::logic_error` for another text.
     */
    void addExtra(const std::string& object);

    /** Returns the object on one line. */
    [[nodiscard]] std::string inLine() const;
    /** Returns the object with one member per line and the braces at `indent`. */
    [[nodiscard]] std::string inLines(int indent) const;

private:
    std::vector<std::string> m_members;
};

} // namespace berg
