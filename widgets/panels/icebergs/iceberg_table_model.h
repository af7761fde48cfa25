#pragma once

#include "widgets/model/scenario_document.h"
#include "widgets/panels/icebergs/iceberg_table_paste.h"
#include "widgets/panels/icebergs/iceberg_table_rows.h"

#include <QAbstractTableModel>
#include <QLocale>

namespace berg {

/**
 * The icebergs as a table, sorted and filtered by itself: before take-off those of the document,
 * which can be edited, in flight those of the instant shown. An update tells of the rows between
 * the first and the last that have changed; the table is begun anew only when icebergs come or go.
 */
class IcebergTableModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Role
    {
        SigmaRole = Qt::UserRole, ///< sigma, m^2
        StateRole,                ///< int of `IcebergStanding`
        AlarmRole,                ///< bool: on its way into the inner ring of the asset
        HighlightRole             ///< bool
    };

    /** The document is borrowed and must outlive the model. */
    IcebergTableModel(ScenarioDocument& document, const QLocale& locale, QObject* parent = nullptr);

    /** Before take-off. */
    void showScenario();
    /** In flight. */
    void showRecord(const FlightRecord& record);
    [[nodiscard]] bool isInFlight() const { return m_kind.isInFlight; }

    /** Shows those whose name or id holds this text, whatever its case; empty: all. */
    void setFilter(const QString& text);
    void setHighlight(const std::string& id);

    [[nodiscard]] const IcebergTableRow& rowAt(int row) const;
    /** -1: not shown. */
    [[nodiscard]] int rowOf(const std::string& id) const;
    /** So many icebergs there are, the ones that the filter hides included. */
    [[nodiscard]] int total() const { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] const IcebergColumnSpec& spec(int column) const;
    /** Whether the column is there now, in the editor or in flight, by the asset and the UAVs
     * there are. */
    [[nodiscard]] bool hasColumn(int column) const;

    /**
     * Sets a cell of all these rows, one undo step; a number is brought into its range, an angle
     * that cannot be read changes nothing.
     */
    bool setAll(const std::vector<int>& rows, IcebergColumn column, const QVariant& value);
    /** Cells of these rows in full precision below the titles, tabs between. */
    [[nodiscard]] QString copied(const std::vector<int>& rows,
                                 const std::vector<int>& columns) const;
    /** Pastes from this cell to the right, through `columns`, and down: one undo step. */
    PasteOutcome paste(const QString& text, int row, int column, const std::vector<int>& columns);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    /** -1: the order of the scenario. Cells without a number come last either way. */
    void sort(int column, Qt::SortOrder order) override;

signals:
    /** A cell was edited; why it could not be, a whole sentence, else empty. */
    void edited(const QString& fault);
    /** `hasColumn` is not what it was. */
    void columnsChanged();

private:
    struct Kind
    {
        bool isInFlight = false;
        bool hasAsset = false;
        bool hasFleet = false;
        bool operator==(const Kind&) const = default;
    };
    void setNumbers(const std::vector<std::string>& ids, IcebergColumn column, double value);
    [[nodiscard]] QString setPlaces(const std::vector<int>& rows, IcebergColumn column,
                                    const QString& text);
    void setRows(std::vector<IcebergTableRow> rows, const Kind& kind);
    void updateRows(std::vector<IcebergTableRow> rows);
    void rankNames();
    [[nodiscard]] std::vector<int> arranged() const;
    [[nodiscard]] bool isBefore(int a, int b) const;
    void rearrange();
    void reportChanges(const std::vector<bool>& hasChanged);
    [[nodiscard]] QString copiedCell(const IcebergTableRow& row, int column) const;

    ScenarioDocument& m_document;
    QLocale m_locale;
    IcebergColumnSpecs m_specs = icebergColumnSpecs();
    std::vector<IcebergTableRow> m_rows; ///< as in the scenario
    std::vector<int> m_nameRanks;        ///< by index, in the order of names
    std::vector<int> m_shown;            ///< by row: index of its iceberg
    QString m_filter;
    std::string m_highlight;
    int m_sortColumn = -1;
    Qt::SortOrder m_sortOrder = Qt::AscendingOrder;
    Kind m_kind;
};

} // namespace berg
