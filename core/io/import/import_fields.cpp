#include "core/io/import/import_fields.h"

#include "core/base/angles.h"
#include "core/base/coordinates.h"
#include "core/base/error.h"
#include "core/scenario/checks.h"
#include "core/scenario/scenario.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace berg {

namespace {

constexpr double kFastest_mps = 50;
/** Bytes of a text that are looked at: those of a track are copied for each of its points. */
constexpr std::size_t kLongestText = 500;

/** What tables write where there is no value. */
bool isAbsent(std::string_view text)
{
    const std::string plain = plainName(text);
    return plain.empty() ? text.find_first_not_of("-. ") == std::string_view::npos
                         : plain == "na" || plain == "nan" || plain == "null" || plain == "none";
}

/** Degrees with the letter of a hemisphere before or behind: 62.4W is -62.4; -62.4W is nothing,
 * because sign and letter may both be meant. */
std::optional<double> degreesOf(std::string_view text, char positive, char negative)
{
    double sign = 1;
    const auto takesLetter = [&](char c) {
        const char letter = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        if (letter == negative)
            sign = -1;
        return letter == negative || letter == positive;
    };
    const std::size_t whole = text.size();
    if (!text.empty() && takesLetter(text.back()))
        text.remove_suffix(1);
    else if (!text.empty() && takesLetter(text.front()))
        text.remove_prefix(1);
    const std::string_view number = trimmed(text);
    const bool hasSign = number.starts_with('-') || number.starts_with('+');
    const std::optional<double> value = decimalOf(number);
    if (!value || (hasSign && text.size() < whole))
        return std::nullopt;
    return sign * *value;
}

/** Half the middle of the length of a class (FIELD-NOTES, section 4); the open class its least. */
std::optional<double> radiusOfClass(std::string_view size)
{
    struct Class
    {
        std::string_view name;
        double length_m;
    };
    constexpr std::array kClasses = {Class{"gr", 2.5}, Class{"bb", 10},  Class{"sm", 37.5},
                                     Class{"med", 90}, Class{"lg", 160}, Class{"vlg", 200}};
    const std::string plain = plainName(size);
    const auto it = std::find_if(kClasses.begin(), kClasses.end(),
                                 [&](const Class& c) { return c.name == plain; });
    return it == kClasses.end() ? std::nullopt : std::optional(it->length_m / 2);
}

/** Digits in groups of three set apart by commas, as 1,200 is, which may be 1.2 as well. */
bool isGrouped(std::string_view text)
{
    const std::string_view digits = text.substr(text.starts_with('-') || text.starts_with('+'));
    const std::size_t first = digits.find(',');
    if (first == std::string_view::npos || first < 1 || first > 3 || (digits.size() - first) % 4)
        return false;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        const bool comma = i >= first && (i - first) % 4 == 0;
        if (comma ? digits[i] != ',' : digits[i] < '0' || digits[i] > '9')
            return false;
    }
    return true;
}

/** Reads the numbers of a row; remembers the first that is wrong. */
class Numbers
{
public:
    explicit Numbers(const FieldTexts& texts) : m_texts(texts) {}

    [[nodiscard]] std::optional<double> read(SightingField field, const Limits& limits)
    {
        const std::string& text = m_texts.text(field);
        if (isAbsent(text))
            return std::nullopt;
        std::optional<double> value = number(text);
        if (value)
            *value *= m_texts.factor(field);
        if (value && !outOfLimits(*value, limits))
            return value;
        if (m_wrong.empty()) {
            const bool isComma = !value && isGrouped(text);
            m_wrong = isComma ? text : nameOf(kSightingFieldNames, field) + (": " + text);
            m_fault = isComma ? IssueId::DecimalComma
                      : value ? IssueId::NumberWrong
                              : IssueId::NotANumber;
        }
        return std::nullopt;
    }
    /** Field and text of the first number that was wrong, empty when none was. */
    [[nodiscard]] const std::string& wrong() const { return m_wrong; }
    [[nodiscard]] IssueId fault() const { return m_fault; }

private:
    /** What a comma among digits means is told by the place of the row; by nothing, it is wrong. */
    [[nodiscard]] std::optional<double> number(const std::string& text) const
    {
        if (!isGrouped(text))
            return decimalOf(text);
        const std::string place =
            m_texts.text(SightingField::Latitude) + m_texts.text(SightingField::Longitude);
        if (place.find(',') != std::string::npos)
            return decimalOf(text);
        if (place.find('.') == std::string::npos)
            return std::nullopt;
        std::string digits = text;
        std::erase(digits, ',');
        return decimalOf(digits);
    }

    const FieldTexts& m_texts;
    std::string m_wrong;
    IssueId m_fault = IssueId::NumberWrong;
};

/** Of angles in degrees and minutes, as they are written at sea; none: they cannot be read. */
std::optional<LatLon> writtenPlace(const std::string& latitude, const std::string& longitude)
{
    // A latitude in the column of longitudes is a mistake, whatever its letter says.
    if (latitude.find_first_of("EWVewv") != std::string::npos ||
        longitude.find_first_of("NSns") != std::string::npos)
        return std::nullopt;
    const std::variant<LatLon, CoordinateFault> read = parsePlace(latitude + ", " + longitude);
    const LatLon* place = std::get_if<LatLon>(&read);
    return place == nullptr ? std::nullopt : std::optional(*place);
}

std::optional<IssueId> readPlace(const FieldTexts& texts, LatLon& place)
{
    const std::string& latitude = texts.text(SightingField::Latitude);
    const std::string& longitude = texts.text(SightingField::Longitude);
    if (latitude.empty() || longitude.empty())
        return IssueId::NoPosition;
    const std::optional<double> north_deg = degreesOf(latitude, 'N', 'S');
    const std::optional<double> east_deg = degreesOf(longitude, 'E', 'W');
    if (!north_deg || !east_deg)
        if (const std::optional<LatLon> written = writtenPlace(latitude, longitude)) {
            place = *written;
            return std::nullopt;
        }
    if (!north_deg || std::abs(*north_deg) > 90)
        return IssueId::LatitudeWrong;
    if (!east_deg || *east_deg < -180 || *east_deg > 360)
        return IssueId::LongitudeWrong;
    place = {.latitude_deg = *north_deg,
             .longitude_deg = *east_deg >= 180 ? *east_deg - 360 : *east_deg};
    return std::nullopt;
}

bool saysGrounded(std::string_view remarks)
{
    return plainName(remarks).find("ground") != std::string::npos;
}

} // namespace

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view kBlanks = " \t\r\n\v\f";
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string cleanText(std::string_view given, std::size_t most)
{
    std::string_view text = trimmed(given);
    constexpr std::string_view kFormulaStarts = "=+-@";
    if (text.size() > 1 && text[0] == '\'' && kFormulaStarts.find(text[1]) != std::string::npos)
        text.remove_prefix(1); // `csvField`
    std::string clean;
    for (const char c : text.substr(0, most + 1)) // one more tells whether it is cut
        clean += static_cast<unsigned char>(c) < 0x20U || c == 0x7F ? ' ' : c;
    std::size_t end = std::min(clean.size(), most);
    while (end > 0 && end < clean.size() &&
           (static_cast<unsigned char>(clean[end]) & 0xC0U) == 0x80U)
        --end;
    clean.resize(end);
    if (!isUtf8(clean))
        for (char& c : clean)
            c = static_cast<unsigned char>(c) >= 0x80U ? '?' : c;
    return clean;
}

std::optional<double> decimalOf(std::string_view text)
{
    std::string copy(text.substr(0, 64));
    if (text.size() > copy.size() || copy.empty())
        return std::nullopt;
    if (copy.find('.') == std::string::npos && std::count(copy.begin(), copy.end(), ',') == 1)
        std::replace(copy.begin(), copy.end(), ',', '.');
    const char* first = copy.data();
    const char* const last = first + copy.size();
    if (*first == '+' && copy.size() > 1 && copy[1] != '-')
        ++first;
    double value = 0;
    const auto [end, error] = std::from_chars(first, last, value);
    if (error != std::errc() || end != last || !std::isfinite(value))
        return std::nullopt;
    return value;
}

void FieldTexts::clear()
{
    for (Entry& entry : m_entries) {
        entry.text.clear();
        entry.factor = 1;
        entry.rank = 0;
    }
}

void FieldTexts::set(const FieldUse& use, std::string_view text)
{
    Entry& entry = m_entries[static_cast<std::size_t>(use.field)];
    const std::string_view value = trimmed(text);
    if (value.empty() || (!entry.text.empty() && entry.rank <= use.rank))
        return;
    entry.text.assign(value.substr(0, kLongestText));
    entry.factor = use.factor;
    entry.rank = use.rank;
}

void FieldTexts::append(const PlacePart& part, std::string_view text)
{
    std::string& whole = m_entries[static_cast<std::size_t>(part.field)].text;
    std::string_view value = trimmed(text);
    if (value.empty() || whole.empty())
        return;
    if (part.kind == PlacePart::Kind::Hemisphere)
        value = value.substr(0, 1);
    else if (whole.ends_with(".0") || whole.ends_with(",0")) // of whole degrees or minutes
        whole.resize(whole.size() - 2);
    whole.append(1, ' ').append(value.substr(0, kLongestText));
    if (part.kind != PlacePart::Kind::Hemisphere)
        std::ranges::replace(whole, ',', '.');
}

std::string timeText(const FieldTexts& texts, bool timeApart)
{
    const std::string& date = texts.text(SightingField::Date);
    const std::string& time = texts.text(SightingField::Time);
    const bool whole = parseSightingTime(time, DateOrder::MonthFirst) ||
                       parseSightingTime(time, DateOrder::DayFirst);
    if (whole || (!timeApart && isAbsent(date)))
        return time;
    if (isAbsent(date) || isAbsent(time))
        return timeApart ? std::string() : date;
    return date + ' ' + time;
}

std::variant<Sighting, RejectedRow> sightingOf(const FieldTexts& texts, const RowRules& rules,
                                               std::size_t line)
{
    const auto rejected = [&](IssueId fault, const std::string& detail = {}) {
        return RejectedRow{.line = line, .fault = fault, .detail = cleanText(detail, 60)};
    };
    Sighting sighting;
    sighting.line = line;
    if (const std::optional<IssueId> fault = readPlace(texts, sighting.place)) {
        if (*fault == IssueId::NoPosition)
            return rejected(*fault);
        return rejected(*fault,
                        texts.text(*fault == IssueId::LatitudeWrong ? SightingField::Latitude
                                                                    : SightingField::Longitude));
    }
    const std::string time = timeText(texts, rules.timeApart);
    if (!isAbsent(time)) {
        sighting.time = parseSightingTime(time, rules.order);
        if (!sighting.time)
            return rejected(IssueId::TimeUnreadable, time);
    } else if (rules.timeNeeded) {
        return rejected(IssueId::NoTime);
    }
    sighting.id = cleanText(texts.text(SightingField::Id), kLongestId + 1);
    if (sighting.id.size() > kLongestId)
        return rejected(IssueId::IdTooLong, sighting.id);
    sighting.name = cleanText(texts.text(SightingField::Name), kLongestName);

    Numbers numbers(texts);
    sighting.speed_mps = numbers.read(SightingField::Speed, {.low = 0, .high = kFastest_mps});
    sighting.direction_deg = numbers.read(SightingField::Direction, {.low = -360, .high = 360});
    sighting.sigma_m2 = numbers.read(SightingField::Sigma, limits::kSigma_m2);
    sighting.q_m2ps = numbers.read(SightingField::Growth, limits::kGrowth_m2ps);
    const Limits length_m = limits::kLength_m;
    const auto length = numbers.read(SightingField::Length, length_m);
    const auto area = numbers.read(SightingField::Area, {.low = 0, .high = 1e12});
    sighting.radius_m = numbers.read(SightingField::Radius, length_m);
    if (!numbers.wrong().empty())
        return rejected(numbers.fault(), numbers.wrong());
    if (!sighting.radius_m && length)
        sighting.radius_m = *length / 2;
    if (!sighting.radius_m && area)
        sighting.radius_m = std::sqrt(*area / kPi);
    if (!sighting.radius_m)
        sighting.radius_m = radiusOfClass(texts.text(SightingField::SizeClass));
    sighting.grounded = saysGrounded(texts.text(SightingField::Remarks));
    return sighting;
}

std::variant<Sighting, RejectedRow> sightingIn(SightingTable& table, const ImportText& source,
                                               const FieldTexts& texts, std::size_t line,
                                               bool timeNeeded)
{
    const std::string time = timeText(texts, false);
    if (!table.toldDates)
        table.toldDates = dateOrderOf(time);
    if (table.guessedDate.empty() && hasTwoReadings(time)) {
        table.guessedDate = cleanText(time, 60);
        table.guessedLine = line;
    }
    return sightingOf(
        texts, {.order = source.dates.value_or(DateOrder::MonthFirst), .timeNeeded = timeNeeded},
        line);
}

std::variant<Sighting, RejectedRow> withDrift(std::variant<Sighting, RejectedRow> row,
                                              const DriftTexts& drift)
{
    auto* const sighting = std::get_if<Sighting>(&row);
    if (sighting == nullptr || (drift.east.empty() && drift.north.empty()))
        return row;
    const auto component = [](const std::string& text) {
        const std::optional<double> value = decimalOf(trimmed(text));
        return value && std::abs(*value) <= kFastest_mps ? value : std::nullopt;
    };
    const std::optional<double> east_mps = component(drift.east);
    const std::optional<double> north_mps = component(drift.north);
    if (!east_mps || !north_mps)
        return RejectedRow{.line = sighting->line,
                           .fault = IssueId::NumberWrong,
                           .detail = cleanText(east_mps ? drift.north : drift.east, 60)};
    sighting->drift_mps = Point(*east_mps, *north_mps);
    return row;
}

void addRow(SightingTable& table, std::variant<Sighting, RejectedRow> row, ReadBudget& budget)
{
    constexpr std::size_t kAfterwards = 120; // to choose, to place and to follow it
    auto* const sighting = std::get_if<Sighting>(&row);
    if (sighting == nullptr) {
        budget.takeRow(0);
        table.rejected.add(std::get<RejectedRow>(std::move(row)));
        return;
    }
    budget.takeRow(sizeof(Sighting) + kAfterwards + sighting->id.capacity() +
                   sighting->name.capacity());
    table.sightings.push_back(std::move(*sighting));
}

void TrackIds::give(SightingTable& table, std::size_t first)
{
    if (first >= table.sightings.size() || !table.sightings[first].id.empty())
        return;
    const std::optional<UtcTime>& time = table.sightings[first].time;
    std::string id = time ? "track " + utcText(*time, 0) : "track";
    if (const int number = ++m_numbers[id]; number > 1)
        id += ' ' + std::to_string(number);
    for (std::size_t i = first; i < table.sightings.size(); ++i)
        table.sightings[i].id = id;
}

void decideIdentity(SightingTable& table)
{
    std::deque<Sighting>& rows = table.sightings;
    const bool isNamed = std::ranges::all_of(rows, [](const Sighting& row) {
        return row.id.empty() && !row.name.empty() && row.name.size() <= kLongestId;
    });
    if (isNamed && std::ranges::any_of(
                       rows, [&](const Sighting& row) { return row.name != rows.front().name; }))
        for (Sighting& row : rows)
            row.id = std::exchange(row.name, {});
    const bool unnamed = std::all_of(rows.begin(), rows.end(), [](const Sighting& row) {
        return row.id.empty() && row.time.has_value();
    });
    table.oneIceberg = unnamed && std::any_of(rows.begin(), rows.end(), [&](const Sighting& row) {
                           return *row.time != *rows.front().time;
                       });
}

} // namespace berg
