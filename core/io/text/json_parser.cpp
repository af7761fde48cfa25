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

// What reading may take: ten times the file and 50 MB, of which the file itself is one.
constexpr std::size_t kMemoryPerByte = 9;
constexpr std::size_t kMemoryBeside = 50'000'000;
// About what a value takes in a list that is read, and while it grows: then there are two of it,
// one of them with room for as many again.
constexpr std::size_t kGrowing = 3;
constexpr std::size_t kNodeMemory = sizeof(Members) + 40; ///< of an object or array
constexpr std::size_t kNameMemory = 80;                   ///< while the object is open

/** Of a text: short ones lie within the string. */
std::size_t textMemory(const std::string& text)
{
    constexpr std::size_t kWithin = 15;
    return text.size() > kWithin ? text.size() + 16 : 0;
}

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

/** Lists go one after another: the library would first gather all of their entries in one. */
void release(Json& value)
{
    if (value.is_object()) {
        for (auto& [name, member] : membersOf(value))
            release(member);
        Members().swap(membersOf(value));
    } else if (value.is_array()) {
        Json::array_t& entries = value.get_ref<Json::array_t&>();
        for (Json& entry : entries)
            release(entry);
        Json::array_t().swap(entries);
    }
}

/**
 * Builds the tree from the parser's events and checks what the library does not: depth, duplicate
 * members, number of values.
 */
class TreeBuilder
{
public:
    TreeBuilder(std::string_view text, const std::string& subject, const std::stop_token& stop)
        : m_text(text)
        , m_subject(subject)
        , m_stop(stop)
        , m_mostMemory(kMemoryPerByte * text.size() + kMemoryBeside)
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
    bool string(std::string& value)
    {
        take(sizeof(std::string) + textMemory(value));
        return add(std::move(value));
    }
    bool binary(Json::binary_t& /*value*/) { return false; }
    bool start_object(std::size_t /*size*/) { return open(true); }
    bool end_object() { return close(); }
    bool start_array(std::size_t /*size*/) { return open(false); }
    bool end_array() { return close(); }
    bool key(std::string& name)
    {
        Level& level = m_levels.back();
        take(textMemory(name));
        takeWhileOpen(kNameMemory + textMemory(name));
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
        std::size_t memory = 0; ///< that it takes while it is open, given back then
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
            text = level.isObject ? memberPath(text, level.name.empty() ? "\"\"" : level.name)
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
        take(kNodeMemory + level.entries.size() * sizeof(Json) +
             level.members.size() * sizeof(Members::value_type));
        m_memory -= level.memory;
        level.entries.shrink_to_fit();
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
        if (!m_levels.empty())
            takeWhileOpen(kGrowing *
                          (m_levels.back().isObject ? sizeof(Members::value_type) : sizeof(Json)));
        if (m_levels.empty())
            m_root = std::move(value);
        else if (Level& level = m_levels.back(); !level.isObject)
            level.entries.push_back(std::move(value));
        else if (!level.duplicate)
            level.members.emplace_back(std::move(level.name), std::move(value));
        return true;
    }

    /** Counts what is kept of the file. */
    void take(std::size_t bytes)
    {
        constexpr std::size_t kMegabyte = 1'000'000;
        m_memory += bytes;
        if (m_memory > m_mostMemory)
            throw Error(ErrorCode::FileTooLarge, m_subject,
                        "holds so many small values that reading it takes more than the " +
                            std::to_string(m_mostMemory / kMegabyte) +
                            " MB that a file of this size may: split it, or leave out what is "
                            "empty");
    }

    void takeWhileOpen(std::size_t bytes)
    {
        m_levels.back().memory += bytes;
        take(bytes);
    }

    std::string_view m_text;
    const std::string& m_subject;
    const std::stop_token& m_stop;
    std::size_t m_memory = 0; ///< taken by what is kept
    std::size_t m_mostMemory;
    std::vector<Level> m_levels;
    std::size_t m_values = 0;
    Json m_root;
    Faults m_faults;
};

} // namespace

ParsedJson::~ParsedJson()
{
    release(root);
}

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
