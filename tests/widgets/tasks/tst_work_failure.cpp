#include "widgets/tasks/work_failure.h"

#include <QtTest>

#include <new>

using namespace berg;

class TestWorkFailure : public QObject
{
    Q_OBJECT

private slots:
    void workThatEndsWell()
    {
        bool done = false;
        QVERIFY(!failureOf([&] { done = true; }));
        QVERIFY(done);
    }

    /** Every exception becomes a value with a readable report. */
    void workThatThrows_data()
    {
        QTest::addColumn<QString>("what");
        QTest::addColumn<QString>("says");
        QTest::addColumn<bool>("isExpected");
        QTest::newRow("error") << "error"
                               << "a.berg" << true;
        QTest::newRow("memory") << "memory"
                                << "memory" << false;
        QTest::newRow("fault") << "fault"
                               << "never so" << false;
        QTest::newRow("number") << "number"
                                << "Internal error" << false;
    }
    void workThatThrows()
    {
        QFETCH(QString, what);
        QFETCH(QString, says);
        QFETCH(bool, isExpected);
        const auto failure = failureOf([&] {
            if (what == QLatin1String("error"))
                throw Error(ErrorCode::FileNotFound, "a.berg", "is not there");
            if (what == QLatin1String("memory"))
                throw std::bad_alloc();
            if (what == QLatin1String("fault"))
                require(false, "never so");
            throw 7; // NOLINT: a type without handler
        });
        QVERIFY(failure.has_value());
        QVERIFY(failure->report.contains(says));
        QCOMPARE(failure->isExpected, isExpected);
        QCOMPARE(failure->error.code(),
                 isExpected ? ErrorCode::FileNotFound : ErrorCode::SolverFailed);
    }
};

QTEST_GUILESS_MAIN(TestWorkFailure)
#include "tst_work_failure.moc"
