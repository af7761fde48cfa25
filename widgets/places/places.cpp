#include "widgets/places/places.h"

#include "core/scenario/limits.h"
#include "widgets/places/gazetteer.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct PlaceText
{
    Q_DECLARE_TR_FUNCTIONS(PlaceText)
};

} // namespace

std::vector<NamedPlace> namedPlaces()
{
    std::vector<NamedPlace> places;
    for (const GazetteerPlace& place : gazetteer())
        places.push_back({.name = placeName(place),
                          .english = QString::fromUtf8(place.name),
                          .also = place.also,
                          .at = place.at,
                          .rank = place.rank,
                          .kind = place.kind});
    std::sort(places.begin(), places.end(), [](const NamedPlace& a, const NamedPlace& b) {
        return searchText(a.name) < searchText(b.name);
    });
    return places;
}

QString searchText(const QString& text)
{
    QString plain;
    for (const QChar c : text.toLower().normalized(QString::NormalizationForm_KD)) {
        if (c == u'ø')
            plain += u'o';
        else if (c == u'æ')
            plain += u"ae"_s;
        else if (c == u'ð' || c == u'đ')
            plain += u'd';
        else if (c == u'þ')
            plain += u"th"_s;
        else if (c == u'τ') // typed "tau"
            plain += u"tau"_s;
        else if (c == u'ζ')
            plain += u"zeta"_s;
        else if (c == u'σ')
            plain += u"sigma"_s;
        else if (c.isLetterOrNumber())
            plain += c;
        else if (!c.isMark() && c != u'.' && c != u'\'' && c != u'’')
            plain += u' ';
    }
    return plain.simplified();
}

QStringList searchNames(const NamedPlace& place)
{
    QStringList names{searchText(place.name), searchText(place.english)};
    for (const QString& other : place.also)
        names << searchText(other);
    return names;
}

bool isWithoutDigits(const QString& text)
{
    return std::any_of(text.begin(), text.end(), [](QChar c) { return c.isLetter(); }) &&
           std::none_of(text.begin(), text.end(), [](QChar c) { return c.isDigit(); });
}

std::variant<FoundPlace, QString> findPlace(const QString& text)
{
    const QString wanted = searchText(text);
    std::vector<FoundPlace> partly;
    for (const NamedPlace& place : namedPlaces()) {
        const QStringList names = searchNames(place);
        if (names.contains(wanted))
            return FoundPlace{place.at, place.name};
        const auto isPart = [&](const QString& name) { return name.contains(wanted); };
        if (std::ranges::any_of(names, isPart))
            partly.push_back({place.at, place.name});
    }
    const auto read = parsePlace(withPlainHemispheres(text).toStdString());
    const auto* at = std::get_if<LatLon>(&read);
    const bool isWord = isWithoutDigits(wanted);
    if (at != nullptr && (!isWord || partly.empty()))
        return FoundPlace{*at, {}};
    if (!isWord)
        return coordinateFaultText(std::get<CoordinateFault>(read));
    if (partly.size() == 1)
        return partly.front();
    return partly.empty()
               ? PlaceText::tr("No known place has this name, and it is not a coordinate.")
               : PlaceText::tr("Several places have this name.");
}

std::variant<LatLon, QString> typedPlace(const QString& text, PlaceHalf half, const LatLon& before)
{
    if (text.trimmed().isEmpty())
        return coordinateFaultText(CoordinateFault::Empty);
    // An angle alone, with a zero beside it, is a coordinate; and "47 03.2" is not read as two
    // angles.
    const bool isLatitude = half == PlaceHalf::Latitude;
    const QString beside = isLatitude ? text + u"; 0°"_s : u"0°; "_s + text;
    const auto read = parsePlace(withPlainHemispheres(beside).toStdString());
    if (const auto* at = std::get_if<LatLon>(&read)) {
        if ((isLatitude ? at->longitude_deg : at->latitude_deg) != 0)
            return isLatitude ? PlaceText::tr("This is a longitude. Enter a latitude.")
                              : PlaceText::tr("This is a latitude. Enter a longitude.");
        return isLatitude ? LatLon{at->latitude_deg, before.longitude_deg}
                          : LatLon{before.latitude_deg, at->longitude_deg};
    }
    const auto whole = findPlace(text);
    if (const auto* found = std::get_if<FoundPlace>(&whole))
        return found->at;
    const CoordinateFault fault = std::get<CoordinateFault>(read);
    return fault == CoordinateFault::Unreadable ? std::get<QString>(whole)
                                                : coordinateFaultText(fault);
}

QString faultForSeveral(const QString& text, PlaceHalf half)
{
    constexpr double kNoAngle = 1000; // no text can give this angle
    const auto typed = typedPlace(text, half, {kNoAngle, kNoAngle});
    const auto* at = std::get_if<LatLon>(&typed);
    if (at == nullptr || at->latitude_deg == kNoAngle || at->longitude_deg == kNoAngle)
        return {};
    return PlaceText::tr(
        "Enter one angle only: a whole coordinate would move all of them to one place.");
}

std::optional<Point> pointInReach(const LatLon& place, const LatLon& origin)
{
    const Point at_m = LocalFrame(origin).toPlane(place);
    if (at_m.cwiseAbs().maxCoeff() > kLargestCoordinate_m)
        return std::nullopt;
    return at_m;
}

QString beyondReachText(const LatLon& place, const LatLon& origin, const QLocale& locale)
{
    return PlaceText::tr("This is %1 from the scenario's origin; the limit is %2.")
        .arg(distanceText(LocalFrame(origin).toPlane(place).norm(), locale),
             distanceText(kLargestCoordinate_m, locale));
}

QString applyTypedPlace(Point& position_m, const QString& text, PlaceHalf half,
                        const LatLon& origin, const QLocale& locale)
{
    const auto typed = typedPlace(text, half, LocalFrame(origin).toGeographic(position_m));
    if (const auto* reason = std::get_if<QString>(&typed))
        return *reason;
    const auto& place = std::get<LatLon>(typed);
    const std::optional<Point> at_m = pointInReach(place, origin);
    if (!at_m)
        return beyondReachText(place, origin, locale);
    position_m = *at_m;
    return {};
}

QString coordinateFaultText(CoordinateFault fault)
{
    switch (fault) {
    case CoordinateFault::Empty:
        return PlaceText::tr("Enter a coordinate or a place name.");
    case CoordinateFault::Unreadable:
        return PlaceText::tr(
            "This is not a coordinate. Examples: 47° 03.2′ N 48° 06′ W, or 47.05 -48.1.");
    case CoordinateFault::Half:
        return PlaceText::tr("This is half a coordinate. Enter latitude and longitude.");
    case CoordinateFault::Ambiguous:
        return PlaceText::tr(
            "This coordinate is ambiguous. Add spaces and the letters N, S, E or W.");
    case CoordinateFault::HemisphereMissing:
        return PlaceText::tr("Only one half states its hemisphere. Add N, S, E or W to the other.");
    case CoordinateFault::SignAndLetter:
        return PlaceText::tr("Use a sign or a hemisphere letter, not both.");
    case CoordinateFault::SameAxis:
        return PlaceText::tr("Enter one latitude and one longitude.");
    case CoordinateFault::Sixty:
        return PlaceText::tr("Minutes and seconds must be below 60.");
    case CoordinateFault::Latitude:
        return PlaceText::tr("Latitude must be between 90° S and 90° N.");
    case CoordinateFault::Longitude:
        return PlaceText::tr("Longitude must be between 180° W and 180° E.");
    case CoordinateFault::Grid:
        return PlaceText::tr("This position does not exist on the UTM or MGRS grid.");
    }
    return {};
}

} // namespace berg
