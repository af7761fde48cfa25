#include "core/io/import/receivers/photo_exif.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <exception>
#include <exiv2/exiv2.hpp>

namespace berg {

namespace {

// exiv2 0.28 has other types for sizes.
#if EXIV2_TEST_VERSION(0, 28, 0)
using ExivSize = std::size_t;
#else
using ExivSize = long;
#endif

constexpr double kHighest_m = 100'000;

/** Returns the text of a tag, or an empty text if there is none. */
std::string exifText(const Exiv2::ExifData& data, const char* key)
{
    const auto found = data.findKey(Exiv2::ExifKey(key));
    if (found == data.end())
        return {};
    std::string text = found->toString();
    text.resize(std::min(text.find('\0'), text.size())); // the standard ends texts by a zero
    return text;
}

/** Returns number `at` of a tag. */
std::optional<double> exifNumber(const Exiv2::ExifData& data, const char* key, ExivSize at = 0)
{
    const auto found = data.findKey(Exiv2::ExifKey(key));
    if (found == data.end() || at >= found->count())
        return std::nullopt;
    const Exiv2::Rational value = found->toRational(at);
    if (value.second == 0)
        return std::nullopt;
    const double number = static_cast<double>(value.first) / static_cast<double>(value.second);
    return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

/** Returns an angle of degrees, minutes and seconds with the sign of its hemisphere. */
std::optional<double> exifAngle(const Exiv2::ExifData& data, const char* key, const char* refKey,
                                std::string_view signs, double limit_deg)
{
    double value_deg = 0;
    constexpr std::array<double, 3> kParts{1, 60, 3600};
    for (std::size_t i = 0; i < kParts.size(); ++i) {
        const std::optional<double> part = exifNumber(data, key, static_cast<ExivSize>(i));
        if (!part && i == 0)
            return std::nullopt;
        if (part && (*part < 0 || (i > 0 && *part > 60)))
            return std::nullopt;
        value_deg += part.value_or(0) / kParts[i];
    }
    const std::string ref = exifText(data, refKey);
    if (ref.empty() || signs.find(ref[0]) == std::string_view::npos || value_deg > limit_deg)
        return std::nullopt;
    return ref[0] == signs[0] ? value_deg : -value_deg;
}

std::optional<LatLon> exifPlace(const Exiv2::ExifData& data)
{
    const auto latitude =
        exifAngle(data, "Exif.GPSInfo.GPSLatitude", "Exif.GPSInfo.GPSLatitudeRef", "NS", 90);
    const auto longitude =
        exifAngle(data, "Exif.GPSInfo.GPSLongitude", "Exif.GPSInfo.GPSLongitudeRef", "EW", 180);
    if (!latitude || !longitude)
        return std::nullopt;
    // A receiver without a fix leaves zeros, or says so.
    if ((*latitude == 0 && *longitude == 0) || exifText(data, "Exif.GPSInfo.GPSStatus") == "V")
        return std::nullopt;
    return LatLon{.latitude_deg = *latitude,
                  .longitude_deg = *longitude >= 180 ? *longitude - 360 : *longitude};
}

/** Returns "2026:11:30" as "2026-11-30". */
std::string isoDate(std::string_view text)
{
    std::string date(text.substr(0, 10));
    for (const std::size_t at : {std::size_t{4}, std::size_t{7}})
        if (date.size() == 10 && date[at] == ':')
            date[at] = '-';
    return date;
}

std::optional<UtcTime> exifGpsTime(const Exiv2::ExifData& data)
{
    const std::optional<UtcTime> day =
        parseUtc(isoDate(exifText(data, "Exif.GPSInfo.GPSDateStamp")) + "T00:00:00Z");
    double time_s = 0;
    constexpr std::array<double, 3> kParts_s{3600, 60, 1};
    constexpr std::array<double, 3> kLimits{24, 60, 61};
    for (std::size_t i = 0; i < kParts_s.size(); ++i) {
        const std::optional<double> part =
            exifNumber(data, "Exif.GPSInfo.GPSTimeStamp", static_cast<ExivSize>(i));
        if (!part || *part < 0 || *part >= kLimits[i])
            return std::nullopt;
        time_s += *part * kParts_s[i];
    }
    if (!day)
        return std::nullopt;
    return *day + std::chrono::milliseconds(std::llround(1000 * time_s));
}

/** Returns the time of the camera's clock, if the data state how far it is ahead of UTC. */
std::optional<UtcTime> exifCameraTime(const Exiv2::ExifData& data)
{
    const std::string local = exifText(data, "Exif.Photo.DateTimeOriginal");
    const std::string offset = exifText(data, "Exif.Photo.OffsetTimeOriginal");
    if (local.size() < 19 || offset.size() != 6 || offset[3] != ':' ||
        (offset[0] != '+' && offset[0] != '-'))
        return std::nullopt;
    int hours = 0;
    int minutes = 0;
    const char* const text = offset.data();
    if (std::from_chars(text + 1, text + 3, hours).ptr != text + 3 ||
        std::from_chars(text + 4, text + 6, minutes).ptr != text + 6 || hours > 14 || minutes > 59)
        return std::nullopt;
    const std::optional<UtcTime> time = parseUtc(isoDate(local) + 'T' + local.substr(11, 8) + 'Z');
    if (!time)
        return std::nullopt;
    const std::chrono::minutes ahead(60 * hours + minutes);
    return offset[0] == '+' ? *time - ahead : *time + ahead;
}

} // namespace

bool readsPhotos()
{
    return true;
}

PhotoData photoData(std::string_view bytes, const std::string& subject)
try {
    Exiv2::LogMsg::setLevel(Exiv2::LogMsg::mute); // its warnings would go to stderr
    const auto image = Exiv2::ImageFactory::open(reinterpret_cast<const Exiv2::byte*>(bytes.data()),
                                                 static_cast<ExivSize>(bytes.size()));
    image->readMetadata();
    const Exiv2::ExifData& data = image->exifData();
    PhotoData photo{.place = exifPlace(data), .time = exifGpsTime(data)};
    if (!photo.time)
        photo.time = exifCameraTime(data);
    const std::optional<double> altitude_m = exifNumber(data, "Exif.GPSInfo.GPSAltitude");
    if (altitude_m && std::abs(*altitude_m) < kHighest_m)
        photo.altitude_m = altitude_m;
    const std::optional<double> direction_deg = exifNumber(data, "Exif.GPSInfo.GPSImgDirection");
    const bool isTrue = exifText(data, "Exif.GPSInfo.GPSImgDirectionRef") != "M"; // magnetic
    if (direction_deg && isTrue && *direction_deg >= 0 && *direction_deg < 360)
        photo.direction_deg = direction_deg;
    return photo;
} catch (const std::exception&) { // of exiv2: its classes differ between versions
    throw Error(ErrorCode::InvalidInput, subject,
                {Issue{Severity::Error, "exif", {IssueId::PhotoDamaged}}});
}

} // namespace berg
