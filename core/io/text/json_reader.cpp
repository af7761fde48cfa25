#include "core/io/text/json_reader.h"

#include "core/io/text/json_writer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace berg {

namespace {

constexpr std::size_t kMostFaults = 100;
constexpr std::int64_t kLargestWhole = std::int64_t{1} << 53;

/**
 * Returns nullopt if the value is not a whole number or exceeds what a double holds exactly. 5.0
 * and 1e3 are whole numbers too: JSON has only one kind of number.
 */
std::optional<std::int64_t> exactWhole(const Json& value)
{
    const auto number = value.is_number() ? value.get<double>() : 0.5;
    if (number != std::floor(number) || std::abs(number) > static_cast<double>(kLargestWhole))
        return std::nullopt;
    // The value is read as an integer, because 2^53 + 1 as a double is 2^53.
    const auto whole = value.get<std::int64_t>();
    return whole > kLargestWhole || whole < -kLargestWhole ? std::nullopt : std::optional(whole);
}

std::optional<IssueReason> formatFault(const Json* given, const std::string& wanted)
{
    if (given == nullptr || !given->is_string())
        return IssueReason{IssueId::NotFormat, {wanted}};
    const auto& text = given->get_ref<const std::string&>();
    if (text == wanted)
        return std::nullopt;
    return IssueReason{IssueId::OtherFormat, {wanted, printable(text)}};
}

std::optional<IssueReason> versionFault(const Json& given)
{
    if (!given.is_number())
        return IssueReason{IssueId::WrongType, {ValueKind::Number, kindOf(given)}};
    if (given.get<double>() == 1)
        return std::nullopt;
    return IssueReason{IssueId::UnknownVersion, {given.get<double>(), 1}};
}

} // namespace

void Faults::add(std::string field, IssueReason reason)
{
    if (m_issues.size() < kMostFaults)
        m_issues.push_back({Severity::Error, std::move(field), std::move(reason)});
    else
        ++m_notKept;
}

bool Faults::has(const std::string& field) const
{
    return std::any_of(m_issues.begin(), m_issues.end(),
                       [&](const Issue& issue) { return issue.field == field; });
}

void Faults::throwIfAny(const std::string& subject) const
{
    if (m_issues.empty())
        return;
    std::vector<Issue> issues = m_issues;
    if (m_notKept > 0)
        issues.push_back({Severity::Error, "", {IssueId::MoreFaults, {countOf(m_notKept)}}});
    throw Error(ErrorCode::InvalidInput, subject, std::move(issues));
}

void requireFormat(ParsedJson& file, std::string_view format, const std::string& subject)
{
    const std::string wanted(format);
    if (!file.root.is_object())
        throw Error(ErrorCode::WrongFormat, subject,
                    {IssueId::NoSuchFormat, {wanted, ValueKind::Object, kindOf(file.root)}});
    const auto given = file.root.find("format");
    if (auto fault = formatFault(given == file.root.end() ? nullptr : &*given, wanted))
        throw Error(ErrorCode::WrongFormat, subject,
                    {{Severity::Error, "format", std::move(*fault)}});
    const auto version = file.root.find("version");
    if (version == file.root.end()) {
        file.faults.add("version", {IssueId::Missing});
    } else if (auto fault = versionFault(*version)) {
        if (version->is_number())
            throw Error(ErrorCode::UnsupportedVersion, subject,
                        {{Severity::Error, "version", std::move(*fault)}});
        file.faults.add("version", std::move(*fault));
    }
}

void checkFormat(ObjectReader& object, std::string_view format)
{
    const auto note = [&object](const char* member, std::optional<IssueReason> fault) {
        std::string path = object.path(member);
        if (fault && !object.faults().has(path))
            object.faults().add(std::move(path), std::move(*fault));
    };
    if (const Json* given = object.find("format"))
        note("format", formatFault(given, std::string(format)));
    if (const Json* version = object.find("version"))
        note("version", versionFault(*version));
}

std::string memberPath(const std::string& object, const std::string& member)
{
    return object.empty() ? printable(member) : object + '.' + printable(member);
}

ValueKind kindOf(const Json& value)
{
    switch (value.type()) {
    case Json::value_t::null:
        return ValueKind::Null;
    case Json::value_t::object:
        return ValueKind::Object;
    case Json::value_t::array:
        return ValueKind::Array;
    case Json::value_t::string:
        return ValueKind::String;
    case Json::value_t::boolean:
        return value.get<bool>() ? ValueKind::True : ValueKind::False;
    case Json::value_t::number_integer:
    case Json::value_t::number_unsigned:
    case Json::value_t::number_float:
        return ValueKind::Number;
    case Json::value_t::binary:
    case Json::value_t::discarded:
        break;
    }
    throw std::logic_error("kindOf: no such type in a JSON text");
}

IssueArgument entriesOf(const Json& value)
{
    return value.is_array() ? countOf(value.size()) : IssueArgument(kindOf(value));
}

std::optional<double> numberOf(const Json& value, const std::string& path, Faults& faults,
                               const std::optional<Limits>& limits)
{
    faults.throwIfStopped();
    if (!value.is_number()) {
        faults.add(path, {IssueId::WrongType, {ValueKind::Number, kindOf(value)}});
        return std::nullopt;
    }
    const auto number = value.get<double>();
    std::optional<IssueReason> fault = limits ? outOfLimits(number, *limits) : std::nullopt;
    if (!fault)
        return number;
    faults.add(path, std::move(*fault));
    return std::nullopt;
}

std::optional<std::int64_t> wholeOf(const Json& value, const std::string& path, Faults& faults,
                                    const WholeLimits& limits)
{
    require(limits.low >= -kLargestWhole && limits.high <= kLargestWhole,
            "wholeOf: limits beyond what a double holds exactly");
    const std::optional<std::int64_t> whole = exactWhole(value);
    if (whole && *whole >= limits.low && *whole <= limits.high)
        return whole;
    faults.add(path, {IssueId::NotWhole,
                      {limits.low, limits.high,
                       value.is_number() ? IssueArgument(jsonText(value)) : kindOf(value)}});
    return std::nullopt;
}

std::optional<Point> pointOf(const Json& value, const std::string& path, Faults& faults)
{
    if (!value.is_array() || value.size() != 2) {
        faults.add(path, {IssueId::WrongType, {ValueKind::TwoNumbers, entriesOf(value)}});
        return std::nullopt;
    }
    const std::optional<double> east = numberOf(value[0], entryPath(path, 0), faults);
    const std::optional<double> north = numberOf(value[1], entryPath(path, 1), faults);
    if (!east || !north)
        return std::nullopt;
    return Point(*east, *north);
}

ObjectReader::ObjectReader(const Json& value, std::string path, Faults& faults)
    : m_object(value.is_object() ? &value : nullptr), m_path(std::move(path)), m_faults(&faults)
{
    faults.throwIfStopped();
    if (m_object == nullptr)
        faults.add(m_path, {IssueId::WrongType, {ValueKind::Object, kindOf(value)}});
}

std::string ObjectReader::path(std::string_view member) const
{
    return memberPath(m_path, std::string(member));
}

const Json* ObjectReader::find(const char* member)
{
    m_read.insert(member);
    if (m_object == nullptr)
        return nullptr;
    const auto it = m_object->find(member);
    return it == m_object->end() ? nullptr : &*it;
}

const Json* ObjectReader::need(const char* member)
{
    const Json* value = find(member);
    if (value == nullptr && m_object != nullptr)
        m_faults->add(path(member), {IssueId::Missing});
    return value;
}

const Json* ObjectReader::array(const char* member)
{
    const Json* value = find(member);
    if (value == nullptr || value->is_array())
        return value;
    m_faults->add(path(member), {IssueId::WrongType, {ValueKind::Array, kindOf(*value)}});
    return nullptr;
}

const Json* ObjectReader::neededArray(const char* member)
{
    return need(member) == nullptr ? nullptr : array(member);
}

double ObjectReader::number(const char* member, double fallback,
                            const std::optional<Limits>& limits)
{
    return optionalNumber(member, limits).value_or(fallback);
}

std::optional<double> ObjectReader::optionalNumber(const char* member,
                                                   const std::optional<Limits>& limits)
{
    const Json* value = find(member);
    return value == nullptr ? std::nullopt : numberOf(*value, path(member), *m_faults, limits);
}

std::int64_t ObjectReader::whole(const char* member, std::int64_t fallback,
                                 const WholeLimits& limits)
{
    const Json* value = find(member);
    if (value == nullptr)
        return fallback;
    return wholeOf(*value, path(member), *m_faults, limits).value_or(fallback);
}

bool ObjectReader::boolean(const char* member, bool fallback)
{
    const Json* value = find(member);
    if (value == nullptr)
        return fallback;
    if (!value->is_boolean()) {
        m_faults->add(path(member), {IssueId::WrongType, {ValueKind::Boolean, kindOf(*value)}});
        return fallback;
    }
    return value->get<bool>();
}

std::string ObjectReader::text(const char* member, std::string fallback)
{
    const Json* value = find(member);
    if (value == nullptr)
        return fallback;
    if (!value->is_string()) {
        m_faults->add(path(member), {IssueId::WrongType, {ValueKind::String, kindOf(*value)}});
        return fallback;
    }
    return value->get<std::string>();
}

Point ObjectReader::point(const char* member, const Point& fallback)
{
    const Json* value = find(member);
    return value == nullptr ? fallback
                            : pointOf(*value, path(member), *m_faults).value_or(fallback);
}

std::string ObjectReader::unknown() const
{
    // The text is written member by member: a copy of the values could be as large as the file.
    std::string text;
    if (m_object != nullptr)
        for (const auto& [name, value] : m_object->items()) {
            m_faults->throwIfStopped();
            if (!m_read.contains(name))
                text += (text.empty() ? '{' : ',') + jsonText(name) + ':' + jsonText(value);
        }
    return text.empty() ? text : text + '}';
}

} // namespace berg
