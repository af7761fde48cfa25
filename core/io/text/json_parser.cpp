#include "core/base/stopped.h"
#include "core/io/text/atomic_file.h"
#include "core/io/text/json_reader.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace berg {

namespace {

constexpr std::size_t kDeepest = 64;
constexpr std::size_t kMostValues = 10'000'000;

/** "line 3, column 7" of a byte offset; columns count characters, not bytes. */
std::string placeText(std::string_view text, std::size_t offset)
{
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t lineStart = before.find_last_of('\n') + 1; // npos + 1 is 0
    const auto column =
        std::count_if(before.begin() + static_cast<std::ptrdiff_t>(lineStart), before.end(),
                      [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
    return "line " + std::to_string(line) + ", column " + std::to_string(column + 1);
}

/** The library's words without its prefix and without the raw text it last read. */
std::string reasonText(std::string message)
{
    const std::size_t quote = message.find("; last read: '");
    if (quote != std::string::npos) {
        const std::size_t expected = message.rfind("; expected ");
        const bool tail = expected != std::string::npos && expected > quote;
        message = message.substr(0, quote) + (tail ? message.substr(expected) : "");
    }
    const std::size_t start = message.find("syntax error");
    return start == std::string::npos ? message : message.substr(start);
}

/**
 * Builds the tree from the parser's events and checks what the library does not: depth, duplicate
 * members, number of values.
 */
class TreeBuilder
{
public:
    TreeBuilder(std::string_view text, const std::string& subject, const std::stop_token& stop)
        : m_text(text), m_subject(subject), m_stop(stop)
    {
    }

    [[nodiscard]] ParsedJson take() { return {std::move(m_root), std::move(m_faults)}; }

    // The interface the library calls; each returns whether to go on.
    // NOLINTBEGIN(readability-identifier-naming): the names are the library's
    bool null() { return add(nullptr); }
    bool boolean(bool value) { return add(value); }
    bool number_integer(Json::number_integer_t value) { return add(value); }
    bool number_unsigned(Json::number_unsigned_t value) { return add(value); }
    bool number_float(Json::number_float_t value, const std::string& /*text*/)
    {
        return add(value);
    }
    bool string(std::string& value) { return add(std::move(value)); }
    bool binary(Json::binary_t& /*value*/) { return false; }
    bool start_object(std::size_t /*size*/) { return open(true); }
    bool end_object() { return close(); }
    bool start_array(std::size_t /*size*/) { return open(false); }
    bool end_array() { return close(); }
    bool key(std::string& name)
    {
        Level& level = m_levels.back();
        level.duplicate = !level.names.insert(name).second;
        level.name = std::move(name);
        if (level.duplicate)
            m_faults.add(path(), "appears more than once");
        return true;
    }
    bool parse_error(std::size_t position, const std::string& /*token*/,
                     const nlohmann::detail::exception& error)
    {
        constexpr int kNumberOverflow = 406;
        const std::string reason = error.id == kNumberOverflow
                                       ? path() + ": a number too large for this program"
                                       : reasonText(error.what());
        fail(position > 0 ? position - 1 : 0, reason);
    }
    // NOLINTEND(readability-identifier-naming)

private:
    /** An object or array that is still open. */
    struct Level
    {
        bool isObject = false;
        bool duplicate = false; ///< the member being read was there before
        std::string name;       ///< of the member being read
        std::vector<std::pair<std::string, Json>> members;
        std::vector<Json> entries;
        std::unordered_set<std::string> names;
    };

    [[noreturn]] void fail(std::size_t offset, const std::string& reason) const
    {
        throw Error(ErrorCode::SyntaxError, m_subject, placeText(m_text, offset) + ": " + reason);
    }

    /** Path of the value being read. */
    [[nodiscard]] std::string path() const
    {
        std::string text;
        for (const Level& level : m_levels)
            text = level.isObject ? memberPath(text, level.name)
                                  : entryPath(text, level.entries.size());
        return text;
    }

    bool open(bool isObject)
    {
        if (m_levels.size() >= kDeepest)
            throw Error(ErrorCode::SyntaxError, m_subject,
                        "nested deeper than " + std::to_string(kDeepest) + " levels");
        m_levels.emplace_back().isObject = isObject;
        return true;
    }

    bool close()
    {
        Level level = std::move(m_levels.back());
        m_levels.pop_back();
        if (!level.isObject)
            return add(std::move(level.entries));
        Json object = Json::object();
        Members& members = membersOf(object);
        members.reserve(level.members.size());
        for (auto& [name, value] : level.members)
            members.emplace_back(std::move(name), std::move(value));
        return add(std::move(object));
    }

    bool add(Json value)
    {
        throwIfStopped(m_stop);
        if (++m_values > kMostValues)
            throw Error(ErrorCode::FileTooLarge, m_subject,
                        "holds more than " + std::to_string(kMostValues) + " values");
        if (m_levels.empty())
            m_root = std::move(value);
        else if (Level& level = m_levels.back(); !level.isObject)
            level.entries.push_back(std::move(value));
        else if (!level.duplicate)
            level.members.emplace_back(std::move(level.name), std::move(value));
        return true;
    }

    std::string_view m_text;
    const std::string& m_subject;
    const std::stop_token& m_stop;
    std::vector<Level> m_levels;
    std::size_t m_values = 0;
    Json m_root;
    Faults m_faults;
};

} // namespace

ParsedJson parseJson(std::string_view text, const std::string& subject, const std::stop_token& stop)
{
    if (text.size() > kLargestFile)
        throw Error(ErrorCode::FileTooLarge, subject,
                    "is larger than " + std::to_string(kLargestFile >> 20U) + " MiB");
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(kByteOrderMark))
        text.remove_prefix(kByteOrderMark.size());
    TreeBuilder builder(text, subject, stop);
    require(Json::sax_parse(text, &builder), "parseJson: stopped without a reason");
    return builder.take();
}

} // namespace berg
