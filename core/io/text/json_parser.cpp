#include "core/io/text/byte_order_mark.h"
#include "core/io/text/json_reader.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace berg {

namespace {

constexpr std::size_t kDeepest = 64;
// Approximate memory of a value in a growing list, in multiples of its size: while the list grows
// there are two copies, one of them with room for as many values again.
constexpr std::size_t kGrowing = 3;
constexpr std::size_t kNodeMemory = sizeof(Members) + 40; ///< bytes of an object or array
constexpr std::size_t kNameMemory = 80;                   ///< bytes while the object is open

/** Heap memory of a text, bytes; short texts lie within the string object. */
std::size_t textMemory(const std::string& text)
{
    constexpr std::size_t kWithin = 15;
    return text.size() > kWithin ? text.size() + 16 : 0;
}

/** Returns line and column of a byte offset; columns count characters, not bytes. */
std::pair<std::int64_t, std::int64_t> placeOf(std::string_view text, std::size_t offset)
{
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t lineStart = before.find_last_of('\n') + 1; // npos + 1 is 0
    const auto column =
        std::count_if(before.begin() + static_cast<std::ptrdiff_t>(lineStart), before.end(),
                      [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
    return {line, column + 1};
}

/** Returns the message of the library without its prefix and without the raw text it last read. */
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
 * Builds the tree from the parser's events and checks what the library does not check: depth,
 * duplicate members and number of values.
 */
class TreeBuilder
{
public:
    /**
     * `wanted` is the only member of the root to read, after which reading stops; if it is empty,
     * all is read.
     */
    TreeBuilder(std::string_view text, ReadBudget& budget, std::string wanted = {})
        : m_text(text), m_budget(budget), m_wanted(std::move(wanted)), m_faults(&budget)
    {
    }

    [[nodiscard]] ParsedJson take() { return {std::move(m_root), std::move(m_faults)}; }
    [[nodiscard]] bool hasWanted() const { return m_hasWanted; }

    // The library calls this interface; each function returns whether to continue.
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
        m_budget.take(sizeof(std::string) + textMemory(value));
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
        m_budget.take(textMemory(name));
        takeWhileOpen(kNameMemory + textMemory(name));
        level.duplicate = !level.names.insert(name).second;
        level.name = std::move(name);
        if (level.duplicate)
            m_faults.add(path(), {IssueId::GivenTwice});
        return true;
    }
    bool parse_error(std::size_t position, const std::string& /*token*/,
                     const nlohmann::detail::exception& error)
    {
        constexpr int kNumberOverflow = 406;
        const auto [line, column] = placeOf(m_text, position > 0 ? position - 1 : 0);
        const bool isOverflow = error.id == kNumberOverflow;
        throw Error(ErrorCode::SyntaxError, m_budget.subject(),
                    {isOverflow ? IssueId::JsonNumber : IssueId::JsonSyntax,
                     {line, column, isOverflow ? path() : reasonText(error.what())}});
    }
    // NOLINTEND(readability-identifier-naming)

private:
    /** An object or array that is still open. */
    struct Level
    {
        bool isObject = false;
        bool duplicate = false; ///< whether the object already has the member being read
        std::string name;       ///< name of the member being read
        std::vector<std::pair<std::string, Json>> members;
        std::vector<Json> entries;
        std::unordered_set<std::string> names;
        std::size_t memory = 0; ///< bytes charged to the budget while this level is open
    };

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
            throw Error(ErrorCode::SyntaxError, m_budget.subject(),
                        {IssueId::JsonDepth, {countOf(kDeepest)}});
        m_levels.emplace_back().isObject = isObject;
        return true;
    }

    bool close()
    {
        Level level = std::move(m_levels.back());
        m_levels.pop_back();
        m_budget.take(kNodeMemory + level.entries.size() * sizeof(Json) +
                      level.members.size() * sizeof(Members::value_type));
        m_budget.release(level.memory);
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
        m_budget.takeValue();
        if (!m_levels.empty())
            takeWhileOpen(kGrowing *
                          (m_levels.back().isObject ? sizeof(Members::value_type) : sizeof(Json)));
        m_hasWanted = !m_wanted.empty() && m_levels.size() == 1 && m_levels[0].name == m_wanted;
        if (m_levels.empty() || m_hasWanted)
            m_root = std::move(value);
        else if (Level& level = m_levels.back(); !level.isObject)
            level.entries.push_back(std::move(value));
        else if (!level.duplicate)
            level.members.emplace_back(std::move(level.name), std::move(value));
        return !m_hasWanted;
    }

    void takeWhileOpen(std::size_t bytes)
    {
        m_levels.back().memory += bytes;
        m_budget.take(bytes);
    }

    std::string_view m_text;
    ReadBudget& m_budget;
    std::string m_wanted;
    bool m_hasWanted = false;
    std::vector<Level> m_levels;
    Json m_root;
    Faults m_faults;
};

/**
 * Removes a UTF-8 mark and rejects UTF-16, which some editors write and whose first bytes identify
 * it.
 */
std::string_view withoutMark(std::string_view text, const ReadBudget& budget)
{
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        throw Error(ErrorCode::WrongFormat, budget.subject(), {IssueId::Utf16});
    return withoutByteOrderMark(text);
}

} // namespace

/** Frees list by list, because the library would first gather all entries in one list. */
void release(Json& value)
{
    if (Members* const members = value.get_ptr<Json::object_t*>()) {
        for (auto& [name, member] : *members)
            release(member);
        Members().swap(*members);
    } else if (auto* const entries = value.get_ptr<Json::array_t*>()) {
        for (Json& entry : *entries)
            release(entry);
        Json::array_t().swap(*entries);
    }
}

ParsedJson::~ParsedJson()
{
    release(root);
}

ParsedJson parseJson(std::string_view text, ReadBudget& budget)
{
    TreeBuilder builder(withoutMark(text, budget), budget);
    require(Json::sax_parse(withoutMark(text, budget), &builder),
            "parseJson: stopped without a reason");
    return builder.take();
}

std::optional<std::string> rootText(std::string_view text, const std::string& member,
                                    ReadBudget& budget)
{
    TreeBuilder builder(withoutMark(text, budget), budget, member);
    Json::sax_parse(withoutMark(text, budget), &builder);
    const ParsedJson found = builder.take();
    if (!builder.hasWanted() || !found.root.is_string())
        return std::nullopt;
    return found.root.get<std::string>();
}

} // namespace berg
