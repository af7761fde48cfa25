#pragma once

#include "widgets/panels/plan_rows.h"

#include <QAbstractTableModel>
#include <QLocale>

#include <array>

namespace berg {

/** The plan as a table. Tells of the rows whose text has changed, as one span. */
class PlanModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Number,
        Name,
        Leg,
        Arrival,
        Sigma,
        ArrivalSigma,
        ColumnCount
    };
    enum Role
    {
        SigmaRole = Qt::UserRole, ///< sigma, m^2
        HighlightRole             ///< bool
    };

    /** "in 01:26". */
    [[nodiscard]] static QString arrivalText(double arrival_s);

    explicit PlanModel(const QLocale& locale, QObject* parent = nullptr);

    void setRows(std::vector<PlanRow> rows);
    void setHighlight(const std::string& id);

    [[nodiscard]] const std::vector<PlanRow>& rows() const { return m_rows; }
    /** -1: not in the plan. */
    [[nodiscard]] int rowOf(const std::string& id) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

private:
    using Texts = std::array<QString, ColumnCount>; ///< of one row

    void takeTexts(int kept);
    [[nodiscard]] QString text(int row, Column column) const;
    [[nodiscard]] QString toolTip(int row, Column column) const;

    QLocale m_locale;
    std::vector<PlanRow> m_rows;
    std::vector<Texts> m_texts; ///< of them, as they were last told of
    std::string m_highlight;
};

} // namespace berg
