#pragma once

#include "core/earth/geodesy.h"

#include <QByteArray>
#include <QStringList>

#include <cstdint>
#include <vector>

namespace berg {

enum class PlaceKind : std::uint8_t
{
    Water, ///< sea, strait, bay, fjord, bank
    Land,  ///< island or coast, also an ice shelf
    Cape,
    Town, ///< town or station
    Field ///< oil or gas field, with or without a platform
};

/** A place of the coasts that the program is used on. */
struct GazetteerPlace
{
    QByteArray name; ///< English or local name, UTF-8
    LatLon at;       ///< middle of waters and lands
    PlaceKind kind = PlaceKind::Water;
    int rank = 1;       ///< 1 is on a map of the ocean, 5 on one of the bay only
    QStringList also{}; ///< other names: former names and names in other languages
};

/**
 * Returns `resources/map/places.tsv`, lowest ranks first. It is read at the first call. Any thread.
 */
[[nodiscard]] const std::vector<GazetteerPlace>& gazetteer();

/** Returns the name in the current language. */
[[nodiscard]] QString placeName(const GazetteerPlace& place);

} // namespace berg
