#pragma once

#include "core/mission/recorder.h"
#include "widgets/tables/cell_model.h"
#include "widgets/theme/mission_clock.h"

#include <QLocale>

#include <map>

namespace berg {

struct MissionHistory;

/** The event log as a table that grows at its end: time, event, and how a plan was made. */
class EventModel : public CellModel
{
    Q_OBJECT

public:
    enum Column
    {
        Time,
        What,
        Details
    };
    enum Role
    {
        AheadRole = Qt::UserRole ///< bool: after the instant shown
    };

    explicit EventModel(const QLocale& locale, QObject* parent = nullptr);

    /**
     * Shows the log. Repeated events are omitted, as are plans at the end of a hold that lead to
     * the same iceberg as the plan before.
     */
    void setHistory(const MissionHistory& history, const std::vector<Iceberg>& icebergs,
                    const std::vector<Uav>& uavs);
    /** Sets the clock that formats the times. */
    void setClock(const MissionClock& clock);
    /** Sets the number of events up to the instant shown. */
    void setShown(std::size_t shown);

    /** Returns the number of rows up to the instant shown. */
    [[nodiscard]] int shownRows() const;
    /** Returns the time of a row, s. */
    [[nodiscard]] double time_s(int row) const { return rowAt(row).event.time_s; }

private:
    struct EventRow
    {
        std::size_t number = 0; ///< number of the event in the log
        MissionEvent event;
        QString what;
        QString details{};
        QString toolTip{};
    };
    void clear();
    /** Returns whether the event adds information to the log. */
    [[nodiscard]] bool addsInformation(const MissionEvent& event, const UavPlan* plan);
    [[nodiscard]] EventRow rowOf(const MissionEvent& event, const Plan* plan,
                                 const std::vector<Iceberg>& icebergs,
                                 const std::vector<Uav>& uavs) const;
    [[nodiscard]] const EventRow& rowAt(int row) const
    {
        return m_rows.at(static_cast<std::size_t>(row));
    }
    [[nodiscard]] CellSheet sheet() const;

    QLocale m_locale;
    MissionClock m_clock;
    std::vector<EventRow> m_rows;
    std::uint64_t m_rewrites = 0;
    std::size_t m_events = 0; ///< number of events processed
    std::size_t m_plans = 0;  ///< number of plans processed
    /** By UAV, the first iceberg of its last plan. */
    std::map<std::optional<int>, std::optional<IcebergIndex>> m_next;
    std::size_t m_shown = 0;
};

} // namespace berg
