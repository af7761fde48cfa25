#pragma once

#include "app/dialogs/interaction.h"

#include <QDialog>

class QLabel;
class QPushButton;
class QRadioButton;

namespace berg {

class OverviewInset;
class PlaceField;

/** Asks for the new place of a scenario, on a chart or as text, and explains why a place is
 * impossible. */
class OriginDialog : public QDialog
{
    Q_OBJECT

public:
    /** `scenario` must outlive the dialog. */
    OriginDialog(const Scenario& scenario, const LatLon& suggested, const Theme& theme,
                 QWidget* parent = nullptr);

    /** Returns the choice as entered; nullopt if the scenario cannot be moved there. */
    [[nodiscard]] const std::optional<OriginChoice>& choice() const { return m_choice; }

private:
    void judge();
    [[nodiscard]] double path_m(const LatLon& place) const;
    [[nodiscard]] QString summary(const LatLon& place) const;

    const Scenario& m_scenario;
    PlaceField* m_field;
    OverviewInset* m_chart;
    QRadioButton* m_keepLayout;
    QRadioButton* m_keepPlaces;
    QLabel* m_note = nullptr;
    QPushButton* m_move = nullptr;
    std::optional<OriginChoice> m_choice;
};

} // namespace berg
