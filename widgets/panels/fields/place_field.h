#pragma once

#include "widgets/model/places.h"

#include <QLineEdit>

namespace berg {

/** A line for a coordinate in any form or the name of a place, which it completes. GUI thread. */
class PlaceField : public QLineEdit
{
    Q_OBJECT

public:
    explicit PlaceField(QWidget* parent = nullptr);

    /** What is typed; else why that is no place. */
    [[nodiscard]] std::variant<FoundPlace, QString> found() const { return findPlace(text()); }
    /** Writes a coordinate in the form chosen. */
    void showPlace(const LatLon& place);

    [[nodiscard]] QSize sizeHint() const override;

signals:
    /** A name was picked from the list. */
    void namePicked();
};

} // namespace berg
