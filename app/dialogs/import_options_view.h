#pragma once

#include "widgets/sightings/import_preview.h"

#include <QWidget>

#include <array>
#include <span>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QPushButton;

namespace berg {

class EntryField;
class NumberField;

/**
 * Returns the smallest box around a closed outline; it includes a pole that the outline encloses.
 */
[[nodiscard]] GeoBox boxRound(std::span<const LatLon> outline);

/** Editor of the options by which sightings become icebergs. */
class ImportOptionsView : public QWidget
{
    Q_OBJECT

public:
    /**
     * `presentName` is the name of the present scenario; `intoNew` the initial choice of target.
     */
    ImportOptionsView(const QString& presentName, bool intoNew, QWidget* parent = nullptr);

    [[nodiscard]] ImportOptions options() const;
    [[nodiscard]] bool intoNew() const;
    /** In flight only sightings are imported, and t = 0 stays. */
    void setInFlight(bool inFlight);
    /** Chooses a new scenario as the target, as the user could. */
    void chooseNew();
    /**
     * Returns the order of day and month in dates such as 05/02/2021, or nullopt if it is detected.
     */
    [[nodiscard]] std::optional<DateOrder> dates() const;

    /** Shows times of the file to choose from, and whether dates are ambiguous. */
    void showFile(const SightingSummary& file);
    void setArea(const GeoBox& box);

signals:
    void edited();
    void presentViewRequested();

private:
    /** An optional time: used only if its box is checked. */
    struct TimeRow
    {
        QCheckBox* box = nullptr;
        EntryField* edit = nullptr;
    };
    void addDates();
    void addTarget(const QString& presentName, bool intoNew);
    TimeRow addTime(const QString& name, const QString& text, const QString& toolTip);
    void addArea();
    NumberField* addNumber(const QString& name, const QString& label, const QString& toolTip,
                           double value, double highest, int decimals, const QString& unit);
    void addSource();
    void addTracks();
    void enableInputs();

    QFormLayout* m_form = nullptr;
    QComboBox* m_target = nullptr;
    QComboBox* m_dates = nullptr;
    TimeRow m_at;
    TimeRow m_since;
    TimeRow m_until;
    QCheckBox* m_areaBox = nullptr;
    std::array<NumberField*, 4> m_edges{}; ///< south, west, north, east edges
    QPushButton* m_presentView = nullptr;
    QComboBox* m_source = nullptr;
    NumberField* m_error = nullptr;
    double m_fileError_m = kMarkedPlace_m; ///< default of the file's format
    /** Whether the user typed an error; otherwise the format's default is used. */
    bool m_errorChosen = false;
    NumberField* m_spread = nullptr;
    NumberField* m_velocityTime = nullptr;
    NumberField* m_growth = nullptr;
    QCheckBox* m_tracks = nullptr;
};

} // namespace berg
