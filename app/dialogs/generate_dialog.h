#pragma once

#include "core/presets/generate.h"
#include "widgets/map/picture/map_view_transform.h"
#include "widgets/panels/fields/number_field.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSpinBox;

namespace berg {

/**
 * Asks for the parameters of a random field of icebergs and generates it at every change. The owner
 * shows the result on the map; the dialog itself changes nothing.
 */
class GenerateDialog : public QDialog
{
    Q_OBJECT

public:
    /** `view_m` is the part of the plane that the map shows. */
    GenerateDialog(const Scenario& scenario, const WorldBounds& view_m, QWidget* parent = nullptr);

    /** The scenario with the generated field, or the original one if no field can be generated. */
    [[nodiscard]] const Scenario& result() const { return m_result; }
    /** Number of icebergs generated; 0 if none can be. */
    [[nodiscard]] int count() const { return m_count; }

signals:
    /** Emitted when `result` has changed. */
    void drawn();

private:
    /** Region in which the icebergs lie. */
    enum class FieldPlace
    {
        Area,
        View,
        Rectangle
    };

    /** Specification of a number field with the lower limit 0. */
    struct NumberSpec
    {
        const char* name;
        QString label;
        QString unit;
        Decimals decimals;
        double high;
        double step;
        double value;
    };

    void addPlace(QFormLayout& form);
    void addMotion(QFormLayout& form);
    void addUncertainty(QFormLayout& form);
    void addSeed(QFormLayout& form);
    void addEnd(QFormLayout& form);
    NumberField* makeNumber(const NumberSpec& spec) const;
    [[nodiscard]] FieldPlace place() const;
    [[nodiscard]] std::vector<Point> area_m() const;
    [[nodiscard]] FieldRequest request() const;
    void draw();
    void showState(const QString& fault);

    Scenario m_scenario;
    WorldBounds m_view_m;
    Scenario m_result;
    int m_count = 0;
    QSpinBox* m_number = nullptr;
    QComboBox* m_place = nullptr;
    NumberField* m_width = nullptr;
    NumberField* m_height = nullptr;
    NumberField* m_speedMin = nullptr;
    NumberField* m_speedMax = nullptr;
    QComboBox* m_direction = nullptr;
    NumberField* m_towards_deg = nullptr;
    NumberField* m_spread_deg = nullptr;
    NumberField* m_sigmaMin_m2 = nullptr;
    NumberField* m_sigmaMax_m2 = nullptr;
    NumberField* m_q_m2ps = nullptr;
    NumberField* m_spacing = nullptr;
    QSpinBox* m_seed = nullptr;
    QCheckBox* m_replace = nullptr;
    QLabel* m_state = nullptr;
    QPushButton* m_ok = nullptr;
};

} // namespace berg
