#pragma once

#include "app/dialogs/interaction.h"
#include "core/study/statistics.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <QEventLoop>
#include <QThread>
#include <QTimer>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace berg {

/** Answers every question at once, because a benchmark has no user. */
class NoDialogs final : public Interaction
{
public:
    Unsaved askUnsaved(QWidget*, const UnsavedWork&) override { return Unsaved::Discard; }
    QString openPath(QWidget*, const QString&) override { return {}; }
    QString savePath(QWidget*, const QString&, const QString&) override { return {}; }
    std::optional<ExportRequest> chooseExport(QWidget*, MissionRunner&, const ExportOffer&) override
    {
        return {};
    }
    std::optional<ImportChoice> chooseImport(QWidget*, ImportRunner&, const ImportOffer&) override
    {
        return {};
    }
    std::optional<ForecastChoice> askForecast(QWidget*, const ForecastOffer&) override
    {
        return {};
    }
    std::optional<Point> askWind(QWidget*, const Point&, double) override { return {}; }
    std::optional<double> askDeclination(QWidget*, double) override { return {}; }
    void soundAlarm() override {}
    std::optional<OriginChoice> askOrigin(QWidget*, const Scenario&, const LatLon&,
                                          const Theme&) override
    {
        return {};
    }
    InUse askInUse(QWidget*, const QString&, const QString&) override { return InUse::OpenCopy; }
    Overwrite askOverwrite(QWidget*, const QString&, const QString&) override
    {
        return Overwrite::Cancel;
    }
    Unsaved askUnsavedRun(QWidget*, bool) override { return Unsaved::Discard; }
    bool askEndFlight(QWidget*, FlightEnd) override { return true; }
    bool askRemove(QWidget*, const QStringList&) override { return false; }
    bool askUndo(QWidget*, const QString&, const QString&) override { return false; }
    bool askReload(QWidget*, const QString&) override { return false; }
    RecoveryAnswer askRecovery(QWidget*, const std::vector<RecoveryOffer>&) override { return {}; }
    void waitUntil(QWidget*, const QString&, const std::function<bool()>&, bool) override {}
    void showError(QWidget*, const QString&) override {}
    void showInformation(QWidget*, const QString&, const QString&) override {}
};

inline double elapsed_ms(const QElapsedTimer& clock)
{
    return static_cast<double>(clock.nsecsElapsed()) * 1e-6;
}

/** CPU time of this thread, ms. */
inline double worked_ms()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

/** Measures CPU time of paints of one widget, of frames of its window, and of single events. */
class FrameWatch final : public QApplication
{
public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override
    {
        if (QThread::currentThread() != thread())
            return QApplication::notify(receiver, event);
        const QEvent::Type type = event->type();
        const bool isPaint = receiver == map && type == QEvent::Paint;
        const bool isFrame = receiver == window && type == QEvent::UpdateRequest;
        std::string name = receiver->metaObject()->className();
        if (const auto* timer = qobject_cast<QTimer*>(receiver)) // one without a parent is a member
            name += " of " + std::to_string(timer->interval()) + " ms";
        const double before_ms = worked_ms();
        ++m_depth;
        const bool isDone = QApplication::notify(receiver, event);
        --m_depth;
        const double work_ms = worked_ms() - before_ms;
        if (isPaint || isFrame)
            (isPaint ? paints_ms : frames_ms).push_back(work_ms);
        if (m_depth == 0 && work_ms > longest.work_ms)
            longest = {.receiver = name, .type = type, .work_ms = work_ms};
        return isDone;
    }

    struct LongestEvent
    {
        std::string receiver;
        int type = 0;
        double work_ms = 0;
    };

    QObject* map = nullptr;
    QObject* window = nullptr;
    std::vector<double> paints_ms;
    std::vector<double> frames_ms;
    LongestEvent longest; ///< not one of those that an event sets off in turn

private:
    int m_depth = 0;
};

struct LongestTurn
{
    double waited_ms = 0;
    double worked_ms = 0;
};

/**
 * Runs the event loop for `length_ms`, or until `mayEnd`; returns its longest turn.
 */
inline LongestTurn watchTurns(
    int length_ms, const std::function<bool()>& mayEnd = [] { return false; })
{
    QEventLoop loop;
    QTimer pulse;
    pulse.setTimerType(Qt::PreciseTimer);
    QElapsedTimer whole;
    QElapsedTimer sinceLast;
    LongestTurn longest;
    double workedBefore_ms = worked_ms();
    QObject::connect(&pulse, &QTimer::timeout, &loop, [&] {
        const double now_ms = worked_ms();
        longest.waited_ms = std::max(longest.waited_ms, elapsed_ms(sinceLast));
        longest.worked_ms =
            std::max(longest.worked_ms, now_ms - std::exchange(workedBefore_ms, now_ms));
        sinceLast.start();
        if (whole.elapsed() >= length_ms || mayEnd())
            loop.quit();
    });
    whole.start();
    sinceLast.start();
    pulse.start(1);
    loop.exec();
    return longest;
}

inline void print(const char* name, std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    if (values.empty())
        std::printf("    %-16s none\n", name);
    else
        std::printf("    %-16s median %6.1f   p95 %6.1f   worst %6.1f ms   (%zu)\n", name,
                    quantile(values, 0.5), quantile(values, 0.95), values.back(), values.size());
}

} // namespace berg
