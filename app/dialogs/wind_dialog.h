#pragma once

#include "core/base/geometry.h"

#include <QDialog>

class QLabel;

namespace berg {

class NumberField;

/** Asks for a wind as forecasts write it: how fast, and where from. */
class WindDialog : public QDialog
{
    Q_OBJECT

public:
    /** Begins with `wind_mps`; it stays slower than `airspeed_mps`, which is above 0. */
    WindDialog(const Point& wind_mps, double airspeed_mps, QWidget* parent = nullptr);

    /** As it stands in the dialog; to the last bit what it began with until it is edited. */
    [[nodiscard]] const Point& wind_mps() const { return m_wind_mps; }

private:
    void edit();
    void judge();

    Point m_wind_mps;
    double m_airspeed_mps;
    NumberField* m_speed;
    NumberField* m_from;
    QLabel* m_note = nullptr;
};

} // namespace berg
