#include "core/link/nmea/ais_message.h"

#include "core/link/nmea/nmea_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace berg {

namespace {

constexpr double kUnitsPerDegree = 600'000;
constexpr std::int64_t kNoSpeed = 1023;
constexpr std::int64_t kNoCourse = 3600;

/** A field of a message, by bits from its start. */
struct AisField
{
    std::size_t first = 0;
    std::size_t count = 0;
};

/** Layout of the messages with a position. */
struct AisLayout
{
    std::size_t bits = 0; ///< of the shortest message
    AisField longitude;
    AisField latitude;
    AisField second;
};
constexpr AisLayout kShipLayout{
    .bits = 168, .longitude = {61, 28}, .latitude = {89, 27}, .second = {137, 6}};
constexpr std::size_t kLongNameStart = 272;
constexpr AisLayout kAidLayout{.bits = 259, // transmitters differ in their spare bits at the end
                               .longitude = {164, 28},
                               .latitude = {192, 27},
                               .second = {253, 6}};
constexpr std::size_t kNameMessageBits = 422; ///< some transmitters leave out the spare bits

class AisBits
{
public:
    /** Returns false if a character is none of AIS. */
    [[nodiscard]] bool read(std::string_view payload, int fillBits)
    {
        for (const char c : payload) {
            const bool isLow = c >= '0' && c <= 'W';
            if (!isLow && (c < '`' || c > 'w'))
                return false;
            m_sixes.push_back(static_cast<std::uint8_t>(c - '0' - (isLow ? 0 : 8)));
        }
        const auto unused = static_cast<std::size_t>(std::clamp(fillBits, 0, 5));
        m_size = 6 * m_sixes.size() - std::min(unused, 6 * m_sixes.size());
        return true;
    }

    [[nodiscard]] std::size_t size() const { return m_size; }

    [[nodiscard]] std::int64_t whole(AisField field) const
    {
        std::int64_t value = 0;
        for (std::size_t i = field.first; i < field.first + field.count; ++i)
            value = 2 * value + ((m_sixes.at(i / 6) >> (5 - i % 6)) & 1U);
        return value;
    }

    [[nodiscard]] std::int64_t signedWhole(AisField field) const
    {
        const std::int64_t value = whole(field);
        const std::int64_t range = std::int64_t{1} << field.count;
        return value >= range / 2 ? value - range : value;
    }

    /** Returns the text without the padding at its end. */
    [[nodiscard]] std::string text(AisField field) const
    {
        std::string text;
        for (std::size_t i = field.first; i + 6 <= std::min(field.first + field.count, m_size);
             i += 6) {
            const auto code = static_cast<char>(whole({i, 6}));
            if (code == 0) // '@' ends the text
                break;
            text += static_cast<char>(code < 32 ? code + 64 : code);
        }
        text.resize(text.find_last_not_of(' ') + 1);
        return text;
    }

private:
    std::vector<std::uint8_t> m_sixes;
    std::size_t m_size = 0;
};

/** Reads the place and time; returns false if the place is not on Earth. */
bool readAisPlace(AisMessage& message, const AisBits& bits, const AisLayout& layout)
{
    const double longitude_deg =
        static_cast<double>(bits.signedWhole(layout.longitude)) / kUnitsPerDegree;
    const double latitude_deg =
        static_cast<double>(bits.signedWhole(layout.latitude)) / kUnitsPerDegree;
    if (const std::int64_t second = bits.whole(layout.second); second < 60)
        message.second = static_cast<int>(second);
    if (longitude_deg == 181 || latitude_deg == 91) // not available
        return true;
    if (std::abs(longitude_deg) > 180 || std::abs(latitude_deg) > 90)
        return false;
    message.place = {.latitude_deg = latitude_deg, .longitude_deg = longitude_deg};
    return true;
}

} // namespace

AisReading aisMessageOf(std::string_view payload, int fillBits)
{
    AisBits bits;
    if (!bits.read(payload, fillBits) || bits.size() < 38)
        return {};
    AisReading reading;
    AisMessage& message = reading.message;
    message.type = static_cast<int>(bits.whole({0, 6}));
    message.mmsi = static_cast<std::uint32_t>(bits.whole({8, 30}));
    const bool isShip = message.type >= 1 && message.type <= 3;
    if (!isShip && message.type != 5 && message.type != 21) {
        reading.outcome = AisOutcome::OtherType;
        return reading;
    }
    if (message.type == 5) {
        if (bits.size() < kNameMessageBits)
            return {};
        message.name = bits.text({112, 120});
    } else {
        const AisLayout& layout = isShip ? kShipLayout : kAidLayout;
        if (bits.size() < layout.bits || !readAisPlace(message, bits, layout))
            return {};
    }
    if (isShip) {
        if (const std::int64_t speed = bits.whole({50, 10}); speed != kNoSpeed)
            message.speed_mps = 0.1 * static_cast<double>(speed) * kKnot_mps;
        if (const std::int64_t course = bits.whole({116, 12}); course < kNoCourse)
            message.course_deg = static_cast<double>(course) / 10;
        if (const std::int64_t heading = bits.whole({128, 9}); heading < 360)
            message.heading_deg = static_cast<double>(heading);
    } else if (message.type == 21) {
        message.name = bits.text({43, 120});
        if (message.name.size() == 20 && bits.size() > kLongNameStart)
            message.name += bits.text({kLongNameStart, 84});
    }
    reading.outcome = AisOutcome::Read;
    return reading;
}

bool saysIce(std::string_view name)
{
    constexpr std::array<std::string_view, 8> kIceWords{"ICE",   "ICEBERG", "ICEBERGS", "BERG",
                                                        "BERGS", "BERGY",   "GROWLER",  "FLOE"};
    std::string word;
    for (std::size_t i = 0; i <= name.size(); ++i) {
        const char c = i < name.size() ? name[i] : ' ';
        const bool isSmall = c >= 'a' && c <= 'z';
        if (isSmall || (c >= 'A' && c <= 'Z')) {
            word += isSmall ? static_cast<char>(c - 'a' + 'A') : c;
            continue;
        }
        if (std::ranges::find(kIceWords, word) != kIceWords.end())
            return true;
        word.clear();
    }
    return false;
}

} // namespace berg
