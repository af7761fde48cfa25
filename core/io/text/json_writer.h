#pragma once

// Private to core/io: all the JSON that is written. Objects with names known beforehand are made of
// texts, others as trees of the library; numbers and texts are written by the same functions.

#include "core/base/geometry.h"
#include "core/io/text/text_sink.h"

#include <nlohmann/json_fwd.hpp>

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** `numberText`; `null` when not finite. */
[[nodiscard]] std::string jsonText(double value);
template <std::integral Whole>
[[nodiscard]] std::string jsonText(Whole value)
{
    return std::to_string(value);
}
[[nodiscard]] std::string jsonText(bool value);
/** Quoted and escaped, also what terminals obey; bytes that are no UTF-8 become U+FFFD. */
[[nodiscard]] std::string jsonText(std::string_view value);
[[nodiscard]] std::string jsonText(const std::string& value);
[[nodiscard]] std::string jsonText(const char* value);
/** `[east, north]` */
[[nodiscard]] std::string jsonText(const Point& value);

/**
 * A tree on one line, or an entry a line, each level `indent` further in. Whole numbers that are
 * measurements, doubles, end in ".0": geographic programs take the type of a column from that.
 */
[[nodiscard]] std::string jsonText(const nlohmann::ordered_json& tree, int indent = -1);

/**
 * Takes a tree apart piece by piece at the end of a scope. The library's own destructor needs
 * memory for that, and ends the program where there is none.
 */
class Dismantled
{
public:
    explicit Dismantled(nlohmann::ordered_json& tree) : m_tree(tree) {}
    Dismantled(const Dismantled&) = delete;
    Dismantled& operator=(const Dismantled&) = delete;
    ~Dismantled();

private:
    nlohmann::ordered_json& m_tree;
};

/** Bytes of the UTF-8 character at the front, 0 when there is no valid one. */
[[nodiscard]] std::size_t characterSize(std::string_view text);

/** `[a, b, c]` on one line. */
[[nodiscard]] std::string jsonArray(const std::vector<std::string>& entries);
/** Each entry on its own line, one blank further in than `indent`. */
[[nodiscard]] std::string jsonLines(const std::vector<std::string>& entries, int indent);

/** The same in pieces, each entry made by `text` when its turn comes. */
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

/** Text of each entry of a list. */
template <class Entries, class Text>
[[nodiscard]] std::vector<std::string> textsOf(const Entries& entries, const Text& text)
{
    std::vector<std::string> texts;
    texts.reserve(entries.size());
    for (const auto& entry : entries)
        texts.push_back(text(entry));
    return texts;
}

template <class T>
[[nodiscard]] std::string jsonArrayOf(const std::vector<T>& values)
{
    return jsonArray(textsOf(values, [](const T& value) { return jsonText(value); }));
}

/** Members of one object in the order they are added. */
class JsonObject
{
public:
    template <class T>
    void add(std::string_view name, const T& value)
    {
        addText(name, jsonText(value));
    }
    template <class T>
    void addUnless(std::string_view name, const T& value, const T& fallback)
    {
        if (!(value == fallback))
            add(name, value);
    }
    /** Nothing when there is no value. */
    template <class T>
    void addOptional(std::string_view name, const std::optional<T>& value)
    {
        if (value)
            add(name, *value);
    }
    /** A value that is JSON text already. */
    void addText(std::string_view name, const std::string& json);
    /** The members of an `extraJson` text; empty adds nothing. */
    void addExtra(const std::string& object);

    [[nodiscard]] std::string inLine() const;
    /** One member per line, the braces at `indent`. */
    [[nodiscard]] std::string inLines(int indent) const;

private:
    std::vector<std::string> m_members;
};

} // namespace berg
