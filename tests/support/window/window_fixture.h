#pragma once

#include "app/window/main_window_host.h"
#include "app/window/window_parts.h"
#include "core/base/solving_guard.h"
#include "tests/support/window/fake_interaction.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "widgets/map/view/map_view.h"
#include "widgets/workspace/workspace.h"

#include <QAction>
#include <QSettings>
#include <QSlider>
#include <QTemporaryDir>
#include <QtTest>

#include <future>

namespace berg::test {

/** Calls a function on another thread, for work that the window's thread must not do. */
template <class Call>
auto elsewhere(const Call& call)
{
    return std::async(std::launch::async, call).get();
}

/**
 * The real window with fake dialogs and its own settings, shown at the design size. Planning or
 * flying on the window's thread ends the test.
 */
class WindowFixture
{
public:
    explicit WindowFixture(const Scenario& scenario)
    {
        workspace.document().reset(scenario);
        m_holder = std::make_unique<MainWindowHost>(workspace, interaction, settings);
        window().resize(1280, 800);
        window().show();
        window().activateWindow();
        if (!QTest::qWaitForWindowActive(&window()) || !untilReady())
            qFatal("the window does not come up");
    }

    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    FakeInteraction interaction;
    Workspace workspace;

    [[nodiscard]] MainWindow& window() { return m_holder->window(); }
    [[nodiscard]] MapView& map() { return window().mapView(); }
    [[nodiscard]] ScenarioDocument& document() { return workspace.document(); }
    [[nodiscard]] const Scenario& scenario() { return workspace.document().scenario(); }
    [[nodiscard]] const FlightRecord& record() { return workspace.record(); }
    [[nodiscard]] QString file(const QString& name) const { return folder.filePath(name); }

    [[nodiscard]] QAction& action(const QString& name) { return child<QAction>(window(), name); }
    void trigger(const QString& name) { action(name).trigger(); }

    /** Waits until the condition holds, for a time that only a slow machine needs. */
    template <class Condition>
    [[nodiscard]] bool until(const Condition& condition)
    {
        return QTest::qWaitFor(condition, kPatience_ms);
    }
    [[nodiscard]] bool until(RunPhase phase)
    {
        return until([&] {
            return record().now.phase == phase &&
                   record().now.generation == workspace.runner().generation();
        });
    }
    /** Waits until the plan of the present scenario is shown. */
    [[nodiscard]] bool untilReady() { return until(RunPhase::Ready); }

    [[nodiscard]] QPoint pixelOf(const Point& p_m) { return map().toScreen(p_m).toPoint(); }
    [[nodiscard]] QPoint pixelOf(const std::string& id)
    {
        for (const Iceberg& iceberg : scenario().icebergs)
            if (iceberg.id == id)
                return pixelOf(iceberg.position_m);
        qFatal("no iceberg %s", id.c_str());
    }
    void click(const QPoint& at) { QTest::mouseClick(&map(), Qt::LeftButton, {}, at); }
    void drag(const QPoint& from, const QPoint& to) { dragOn(map(), from, to, 4); }

    /**
     * Presses at `from`, moves in steps and releases at `to`; both are shares of the slider's
     * width.
     */
    void dragTau(double from, double to, int steps = 20)
    {
        auto& slider = child<QSlider>(window(), QStringLiteral("tauSlider"));
        const auto at = [&](double share) {
            return QPoint(static_cast<int>(share * slider.width()), slider.height() / 2);
        };
        dragOn(slider, at(from), at(to), steps);
    }

private:
    static void dragOn(QWidget& widget, const QPoint& from, const QPoint& to, int steps)
    {
        QTest::mousePress(&widget, Qt::LeftButton, {}, from);
        for (int i = 1; i <= steps; ++i)
            QTest::mouseMove(&widget, from + (to - from) * i / steps);
        QTest::mouseRelease(&widget, Qt::LeftButton, {}, to);
    }

    std::unique_ptr<MainWindowHost> m_holder;
    NoBlockingScope m_guard;
};

/** Returns the run so far, as it would be saved. */
inline std::shared_ptr<const RunFile> flownRun(WindowFixture& w)
{
    std::shared_ptr<const RunFile> taken;
    QObject context;
    QObject::connect(
        &w.workspace.runner(), &MissionRunner::runReady, &context,
        [&](const QString&, const std::shared_ptr<const RunFile>& run) { taken = run; });
    w.workspace.runner().requestRun();
    if (!w.until([&] { return taken != nullptr; }))
        qFatal("no run");
    return taken;
}

} // namespace berg::test
