#pragma once

#include "core/base/coordinates.h"

#include <QString>

#include <variant>
#include <vector>

namespace berg {

/** A place of ice navigation that comes with the program. */
struct NamedPlace
{
    QString name;    ///< in the language of now
    QString english; ///< found by that as well
    LatLon at;
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

/** A name, a coordinate, or a part of one name only; else why not, as a sentence. */
[[nodiscard]] std::variant<FoundPlace, QString> findPlace(const QString& text);

/** In the user's words, a whole sentence. */
[[nodiscard]] QString coordinateFaultText(CoordinateFault fault);

} // namespace berg
