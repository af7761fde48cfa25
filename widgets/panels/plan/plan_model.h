#pragma once

#include "widgets/panels/plan/plan_rows.h"
#include "widgets/theme/mission_clock.h"

#include <QAbstractTableModel>
#include <QLocale>

#include <array>

namespace berg {

/** One line of the table: an iceberg, or the UAV that the icebergs below it are visited by. */
struct PlanLine
{
    PlanRow row;    ///< of a UAV: its id and name, the whole way and the last arrival
    int uav = -1;   ///< place of the UAV in the scenario; -1: there is but one, it has no line
    int number = 0; ///< place in the order of the UAV, from 1; 0: it is the UAV; -1: none
    int visits = 0; ///< of a UAV
    FlightMode mode = FlightMode::Idle; ///< of a UAV that is not planned
    bool isIdle = true;                 ///< of a UAV: it neither visits nor searches
    bool operator==(const PlanLine&) const = default;

    [[nodiscard]] bool isUav() const { return number == 0; }
};

/**
 * The plan as a table, of several UAVs with a line for each above its icebergs, to which icebergs
 * can be dragged. Tells of the lines that look otherwise than before, as one span.
 */
class PlanModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Number,
        Name,
        Leg,
        Course,
        GroundSpeed,
        Arrival,
        Sigma,
        ArrivalSigma,
        Chance,
        ColumnCount
    };
    enum Role
    {
        SigmaRole = Qt::UserRole, ///< double, m^2, in the columns of sigma where it is known
        HighlightRole,            ///< bool
        UavRole,                  ///< int, `PlanLine::uav`
        NumberRole,               ///< int, `PlanLine::number`
        KeptRole,                 ///< bool, for that UAV alone
        DropRole                  ///< bool, of the UAV an iceberg is about to be given to
    };

    explicit PlanModel(const QLocale& locale, QObject* parent = nullptr);

    /** Arrivals are written by `times`. */
    void setPlan(const std::vector<PlanSection>& sections, const TimesAhead& times = {});
    void setHighlight(const std::string& id);
    /** The UAV whose lines show that an iceberg is about to be given to it; -1: none. */
    void setDropUav(int uav);

    /** Of an iceberg or a UAV. */
    [[nodiscard]] const std::string& idOf(int row) const;
    [[nodiscard]] const PlanLine& line(int row) const;
    /** -1: not in the plan. */
    [[nodiscard]] int rowOf(const std::string& id) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    [[nodiscard]] QStringList mimeTypes() const override;
    [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override;
    [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                      const QModelIndex& parent) override;

    /** As wide as usual texts of the course or the ground speed of a leg. */
    [[nodiscard]] QString widestText(Column column) const;

    /** The chance that one of the icebergs is not in view on arrival is worth telling. */
    [[nodiscard]] bool mayMiss() const;

signals:
    /** An iceberg was dragged onto the lines of this UAV. */
    void handedOver(const std::string& iceberg, const std::string& uav);

private:
    /** Of one line. */
    struct Look
    {
        std::array<QString, ColumnCount> texts;
        int uav = -1;
        bool isAssigned = false;
        bool operator==(const Look&) const = default;
    };

    void setLines(std::vector<PlanLine> lines, const TimesAhead& times);
    void acceptLooks(int kept);
    [[nodiscard]] QString text(int row, Column column) const;
    [[nodiscard]] QString uavText(const PlanLine& line, Column column) const;
    [[nodiscard]] QString toolTip(int row, Column column) const;
    [[nodiscard]] QString searchesText(const std::vector<PlannedSearch>& searches) const;
    /** Why the UAV is not planned. */
    [[nodiscard]] static QString modeText(FlightMode mode);
    [[nodiscard]] QString uavToolTip(const PlanLine& line) const;
    [[nodiscard]] const PlanLine& uavOf(int row) const;

    QLocale m_locale;
    TimesAhead m_times;
    std::vector<PlanLine> m_lines;
    std::vector<Look> m_looks; ///< of them, as they were last told of
    std::string m_highlight;
    int m_dropUav = -1;
};

} // namespace berg
