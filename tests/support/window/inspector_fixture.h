#pragma once

#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/panel_test.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/inspector/inspector_panel.h"

#include <QLabel>
#include <QLineEdit>
#include <QUndoStack>

namespace berg::test {

inline Scenario threeIcebergs()
{
    Scenario scenario = emptySea();
    addIceberg(scenario, 1000, 2000).velocity_mps = Point(0.3, 0.4);
    addIceberg(scenario, 3000, 2000, 8);
    addIceberg(scenario, 5000, 4000);
    return scenario;
}

/** The Inspector of a document, as wide as its dock. */
struct InspectorFixture
{
    ScenarioDocument document;
    Selection selection;
    InspectorPanel panel{document, selection};

    explicit InspectorFixture(const Scenario& scenario = threeIcebergs())
    {
        document.reset(scenario);
        panel.setLocale(QLocale::c());
        panel.resize(kDock_px, 500);
        panel.show();
    }
    [[nodiscard]] NumberField& number(const QString& name) const
    {
        return child<NumberField>(panel, name);
    }
    [[nodiscard]] QLineEdit& line(const QString& name) const
    {
        return child<QLineEdit>(panel, name);
    }
    [[nodiscard]] QLabel& label(const QString& name) const { return child<QLabel>(panel, name); }
    [[nodiscard]] const Iceberg& iceberg(std::size_t i) const
    {
        return document.scenario().icebergs[i];
    }
    [[nodiscard]] int undoSteps() const { return document.undoStack()->count(); }
};

} // namespace berg::test
