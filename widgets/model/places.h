#pragma once

#include "core/base/coordinates.h"

#include <QLocale>
#include <QStringList>

#include <optional>
#include <variant>
#include <vector>

namespace berg {

/** A place of ice navigation that comes with the program. */
struct NamedPlace
{
    QString name;       ///< in the language of now
    QString english;    ///< found by that as well
    QStringList also{}; ///< and by these: former names, names in other languages
    LatLon at;
    int rank = 1; ///< 1 is the best known, 5 the least
};

/** By name. */
[[nodiscard]] std::vector<NamedPlace> namedPlaces();

/** Lower-case Latin letters without diacritics, digits and single spaces, to compare names by. */
[[nodiscard]] QString searchText(const QString& text);

/** Of a text: where it is, and its name if it has one. */
struct FoundPlace
{
    LatLon at;
    QString name; ///< empty: a coordinate
};

/** All that the place is found by, as `searchText`. */
[[nodiscard]] QStringList searchNames(const NamedPlace& place);

/**
 * Whether a text is words: these are names first. "bay" is a square of MGRS in Antarctica as well,
 * which nobody means who has Baffin Bay to choose.
 */
[[nodiscard]] bool isWithoutDigits(const QString& text);

/** A name, a coordinate, or a part of one name only; else why not, as a sentence. */
[[nodiscard]] std::variant<FoundPlace, QString> findPlace(const QString& text);

/** Half of a place. */
enum class PlaceHalf
{
    Latitude,
    Longitude
};

/**
 * A place typed over another: an angle in any form takes the place of this half of `before`, a
 * whole coordinate or a name of both. Else why not, as a sentence.
 */
[[nodiscard]] std::variant<LatLon, QString> typedPlace(const QString& text, PlaceHalf half,
                                                       const LatLon& before);

/**
 * Why a text is not typed over this half of several places, a whole sentence: it sets both, and
 * would put them all on one. Empty: it can be.
 */
[[nodiscard]] QString faultForSeveral(const QString& text, PlaceHalf half);

/** Where a place is on the plane of a scenario; empty: beyond what that reaches. */
[[nodiscard]] std::optional<Point> reachedPoint(const LatLon& place, const LatLon& origin);
/** How far away a place is that is not reached, a whole sentence. */
[[nodiscard]] QString beyondReachText(const LatLon& place, const LatLon& origin,
                                      const QLocale& locale);

/** Moves a point of a scenario to what is typed; else says why not and leaves it. */
[[nodiscard]] QString takePlace(Point& position_m, const QString& text, PlaceHalf half,
                                const LatLon& origin, const QLocale& locale);

/** In the user's words, a whole sentence. */
[[nodiscard]] QString coordinateFaultText(CoordinateFault fault);

} // namespace berg
