#include "tests/support/window/patience.h"
#include "widgets/tasks/latest_task.h"

#include <QtTest>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace berg;

namespace {

using Task = LatestTask<int, int>;

/** Results and end of a task. */
struct Heard
{
    std::vector<int> results;
    std::vector<QString> ends; ///< report of the failure, if any

    [[nodiscard]] Task::Parts
    parts(const std::function<void(int&, const std::stop_token&, const Task::Deliver&)>& work)
    {
        return {.work = work,
                .deliver = [this](int result) { results.push_back(result); },
                .end =
                    [this](const std::optional<WorkFailure>& failure) {
                        ends.push_back(failure ? failure->report : QString());
                    }};
    }
};

void untilStopped(const std::stop_token& stop)
{
    while (!stop.stop_requested())
        std::this_thread::yield();
}

} // namespace

class TestLatestTask : public QObject
{
    Q_OBJECT

private slots:
    void deliversResultsAndTheEnd()
    {
        Heard heard;
        Task task(QStringLiteral("task"),
                  heard.parts([](int& n, const auto&, const auto& deliver) { deliver(2 * n); }));
        task.start(21);
        QTRY_COMPARE(heard.ends.size(), std::size_t{1});
        QCOMPARE(heard.results, std::vector<int>{42});
        QVERIFY(heard.ends[0].isEmpty());
    }

    /** The next request stops the current one; nothing of it is delivered. */
    void newestWins()
    {
        Heard heard;
        std::atomic<int> begun{0};
        Task task(QStringLiteral("task"),
                  heard.parts([&](int& n, const std::stop_token& stop, const auto& deliver) {
                      ++begun;
                      if (n == 1)
                          untilStopped(stop);
                      deliver(n);
                  }));
        task.start(1);
        QTRY_COMPARE(begun.load(), 1);
        task.start(2);
        QTRY_COMPARE(heard.ends.size(), std::size_t{1});
        QCOMPARE(heard.results, std::vector<int>{2});
    }

    /** The results are not read while it works: the newest one and the end remain. */
    void newestResultIsKept()
    {
        Heard heard;
        Task task(QStringLiteral("task"), heard.parts([](int& n, const auto&, const auto& deliver) {
            for (int i = 1; i <= n; ++i)
                deliver(i);
        }));
        task.start(1000);
        QTRY_COMPARE(heard.ends.size(), std::size_t{1});
        QCOMPARE(heard.results.back(), 1000);
    }

    /** The last result of a stopped request is delivered, but nothing of a dropped one. */
    void stopsAndDrops()
    {
        Heard heard;
        std::atomic<int> done{0};
        Task task(QStringLiteral("task"),
                  heard.parts([&](int& n, const std::stop_token& stop, const auto& deliver) {
                      untilStopped(stop);
                      deliver(n);
                      ++done;
                  }));
        task.start(1);
        task.stop();
        QTRY_COMPARE(heard.ends.size(), std::size_t{1});
        QCOMPARE(heard.results, std::vector<int>{1});
        task.start(2);
        task.drop();
        QTRY_COMPARE(done.load(), 2);
        QCoreApplication::sendPostedEvents();
        QCOMPARE(heard.results, std::vector<int>{1});
        QCOMPARE(heard.ends.size(), std::size_t{1});
    }

    void failuresAreReported()
    {
        Heard heard;
        Task task(QStringLiteral("task"), heard.parts([](int& n, const auto&, const auto& deliver) {
            deliver(n);
            throw std::runtime_error("broken");
        }));
        task.start(7);
        QTRY_COMPARE(heard.ends.size(), std::size_t{1});
        QCOMPARE(heard.results, std::vector<int>{7});
        QVERIFY(heard.ends[0].contains(QStringLiteral("broken")));
    }

    void destructionStops()
    {
        Heard heard;
        std::atomic<bool> begun{false};
        {
            Task task(QStringLiteral("task"),
                      heard.parts([&](int&, const std::stop_token& stop, const auto&) {
                          begun = true;
                          untilStopped(stop);
                      }));
            task.start(1);
            QTRY_VERIFY(begun.load());
        }
        QCoreApplication::sendPostedEvents();
        QVERIFY(heard.ends.empty());
    }
};

QTEST_MAIN(TestLatestTask)
#include "tst_latest_task.moc"
