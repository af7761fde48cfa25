#include "core/base/error.h"

#include <QtTest>

using namespace berg;

class TestError : public QObject
{
    Q_OBJECT

private slots:
    void messageHasItsSubject()
    {
        const Error error(ErrorCode::FileNotFound, "a.berg", "no such file");
        QCOMPARE(error.code(), ErrorCode::FileNotFound);
        QCOMPARE(error.subject(), std::string("a.berg"));
        QCOMPARE(std::string(error.what()), std::string("a.berg: no such file"));
        const std::vector<Issue> expected{
            {Severity::Error, "", {IssueId::Verbatim, {"no such file"}}}};
        QVERIFY(error.issues() == expected);
    }

    /** A reason without text is no reason to throw. */
    void reasonWithoutWordsIsEmpty()
    {
        QCOMPARE(Issue{}.message(), std::string());
        QCOMPARE(englishText({IssueId::OutOfRange, {1, 2}}),
                 std::string("must be from 1 to 2, not "));
    }

    void patternIsFilledIn()
    {
        const std::string name = "%2";
        QCOMPARE(filledIn("%2 av %1: %3", {name, 7, ValueKind::Array}),
                 std::string("7 av %2: an array"));
        QCOMPARE(filledIn("har ingen tid", {}), std::string("har ingen tid"));
        QCOMPARE(filledIn("er ikke et tall", {name}), std::string("er ikke et tall: \"%2\""));
        QCOMPARE(filledIn("100 %", {}), std::string("100 %"));
    }

    void messageWithoutSubject()
    {
        const Error error(ErrorCode::Unsupported, "", "not in this build");
        QCOMPARE(std::string(error.what()), std::string("not in this build"));
        QCOMPARE(error.subject(), std::string());
    }

    void oneLineForEachIssue()
    {
        const std::vector<Issue> issues{
            {Severity::Error, "uavs[0].airspeed_mps", {IssueId::Missing}},
            {Severity::Warning, "", {IssueId::NotOnEarth}},
            {Severity::Error,
             "icebergs[3].q_m2ps",
             {IssueId::WrongType, {ValueKind::Number, ValueKind::String}}}};
        const Error error(ErrorCode::InvalidInput, "b.berg", issues);
        QCOMPARE(error.code(), ErrorCode::InvalidInput);
        QCOMPARE(error.subject(), std::string("b.berg"));
        QVERIFY(error.issues() == issues);
        QCOMPARE(std::string(error.what()),
                 std::string("b.berg: uavs[0].airspeed_mps: is missing\n"
                             "b.berg: this is not a place on the Earth\n"
                             "b.berg: icebergs[3].q_m2ps: must be a number, not a string"));
    }

    void caughtAsRuntimeErrorAndNotAsBug()
    {
        const auto fail = [] { throw Error(ErrorCode::SyntaxError, "c", "bad"); };
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, fail());
        const auto bug = [] { require(false, "a bug"); };
        QVERIFY_THROWS_EXCEPTION(std::logic_error, bug());
    }

    void requirePassesAndSaysWhat()
    {
        require(true, "never thrown");
        try {
            require(false, "count must be at least 1");
            QFAIL("nothing thrown");
        } catch (const std::logic_error& e) {
            QCOMPARE(std::string(e.what()), std::string("count must be at least 1"));
        }
    }

    void onlyErrorsCountAsErrors_data()
    {
        QTest::addColumn<QList<int>>("severities");
        QTest::addColumn<bool>("expected");
        const auto error = static_cast<int>(Severity::Error);
        const auto warning = static_cast<int>(Severity::Warning);
        const auto hint = static_cast<int>(Severity::Hint);
        QTest::newRow("nothing") << QList<int>{} << false;
        QTest::newRow("warning and hint") << QList<int>{warning, hint} << false;
        QTest::newRow("error alone") << QList<int>{error} << true;
        QTest::newRow("error last") << QList<int>{hint, warning, error} << true;
    }

    void onlyErrorsCountAsErrors()
    {
        QFETCH(QList<int>, severities);
        QFETCH(bool, expected);
        std::vector<Issue> issues;
        for (const int severity : severities)
            issues.push_back({static_cast<Severity>(severity), "field", {IssueId::Missing}});
        QCOMPARE(hasErrors(issues), expected);
    }

    void issuesDifferByEveryMember()
    {
        const Issue issue{Severity::Error, "a", {IssueId::Missing}};
        QVERIFY((issue == Issue{Severity::Error, "a", {IssueId::Missing}}));
        QVERIFY(!(issue == Issue{Severity::Hint, "a", {IssueId::Missing}}));
        QVERIFY(!(issue == Issue{Severity::Error, "x", {IssueId::Missing}}));
        QVERIFY(!(issue == Issue{Severity::Error, "a", {IssueId::Damaged}}));
    }
};

QTEST_APPLESS_MAIN(TestError)
#include "tst_error.moc"
