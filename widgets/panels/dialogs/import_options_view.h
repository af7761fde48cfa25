#pragma once

#include "widgets/model/import_preview.h"

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

/** The smallest box round a closed outline that goes round what is wanted, a pole included. */
[[nodiscard]] GeoBox boxRound(std::span<const LatLon> outline);

/** How sightings become icebergs, for editing. */
class ImportOptionsView : public QWidget
{
    Q_OBJECT

public:
    /** `presentName`: scenario on screen; `intoNew`: what is chosen at first. */
    ImportOptionsView(const QString& presentName, bool intoNew, QWidget* parent = nullptr);

    [[nodiscard]] ImportOptions options() const;
    [[nodiscard]] bool intoNew() const;
    /** Nothing but sightings can be taken then, and t = 0 stays. */
    void setInFlight(bool inFlight);
    /** As by hand. */
    void chooseNew();
    /** None: as the file suggests. */
    [[nodiscard]] std::optional<bool> oneIceberg() const { return m_oneChosen; }
    /** How 05/02/2021 is meant; none: as the file suggests. */
    [[nodiscard]] std::optional<DateOrder> dates() const;

    /** Times to start from, and whether there is a choice about unnamed icebergs and dates. */
    void showFile(const SightingSummary& file);
    void setArea(const GeoBox& box);

signals:
    void edited();
    void presentViewRequested();

private:
    /** A time that counts only when it is asked for. */
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
    void addTracks();
    void enableInputs();

    QFormLayout* m_form = nullptr;
    QComboBox* m_target = nullptr;
    QComboBox* m_dates = nullptr;
    TimeRow m_at;
    TimeRow m_since;
    TimeRow m_until;
    QCheckBox* m_areaBox = nullptr;
    std::array<NumberField*, 4> m_edges{}; ///< south, west, north, east
    QPushButton* m_presentView = nullptr;
    NumberField* m_error = nullptr;
    bool m_errorChosen = false; ///< otherwise it is that of the file's format
    NumberField* m_spread = nullptr;
    NumberField* m_velocityTime = nullptr;
    NumberField* m_growth = nullptr;
    QCheckBox* m_tracks = nullptr;
    QCheckBox* m_one = nullptr;
    std::optional<bool> m_oneChosen;
};

} // namespace berg
