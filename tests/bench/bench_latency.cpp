// From a move of the trade-off slider to the map painted with the plan of that trade-off, in the
// whole window at 1280 x 800 without a display.
//
// A paint counts when it is over and the picture shown is that of the mission with the new tau: the
// first order found ("first") and the final plan ("final"). The drag moves the slider every 8 ms
// for 2 s; the number of plans painted and the longest wait between two show whether the picture
// starves while the hand is moving.
//
// Use: bench_latency [icebergs...]      (12 20 40 when none are named)

#include "app/window/main_window.h"
#include "core/presets/presets.h"
#include "core/study/statistics.h"
#include "tests/bench/bench_window.h"
#include "widgets/map/view/map_view.h"
#include "widgets/workspace/workspace.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <QSlider>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

constexpr int kPositions = 60;
constexpr int kPatience_ms = 4000; ///< limit for one final plan
constexpr int kMove_ms = 8;
constexpr int kDrag_ms = 2000;

/** Records when a widget has been painted. */
class PaintWatch final : public QApplication
{
public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override
    {
        if (receiver != watched || event->type() != QEvent::Paint)
            return QApplication::notify(receiver, event);
        QElapsedTimer clock;
        clock.start();
        const bool isDone = QApplication::notify(receiver, event);
        paints_ms.push_back(static_cast<double>(clock.nsecsElapsed()) * 1e-6);
        if (onPainted)
            onPainted();
        return isDone;
    }

    QObject* watched = nullptr;
    std::function<void()> onPainted;
    std::vector<double> paints_ms; ///< duration of each
};

class Bench
{
public:
    Bench(PaintWatch& application, int icebergs)
        : m_application(application), m_window(m_workspace, m_interaction, m_settings)
    {
        m_workspace.document().reset(randomScenario(1, {.icebergs = icebergs}));
        m_window.resize(1280, 800);
        m_window.show();
        m_slider = m_window.findChild<QSlider*>(u"tauSlider"_s);
        m_application.watched = &m_window.mapView();
        QTest::qWait(kPatience_ms / 2);
        std::printf("%d icebergs\n", icebergs);
    }

    void singleMoves()
    {
        std::vector<double> first_ms;
        std::vector<double> final_ms;
        std::vector<double> gaps;
        int proven = 0;
        m_application.paints_ms.clear();
        press(0);
        for (int i = 1; i <= kPositions; ++i) {
            QElapsedTimer clock;
            bool isFirst = false;
            bool isFinal = false;
            m_application.onPainted = [&] {
                const double now_ms = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
                if (!showsPlan())
                    return;
                if (!std::exchange(isFirst, true))
                    first_ms.push_back(now_ms);
                if (present().phase == RunPhase::Ready && !std::exchange(isFinal, true))
                    final_ms.push_back(now_ms);
            };
            clock.start();
            QTest::mouseMove(m_slider, at(static_cast<double>(i) / kPositions));
            static_cast<void>(QTest::qWaitFor([&] { return isFinal; }, kPatience_ms));
            m_application.onPainted = {};
            if (present().plan && present().plan->outcome.status == SolveStatus::Optimal)
                ++proven;
            else if (present().plan && present().plan->gap)
                gaps.push_back(100 * *present().plan->gap);
            QTest::qWait(20);
        }
        release(1);
        print("first plan painted", first_ms);
        print("final plan painted", final_ms);
        print("one paint of the map", m_application.paints_ms);
        std::sort(gaps.begin(), gaps.end());
        std::printf("  proven %d of %d", proven, kPositions);
        if (!gaps.empty())
            std::printf(", else gap median %.2f %%, worst %.2f %%", quantile(gaps, 0.5),
                        gaps.back());
        std::printf("\n");
    }

    void drag()
    {
        press(0);
        std::vector<double> waits_ms;
        QElapsedTimer clock;
        clock.start();
        double last_ms = 0;
        std::uint64_t shown = present().generation;
        m_application.onPainted = [&] {
            if (!present().plan || present().generation == shown)
                return;
            shown = present().generation;
            const double now_ms = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
            waits_ms.push_back(now_ms - std::exchange(last_ms, now_ms));
        };
        int moves = 0;
        while (clock.elapsed() < kDrag_ms) {
            // Moves back and forth, so that every move sets another tau.
            const double phase = static_cast<double>(++moves % 100) / 50;
            QTest::mouseMove(m_slider, at(phase <= 1 ? phase : 2 - phase));
            QTest::qWait(kMove_ms);
        }
        const double end_ms = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
        m_application.onPainted = {};
        release(0);
        waits_ms.push_back(end_ms - last_ms);
        std::printf("  drag of %.1f s: %d moves, %zu plans painted\n", end_ms / 1000, moves,
                    waits_ms.size() - 1);
        print("wait between plans", waits_ms);
    }

private:
    [[nodiscard]] const MissionSnapshot& present() const { return m_workspace.record().now; }

    /** Returns whether the picture shows a plan for the scenario's tau. */
    [[nodiscard]] bool showsPlan()
    {
        return present().plan && present().generation == m_workspace.runner().generation();
    }
    [[nodiscard]] QPoint at(double share) const
    {
        return {static_cast<int>((0.05 + 0.9 * share) * m_slider->width()), m_slider->height() / 2};
    }
    void press(double share)
    {
        QTest::mousePress(m_slider, Qt::LeftButton, {}, at(share));
        QTest::qWait(kPatience_ms / 4);
    }
    void release(double share)
    {
        QTest::mouseRelease(m_slider, Qt::LeftButton, {}, at(share));
        QTest::qWait(kPatience_ms / 4);
    }

    PaintWatch& m_application;
    QTemporaryDir m_folder;
    QSettings m_settings{m_folder.filePath(u"settings.ini"_s), QSettings::IniFormat};
    NoDialogs m_interaction;
    Workspace m_workspace;
    MainWindow m_window;
    QSlider* m_slider = nullptr;
};

} // namespace

int main(int argc, char* argv[])
{
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    PaintWatch application(argc, argv);
    std::vector<int> sizes;
    for (int i = 1; i < argc; ++i)
        sizes.push_back(std::atoi(argv[i]));
    if (sizes.empty())
        sizes = {12, 20, 40};
    for (const int size : sizes) {
        Bench bench(application, size);
        bench.singleMoves();
        bench.drag();
        application.watched = nullptr;
    }
    return 0;
}
