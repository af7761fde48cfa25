// Fluency of editing a large scenario, in the whole window at 1280 x 800 without a display.
//
// Each hand movement is real mouse and key events, one every 8 ms for 2 s. Printed is the CPU time
// of the GUI thread: for one event with its immediate consequences ("event"), for a frame of the
// window, and for the longest turn of the event loop.
//
// Use: bench_edit [icebergs...]      (40 500 when none are named)

#include "app/window/main_window.h"
#include "core/presets/presets.h"
#include "tests/bench/bench_window.h"
#include "widgets/map/view/map_view.h"
#include "widgets/workspace/workspace.h"

#include <QDockWidget>
#include <QSettings>
#include <QSlider>
#include <QTemporaryDir>
#include <QUndoStack>
#include <QtTest>

#include <cstdlib>
#include <string>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

constexpr int kSettle_ms = 2500; ///< for the plan and its curve
constexpr int kMove_ms = 8;
constexpr int kHand_ms = 2000; ///< length of each movement
constexpr double kReach_px = 60;

class Bench
{
public:
    Bench(FrameWatch& application, int icebergs)
        : m_application(application)
        , m_start(randomScenario(1, {.icebergs = icebergs}))
        , m_window(m_workspace, m_interaction, m_settings)
    {
        m_workspace.document().reset(m_start);
        m_window.resize(1280, 800);
        m_window.show();
        m_application.map = &map();
        m_application.window = &m_window;
        watchTurns(kSettle_ms);
    }
    ~Bench()
    {
        m_application.map = nullptr;
        m_application.window = nullptr;
    }
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;

    void all()
    {
        dragIcebergs("drag one iceberg", 1);
        dragIcebergs("drag 100 icebergs", 100);
        undoAndRedo("undo and redo of it");
        showTable();
        dragIcebergs("drag 100, table shown", 100);
        stretchBand();
        select(100);
        hold("nudge 100 icebergs",
             [this](int i) { QTest::keyClick(&map(), i % 2 == 0 ? Qt::Key_Left : Qt::Key_Right); });
        hold("select all, select none", [this](int i) {
            if (i % 2 == 0)
                map().edits().selectAll();
            else
                m_workspace.selection().clear();
        });
        dragTau();
    }

private:
    MapView& map() { return m_window.mapView(); }
    ScenarioDocument& document() { return m_workspace.document(); }

    void select(std::size_t count)
    {
        std::vector<std::string> ids;
        for (const Iceberg& iceberg : document().scenario().icebergs)
            if (ids.size() < count)
                ids.push_back(iceberg.id);
        m_workspace.selection().set(ids);
        watchTurns(kSettle_ms / 2);
    }

    void showTable()
    {
        auto* dock = m_window.findChild<QDockWidget*>(u"icebergsDock"_s);
        dock->show();
        dock->raise();
        watchTurns(kSettle_ms / 2);
    }

    void dragIcebergs(const char* name, std::size_t count)
    {
        document().reset(m_start); // nothing under a panel, nothing to redo: edits while it moves
        select(count);
        const QPointF from = map().toScreen(document().scenario().icebergs.front().position_m);
        QTest::mousePress(&map(), Qt::LeftButton, {}, from.toPoint());
        hold(name, [&](int i) {
            const double turn = i * 0.1;
            const QPointF path(kReach_px * std::sin(turn), kReach_px * (1 - std::cos(turn)));
            QTest::mouseMove(&map(), (from + path).toPoint());
        });
        QTest::mouseRelease(&map(), Qt::LeftButton, {}, from.toPoint() + QPoint(15, 25));
        watchTurns(kSettle_ms / 2);
    }

    void undoAndRedo(const char* name)
    {
        hold(name, [this](int i) {
            if (i % 2 == 0)
                document().undoStack()->undo();
            else
                document().undoStack()->redo();
        });
    }

    void stretchBand()
    {
        m_workspace.selection().clear();
        const QPoint from(map().width() - 20, map().height() / 2);
        QTest::mousePress(&map(), Qt::LeftButton, {}, from);
        hold("rubber band", [&](int i) {
            const double share = (1 - std::cos(i * 0.05)) / 2;
            QTest::mouseMove(&map(), QPointF(from.x() * (1 - share), 20 + share).toPoint());
        });
        QTest::mouseRelease(&map(), Qt::LeftButton, {}, from);
    }

    void dragTau()
    {
        m_workspace.selection().clear();
        auto* slider = m_window.findChild<QSlider*>(u"tauSlider"_s);
        const auto at = [slider](double share) {
            return QPoint(static_cast<int>((0.05 + 0.9 * share) * slider->width()),
                          slider->height() / 2);
        };
        QTest::mousePress(slider, Qt::LeftButton, {}, at(0));
        hold("drag tau",
             [&](int i) { QTest::mouseMove(slider, at((1 - std::cos(i * 0.05)) / 2)); });
        QTest::mouseRelease(slider, Qt::LeftButton, {}, at(0));
        watchTurns(kSettle_ms);
    }

    /** Calls `move` with 0, 1, 2, ... for the length of a movement and prints its cost. */
    void hold(const char* name, const std::function<void(int)>& move)
    {
        m_application.paints_ms.clear();
        m_application.frames_ms.clear();
        m_application.longest = {};
        std::vector<double> moves_ms;
        QTimer timer;
        timer.setTimerType(Qt::PreciseTimer);
        QObject::connect(&timer, &QTimer::timeout, &timer, [&] {
            const double before_ms = worked_ms();
            move(static_cast<int>(moves_ms.size()));
            moves_ms.push_back(worked_ms() - before_ms);
        });
        timer.start(kMove_ms);
        const LongestTurn longest = watchTurns(kHand_ms);
        std::printf("  %s: longest turn %.1f ms (%.1f ms of work), last step \"%s\"\n", name,
                    longest.waited_ms, longest.worked_ms,
                    qPrintable(document().undoStack()->undoText()));
        std::printf("    longest event: %.1f ms of work, type %d to %s\n",
                    m_application.longest.work_ms, m_application.longest.type,
                    m_application.longest.receiver.c_str());
        print("event", moves_ms);
        print("map paint", m_application.paints_ms);
        print("window frame", m_application.frames_ms);
        std::fflush(stdout);
    }

    FrameWatch& m_application;
    Scenario m_start;
    QTemporaryDir m_folder;
    QSettings m_settings{m_folder.filePath(u"settings.ini"_s), QSettings::IniFormat};
    NoDialogs m_interaction;
    Workspace m_workspace;
    MainWindow m_window;
};

} // namespace

int main(int argc, char* argv[])
{
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    FrameWatch application(argc, argv);
    std::vector<int> sizes;
    for (int i = 1; i < argc; ++i)
        sizes.push_back(std::atoi(argv[i]));
    if (sizes.empty())
        sizes = {40, 500};
    for (const int size : sizes) {
        std::printf("%d icebergs\n", size);
        Bench(application, size).all();
    }
    return 0;
}
