#include "widgets/words/error_text.h"

#include <QtTest>

#include <set>

using namespace berg;
using namespace Qt::StringLiterals;

class TestErrorText : public QObject
{
    Q_OBJECT

private slots:
    void everyCodeHasItsOwnText()
    {
        std::set<QString> texts;
        const int last = static_cast<int>(ErrorCode::ReplayMismatch);
        for (int code = 0; code <= last; ++code) {
            const QString text = errorText(static_cast<ErrorCode>(code));
            QVERIFY2(!text.isEmpty(), QByteArray::number(code).constData());
            QVERIFY(text.endsWith(u'.'));
            texts.insert(text);
        }
        QCOMPARE(static_cast<int>(texts.size()), last + 1);
    }

    void reportNamesSubjectAndFields()
    {
        const Error error(
            ErrorCode::InvalidInput, "ice.berg",
            {{.severity = Severity::Error,
              .field = "icebergs[3].q_m2ps",
              .reason = {IssueId::OutOfRange, {0.0, 1.0, 4.5}}},
             {.severity = Severity::Error, .field = "line 3", .reason = {IssueId::NoTime}},
             {.severity = Severity::Error, .reason = {IssueId::NotOnEarth}}});
        const QStringList lines = errorReport(error).split(u'\n');
        QCOMPARE(lines.size(), 4);
        QCOMPARE(lines[0], u"ice.berg: "_s + errorText(ErrorCode::InvalidInput));
        QCOMPARE(lines[1], u"  icebergs[3].q_m2ps: must be from 0 m²/s to 1 m²/s, not 4.5 m²/s"_s);
        QCOMPARE(lines[2], u"  line 3: has no time"_s);
        QCOMPARE(lines[3], u"  this is not a place on the Earth"_s);
    }

    /** A box with all findings would be taller than the screen. */
    void manyFaultsAreCounted()
    {
        const Issue issue{.severity = Severity::Error, .reason = {IssueId::NotOnEarth}};
        const auto linesOf = [&](std::size_t count) {
            return errorReport(
                       Error(ErrorCode::InvalidInput, "ice.berg", std::vector(count, issue)))
                .split(u'\n');
        };
        QCOMPARE(linesOf(12).size(), 13);
        QCOMPARE(linesOf(100).size(), 14);
        QCOMPARE(linesOf(100).back(), u"  … and 88 more"_s);
    }

    void reportOfAMessageKeepsIt()
    {
        const Error error(ErrorCode::SyntaxError, "ice.berg", "line 3, column 7: expected a comma");
        const QString report = errorReport(error);
        QVERIFY(report.startsWith(u"ice.berg: "_s + errorText(ErrorCode::SyntaxError)));
        QVERIFY(report.contains(u"line 3, column 7: expected a comma"_s));
    }
};

QTEST_APPLESS_MAIN(TestErrorText)
#include "tst_error_text.moc"
