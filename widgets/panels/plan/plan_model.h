#pragma once

#include "widgets/panels/plan/plan_rows.h"
#include "widgets/tables/cell_model.h"
#include "widgets/theme/mission_clock.h"

#include <QLocale>

#include <memory>

namespace berg {

/** A line of the table: an iceberg, or a UAV above the icebergs that it visits. */
struct PlanLine
{
    PlanRow row; ///< for a UAV: id, name, length of its path and last arrival
    /** Index of the UAV in the scenario; nullopt if it is the only one, which has no line. */
    std::optional<int> uav = {};
    bool isUav = false;                 ///< whether the line is that of a UAV
    int visits = 0;                     ///< visits of a UAV
    FlightMode mode = FlightMode::Idle; ///< mode of a UAV without a plan
    bool isIdle = true;                 ///< whether a UAV neither visits nor searches
    bool operator==(const PlanLine&) const = default;
};

/**
 * The plan as a table. With several UAVs, each has a line above its icebergs, onto which icebergs
 * can be dragged.
 */
class PlanModel : public CellModel
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
        Again,
        Sigma,
        ArrivalSigma,
        Chance,
        ColumnCount
    };
    enum Role
    {
        SigmaRole = Qt::UserRole, ///< double, m^2, in the columns of sigma if it is known
        HighlightRole,            ///< bool
        UavRole,                  ///< int, `PlanLine::uav`, if there is one
        IsUavRole,                ///< bool, `PlanLine::isUav`
        NumberRole,               ///< int, `PlanRow::number`, if there is one
        LaterRole,                ///< bool: beyond the planned path
        AssignedRole,             ///< bool: assigned to that UAV alone
        DropRole                  ///< bool: an iceberg is being dragged onto this UAV
    };

    explicit PlanModel(const QLocale& locale, QObject* parent = nullptr);

    /** Sets the plan; `times` formats arrivals. */
    void setPlan(const std::vector<PlanSection>& sections, const TimesAhead& times = {});
    void setHighlight(const std::string& id);
    /** Sets the UAV whose lines show that an iceberg is dragged onto it. */
    void setDropUav(std::optional<int> uav);

    /** Returns the id of the iceberg or UAV of a row. */
    [[nodiscard]] const std::string& idOf(int row) const;
    [[nodiscard]] const PlanLine& line(int row) const;
    /** Returns the row, or nullopt if the id is not in the plan. */
    [[nodiscard]] std::optional<int> rowOf(const std::string& id) const;

    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    [[nodiscard]] QStringList mimeTypes() const override;
    [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override;
    [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                      const QModelIndex& parent) override;

    /** Returns a text as wide as usual texts of the course or ground speed of a leg. */
    [[nodiscard]] QString widestText(Column column) const;

    /**
     * Returns whether an iceberg may be out of view on arrival, so that chances are worth showing.
     */
    [[nodiscard]] bool mayMiss() const;

    /** Whether the plan is a patrol, which comes back to icebergs. */
    [[nodiscard]] bool isPatrol() const;

signals:
    /** Emitted when an iceberg was dragged onto the lines of this UAV. */
    void assignRequested(const std::string& iceberg, const std::string& uav);

private:
    /** Lines with their texts. */
    struct Lines;

    [[nodiscard]] QVariant lineData(const Lines& lines, int row, int column, int role) const;

    QLocale m_locale;
    std::shared_ptr<const Lines> m_lines;
    std::string m_highlight;
    std::optional<int> m_dropUav;
};

} // namespace berg
