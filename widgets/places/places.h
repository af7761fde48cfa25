#pragma once

#include "core/earth/coordinates.h"
#include "widgets/places/gazetteer.h"

#include <QLocale>
#include <QStringList>

#include <optional>
#include <variant>
#include <vector>

namespace berg {

/** A place name for ice navigation. */
struct NamedPlace
{
    QString name;       ///< name in the current language
    QString english;    ///< English name
    QStringList also{}; ///< former names and names in other languages
    LatLon at;
    int rank = 1; ///< 1 is the best known, 5 the least known
    PlaceKind kind = PlaceKind::Water;
};

/** Returns the places of the gazetteer, sorted by name. */
[[nodiscard]] std::vector<NamedPlace> namedPlaces();

/**
 * Returns the text in lower-case letters without diacritics, digits and single spaces, for
 * comparing names: ø becomes o, æ ae, τ tau; points and apostrophes are removed.
 */
[[nodiscard]] QString searchText(const QString& text);

/** A place found by a text. */
struct FoundPlace
{
    LatLon at;
    QString name; ///< empty for a coordinate
};

/** Returns all names of a place in the form of `searchText`. */
[[nodiscard]] QStringList searchNames(const NamedPlace& place);

/**
 * Returns whether a text has letters and no digits; such a text is a name first. "bay" is also an
 * MGRS square in Antarctica, which is not meant by a user who can choose Baffin Bay.
 */
[[nodiscard]] bool isWithoutDigits(const QString& text);

/**
 * Returns the place of a name, of a coordinate, or of a part of exactly one name; else the reason
 * as a sentence.
 */
[[nodiscard]] std::variant<FoundPlace, QString> findPlace(const QString& text);

/** The coordinate of a position that a field edits. */
enum class PlaceHalf
{
    Latitude,
    Longitude
};

/**
 * Returns `before` with the typed place: an angle replaces the given half, a whole coordinate or a
 * name replaces both. Else returns the reason as a sentence.
 */
[[nodiscard]] std::variant<LatLon, QString> typedPlace(const QString& text, PlaceHalf half,
                                                       const LatLon& before);

/**
 * Returns why a text cannot be typed for several positions at once, as a sentence: it sets both
 * halves and would move all of them to one place. Returns an empty text if it can.
 */
[[nodiscard]] QString faultForSeveral(const QString& text, PlaceHalf half);

/**
 * Returns the place in the scenario's plane, m, or nullopt if it is beyond the largest coordinate.
 */
[[nodiscard]] std::optional<Point> pointInReach(const LatLon& place, const LatLon& origin);
/** Returns a sentence that states how far beyond the scenario's reach a place is. */
[[nodiscard]] QString beyondReachText(const LatLon& place, const LatLon& origin,
                                      const QLocale& locale);

/**
 * Moves a point of a scenario to the typed place. Returns an empty text, or the reason as a
 * sentence and leaves the point unchanged.
 */
[[nodiscard]] QString applyTypedPlace(Point& position_m, const QString& text, PlaceHalf half,
                                      const LatLon& origin, const QLocale& locale);

/** Returns the fault as a sentence for the user. */
[[nodiscard]] QString coordinateFaultText(CoordinateFault fault);

} // namespace berg
