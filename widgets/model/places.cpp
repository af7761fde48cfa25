#include "widgets/model/places.h"

#include "core/scenario/limits.h"
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

struct Entry
{
    const char* name;
    double latitude_deg;
    double longitude_deg;
};

// To about a hundredth of a degree for towns and fields, the middle for seas. Marked are those that
// have a name in other languages.
constexpr std::array kPlaces{
    Entry{"Grand Banks", 45.50, -51.50},
    Entry{"Flemish Pass", 47.30, -46.90},
    Entry{"Flemish Cap", 47.00, -45.00},
    Entry{"Hibernia", 46.75, -48.78},
    Entry{"St. John's", 47.56, -52.71},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Labrador Sea"), 58.00, -54.00},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Davis Strait"), 66.00, -58.00},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Baffin Bay"), 73.00, -66.00},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Disko Bay"), 69.00, -52.50},
    Entry{"Ilulissat", 69.22, -51.10},
    Entry{"Nuuk", 64.18, -51.72},
    Entry{"Upernavik", 72.79, -56.15},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Melville Bay"), 75.50, -62.00},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Cape York"), 75.90, -66.40},
    Entry{"Pituffik", 76.53, -68.70},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Nares Strait"), 80.00, -69.00},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Cape Farewell"), 59.77, -43.92},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Denmark Strait"), 67.00, -25.00},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Scoresby Sund"), 70.50, -25.00},
    Entry{"Jan Mayen", 70.98, -8.53},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Fram Strait"), 79.00, 0.00},
    Entry{"Svalbard", 78.50, 18.00},
    Entry{"Longyearbyen", 78.22, 15.65},
    Entry{"Kongsfjorden", 78.97, 12.00},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Hinlopen Strait"), 79.60, 18.60},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Bear Island"), 74.43, 19.00},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Barents Sea"), 75.00, 40.00},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Franz Josef Land"), 80.70, 55.00},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Novaya Zemlya"), 74.00, 57.00},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Kara Sea"), 76.00, 75.00},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Laptev Sea"), 76.00, 125.00},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Bering Strait"), 65.75, -168.98},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Beaufort Sea"), 72.00, -137.00},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "North Pole"), 90.00, 0.00},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Drake Passage"), -58.00, -65.00},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "South Georgia"), -54.30, -36.80},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Weddell Sea"), -73.00, -45.00},
    Entry{"Bouvetøya", -54.42, 3.36},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Amery Ice Shelf"), -69.75, 71.00},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "Ross Sea"), -75.00, -175.00},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "McMurdo Sound"), -77.50, 165.00},
    Entry{QT_TRANSLATE_NOOP("PlaceText", "South Pole"), -90.00, 0.00}};

} // namespace

std::vector<NamedPlace> namedPlaces()
{
    std::vector<NamedPlace> places;
    for (const Entry& entry : kPlaces)
        places.push_back({.name = PlaceText::tr(entry.name),
                          .english = QString::fromUtf8(entry.name),
                          .at = {entry.latitude_deg, entry.longitude_deg}});
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
        else if (c == u'τ') // as it is typed
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

std::variant<FoundPlace, QString> findPlace(const QString& text)
{
    const QString wanted = searchText(text);
    std::vector<FoundPlace> partly;
    for (const NamedPlace& place : namedPlaces()) {
        const QString name = searchText(place.name);
        const QString english = searchText(place.english);
        if (wanted == name || wanted == english)
            return FoundPlace{place.at, place.name};
        if (name.contains(wanted) || english.contains(wanted))
            partly.push_back({place.at, place.name});
    }
    const auto read = parsePlace(text.toStdString());
    if (const auto* at = std::get_if<LatLon>(&read))
        return FoundPlace{*at, {}};
    const bool isWord =
        std::any_of(wanted.begin(), wanted.end(), [](QChar c) { return c.isLetter(); }) &&
        std::none_of(wanted.begin(), wanted.end(), [](QChar c) { return c.isDigit(); });
    if (!isWord)
        return coordinateFaultText(std::get<CoordinateFault>(read));
    if (partly.size() == 1)
        return partly.front();
    return partly.empty() ? PlaceText::tr("There is no place of this name here, and it is not a "
                                          "coordinate.")
                          : PlaceText::tr("Several places are called like this.");
}

std::variant<LatLon, QString> typedPlace(const QString& text, PlaceHalf half, const LatLon& before)
{
    if (text.trimmed().isEmpty())
        return coordinateFaultText(CoordinateFault::Empty);
    // Beside a zero an angle alone is a coordinate, and "47 03.2" is not taken for two.
    const bool isLatitude = half == PlaceHalf::Latitude;
    const QString beside = isLatitude ? text + u"; 0°"_s : u"0°; "_s + text;
    const auto read = parsePlace(beside.toStdString());
    if (const auto* at = std::get_if<LatLon>(&read)) {
        if ((isLatitude ? at->longitude_deg : at->latitude_deg) != 0)
            return isLatitude ? PlaceText::tr("This is a longitude, a latitude is needed.")
                              : PlaceText::tr("This is a latitude, a longitude is needed.");
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
    constexpr double kNoAngle = 1000; // that a text could say
    const auto typed = typedPlace(text, half, {kNoAngle, kNoAngle});
    const auto* at = std::get_if<LatLon>(&typed);
    if (at == nullptr || at->latitude_deg == kNoAngle || at->longitude_deg == kNoAngle)
        return {};
    return PlaceText::tr("Type one angle: a whole coordinate would put all of them at one place.");
}

std::optional<Point> reachedPoint(const LatLon& place, const LatLon& origin)
{
    const Point at_m = LocalFrame(origin).toPlane(place);
    if (at_m.cwiseAbs().maxCoeff() > kLargestCoordinate_m)
        return std::nullopt;
    return at_m;
}

QString beyondReachText(const LatLon& place, const LatLon& origin, const QLocale& locale)
{
    return PlaceText::tr("This is %1 from the origin of the scenario, which reaches %2.")
        .arg(distanceText(LocalFrame(origin).toPlane(place).norm(), locale),
             distanceText(kLargestCoordinate_m, locale));
}

QString takePlace(Point& position_m, const QString& text, PlaceHalf half, const LatLon& origin,
                  const QLocale& locale)
{
    const auto typed = typedPlace(text, half, LocalFrame(origin).toGeographic(position_m));
    if (const auto* reason = std::get_if<QString>(&typed))
        return *reason;
    const auto& place = std::get<LatLon>(typed);
    const std::optional<Point> at_m = reachedPoint(place, origin);
    if (!at_m)
        return beyondReachText(place, origin, locale);
    position_m = *at_m;
    return {};
}

QString coordinateFaultText(CoordinateFault fault)
{
    switch (fault) {
    case CoordinateFault::Empty:
        return PlaceText::tr("A coordinate or the name of a place is needed.");
    case CoordinateFault::Unreadable:
        return PlaceText::tr("This is not a coordinate. Such as 47° 03.2′ N 48° 06′ W, or "
                             "47.05 -48.1.");
    case CoordinateFault::Half:
        return PlaceText::tr("This is half a coordinate: latitude and longitude are needed.");
    case CoordinateFault::Ambiguous:
        return PlaceText::tr("This can be read in more than one way. Spaces and the letters N, S, "
                             "E and W make it clear.");
    case CoordinateFault::HemisphereMissing:
        return PlaceText::tr("One half says which hemisphere it is in, the other does not.");
    case CoordinateFault::SignAndLetter:
        return PlaceText::tr("Either a sign or a letter says which hemisphere, not both.");
    case CoordinateFault::SameAxis:
        return PlaceText::tr("One latitude and one longitude are needed, not two of a kind.");
    case CoordinateFault::Sixty:
        return PlaceText::tr("Minutes and seconds are less than 60.");
    case CoordinateFault::Latitude:
        return PlaceText::tr("Latitudes go from 90° S to 90° N.");
    case CoordinateFault::Longitude:
        return PlaceText::tr("Longitudes go from 180° W to 180° E.");
    case CoordinateFault::Grid:
        return PlaceText::tr("There is no such place on the UTM or MGRS grid.");
    }
    return {};
}

} // namespace berg
