#pragma once

#include "core/io/export/formats.h"

#include <QWidget>

class QComboBox;
class QFormLayout;
class QSpinBox;

namespace berg {

class NumberField;

/** What of a mission is exported and with which numbers. */
class ExportOptionsView : public QWidget
{
    Q_OBJECT

public:
    /** `flown`: there is a flight. Starts with `options` as far as they fit the scenario. */
    ExportOptionsView(const Scenario& scenario, bool flown, const ExportOptions& options,
                      QWidget* parent = nullptr);

    /** Only what files of this format can hold can be chosen. */
    void showFormat(const ExportFormat& format);

    /** Those that the format shown can hold. */
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
    bool m_isWhatChosen = false; ///< by the user: it stays whatever the format
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
