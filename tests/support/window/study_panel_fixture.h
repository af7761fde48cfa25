#pragma once

#include "core/base/solving_guard.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "tests/support/window/study_builder.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/study/study_panel.h"
#include "widgets/panels/study/study_setup.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>

namespace berg::test {

/** A study panel with a runner, as the window joins them; planning on this thread fails. */
struct StudyPanelFixture
{
    StudyRunner runner;
    StudyPanel panel{runner};
    QSignalSpy finished{&runner, &StudyRunner::finished};
    NoBlockingScope onThisThread;

    explicit StudyPanelFixture(const Scenario& scenario = quickScenario())
    {
        QObject::connect(&panel, &StudyPanel::startRequested, &panel, &StudyPanel::start);
        panel.setLocale(QLocale::c());
        panel.resize(panel.sizeHint());
        panel.setScenario(scenario);
        panel.show();
    }
    template <class Widget>
    [[nodiscard]] Widget& get(const QString& name)
    {
        return child<Widget>(panel, name);
    }
    void setNumber(const QString& name, const QString& value)
    {
        enter(get<NumberField>(name), value);
    }
    void setPolicies(const QStringList& names)
    {
        for (QCheckBox* box : panel.findChildren<QCheckBox*>())
            box->setChecked(names.contains(box->objectName().section(u'-', 1)));
    }
    [[nodiscard]] StudySpec spec() { return child<StudySetup>(panel, {}).spec(); }
    [[nodiscard]] QPushButton& start() { return get<QPushButton>(QStringLiteral("startStudy")); }
    [[nodiscard]] QString state() { return get<QLabel>(QStringLiteral("studyState")).text(); }
    [[nodiscard]] bool ends(int times = 1)
    {
        return QTest::qWaitFor([&] { return finished.count() >= times; }, kPatience_ms);
    }
    /** Shows a result as if it had been flown. */
    void show(const StudyPointer& result)
    {
        runner.show(result->study);
        QVERIFY(QTest::qWaitFor([&] { return runner.result() != nullptr; }, kPatience_ms));
    }
    [[nodiscard]] QStringList column(const QString& table, int column)
    {
        QStringList texts;
        const QAbstractItemModel& model = *get<QTableView>(table).model();
        for (int row = 0; row < model.rowCount(); ++row)
            texts << model.index(row, column).data().toString();
        return texts;
    }
};

} // namespace berg::test
