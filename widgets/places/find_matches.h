#pragma once

#include "widgets/places/gazetteer.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace berg {

struct Scenario;

enum class FindKind
{
    Iceberg,
    Uav,
    Place, ///< place with a name, or a coordinate
    Command,
    Field ///< input of the Inspector
};

/** An item that can be found by its name. */
struct FindItem
{
    FindKind kind = FindKind::Place;
    /**
     * Id, English name of a place, or object name of an action or input; empty for a coordinate.
     */
    QString key{};
    QString text{};  ///< name in the current language
    QString other{}; ///< further names, one a line: id, English name, use of a command
    QString hint{};  ///< shown beside the name: shortcut of a command, position of a place
    LatLon at{};     ///< position of a place
    bool isFavourite = false;
    std::optional<PlaceKind> placeKind = {}; ///< nullopt for coordinates and other items
};

/** Returns icebergs and UAVs of a scenario, then the places of the gazetteer, best known first. */
[[nodiscard]] std::vector<FindItem> findableItems(const Scenario& scenario);

/**
 * Returns the key of a favourite in the settings, or an empty text for an item of one scenario,
 * which cannot be a favourite.
 */
[[nodiscard]] QString favouriteKey(const FindItem& item);
/** Marks the items whose keys are in `keys` as favourites and adds the coordinates among them. */
void markFavourites(std::vector<FindItem>& items, const QStringList& keys);

/**
 * Returns at most `most` items that match a text, best first: equal names, names that begin with
 * it, names with words that begin so, names that contain it; favourites first within each, then in
 * the order of `items`. A coordinate in any form is found as well, first if it has a digit, else
 * last. All words of the text must occur, in any order, ignoring case and diacritics. An empty text
 * returns the favourites.
 */
[[nodiscard]] std::vector<FindItem>
findMatches(const QString& text, const std::vector<FindItem>& items, std::size_t most);

} // namespace berg
