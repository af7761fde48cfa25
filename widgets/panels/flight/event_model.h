#pragma once

#include "core/sim/recorder.h"
#include "widgets/theme/mission_clock.h"

#include <QAbstractTableModel>
#include <QLocale>

#include <map>
#include <vector>

namespace berg {

struct MissionHistory;

/** The event log as a table that grows at its end: time, what happened, how the plan was made. */
class EventModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Time,
        What,
        Details,
        ColumnCount
    };
    enum Role
    {
        AheadRole = Qt::UserRole ///< bool: after the instant shown
    };

    explicit EventModel(const QLocale& locale, QObject* parent = nullptr);

    /**
     * The log now; what was told of it before is not told again, nor are plans at the end of a hold
     * that lead to the same iceberg as the one before.
     */
    void setHistory(const MissionHistory& history, const std::vector<Iceberg>& icebergs,
                    const std::vector<Uav>& uavs);
    /** Writes the times from now on. */
    void setClock(const MissionClock& clock);
    /** So many events had come at the instant shown. */
    void setShown(std::size_t shown);

    /** The last row that had come at the instant shown; -1: none had. */
    [[nodiscard]] int lastShown() const;
    /** Time of a row, s. */
    [[nodiscard]] double time_s(int row) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

private:
    struct Row
    {
        std::size_t number = 0; ///< of the event in the log
        MissionEvent event;
        QString what;
        QString details{};
        QString toolTip{};
    };
    void clear();
    /** Whether it tells anything. */
    [[nodiscard]] bool isNews(const MissionEvent& event, const PlanEvent* plan);
    [[nodiscard]] Row rowOf(const MissionEvent& event, const PlanEvent* plan,
                            const std::vector<Iceberg>& icebergs,
                            const std::vector<Uav>& uavs) const;

    QLocale m_locale;
    MissionClock m_clock;
    std::vector<Row> m_rows;
    std::uint64_t m_rewrites = 0;
    std::size_t m_events = 0;  ///< that the rows have come to
    std::size_t m_plans = 0;   ///< likewise
    std::map<int, int> m_next; ///< by UAV, the iceberg that its last plan leads to
    std::size_t m_shown = 0;
};

} // namespace berg
