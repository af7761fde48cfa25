#pragma once

#include "widgets/places/places.h"

#include <QLineEdit>

namespace berg {

/** A line for a coordinate in any form, or a place name, which it completes. GUI thread. */
class PlaceField : public QLineEdit
{
    Q_OBJECT

public:
    explicit PlaceField(QWidget* parent = nullptr);

    /** Returns the typed place, or a sentence on why it is none. */
    [[nodiscard]] std::variant<FoundPlace, QString> found() const { return findPlace(text()); }
    /** Shows a coordinate in the chosen form. */
    void showPlace(const LatLon& place);

    [[nodiscard]] QSize sizeHint() const override;

signals:
    /** Emitted when a name was picked from the list. */
    void namePicked();
};

} // namespace berg
