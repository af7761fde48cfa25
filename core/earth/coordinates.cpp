#include "core/earth/coordinates.h"

#include "core/earth/coordinate_reader.h"

#include <GeographicLib/DMS.hpp>
#include <GeographicLib/GeoCoords.hpp>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <regex>

namespace berg {
namespace {

using GeographicLib::DMS;
using GeographicLib::GeoCoords;
using GeographicLib::GeographicErr;
using PlaceOrFault = std::variant<LatLon, CoordinateFault>;

// These are the latitudes of band S, whose letter also means the southern hemisphere.
constexpr double kBandS_deg = 32;
constexpr double kBandT_deg = 40;

constexpr std::size_t kLongestText = 200;

double withinTurn(double longitude_deg)
{
    const double within_deg = std::remainder(longitude_deg, 360.0);
    return within_deg >= 180 ? within_deg - 360 : within_deg;
}

PlaceOrFault gridPlace(const std::string& text)
{
    try {
        const GeoCoords coordinates(text);
        return LatLon{coordinates.Latitude(), withinTurn(coordinates.Longitude())};
    } catch (const GeographicErr&) {
        return CoordinateFault::Grid;
    }
}

/**
 * Reads UTM with the letter of a band or hemisphere, UPS or MGRS. Returns nullopt if the text
 * resembles none of them.
 */
std::optional<PlaceOrFault> readGrid(const std::string& text)
{
    static const std::regex square(R"((\d{1,2} ?[C-X]|[ABYZ]) ?[A-Z]{2}( ?\d+){0,2})",
                                   std::regex::icase);
    static const std::regex utm(
        R"((\d{1,2}) ?([C-X]) (\d{6,7}(?:\.\d+)?) ?m? ?E?,? (\d{1,8}(?:\.\d+)?) ?m? ?N?)",
        std::regex::icase);
    static const std::regex ups(R"(([NS]) (\d{6,7}(\.\d+)?) (\d{6,7}(\.\d+)?))", std::regex::icase);
    std::smatch parts;
    if (std::regex_match(text, square)) {
        std::string joined = text;
        std::erase(joined, ' ');
        return gridPlace(joined);
    }
    if (std::regex_match(text, ups))
        return gridPlace(text);
    if (!std::regex_match(text, parts, utm))
        return std::nullopt;
    const char band = static_cast<char>(std::toupper(parts[2].str().front()));
    const std::string rest = ' ' + parts[3].str() + ' ' + parts[4].str();
    const std::string zone = parts[1].str();
    if (band == 'S') {
        const PlaceOrFault north = gridPlace(zone + 'n' + rest);
        const auto* place = std::get_if<LatLon>(&north);
        if (place != nullptr && place->latitude_deg >= kBandS_deg &&
            place->latitude_deg < kBandT_deg)
            return CoordinateFault::Ambiguous;
    }
    return gridPlace(zone + (band >= 'N' && band != 'S' ? 'n' : 's') + rest);
}

/**
 * Returns "+4703.2-04758.1/" as numbers for the reader of angles, or nullopt if the text is not in
 * this form.
 */
std::optional<std::string> fromIso6709(const std::string& text)
{
    static const std::regex form(
        R"(([+-])(\d\d)(\d\d)?(\d\d)?(\.\d+)?([+-])(\d{3})(\d\d)?(\d\d)?(\.\d+)?([+-][\d.]+)?(CRS.*)?/?)",
        std::regex::icase);
    std::smatch parts;
    if (!std::regex_match(text, parts, form))
        return std::nullopt;
    const auto angle = [&](std::size_t first) {
        std::string words = parts[first].str() + parts[first + 1].str();
        for (const std::size_t more : {first + 2, first + 3})
            if (parts[more].matched)
                words += ' ' + parts[more].str();
        return words + parts[first + 4].str();
    };
    return angle(1) + ';' + angle(6);
}

std::variant<double, CoordinateFault> decode(const CoordinateAngle& angle)
{
    constexpr std::string_view kMarks = "d'\"";
    std::string text;
    for (std::size_t i = 0; i < angle.numbers.size(); ++i) {
        if (i > 0 && std::stod(angle.numbers[i]) >= 60)
            return CoordinateFault::Sixty;
        text += angle.numbers[i] + kMarks[i];
    }
    if (angle.sign && angle.letter)
        return CoordinateFault::SignAndLetter;
    try {
        DMS::flag axis = DMS::NONE;
        const double size_deg = DMS::Decode(text, axis);
        const bool isNegative = angle.sign == '-' || angle.letter == 'S' || angle.letter == 'W';
        return isNegative ? -size_deg : size_deg;
    } catch (const GeographicErr&) {
        return CoordinateFault::Unreadable; // e.g. decimals in both degrees and minutes
    }
}

bool isLatitude(const CoordinateAngle& angle)
{
    const char letter = angle.letter.value_or(' ');
    return letter == 'N' || letter == 'S';
}

PlaceOrFault pairedPlace(CoordinateAngle first, CoordinateAngle second)
{
    const bool isSwapped = (first.letter && !isLatitude(first)) || isLatitude(second);
    if (isSwapped)
        std::swap(first, second);
    if ((first.letter && !isLatitude(first)) || isLatitude(second))
        return CoordinateFault::SameAxis;
    const auto latitude = decode(first);
    const auto longitude = decode(second);
    for (const auto* angle : {&latitude, &longitude})
        if (const auto* fault = std::get_if<CoordinateFault>(angle))
            return *fault;
    const LatLon place{std::get<double>(latitude), std::get<double>(longitude)};
    const auto lacksHemisphere = [](const CoordinateAngle& angle, double value_deg) {
        return !angle.letter && !angle.sign && std::remainder(value_deg, 180.0) != 0;
    };
    const bool hasLetter = first.letter || second.letter;
    if (hasLetter && (lacksHemisphere(first, place.latitude_deg) ||
                      lacksHemisphere(second, place.longitude_deg)))
        return CoordinateFault::HemisphereMissing;
    if (std::abs(place.latitude_deg) > 90)
        return CoordinateFault::Latitude;
    const bool countsRound = !second.letter && !second.sign; // such as 312 for 48 W
    if (std::abs(place.longitude_deg) > 180 && !(countsRound && place.longitude_deg < 360))
        return CoordinateFault::Longitude;
    return LatLon{place.latitude_deg, withinTurn(place.longitude_deg)};
}

} // namespace

PlaceOrFault parsePlace(std::string_view text)
{
    if (text.size() > kLongestText)
        return CoordinateFault::Unreadable;
    const std::string characters = plainCharacters(text);
    if (characters.empty())
        return CoordinateFault::Empty;
    if (const std::optional<PlaceOrFault> place = readGrid(characters))
        return *place;
    const std::string plain = plainDirections(characters);
    const auto halves = readAngles(fromIso6709(plain).value_or(plain));
    if (const auto* fault = std::get_if<CoordinateFault>(&halves))
        return *fault;
    const auto& [first, second] = std::get<CoordinateAngles>(halves);
    return pairedPlace(first, second);
}

std::string angleText(double angle_deg, CoordinateForm form, std::optional<int> decimals)
{
    const int precision = decimals.value_or(0);
    const auto fields = [&](DMS::component last, int places) {
        // Colons separate the parts so that the marks are added here.
        return DMS::Encode(angle_deg, last, static_cast<unsigned>(places), DMS::NONE, ':');
    };
    if (!decimals)
        return fields(DMS::DEGREE, 0) + "°";
    if (form == CoordinateForm::DecimalDegrees)
        return fields(DMS::DEGREE, precision + 2) + "°";
    const bool hasSeconds = form == CoordinateForm::DegreesMinutesSeconds && precision > 0;
    std::string text = hasSeconds ? fields(DMS::SECOND, std::max(0, precision - 2))
                                  : fields(DMS::MINUTE, precision);
    text.replace(text.find(':'), 1, "° ");
    if (!hasSeconds)
        return text + "′";
    text.replace(text.find(':'), 1, "′ ");
    return text + "″";
}

std::string placeText(const LatLon& place, CoordinateForm form, std::optional<int> decimals)
{
    return angleText(std::abs(place.latitude_deg), form, decimals) +
           (place.latitude_deg < 0 ? " S  " : " N  ") +
           angleText(std::abs(place.longitude_deg), form, decimals) +
           (place.longitude_deg < 0 ? " W" : " E");
}

} // namespace berg
