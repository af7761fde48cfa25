#pragma once

#include "widgets/document/scenario_document.h"
#include "widgets/panels/icebergs/iceberg_table_paste.h"
#include "widgets/panels/icebergs/iceberg_table_rows.h"
#include "widgets/tables/cell_model.h"

#include <QLocale>

#include <optional>

namespace berg {

/**
 * Model of the iceberg table with a filter: before take-off the editable icebergs of the document,
 * in flight those of the instant shown. The model is reset only when icebergs are added or removed.
 */
class IcebergTableModel : public CellModel
{
    Q_OBJECT

public:
    enum Role
    {
        SigmaRole = Qt::UserRole, ///< sigma, m^2
        StateRole,                ///< int of `IcebergStanding`
        /** A bool that is true if the iceberg is on its way into the inner ring of the asset. */
        AlarmRole,
        HighlightRole ///< bool
    };

    /** Borrows the document, which must outlive the model. */
    IcebergTableModel(ScenarioDocument& document, const QLocale& locale, QObject* parent = nullptr);

    /** Shows the document before take-off. */
    void showScenario();
    /** Shows a flight. */
    void showRecord(const FlightRecord& record);
    [[nodiscard]] bool isInFlight() const { return m_state.isInFlight; }

    /**
     * Shows only icebergs whose name or id contains this text, ignoring case; an empty text shows
     * all.
     */
    void setFilter(const QString& text);
    void setHighlight(const std::string& id);

    [[nodiscard]] const IcebergTableRow& rowAt(int row) const;
    /** Returns the row of an iceberg, or nullopt if it is not shown. */
    [[nodiscard]] std::optional<int> rowOf(const std::string& id) const;
    /** Returns the number of icebergs, including those hidden by the filter. */
    [[nodiscard]] int total() const { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] const IcebergColumnSpec& spec(int column) const;
    /**
     * Returns whether the column applies now: before take-off or in flight, with an asset, or with
     * several UAVs.
     */
    [[nodiscard]] bool hasColumn(int column) const;

    /**
     * Sets a cell of all these rows in one undo step. A number is limited to its range; an angle
     * that cannot be read changes nothing. Returns whether the scenario changed.
     */
    bool setAll(const std::vector<int>& rows, IcebergColumn column, const QVariant& value);
    /** Returns the cells of these rows in full precision below their titles, separated by tabs. */
    [[nodiscard]] QString copied(const std::vector<int>& rows,
                                 const std::vector<int>& columns) const;
    /** Pastes from this cell to the right, through `columns`, and down, in one undo step. */
    PasteOutcome paste(const QString& text, int row, int column, const std::vector<int>& columns);

signals:
    /** Emitted after an edit with a sentence on why it was rejected, or an empty text. */
    void edited(const QString& fault);
    /** Emitted when `hasColumn` has changed. */
    void columnsChanged();

private:
    struct TableState
    {
        bool isInFlight = false;
        bool hasAsset = false;
        bool hasFleet = false;
        bool operator==(const TableState&) const = default;
    };
    void setNumbers(const std::vector<std::string>& ids, IcebergColumn column, double value);
    [[nodiscard]] QString setPlaces(const std::vector<int>& rows, IcebergColumn column,
                                    const QString& text);
    void setRows(std::vector<IcebergTableRow> rows, const TableState& state);
    void rankNames();
    [[nodiscard]] CellSheet sheet();
    [[nodiscard]] CellColumn cellColumn(IcebergColumn column);
    [[nodiscard]] QVariant rowData(const IcebergTableRow& row, IcebergColumn column,
                                   int role) const;
    [[nodiscard]] QString copiedCell(const IcebergTableRow& row, int column) const;

    ScenarioDocument& m_document;
    QLocale m_locale;
    IcebergColumnSpecs m_specs = icebergColumnSpecs();
    std::vector<IcebergTableRow> m_rows; ///< in the order of the scenario
    std::vector<int> m_nameRanks;        ///< by iceberg index: rank in the order of names
    QString m_filter;
    std::string m_highlight;
    TableState m_state;
};

} // namespace berg
