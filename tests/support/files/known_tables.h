#pragma once

// Tables of sightings whose meaning is known by construction.

#include "tests/support/files/known_sightings.h"

#include <algorithm>

namespace berg::test {

/** Writes one table in a dialect chosen at random. */
class TableWriter
{
public:
    TableWriter(KnownChooser& choose, KnownFile& file) : m_choose(choose), m_file(file) {}

    void write()
    {
        chooseDialect();
        const bool isOnce = m_time == kNoTime || m_spoil > 0;
        const std::size_t fixes = isOnce ? 1 : 1 + m_choose.below(4);
        const auto step_s = static_cast<std::int64_t>(3600 * (1 + m_choose.below(6)));
        std::vector<KnownPlace> places;
        for (std::size_t fix = 0; fix < fixes; ++fix)
            for (std::size_t berg = 0; berg < m_file.bergs.size(); ++berg)
                places.push_back(knownPlaceAt(
                    m_file, berg, m_file.start_s + static_cast<std::int64_t>(fix) * step_s));
        if (m_choose.once(3))
            std::ranges::stable_sort(places, {}, &KnownPlace::berg);
        addHead();
        line(header());
        for (KnownPlace& place : places) {
            place.row = m_line + 1;
            if (m_time == kNoTime)
                place.time_s.reset();
            m_isSpoilt = m_spoil > 0 && m_choose.once(3);
            if (m_isSpoilt)
                spoil(place);
            addRow(place);
            m_isSpoilt = false;
            if (place.isSpoilt && m_spoil == 1)
                place.time_s.reset();
            m_file.places.push_back(place);
            if (m_choose.once(12))
                addOddRow(place);
        }
        if (m_choose.once(20)) {
            line("");
            m_file.trait("blank line at the end");
        }
        m_file.bytes = encoded();
    }

private:
    static constexpr std::size_t kNoTime = 13;
    static constexpr std::size_t kOneColumn = 8; ///< value of `m_place`

    void chooseDialect()
    {
        static const std::array<std::string, 4> kSeparators{",", ";", "\t", ","};
        static const std::array<std::string, 3> kEnds{"\n", "\r\n", "\r"};
        m_separator = m_choose.of(kSeparators);
        m_end = kEnds[m_choose.once(8) ? 2 : m_choose.below(2)];
        m_hasComma = m_choose.once(4);
        m_quotes = m_choose.below(3);
        m_encoding = m_choose.once(2) ? 0 : m_choose.below(6);
        m_place = m_choose.below(9);
        m_time = m_choose.below(14);
        m_speed = m_choose.once(3) ? 1 + m_choose.below(6) : 0;
        m_spoil = m_choose.once(4) ? 1 + m_choose.below(3) : 0;
        m_file.hasIds = !m_choose.once(10);
        if (m_hasComma && m_separator == ",")
            m_quotes = 2;
        m_file.trait("separator " + (m_separator == "\t" ? "tab" : m_separator));
        m_file.trait(formatted("place %zu", m_place));
        m_file.trait(formatted("time %zu", m_time));
        m_file.trait(formatted("encoding %zu", m_encoding));
        if (m_hasComma)
            m_file.trait("decimal comma");
        if (!m_file.hasIds)
            m_file.trait("no ids");
        if (m_speed > 0)
            m_file.trait(formatted("speed %zu", m_speed));
    }

    /** Makes one value of the row unreadable. */
    void spoil(KnownPlace& place)
    {
        if (m_spoil == 1 && m_time != kNoTime) {
            place.isSpoilt = true;
            m_file.trait("time in words");
        } else if (m_spoil == 2 && m_speed > 0) {
            place.isSpoilt = true;
            m_file.trait("speed in words");
        } else if (m_spoil == 3) {
            place.isGood = false;
            m_file.trait("row without a latitude");
        } else {
            m_isSpoilt = false;
        }
    }

    void line(const std::string& text)
    {
        m_text += text + m_end;
        ++m_line;
    }

    void addHead()
    {
        if (m_choose.once(10)) {
            line("sep=" + m_separator);
            m_file.trait("sep=");
        }
        if (m_choose.once(8)) {
            line("# made by hand, 2026");
            m_file.trait("comment above");
        }
        if (m_choose.once(8)) {
            line("Ice report of the week");
            m_file.trait("title above");
            if (m_choose.once(2)) {
                line("");
                m_file.trait("blank line above");
            }
        }
    }

    std::string joined(const std::vector<std::string>& cells) const
    {
        std::string text;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const bool needs = cells[i].find(m_separator) != std::string::npos ||
                               cells[i].find('"') != std::string::npos;
            const bool isQuoted = needs || m_quotes == 2 || (m_quotes == 1 && i % 2 == 0);
            text += (i == 0 ? "" : m_separator) +
                    (isQuoted ? '"' + replaced(cells[i], "\"", "\"\"") + '"' : cells[i]);
        }
        return text;
    }

    std::string header()
    {
        static const std::array<std::string, 21> kIds{
            "id",      "Iceberg",    "iceberg_id", "Target",  "Track", "contact", "MMSI",
            "Device",  "BuoyID",     "reference",  "No.",     "Nr",    "Isfjell", "instrument",
            "Kennung", "trajectory", "Beacon",     "Berg no", "ID",    "Eisberg", "platform"};
        std::vector<std::string> cells;
        if (m_file.hasIds) {
            cells.push_back(m_choose.of(kIds));
            m_file.idColumn = cells.back();
            m_file.trait("id column " + cells.back());
        }
        addTimeNames(cells);
        addPlaceNames(cells);
        static const std::array<std::array<const char*, 2>, 7> kSpeeds{
            {{"", ""},
             {"speed_mps", "direction"},
             {"Speed (kn)", "Direction"},
             {"speed", "course"},
             {"Speed km/h", "Bearing"},
             {"drift speed", "drift direction"},
             {"SOG", "COG"}}};
        if (m_speed > 0)
            cells.insert(cells.end(), {kSpeeds[m_speed][0], kSpeeds[m_speed][1]});
        m_hasName = m_encoding > 0 || m_choose.once(6);
        if (m_hasName)
            cells.emplace_back("comment");
        return joined(cells);
    }

    void addTimeNames(std::vector<std::string>& cells)
    {
        static const std::array<std::string, 12> kTimes{
            "time", "Timestamp", "date_time", "Time (UTC)",    "datetime", "UTC",
            "Tid",  "Observed",  "Zeit",      "Date and time", "GMT",      "obs_time"};
        switch (m_time) {
        case kNoTime:
            return;
        case 7:
            cells.insert(cells.end(), {"date", "time"});
            return;
        case 8:
            cells.insert(cells.end(), {"Year", "Month", "Day", "Hour", "Minute"});
            return;
        case 9:
            cells.insert(cells.end(), {"Year", "DOY", "Hour", "Min"});
            return;
        default:
            cells.push_back(m_choose.of(kTimes));
            m_file.timeColumn = cells.back();
            m_file.trait("time column " + cells.back());
        }
    }

    void addPlaceNames(std::vector<std::string>& cells)
    {
        static const std::array<std::array<const char*, 2>, 11> kNames{
            {{"lat", "lon"},
             {"Latitude", "Longitude"},
             {"latitude (degrees_north)", "longitude (degrees_east)"},
             {"LAT", "LONG"},
             {"Lat (deg)", "Lon (deg)"},
             {"Breddegrad", "Lengdegrad"},
             {"latitude_deg", "longitude_deg"},
             {"Lat.", "Lng."},
             {"Breite", "L\xC3\xA4nge"},
             {"Bredde", "L\xC3\xA6ngde"},
             {"POS_LAT", "POS_LON"}}};
        if (m_place == 6) {
            cells.insert(cells.end(), {"Latitude", "N/S", "Longitude", "E/W"});
            return;
        }
        if (m_place == 7) {
            cells.insert(cells.end(),
                         {"lat_deg", "lat_min", "lat_hem", "lon_deg", "lon_min", "lon_hem"});
            return;
        }
        if (m_place == kOneColumn) {
            cells.emplace_back("Position");
            return;
        }
        const auto& names = m_choose.of(kNames);
        m_file.trait(std::string("place columns ") + names[0]);
        cells.insert(cells.end(), {names[0], names[1]});
    }

    std::string number(const std::string& text) const
    {
        return m_hasComma ? replaced(text, ".", ",") : text;
    }

    void addAngle(std::vector<std::string>& cells, double angle_deg, char positive, char negative)
    {
        const double size_deg = std::abs(angle_deg);
        const std::string letter(1, angle_deg < 0 ? negative : positive);
        const int degrees = static_cast<int>(size_deg);
        const double minutes = (size_deg - degrees) * 60;
        switch (m_place) {
        case 1:
            cells.push_back(number(formatted("%.5f", size_deg)) + ' ' + letter);
            break;
        case 2:
            cells.push_back(letter + number(formatted("%.5f", size_deg)));
            break;
        case 3:
        case kOneColumn:
            cells.push_back(formatted("%d\xC2\xB0", degrees) +
                            number(formatted("%07.4f", minutes)) + '\'' + letter);
            break;
        case 4: {
            const auto seconds = std::llround(size_deg * 36000);
            cells.push_back(formatted("%lld\xC2\xB0%02lld'", seconds / 36000, seconds / 600 % 60) +
                            number(formatted("%lld.%lld", seconds / 10 % 60, seconds % 10)) + '"' +
                            letter);
            m_file.rounding_m = 2;
            break;
        }
        case 5: {
            const auto seconds = std::llround(size_deg * 3600);
            cells.push_back(
                formatted("%lld %02lld %02lld ", seconds / 3600, seconds / 60 % 60, seconds % 60) +
                letter);
            m_file.rounding_m = 20;
            break;
        }
        case 6:
            cells.insert(cells.end(), {number(formatted("%.5f", size_deg)), letter});
            break;
        case 7:
            cells.insert(cells.end(),
                         {formatted("%d", degrees), number(formatted("%.4f", minutes)), letter});
            break;
        default:
            cells.push_back(number(formatted("%.5f", angle_deg)));
        }
    }

    void addTime(std::vector<std::string>& cells, std::int64_t time_s)
    {
        static const std::array<const char*, 12> kMonths{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                         "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
        const Calendar c = calendarOf(time_s);
        const char* const month = kMonths[static_cast<std::size_t>(c.month) - 1];
        switch (m_time) {
        case 0:
            cells.push_back(isoText(time_s));
            break;
        case 1:
            cells.push_back(
                formatted("%04d-%02d-%02d %02d:%02d", c.year, c.month, c.day, c.hour, c.minute));
            break;
        case 2: {
            const Calendar local = calendarOf(time_s + 2 * 3600);
            cells.push_back(formatted("%04d-%02d-%02dT%02d:%02d:%02d+02:00", local.year,
                                      local.month, local.day, local.hour, local.minute,
                                      local.second));
            break;
        }
        case 3:
            cells.push_back(
                formatted("%02d.%02d.%04d %02d:%02d", c.day, c.month, c.year, c.hour, c.minute));
            break;
        case 4:
            cells.push_back(
                formatted("%d-%s-%04d %02d:%02d", c.day, month, c.year, c.hour, c.minute));
            break;
        case 5:
            cells.push_back(formatted("%d/%d/%04d %d:%02d %s", c.month, c.day, c.year,
                                      (c.hour + 11) % 12 + 1, c.minute, c.hour < 12 ? "AM" : "PM"));
            m_file.isAmbiguous = m_file.isAmbiguous || c.day <= 12;
            break;
        case 6:
            cells.push_back(
                formatted("%02d/%02d/%04d %02d:%02d", c.day, c.month, c.year, c.hour, c.minute));
            m_file.isAmbiguous = m_file.isAmbiguous || c.day <= 12;
            break;
        case 7:
            cells.insert(cells.end(), {formatted("%04d-%02d-%02d", c.year, c.month, c.day),
                                       formatted("%02d:%02d:%02d", c.hour, c.minute, c.second)});
            break;
        case 8:
            cells.insert(cells.end(),
                         {formatted("%d", c.year), formatted("%d", c.month), formatted("%d", c.day),
                          formatted("%d", c.hour), formatted("%d", c.minute)});
            break;
        case 9:
            cells.insert(cells.end(), {formatted("%d", c.year), formatted("%d", c.dayOfYear),
                                       formatted("%d", c.hour), formatted("%d", c.minute)});
            break;
        case 10:
            cells.push_back(formatted("%lld", static_cast<long long>(time_s)));
            m_file.isAmbiguous = true; // seconds since 1970, without any statement of the unit
            break;
        case 11:
            cells.push_back(replaced(isoText(time_s), "Z", ".000Z"));
            break;
        case 12:
            cells.push_back(
                formatted("%d %s %04d %02d:%02d UTC", c.day, month, c.year, c.hour, c.minute));
            break;
        default:
            break;
        }
    }

    void addSpeed(std::vector<std::string>& cells, KnownBerg& berg)
    {
        const double speed_mps = std::hypot(berg.east_mps, berg.north_mps);
        double bearing_deg = std::atan2(berg.east_mps, berg.north_mps) / 0.017453292519943295;
        bearing_deg += bearing_deg < 0 ? 360 : 0;
        berg.givesVelocity = true;
        switch (m_speed) {
        case 1:
            cells.insert(cells.end(), {number(formatted("%.3f", speed_mps)),
                                       number(formatted("%.1f", bearing_deg))});
            break;
        case 2:
            cells.insert(cells.end(), {number(formatted("%.3f", speed_mps * 3600 / 1852)),
                                       formatted("%.0f\xC2\xB0", bearing_deg)});
            break;
        case 3:
            cells.insert(cells.end(), {number(formatted("%.3f", speed_mps * 3.6)) + " km/h",
                                       number(formatted("%.2f", bearing_deg)) + " \xC2\xB0 True"});
            break;
        case 4:
            cells.insert(cells.end(), {number(formatted("%.3f", speed_mps * 3.6)),
                                       number(formatted("%.1f", bearing_deg))});
            break;
        case 5:
            cells.insert(cells.end(), {number(formatted("%.3f", speed_mps * 3600 / 1852)) + " kn",
                                       formatted("%.0f deg", bearing_deg)});
            break;
        default: // AIS value for "not available"
            cells.insert(cells.end(), {number("102.3"), number("360.0")});
            berg.givesVelocity = false;
        }
    }

    void addRow(const KnownPlace& place)
    {
        std::vector<std::string> cells;
        KnownBerg& berg = m_file.bergs[place.berg];
        if (m_file.hasIds)
            cells.push_back(berg.id);
        const std::size_t timeAt = cells.size();
        if (place.time_s)
            addTime(cells, *place.time_s);
        if (m_isSpoilt && m_spoil == 1)
            cells[timeAt] = "at noon";
        const std::size_t placeAt = cells.size();
        addAngle(cells, place.latitude_deg, 'N', 'S');
        addAngle(cells, place.longitude_deg, 'E', 'W');
        if (m_place == kOneColumn) {
            cells[placeAt] += ' ' + cells.back();
            cells.pop_back();
        }
        if (m_isSpoilt && m_spoil == 3)
            cells[placeAt].clear();
        const std::size_t speedAt = cells.size();
        if (m_speed > 0)
            addSpeed(cells, berg);
        if (m_isSpoilt && m_spoil == 2) {
            cells[speedAt] = "slow";
            berg.givesVelocity = false;
        }
        if (m_hasName)
            cells.push_back(m_encoding == 3 ? "Sm\xC3\xA5 \xE2\x80\x93 gr\xC3\xA5"
                                            : "Sm\xC3\xA5 gr\xC3\xA5");
        line(joined(cells));
    }

    /** Adds a row that is not a place, or an impossible one, which must be listed. */
    void addOddRow(KnownPlace place)
    {
        place.row = m_line + 1;
        place.isGood = false;
        const std::size_t kind = m_choose.below(4);
        if (kind == 0) {
            place.latitude_deg = 0;
            place.longitude_deg = 0;
            m_file.trait("row at 0 0");
        } else if (kind == 1) {
            place.latitude_deg = place.latitude_deg > 0 ? -40 : 40;
            place.longitude_deg = 100;
            m_file.trait("row far away");
        } else if (kind == 2) {
            place.latitude_deg = 97.5;
            m_file.trait("row of latitude 97.5");
        } else {
            line(m_choose.once(2) ? "end of report" : "total" + m_separator + "12");
            m_file.places.push_back(place);
            m_file.trait("row of words");
            return;
        }
        addRow(place);
        m_file.places.push_back(place);
    }

    std::string encoded() const
    {
        switch (m_encoding) {
        case 1:
            return "\xEF\xBB\xBF" + m_text;
        case 2:
        case 3: {
            std::string text = replaced(m_text, "\xC3\xA5", "\xE5");
            text = replaced(text, "\xC3\xA4", "\xE4");
            text = replaced(text, "\xC3\xA6", "\xE6");
            text = replaced(text, "\xC2\xB0", "\xB0");
            return replaced(text, "\xE2\x80\x93", "\x96");
        }
        case 4:
            return inUtf16(true);
        case 5:
            return inUtf16(false);
        default:
            return m_text;
        }
    }

    [[nodiscard]] std::string inUtf16(bool isLittle) const
    {
        std::string bytes = isLittle ? "\xFF\xFE" : "\xFE\xFF";
        for (std::size_t i = 0; i < m_text.size(); ++i) {
            auto unit = static_cast<unsigned char>(m_text[i]);
            unsigned code = unit;
            if (unit >= 0xC0 && i + 1 < m_text.size()) // two bytes cover all characters used here
                code = (unit & 0x1FU) << 6U | (static_cast<unsigned char>(m_text[++i]) & 0x3FU);
            const char low = static_cast<char>(code & 0xFFU);
            const char high = static_cast<char>(code >> 8U);
            bytes += isLittle ? low : high;
            bytes += isLittle ? high : low;
        }
        return bytes;
    }

    KnownChooser& m_choose;
    KnownFile& m_file;
    std::string m_text;
    std::size_t m_line = 0;
    std::string m_separator;
    std::string m_end;
    bool m_hasComma = false;
    bool m_hasName = false;
    std::size_t m_quotes = 0; ///< 0 quotes nothing, 1 some cells, 2 all
    std::size_t m_encoding = 0;
    std::size_t m_place = 0;
    std::size_t m_time = 0;
    std::size_t m_speed = 0;
    std::size_t m_spoil = 0; ///< text in some rows: 1 times, 2 speeds, 3 no latitude
    bool m_isSpoilt = false; ///< whether the present row is one of these
};

} // namespace berg::test
