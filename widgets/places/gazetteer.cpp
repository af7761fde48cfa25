#include "widgets/places/gazetteer.h"

#include "core/base/error.h"

#include <QCoreApplication>
#include <QFile>

#include <algorithm>
#include <array>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct PlaceText
{
    Q_DECLARE_TR_FUNCTIONS(PlaceText)
};

/** Names of `PlaceKind` in the file, in its order. */
constexpr std::array<const char*, 5> kKindNames{"water", "land", "cape", "town", "field"};

// Names in the file that are translated.
[[maybe_unused]] constexpr std::array kTranslated{
    QT_TRANSLATE_NOOP("PlaceText", "Amery Ice Shelf"),
    QT_TRANSLATE_NOOP("PlaceText", "Amundsen Sea"),
    QT_TRANSLATE_NOOP("PlaceText", "Antarctic Peninsula"),
    QT_TRANSLATE_NOOP("PlaceText", "Baffin Bay"),
    QT_TRANSLATE_NOOP("PlaceText", "Baffin Island"),
    QT_TRANSLATE_NOOP("PlaceText", "Barents Sea"),
    QT_TRANSLATE_NOOP("PlaceText", "Bear Island"),
    QT_TRANSLATE_NOOP("PlaceText", "Beaufort Sea"),
    QT_TRANSLATE_NOOP("PlaceText", "Bellingshausen Sea"),
    QT_TRANSLATE_NOOP("PlaceText", "Bering Sea"),
    QT_TRANSLATE_NOOP("PlaceText", "Bering Strait"),
    QT_TRANSLATE_NOOP("PlaceText", "Bransfield Strait"),
    QT_TRANSLATE_NOOP("PlaceText", "Cape Farewell"),
    QT_TRANSLATE_NOOP("PlaceText", "Cape Horn"),
    QT_TRANSLATE_NOOP("PlaceText", "Cape York"),
    QT_TRANSLATE_NOOP("PlaceText", "Chukchi Sea"),
    QT_TRANSLATE_NOOP("PlaceText", "Davis Strait"),
    QT_TRANSLATE_NOOP("PlaceText", "Denmark Strait"),
    QT_TRANSLATE_NOOP("PlaceText", "Disko Bay"),
    QT_TRANSLATE_NOOP("PlaceText", "Drake Passage"),
    QT_TRANSLATE_NOOP("PlaceText", "East Siberian Sea"),
    QT_TRANSLATE_NOOP("PlaceText", "Ellesmere Island"),
    QT_TRANSLATE_NOOP("PlaceText", "Falkland Islands"),
    QT_TRANSLATE_NOOP("PlaceText", "Fram Strait"),
    QT_TRANSLATE_NOOP("PlaceText", "Franz Josef Land"),
    QT_TRANSLATE_NOOP("PlaceText", "Greenland"),
    QT_TRANSLATE_NOOP("PlaceText", "Greenland Sea"),
    QT_TRANSLATE_NOOP("PlaceText", "Gulf of St. Lawrence"),
    QT_TRANSLATE_NOOP("PlaceText", "Hinlopen Strait"),
    QT_TRANSLATE_NOOP("PlaceText", "Hudson Bay"),
    QT_TRANSLATE_NOOP("PlaceText", "Hudson Strait"),
    QT_TRANSLATE_NOOP("PlaceText", "Iceland"),
    QT_TRANSLATE_NOOP("PlaceText", "Iceland Sea"),
    QT_TRANSLATE_NOOP("PlaceText", "Irminger Sea"),
    QT_TRANSLATE_NOOP("PlaceText", "Kara Sea"),
    QT_TRANSLATE_NOOP("PlaceText", "Labrador Sea"),
    QT_TRANSLATE_NOOP("PlaceText", "Lancaster Sound"),
    QT_TRANSLATE_NOOP("PlaceText", "Laptev Sea"),
    QT_TRANSLATE_NOOP("PlaceText", "Lincoln Sea"),
    QT_TRANSLATE_NOOP("PlaceText", "McMurdo Sound"),
    QT_TRANSLATE_NOOP("PlaceText", "Melville Bay"),
    QT_TRANSLATE_NOOP("PlaceText", "Nares Strait"),
    QT_TRANSLATE_NOOP("PlaceText", "New Siberian Islands"),
    QT_TRANSLATE_NOOP("PlaceText", "Newfoundland"),
    QT_TRANSLATE_NOOP("PlaceText", "North Cape"),
    QT_TRANSLATE_NOOP("PlaceText", "North Pole"),
    QT_TRANSLATE_NOOP("PlaceText", "North Sea"),
    QT_TRANSLATE_NOOP("PlaceText", "Norwegian Sea"),
    QT_TRANSLATE_NOOP("PlaceText", "Novaya Zemlya"),
    QT_TRANSLATE_NOOP("PlaceText", "Ross Sea"),
    QT_TRANSLATE_NOOP("PlaceText", "Scoresby Sund"),
    QT_TRANSLATE_NOOP("PlaceText", "Scotia Sea"),
    QT_TRANSLATE_NOOP("PlaceText", "Severnaya Zemlya"),
    QT_TRANSLATE_NOOP("PlaceText", "South Georgia"),
    QT_TRANSLATE_NOOP("PlaceText", "South Orkney Islands"),
    QT_TRANSLATE_NOOP("PlaceText", "South Pole"),
    QT_TRANSLATE_NOOP("PlaceText", "South Shetland Islands"),
    QT_TRANSLATE_NOOP("PlaceText", "Strait of Belle Isle"),
    QT_TRANSLATE_NOOP("PlaceText", "Weddell Sea"),
    QT_TRANSLATE_NOOP("PlaceText", "White Sea"),
    QT_TRANSLATE_NOOP("PlaceText", "Wrangel Island")};

/** The columns are latitude, longitude, kind, rank, name and other names, if any. */
GazetteerPlace placeOf(const QByteArray& line)
{
    const QList<QByteArray> columns = line.split('\t');
    require(columns.size() == 5 || columns.size() == 6, "a place has five or six columns");
    const auto kind =
        std::ranges::find_if(kKindNames, [&](const char* name) { return columns[2] == name; });
    require(kind != kKindNames.end(), "the kind of a place is known");
    GazetteerPlace place{.name = columns[4],
                         .at = {columns[0].toDouble(), columns[1].toDouble()},
                         .kind = static_cast<PlaceKind>(kind - kKindNames.begin()),
                         .rank = columns[3].toInt()};
    if (columns.size() == 6)
        place.also = QString::fromUtf8(columns[5]).split(u"; "_s);
    return place;
}

std::vector<GazetteerPlace> readGazetteer()
{
    QFile file(u":/map/places.tsv"_s);
    require(file.open(QIODevice::ReadOnly), "the gazetteer is part of the program");
    std::vector<GazetteerPlace> places;
    for (const QByteArray& line : file.readAll().split('\n'))
        if (!line.isEmpty() && !line.startsWith('#'))
            places.push_back(placeOf(line));
    std::ranges::stable_sort(places, {}, &GazetteerPlace::rank);
    return places;
}

} // namespace

const std::vector<GazetteerPlace>& gazetteer()
{
    static const std::vector<GazetteerPlace> places = readGazetteer();
    return places;
}

QString placeName(const GazetteerPlace& place)
{
    return PlaceText::tr(place.name.constData());
}

} // namespace berg
