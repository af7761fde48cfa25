#include "widgets/places/find_matches.h"

#include "core/scenario/scenario.h"
#include "widgets/places/places.h"
#include "widgets/theme/quantity_text.h"

#include <QLocale>

#include <algorithm>
#include <optional>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr auto kPlacePrefix = QLatin1String("place:");
constexpr auto kCommandPrefix = QLatin1String("command:");
constexpr auto kFieldPrefix = QLatin1String("field:");
constexpr auto kCoordinatePrefix = QLatin1String("at:");

/** Returns the rank of a name, smaller is better, or nullopt if it does not match. */
std::optional<int> rankOf(const QString& wanted, const QString& name)
{
    if (name.isEmpty())
        return std::nullopt;
    if (name == wanted)
        return 0;
    if (name.startsWith(wanted))
        return 1;
    const QString spaced = u' ' + name;
    const QStringList words = wanted.split(u' ');
    const auto begins = [&](const QString& word) { return spaced.contains(u' ' + word); };
    if (std::ranges::all_of(words, begins))
        return 2;
    const auto isThere = [&](const QString& word) { return name.contains(word); };
    return std::ranges::all_of(words, isThere) ? std::optional(3) : std::nullopt;
}

/** Returns the best rank over all names of an item and over words of several names. */
std::optional<int> rankOf(const QString& wanted, const FindItem& item)
{
    QStringList names{searchText(item.text), searchText(item.text + u' ' + item.other)};
    for (const QString& other : item.other.split(u'\n'))
        names << searchText(other);
    std::optional<int> best;
    for (const QString& one : names)
        if (const std::optional<int> rank = rankOf(wanted, one); rank && (!best || *rank < *best))
            best = rank;
    return best;
}

std::optional<FindItem> coordinateOf(const QString& text)
{
    const auto read = parsePlace(withPlainHemispheres(text).toStdString());
    const auto* at = std::get_if<LatLon>(&read);
    if (at == nullptr)
        return std::nullopt;
    return FindItem{.kind = FindKind::Place,
                    .key = {},
                    .text = placeText(*at, kPlaceDecimals, QLocale()),
                    .other = {},
                    .hint = {},
                    .at = *at};
}

FindItem objectItem(FindKind kind, const std::string& id, const std::string& name)
{
    const QString key = QString::fromStdString(id);
    return {.kind = kind,
            .key = key,
            .text = name.empty() ? key : QString::fromStdString(name),
            .other = key,
            .hint = {},
            .at = {}};
}

} // namespace

std::vector<FindItem> findableItems(const Scenario& scenario)
{
    std::vector<FindItem> items;
    for (const Iceberg& iceberg : scenario.icebergs)
        items.push_back(objectItem(FindKind::Iceberg, iceberg.id, iceberg.name));
    for (const Uav& uav : scenario.uavs)
        items.push_back(objectItem(FindKind::Uav, uav.id, uav.name));
    std::vector<NamedPlace> places = namedPlaces();
    std::ranges::stable_sort(places, {}, &NamedPlace::rank);
    for (const NamedPlace& place : places)
        items.push_back({.kind = FindKind::Place,
                         .key = place.english,
                         .text = place.name,
                         .other = (QStringList{place.english} + place.also).join(u'\n'),
                         .hint = placeText(place.at, 0, QLocale()),
                         .at = place.at,
                         .placeKind = place.kind});
    return items;
}

QString favouriteKey(const FindItem& item)
{
    switch (item.kind) {
    case FindKind::Iceberg:
    case FindKind::Uav:
        return {};
    case FindKind::Command:
        return kCommandPrefix + item.key;
    case FindKind::Field:
        return kFieldPrefix + item.key;
    case FindKind::Place:
        break;
    }
    if (!item.key.isEmpty())
        return kPlacePrefix + item.key;
    const auto angle = [](double angle_deg) {
        return QString::number(angle_deg, 'f', QLocale::FloatingPointShortest);
    };
    return kCoordinatePrefix + angle(item.at.latitude_deg) + u' ' + angle(item.at.longitude_deg);
}

void markFavourites(std::vector<FindItem>& items, const QStringList& keys)
{
    for (FindItem& item : items)
        item.isFavourite = keys.contains(favouriteKey(item));
    for (const QString& key : keys)
        if (key.startsWith(kCoordinatePrefix))
            if (std::optional<FindItem> item = coordinateOf(key.sliced(kCoordinatePrefix.size()))) {
                item->isFavourite = true;
                items.push_back(*item);
            }
}

std::vector<FindItem> findMatches(const QString& text, const std::vector<FindItem>& items,
                                  std::size_t most)
{
    const QString wanted = searchText(text);
    std::vector<std::pair<int, const FindItem*>> ranked;
    for (const FindItem& item : items) {
        const std::optional<int> rank = wanted.isEmpty() ? std::nullopt : rankOf(wanted, item);
        const int behind = item.isFavourite ? 0 : 1;
        if (rank || (text.trimmed().isEmpty() && item.isFavourite))
            ranked.emplace_back(2 * rank.value_or(0) + behind, &item);
    }
    std::ranges::stable_sort(ranked, {}, [](const auto& one) { return one.first; });
    std::vector<FindItem> found;
    const std::optional<FindItem> coordinate = coordinateOf(text);
    const bool isNameFirst = isWithoutDigits(text);
    if (coordinate && !isNameFirst)
        found.push_back(*coordinate);
    for (const auto& [rank, item] : ranked)
        if (found.size() < most)
            found.push_back(*item);
    if (coordinate && isNameFirst && found.size() < most)
        found.push_back(*coordinate);
    return found;
}

} // namespace berg
