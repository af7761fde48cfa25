#pragma once

#include "core/geometry/geometry.h"

#include <QDialog>

class QLabel;

namespace berg {

class NumberField;

/** Asks for a wind as forecasts give it: speed, and the direction it comes from. */
class WindDialog : public QDialog
{
    Q_OBJECT

public:
    /** Starts with `wind_mps` and accepts winds below `airspeed_mps`, which is above 0. */
    WindDialog(const Point& wind_mps, double airspeed_mps, QWidget* parent = nullptr);

    /** Returns the wind as entered, or exactly the initial wind if it was not edited. */
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
