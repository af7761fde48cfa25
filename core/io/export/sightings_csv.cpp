#include "core/io/export/sightings_csv.h"

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/tracking/iceberg_size.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>
#include <set>

namespace berg {

namespace {

constexpr std::string_view kIipHeader =
    "ICEBERG_YEAR,ICEBERG_NUMBER,SIGHTING_DATE,SIGHTING_TIME,SIGHTING_LATITUDE,SIGHTING_LONGITUDE,"
    "SIGHTING_METHOD,SIZE,SHAPE,SOURCE\n";
constexpr std::string_view kUnknownClass = "GEN";
constexpr int kLargestNumber = 999'999;

/** Returns the whole number that the text is, without leading zeros, or nullopt. */
std::optional<int> plainNumber(std::string_view text)
{
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool isRead = error == std::errc() && end == text.data() + text.size();
    return isRead && value > 0 && value <= kLargestNumber && text.front() != '0'
               ? std::optional(value)
               : std::nullopt;
}

/** A date with the season of the Ice Patrol, which begins in October. */
struct SeasonDate
{
    std::chrono::year_month_day day;
    int season = 0;
};

SeasonDate seasonDateOf(UtcTime time)
{
    const std::chrono::year_month_day day(std::chrono::floor<std::chrono::days>(time));
    const bool isNext = day.month() >= std::chrono::October;
    return {.day = day, .season = static_cast<int>(day.year()) + (isNext ? 1 : 0)};
}

/** Returns the numbers of the icebergs, by index. */
std::vector<int> iipNumbers(std::span<const Iceberg> icebergs, int season)
{
    const std::string prefix = std::to_string(season) + '-';
    std::vector<int> numbers(icebergs.size(), 0);
    std::set<int> taken;
    for (std::size_t i = 0; i < icebergs.size(); ++i) {
        std::string_view id = icebergs[i].id;
        if (id.starts_with(prefix))
            id.remove_prefix(prefix.size());
        const std::optional<int> number = plainNumber(id);
        if (number && taken.insert(*number).second)
            numbers[i] = *number;
    }
    int next = 1;
    for (int& number : numbers) {
        if (number > 0)
            continue;
        while (taken.contains(next))
            ++next;
        number = next++;
    }
    return numbers;
}

std::string iipDate(std::chrono::year_month_day day)
{
    char text[32];
    std::snprintf(text, sizeof text, "%02u/%02u/%04d", static_cast<unsigned>(day.month()),
                  static_cast<unsigned>(day.day()), static_cast<int>(day.year()));
    return text;
}

/** Returns the row of one sighting. */
std::string iipRow(const Iceberg& iceberg, int number, UtcTime time, const LatLon& place)
{
    constexpr int kDecimals = 5; // a metre
    const UtcTime minute = std::chrono::round<std::chrono::minutes>(time);
    const SeasonDate date = seasonDateOf(minute);
    const auto minutes = std::chrono::duration_cast<std::chrono::minutes>(
                             minute - std::chrono::floor<std::chrono::days>(minute))
                             .count();
    return std::to_string(date.season) + ',' + std::to_string(number) + ',' + iipDate(date.day) +
           ',' + std::to_string(100 * (minutes / 60) + minutes % 60) + ',' +
           fixedText(place.latitude_deg, kDecimals) + ',' +
           fixedText(place.longitude_deg, kDecimals) + ",VIS," + sizeCodeOf(iceberg) + ',' +
           std::string(kUnknownClass) + ",UAV\n";
}

} // namespace

std::string sizeCodeOf(const Iceberg& iceberg)
{
    const bool isGuess = iceberg.radius_m == Iceberg{}.radius_m;
    if (!iceberg.length_m && isGuess)
        return std::string(kUnknownClass);
    std::string code(sizeOfLength(iceberg.length_m.value_or(2 * iceberg.radius_m)).code);
    std::ranges::transform(code, code.begin(),
                           [](char c) { return static_cast<char>(c - 'a' + 'A'); });
    return code;
}

void writeSightings(const ExportContent& content, const TextSink& put)
{
    if (content.mission == nullptr)
        throw Error(ErrorCode::InvalidInput, "format", {IssueId::NothingFlown});
    if (!content.start)
        throw Error(ErrorCode::InvalidInput, "format", {IssueId::SightingsNoStart});
    const Mission& mission = *content.mission;
    const std::vector<Iceberg>& icebergs = mission.icebergs();
    const std::vector<int> numbers = iipNumbers(icebergs, seasonDateOf(*content.start).season);
    put(kIipHeader);
    IcebergReader reader = mission.recorder().reader();
    std::vector<bool> wasInView(icebergs.size(), false);
    for (std::size_t row = 0; row < mission.recorder().samples().size(); ++row) {
        const UtcTime time = *content.start + std::chrono::milliseconds(std::llround(
                                                  1000 * mission.recorder().samples()[row].time_s));
        const std::vector<IcebergSample>& now = reader.at(row);
        for (std::size_t i = 0; i < now.size(); ++i) {
            const bool isInView = now[i].active && now[i].inView;
            if (isInView && !wasInView[i])
                put(iipRow(icebergs[i], numbers[i], time,
                           content.frame.toGeographic(now[i].truth_m)));
            wasInView[i] = isInView;
        }
    }
}

} // namespace berg
