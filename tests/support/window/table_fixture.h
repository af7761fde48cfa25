#pragma once

#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/ids.h"
#include "tests/support/window/panel_test.h"
#include "widgets/panels/icebergs/iceberg_table_model.h"

#include <QAbstractItemModelTester>
#include <QUndoStack>

namespace berg::test {

constexpr int col(IcebergColumn column)
{
    return static_cast<int>(column);
}

inline const std::vector<int> kEditorColumns{
    col(IcebergColumn::Name),     col(IcebergColumn::East),      col(IcebergColumn::North),
    col(IcebergColumn::Speed),    col(IcebergColumn::Direction), col(IcebergColumn::Sigma0),
    col(IcebergColumn::Growth),   col(IcebergColumn::Observed),  col(IcebergColumn::Appears),
    col(IcebergColumn::Latitude), col(IcebergColumn::Longitude)};

/** The table model of a document, as in the panel. */
struct TableFixture
{
    ScenarioDocument document;
    IcebergTableModel model;
    QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::QtTest};

    explicit TableFixture(const Scenario& scenario = fourIcebergs(),
                          const QLocale& locale = QLocale::c())
        : model(document, locale)
    {
        document.reset(scenario);
        QObject::connect(&document, &ScenarioDocument::scenarioChanged, &model,
                         [this] { model.showScenario(); });
        model.showScenario();
    }
    [[nodiscard]] QString cell(int row, IcebergColumn column) const
    {
        return model.index(row, col(column)).data().toString();
    }
    bool put(int row, IcebergColumn column, const QVariant& value)
    {
        return model.setData(model.index(row, col(column)), value, Qt::EditRole);
    }
    [[nodiscard]] const std::vector<Iceberg>& icebergs() const
    {
        return document.scenario().icebergs;
    }
    [[nodiscard]] QString undoText() const { return document.undoStack()->undoText(); }
    [[nodiscard]] Ids shown() const
    {
        Ids ids;
        for (int row = 0; row < model.rowCount(); ++row)
            ids.push_back(model.rowAt(row).id);
        return ids;
    }
    [[nodiscard]] std::vector<int> allRows() const
    {
        std::vector<int> rows;
        for (int row = 0; row < model.rowCount(); ++row)
            rows.push_back(row);
        return rows;
    }
};

} // namespace berg::test
