#include "widgets/panels/fields/place_field.h"

#include "widgets/theme/quantity_text.h"

#include <QCompleter>
#include <QStandardItemModel>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kShownCharacters = 34; ///< length of a coordinate with seconds
constexpr int kNamesShown = 9;
constexpr int kSearchRole = Qt::UserRole;

/** Completes place names in either language, with or without diacritics. */
class PlaceCompleter final : public QCompleter
{
public:
    explicit PlaceCompleter(QObject* parent) : QCompleter(parent)
    {
        auto* names = new QStandardItemModel(this);
        for (const NamedPlace& place : namedPlaces()) {
            auto* item = new QStandardItem(place.name);
            item->setData(searchNames(place).join(u'\n'), kSearchRole);
            names->appendRow(item);
        }
        setModel(names);
        setCompletionRole(kSearchRole);
        setFilterMode(Qt::MatchContains);
        setMaxVisibleItems(kNamesShown);
    }

    [[nodiscard]] QStringList splitPath(const QString& path) const override
    {
        return {searchText(path)};
    }
    [[nodiscard]] QString pathFromIndex(const QModelIndex& index) const override
    {
        return index.data(Qt::DisplayRole).toString();
    }
};

} // namespace

PlaceField::PlaceField(QWidget* parent) : QLineEdit(parent)
{
    setPlaceholderText(tr("Coordinate or name of a place"));
    setAccessibleName(placeholderText());
    setClearButtonEnabled(true);
    auto* completer = new PlaceCompleter(this);
    setCompleter(completer);
    connect(completer, qOverload<const QString&>(&QCompleter::activated), this,
            &PlaceField::namePicked, Qt::QueuedConnection); // queued until the name is in the line
}

void PlaceField::showPlace(const LatLon& place)
{
    setText(placeText(place, kPlaceDecimals, locale()));
}

QSize PlaceField::sizeHint() const
{
    const int width_px = kShownCharacters * fontMetrics().averageCharWidth();
    return {width_px, QLineEdit::sizeHint().height()};
}

} // namespace berg
