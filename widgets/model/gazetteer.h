#pragma once

#include "core/base/geodesy.h"

#include <QByteArray>
#include <QStringList>

#include <cstdint>
#include <vector>

namespace berg {

enum class PlaceKind : std::uint8_t
{
    Water, ///< sea, strait, bay, fjord, bank
    Land,  ///< island or coast, an ice shelf as well
    Cape,
    Town, ///< or station
    Field ///< of oil or gas, with or without a platform
};

/** A place of the coasts that the program is for. */
struct GazetteerPlace
{
    QByteArray name; ///< in English or as its people call it, UTF-8
    LatLon at;       ///< the middle of waters and lands
    PlaceKind kind = PlaceKind::Water;
    int rank = 1;       ///< 1, known on a map of the ocean, to 5, known on one of the bay
    QStringList also{}; ///< other names: former ones, those in other languages
};

/** `resources/map/places.tsv`, read when first asked for: the lowest ranks first. Any thread. */
[[nodiscard]] const std::vector<GazetteerPlace>& gazetteer();

/** In the language of now. */
[[nodiscard]] QString placeName(const GazetteerPlace& place);

} // namespace berg
