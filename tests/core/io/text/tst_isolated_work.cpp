#include "core/base/stopped.h"
#include "core/io/text/isolated_work.h"
#include "core/io/text/read_budget.h"
#include "tests/support/expect_error.h"

#include <QTest>

#include <csignal>
#include <thread>

using namespace berg;
using namespace berg::test;

namespace {

using Report = std::function<void(double)>;
constexpr IsolationLimits kLimits{.memory = 200'000'000, .processor_s = 10};

std::string isolated(const std::function<std::string(const Report&)>& work)
{
    return runIsolated("file", work, kLimits, {}, {});
}

} // namespace

class TestIsolatedWork : public QObject
{
    Q_OBJECT

private slots:
    void resultAndProgressComeBack()
    {
        std::vector<double> shares;
        const std::string long_text(3'000'000, 'P');
        const std::string result = runIsolated(
            "file",
            [&](const Report& report) {
                report(0.25);
                report(0.75);
                return long_text;
            },
            kLimits, [&](double share) { shares.push_back(share); }, {});
        QCOMPARE(result, long_text);
        QCOMPARE(shares, (std::vector<double>{0.25, 0.75}));
    }

    void errorsComeBack()
    {
        const std::optional<Error> error = errorOf([] {
            (void)isolated([](const Report&) -> std::string {
                throw Error(ErrorCode::InvalidInput, "file",
                            {{Severity::Error, "u", {IssueId::OutOfRange, {1.0, 2.0, 3.5}}},
                             {Severity::Error,
                              "v",
                              {IssueId::MostEntries, {countOf(5), std::string("six")}}}});
            });
        });
        QVERIFY(error);
        QCOMPARE(error->code(), ErrorCode::InvalidInput);
        QCOMPARE(std::string(error->what()), std::string("file: u: must be from 1 to 2, not 3.5\n"
                                                         "file: v: must hold at most 5 entries, "
                                                         "not six"));
    }

    void aCrashIsAnError()
    {
        const std::optional<Error> error = errorOf([] {
            (void)isolated([](const Report&) -> std::string {
                (void)raise(SIGKILL);
                return {};
            });
        });
        QVERIFY(error);
        QCOMPARE(error->code(), ErrorCode::FileUnreadable);
        QCOMPARE(std::string(error->what()), std::string("file: is damaged"));
    }

    void memoryIsLimited()
    {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("the sanitizers' own memory has no limit");
#endif
        const std::optional<Error> error = errorOf(
            [] { (void)isolated([](const Report&) { return std::string(400'000'000, 'x'); }); });
        QVERIFY(error);
        QCOMPARE(error->code(), ErrorCode::FileTooLarge);
    }

    void aStopEndsIt()
    {
        std::stop_source source;
        QVERIFY_EXCEPTION_THROWN((void)runIsolated(
                                     "file",
                                     [](const Report& report) -> std::string {
                                         report(0.5);
                                         std::this_thread::sleep_for(std::chrono::hours(1));
                                         return {};
                                     },
                                     kLimits, [&](double) { source.request_stop(); },
                                     source.get_token()),
                                 Stopped);
    }
};

QTEST_APPLESS_MAIN(TestIsolatedWork)
#include "tst_isolated_work.moc"
