#pragma once

// Files of sightings whose meaning is known by construction. Nothing here uses the readers: texts
// and numbers are formatted by this file's own code.

#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace berg::test {

/** One place of a file. */
struct KnownPlace
{
    std::size_t berg = 0; ///< index in `KnownFile::bergs`
    double latitude_deg = 0;
    double longitude_deg = 0;
    std::optional<std::int64_t> time_s; ///< seconds since 1970, UTC
    std::size_t row = 0;                ///< line, feature or packet of the file
    bool isGood = true;                 ///< otherwise it must be listed, or left out with a note
    /** Whether another value of the row cannot be read, which must be listed. */
    bool isSpoilt = false;
};

/** An iceberg that drifts uniformly. */
struct KnownBerg
{
    std::string id;
    double latitude_deg = 0; ///< position at `KnownFile::start_s`
    double longitude_deg = 0;
    double east_mps = 0;
    double north_mps = 0;
    bool givesVelocity = false; ///< whether its last row states speed and direction

    [[nodiscard]] double speed_mps() const { return std::hypot(east_mps, north_mps); }
};

/** Meaning and form of a file. */
struct KnownFile
{
    std::string name;
    std::string bytes;
    std::vector<std::string> traits; ///< its special features
    std::vector<KnownBerg> bergs;
    std::vector<KnownPlace> places;
    std::int64_t start_s = 0;
    std::string idColumn;
    std::string timeColumn;
    double rounding_m = 1;    ///< rounding of places
    double rounding_s = 0;    ///< rounding of times
    bool hasIds = true;       ///< whether it states the iceberg of each place
    bool hasOneName = false;  ///< whether all tracks have the same name
    bool isAmbiguous = false; ///< whether a reader may refuse it, or warn

    void trait(std::string text) { traits.push_back(std::move(text)); }
};

/** Random choices, the same on every machine. */
class KnownChooser
{
public:
    explicit KnownChooser(std::uint64_t seed) : m_engine(seed) {}

    /** Returns a number from 0 to below `count`. */
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(m_engine() % count); }
    bool once(std::size_t in) { return below(in) == 0; }
    double real(double low, double high)
    {
        return low + (high - low) * static_cast<double>(m_engine() >> 11U) / 9007199254740992.0;
    }
    template <class List>
    const auto& of(const List& list)
    {
        return list[below(list.size())];
    }

private:
    std::mt19937_64 m_engine;
};

template <class... Values>
std::string formatted(const char* pattern, Values... values)
{
    std::array<char, 400> text{};
    std::snprintf(text.data(), text.size(), pattern, values...);
    return text.data();
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

/** Parts of a UTC time. */
struct Calendar
{
    int year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0, dayOfYear = 0;
};

inline Calendar calendarOf(std::int64_t time_s)
{
    using namespace std::chrono;
    const sys_days date = floor<days>(sys_seconds(seconds(time_s)));
    const year_month_day ymd(date);
    const auto rest = time_s - date.time_since_epoch().count() * 86400;
    return {.year = static_cast<int>(ymd.year()),
            .month = static_cast<int>(static_cast<unsigned>(ymd.month())),
            .day = static_cast<int>(static_cast<unsigned>(ymd.day())),
            .hour = static_cast<int>(rest / 3600),
            .minute = static_cast<int>(rest / 60 % 60),
            .second = static_cast<int>(rest % 60),
            .dayOfYear = static_cast<int>((date - sys_days(ymd.year() / January / 1)).count()) + 1};
}

inline std::string isoText(std::int64_t time_s)
{
    const Calendar c = calendarOf(time_s);
    return formatted("%04d-%02d-%02dT%02d:%02d:%02dZ", c.year, c.month, c.day, c.hour, c.minute,
                     c.second);
}

/** Returns where an iceberg is at a time; metres by a sphere are near enough within a day. */
inline KnownPlace knownPlaceAt(const KnownFile& file, std::size_t berg, std::int64_t time_s)
{
    constexpr double kDegree_m = 111'195;
    const KnownBerg& known = file.bergs[berg];
    const auto since_s = static_cast<double>(time_s - file.start_s);
    const double cosine = std::cos(known.latitude_deg * 0.017453292519943295);
    double longitude_deg = known.longitude_deg + known.east_mps * since_s / (kDegree_m * cosine);
    if (longitude_deg >= 180)
        longitude_deg -= 360;
    else if (longitude_deg < -180)
        longitude_deg += 360;
    return {.berg = berg,
            .latitude_deg = known.latitude_deg + known.north_mps * since_s / kDegree_m,
            .longitude_deg = longitude_deg,
            .time_s = time_s};
}

/** Adds icebergs within some tens of kilometres, in one of six seas without land near by. */
inline void addBergs(KnownFile& file, KnownChooser& choose, const std::vector<std::string>& ids)
{
    constexpr std::array<std::array<double, 2>, 6> kSeas{
        {{47, -48}, {70.5, -62}, {77.5, 2}, {-62.3, -50}, {-66, 179.98}, {56, 3}}};
    const auto& sea = choose.of(kSeas);
    file.start_s = 1'577'836'800 + static_cast<std::int64_t>(choose.below(6 * 365 * 24)) * 3600;
    for (const std::string& id : ids) {
        const double speed_mps = choose.real(0.05, 0.3);
        const double bearing_rad = choose.real(0, 6.28);
        file.bergs.push_back({.id = id,
                              .latitude_deg = sea[0] + choose.real(-0.4, 0.4),
                              .longitude_deg = sea[1] + choose.real(-0.6, 0.6),
                              .east_mps = speed_mps * std::sin(bearing_rad),
                              .north_mps = speed_mps * std::cos(bearing_rad)});
        if (file.bergs.back().longitude_deg >= 180)
            file.bergs.back().longitude_deg -= 360;
    }
}

/** Makes ids as people write them. */
inline std::vector<std::string> anyIds(KnownChooser& choose, std::size_t count)
{
    const std::size_t style = choose.below(6);
    std::vector<std::string> ids;
    for (std::size_t i = 0; i < count; ++i) {
        const int n = static_cast<int>(i) + 1;
        switch (style) {
        case 0:
            ids.push_back(formatted("%d", n));
            break;
        case 1:
            ids.push_back(formatted("B%02d", n + 8));
            break;
        case 2:
            ids.push_back(formatted("2026-%03d", n * 7));
            break;
        case 3:
            ids.push_back(formatted("Isfjell %d", n));
            break;
        case 4:
            ids.push_back(formatted("A23%c", 'A' + n));
            break;
        default:
            ids.push_back(formatted("%d", 300234063 + n * 11));
        }
    }
    return ids;
}

} // namespace berg::test
