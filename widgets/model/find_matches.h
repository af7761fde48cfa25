#pragma once

#include "core/base/geodesy.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace berg {

struct Scenario;

enum class FindKind
{
    Iceberg,
    Uav,
    Place, ///< named or a coordinate
    Command
};

/** Something that can be found by its name. */
struct FindItem
{
    FindKind kind = FindKind::Place;
    QString key{}; ///< id, English name of a place or object name of an action; empty: a coordinate
    QString text{};  ///< in the language of now
    QString other{}; ///< found by each of its lines as well: id, English name, use of a command
    QString hint{};  ///< shown beside it, e.g. the shortcut of a command
    LatLon at{};     ///< of a place
    bool isFavourite = false;
};

/** Icebergs and UAVs of a scenario, then the places that come with the program, the best known
 * first. */
[[nodiscard]] std::vector<FindItem> findableItems(const Scenario& scenario);

/** Names a favourite in the settings; empty: it belongs to one scenario and can be none. */
[[nodiscard]] QString favouriteKey(const FindItem& item);
/** Marks those of `keys`; adds the coordinates among them. */
void markFavourites(std::vector<FindItem>& items, const QStringList& keys);

/**
 * What a text finds, best first, at most so many: what is called so, what begins so, what has words
 * that begin so, what has it somewhere; favourites first within each, then the order of `items`. A
 * coordinate in any form is found as well, before all else, or after it when it is without a digit.
 * All words of the text must be there, in any order, whatever their case and diacritics. An empty
 * text finds the favourites.
 */
[[nodiscard]] std::vector<FindItem>
findMatches(const QString& text, const std::vector<FindItem>& items, std::size_t most);

} // namespace berg
