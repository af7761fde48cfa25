#pragma once

#include "core/io/export/formats.h"

#include <QWidget>

class QComboBox;
class QFormLayout;
class QSpinBox;

namespace berg {

class NumberField;

/** Fields for the part of a mission to export and its parameters. */
class ExportOptionsView : public QWidget
{
    Q_OBJECT

public:
    /** Starts with `options` as far as they fit the scenario. `flown` enables exports of a flight.
     */
    ExportOptionsView(const Scenario& scenario, bool flown, const ExportOptions& options,
                      QWidget* parent = nullptr);

    /** Offers only choices that this format supports. */
    void showFormat(const ExportFormat& format);

    /** Returns the options that the current format supports. */
    [[nodiscard]] ExportOptions options() const;

signals:
    void edited();

private:
    void addWhat(bool flown);
    void addUavs(const Scenario& scenario);
    void addNumbers();
    void addReturn();
    void fill(const ExportOptions& options);
    [[nodiscard]] NumberField* addNumber(const QString& label, const QString& name,
                                         const QString& unit, double most);

    bool m_isFlown = false;
    bool m_isWhatChosen = false; ///< the user chose the part, so another format keeps it
    QFormLayout* m_form = nullptr;
    QComboBox* m_what = nullptr;
    QComboBox* m_uav = nullptr;
    NumberField* m_altitude = nullptr;
    NumberField* m_airspeed = nullptr;
    NumberField* m_acceptance = nullptr;
    QSpinBox* m_loiter = nullptr;
    QComboBox* m_return = nullptr;
};

} // namespace berg
