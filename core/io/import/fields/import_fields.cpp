#include "core/io/import/fields/import_fields.h"

#include "core/base/angles.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/earth/coordinates.h"
#include "core/io/import/fields/import_quantity.h"
#include "core/scenario/scenario.h"
#include "core/scenario/text_checks.h"
#include "core/tracking/iceberg_size.h"
#include "core/tracking/position_error.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <utility>

namespace berg {

namespace {

constexpr double kFastest_mps = 50;
/** Bytes of a text that are read; the texts of a track are copied for each of its points. */
constexpr std::size_t kLongestText = 500;

/** Whether the text is one that tables write for a missing value. */
bool isAbsent(std::string_view text)
{
    const std::string plain = plainName(text);
    constexpr std::array<std::string_view, 9> kWords{
        "na", "nan", "null", "none", "nil", "nul", "missing", "unknown", "notavailable"};
    return plain.empty() ? text.find_first_not_of("-. ?*/_\u2013\u2014") == std::string_view::npos
                         : std::ranges::find(kWords, plain) != kWords.end();
}

/** Reads degrees with a hemisphere before or behind: 62.4W is -62.4; -62.4W is rejected. */
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

/** Returns half the length of a size class, or nullopt for another text. */
std::optional<double> radiusOfClass(std::string_view size)
{
    const auto* const found = std::ranges::find(kIcebergSizes, plainName(size), &IcebergSize::code);
    return found == kIcebergSizes.end() ? std::nullopt : std::optional(found->length_m / 2);
}

/** Whether commas separate groups of three digits, as in 1,200, which may also mean 1.2. */
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

/** Notes values of one row that are left out or changed. */
class RowNotes
{
public:
    RowNotes(const RowRules& rules, std::size_t line) : m_noted(rules.noted), m_line(line) {}

    void add(IssueId what, const std::string& detail) const
    {
        if (m_noted != nullptr)
            m_noted->add({.line = m_line, .fault = what, .detail = cleanText(detail, 60)});
    }

private:
    Rejections* m_noted;
    std::size_t m_line;
};

/** Reads the optional numbers of a row and notes those that cannot be used as they are. */
class Numbers
{
public:
    Numbers(const FieldTexts& texts, const RowNotes& notes) : m_texts(texts), m_notes(notes) {}

    [[nodiscard]] std::optional<double> read(SightingField field, Dimension dimension,
                                             const Limits& limits) const
    {
        const std::string& text = m_texts.text(field);
        if (isAbsent(text))
            return std::nullopt;
        const std::optional<double> plain = number(text);
        const std::optional<ReadQuantity> quantity =
            plain ? std::optional(ReadQuantity{.value = *plain})
                  : quantityOf(text, dimension,
                               [this](std::string_view digits) { return number(digits); });
        const auto note = [&](IssueId what) {
            m_notes.add(what, nameOf(kSightingFieldNames, field) + ": " + text);
        };
        if (!quantity)
            note(IssueId::ValueLeftOut);
        if (!quantity || isNone(field, quantity->value))
            return std::nullopt;
        const double value =
            quantity->hasUnit ? quantity->value : quantity->value * m_texts.factor(field);
        if (outOfLimits(value, limits)) {
            note(IssueId::NumberLeftOut);
            return std::nullopt;
        }
        if (!quantity->isExact)
            note(IssueId::NumberInexact);
        return value;
    }

private:
    /** Whether the number stands for a missing value, as in AIS. */
    [[nodiscard]] bool isNone(SightingField field, double value) const
    {
        if (standsForNone(value))
            return true;
        if (field == SightingField::Speed)
            return value == 102.3 || value == 1023;
        return field == SightingField::Direction &&
               (value == 511 || value == 3600 || (value == 360 && m_texts.isAis(field)));
    }

    /** Reads a number; the place of the row must show what a comma among digits means. */
    [[nodiscard]] std::optional<double> number(std::string_view text) const
    {
        if (!isGrouped(text))
            return decimalOf(text);
        const std::string place =
            m_texts.text(SightingField::Latitude) + m_texts.text(SightingField::Longitude);
        if (place.find(',') != std::string::npos)
            return decimalOf(text);
        if (place.find('.') == std::string::npos)
            return std::nullopt;
        std::string digits(text);
        std::erase(digits, ',');
        return decimalOf(digits);
    }

    const FieldTexts& m_texts;
    const RowNotes& m_notes;
};

bool isLongId(std::string_view text)
{
    return cleanText(text, kLongestId + 1).size() > kLongestId;
}

/** Returns the id that fits best; notes one that had to be shortened. */
std::string idOf(const FieldTexts& texts, const RowNotes& notes)
{
    if (const std::string& text = texts.text(SightingField::Id); isLongId(text))
        notes.add(IssueId::IdShortened, text);
    return texts.ids().empty() ? std::string() : texts.ids().front().text;
}

/** Reads angles in degrees and minutes, as navigators write them, or returns nullopt. */
std::optional<LatLon> writtenPlace(const std::string& latitude, const std::string& longitude)
{
    // A latitude in the column of longitudes is an error, whatever its letter is.
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
    if (isAbsent(latitude) || isAbsent(longitude))
        return IssueId::NoPosition;
    const std::optional<double> north_deg = degreesOf(latitude, 'N', 'S');
    const std::optional<double> east_deg = degreesOf(longitude, 'E', 'W');
    const bool isAisNone = north_deg == 91 && east_deg == 181;
    if (isAisNone || standsForNone(north_deg.value_or(0)) || standsForNone(east_deg.value_or(0)))
        return IssueId::NoPosition;
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

/** Text such as " +02:00", to be appended to a time. */
std::string offsetText(std::chrono::minutes offset)
{
    const auto count = std::abs(offset.count());
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), " %c%02d:%02d", offset.count() < 0 ? '-' : '+',
                  static_cast<int>(count / 60), static_cast<int>(count % 60));
    return text.data();
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
    for (const char c : text.substr(0, most + 1)) // one more, to detect that it is cut
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

std::string shortened(std::string_view text, std::size_t most)
{
    constexpr std::size_t kDigits = 8;
    std::string number(kDigits, '0');
    constexpr std::size_t kMostHashed = 4096; // a long text may be repeated for each point
    std::uint64_t hash = stableHash(text.substr(0, kMostHashed));
    for (char& digit : number) {
        digit = "0123456789abcdef"[hash % 16];
        hash /= 16;
    }
    return cleanText(text, most - kDigits - 1) + ' ' + number;
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
        entry.isAis = false;
    }
    m_ids.clear();
}

void FieldTexts::set(const FieldUse& use, std::string_view text)
{
    Entry& entry = m_entries[static_cast<std::size_t>(use.field)];
    const std::string_view value = trimmed(text);
    if (use.field == SightingField::Id && !isAbsent(value))
        addId(use.rank, value);
    if (value.empty() || (!entry.text.empty() && entry.rank <= use.rank))
        return;
    entry.text.assign(value.substr(0, kLongestText));
    if (use.offset)
        entry.text = withZone(entry.text, *use.offset);
    entry.isAis = use.isAis;
    entry.factor = use.factor;
    entry.rank = use.rank;
}

void FieldTexts::addId(std::size_t rank, std::string_view text)
{
    const auto at = std::ranges::lower_bound(m_ids, rank, {}, &IdText::rank);
    if (at == m_ids.end() || at->rank != rank)
        m_ids.insert(at, {.rank = rank,
                          .text = isLongId(text) ? shortened(text, kLongestId)
                                                 : cleanText(text, kLongestId)});
}

void FieldTexts::append(const PlacePart& part, std::string_view text)
{
    std::string& whole = m_entries[static_cast<std::size_t>(part.field)].text;
    std::string_view value = trimmed(text);
    if (value.empty() || whole.empty())
        return;
    if (part.kind == PlacePart::Kind::Hemisphere)
        value = value.substr(0, 1);
    else if (whole.ends_with(".0") || whole.ends_with(",0")) // written for whole degrees or minutes
        whole.resize(whole.size() - 2);
    whole.append(1, ' ').append(value.substr(0, kLongestText));
    if (part.kind != PlacePart::Kind::Hemisphere)
        std::ranges::replace(whole, ',', '.');
}

std::string withZone(const std::string& time, std::chrono::minutes offset)
{
    const std::string zoned = time + offsetText(offset);
    const bool isTime = parseSightingTime(zoned, DateOrder::MonthFirst) ||
                        parseSightingTime(zoned, DateOrder::DayFirst) || parseTimeOfDay(zoned);
    return isTime ? zoned : time;
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
    const RowNotes notes(rules, line);
    const std::string time = timeText(texts, rules.timeApart);
    const bool hasTime = !isAbsent(time);
    if (hasTime)
        sighting.time = parseSightingTime(time, rules.order);
    if (!sighting.time && rules.timeNeeded)
        return hasTime ? rejected(IssueId::TimeUnreadable, time) : rejected(IssueId::NoTime);
    if (!sighting.time && hasTime)
        notes.add(IssueId::TimeLeftOut, time);
    else if (!sighting.time && rules.timeExpected)
        notes.add(IssueId::TimeNotGiven, {});
    sighting.id = idOf(texts, notes);
    sighting.name = cleanText(texts.text(SightingField::Name), kLongestName);
    sighting.ids = texts.ids();

    using enum Dimension;
    const Numbers numbers(texts, notes);
    sighting.speed_mps =
        numbers.read(SightingField::Speed, Speed, {.low = 0, .high = kFastest_mps});
    sighting.direction_deg =
        numbers.read(SightingField::Direction, Angle, {.low = -360, .high = 360});
    sighting.sigma_m2 = numbers.read(SightingField::Sigma, Area, limits::kSigma_m2);
    sighting.q_m2ps = numbers.read(SightingField::Growth, Growth, limits::kGrowth_m2ps);
    const Limits length_m = limits::kLength_m;
    const auto length = numbers.read(SightingField::Length, Length, length_m);
    const auto area = numbers.read(SightingField::Area, Area, {.low = 0, .high = 1e12});
    sighting.radius_m = numbers.read(SightingField::Radius, Length, length_m);
    if (!sighting.radius_m && length)
        sighting.radius_m = *length / 2;
    if (!sighting.radius_m && area)
        sighting.radius_m = std::sqrt(*area / kPi);
    if (!sighting.radius_m)
        sighting.radius_m = radiusOfClass(texts.text(SightingField::SizeClass));
    sighting.grounded = saysGrounded(texts.text(SightingField::Remarks));
    if (const auto source = sourceInWords(texts.text(SightingField::Source));
        source && !sighting.sigma_m2)
        sighting.sigma_m2 = errorOf(*source).sigma_m2();
    return sighting;
}

std::variant<Sighting, RejectedRow> sightingIn(SightingTable& table, const ImportText& source,
                                               const FieldTexts& texts, std::size_t line,
                                               bool timeNeeded)
{
    const std::string time = timeText(texts, false);
    if (!table.shownOrder)
        table.shownOrder = dateOrderOf(time);
    if (table.guessedDate.empty() && hasTwoReadings(time)) {
        table.guessedDate = cleanText(time, 60);
        table.guessedLine = line;
    }
    return sightingOf(texts,
                      {.order = source.dates.value_or(DateOrder::MonthFirst),
                       .timeNeeded = timeNeeded,
                       .noted = &table.noted},
                      line);
}

std::variant<Sighting, RejectedRow>
withDrift(SightingTable& table, std::variant<Sighting, RejectedRow> row, const DriftTexts& drift)
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
    const RowNotes notes({.noted = &table.noted}, sighting->line);
    if (east_mps && north_mps)
        sighting->drift_mps = Point(*east_mps, *north_mps);
    else
        notes.add(IssueId::NumberWrong, east_mps ? drift.north : drift.east);
    return row;
}

void addRow(SightingTable& table, std::variant<Sighting, RejectedRow> row, ReadBudget& budget)
{
    constexpr std::size_t kAfterwards = 120; // bytes to select, place and track it later
    auto* const sighting = std::get_if<Sighting>(&row);
    if (sighting == nullptr) {
        budget.takeRow(0);
        table.rejected.add(std::get<RejectedRow>(std::move(row)));
        return;
    }
    std::size_t candidates = 0;
    for (const IdText& id : sighting->ids)
        candidates += sizeof(IdText) + id.text.capacity();
    budget.takeRow(sizeof(Sighting) + kAfterwards + sighting->id.capacity() +
                   sighting->name.capacity() + candidates);
    table.sightings.push_back(std::move(*sighting));
}

void TrackIds::give(SightingTable& table, std::size_t first)
{
    if (first >= table.sightings.size())
        return;
    ++m_tracks;
    for (std::size_t i = first; i < table.sightings.size(); ++i)
        table.sightings[i].track = m_tracks;
    if (!table.sightings[first].id.empty())
        return;
    const std::optional<UtcTime>& time = table.sightings[first].time;
    std::string id = time ? "track " + utcText(*time, 0) : "track";
    if (const int number = ++m_numbers[id]; number > 1)
        id += ' ' + std::to_string(number);
    for (std::size_t i = first; i < table.sightings.size(); ++i)
        table.sightings[i].id = id;
}

} // namespace berg
