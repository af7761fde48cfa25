#pragma once

#include "widgets/model/study_runner.h"
#include "widgets/theme/theme.h"

#include <QAbstractTableModel>
#include <QLocale>

#include <optional>
#include <vector>

namespace berg {

/** Scenario and run of a case of a study. */
struct StudyCase
{
    QString scenario{}; ///< its name, or what it was drawn from
    int run = 0;
    std::int64_t seed = 0; ///< of the noise
};
[[nodiscard]] StudyCase studyCase(const StudySpec& spec, std::size_t caseIndex);

/** A table whose rows are sorted by the model itself: large ones in milliseconds. The first column
 * holds words, the others numbers. */
class StudyTableModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    struct ColumnHeader
    {
        QString text;
        QString toolTip;
    };
    StudyTableModel(const QLocale& locale, std::vector<ColumnHeader> headers, QObject* parent);

    void sort(int column, Qt::SortOrder order) override;
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;
    /** Where a row, by its place before sorting, is shown; -1: there is no such row. */
    [[nodiscard]] int rowOf(std::size_t row) const;

protected:
    /** What a row is sorted by: a number, or equal numbers a text. */
    struct SortKey
    {
        double number = 0;
        QString text{};
    };
    // Of a row by its place before sorting.
    [[nodiscard]] virtual SortKey sortKey(std::size_t row, int column) const = 0;
    [[nodiscard]] virtual QString text(std::size_t row, int column) const = 0;
    [[nodiscard]] virtual QString toolTip(std::size_t row) const = 0;
    /** There are `rows` rows now; as few changes as possible are told. */
    void setRows(std::size_t rows);
    [[nodiscard]] std::size_t unsorted(int row) const
    {
        return m_order[static_cast<std::size_t>(row)];
    }

    QLocale m_locale;

private:
    [[nodiscard]] std::vector<std::size_t> orderOf(std::size_t rows) const;

    std::vector<ColumnHeader> m_headers;
    std::vector<std::size_t> m_order; ///< rows before sorting, as shown
    int m_column = -1;
    Qt::SortOrder m_direction = Qt::AscendingOrder;
};

/** The settings of a study and what each came to; last the best tau of each case, in hindsight. */
class StudySettingsModel : public StudyTableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Setting,
        Mean,
        Median,
        Quartiles,
        Difference,
        Interval,
        BestIn,
        Stuck
    };

    explicit StudySettingsModel(const QLocale& locale, QObject* parent = nullptr);

    void setTheme(const Theme& theme);
    /** Null: none. */
    void setResult(StudyPointer result);
    /** None: the row is the best tau of each case. */
    [[nodiscard]] std::optional<std::size_t> settingAt(int row) const;

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

protected:
    [[nodiscard]] SortKey sortKey(std::size_t row, int column) const override;
    [[nodiscard]] QString text(std::size_t row, int column) const override;
    [[nodiscard]] QString toolTip(std::size_t row) const override;

private:
    [[nodiscard]] std::size_t settings() const;
    [[nodiscard]] const Summary& zetaOf(std::size_t row) const;
    [[nodiscard]] const MeanInterval& differenceOf(std::size_t row) const;

    StudyPointer m_result;
    Theme m_theme;
};

/** The cases of one setting: zeta of each, and how it compares. */
class StudyCasesModel : public StudyTableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Case,
        Seed,
        Zeta,
        Difference,
        BestTau,
        Best,
        Stuck
    };

    explicit StudyCasesModel(const QLocale& locale, QObject* parent = nullptr);

    /** Without result or setting it is empty. */
    void setCases(StudyPointer result, std::optional<std::size_t> setting);
    /** Index of a case in the study. */
    [[nodiscard]] std::size_t caseAt(int row) const;

protected:
    [[nodiscard]] SortKey sortKey(std::size_t row, int column) const override;
    [[nodiscard]] QString text(std::size_t row, int column) const override;
    [[nodiscard]] QString toolTip(std::size_t row) const override;

private:
    [[nodiscard]] const MissionOutcome& outcome(std::size_t row, std::size_t setting) const;
    [[nodiscard]] double difference(std::size_t row) const;

    StudyPointer m_result;
    std::size_t m_setting = 0;
};

} // namespace berg
