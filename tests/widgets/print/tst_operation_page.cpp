#include "tests/support/files/brief_fixtures.h"
#include "widgets/print/flight_brief.h"
#include "widgets/print/operation_page.h"
#include "widgets/theme/quantity_text.h"

#include <QtTest>

#include <algorithm>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

Scenario withOperation(const Operation& operation)
{
    return changed([&](Scenario& s) { s.operation = operation; });
}

PrintedDocument pageOf(const Scenario& scenario)
{
    return operationDocument(planContent(scenario), kEnglish);
}

QString wordsOf(const PrintedDocument& page)
{
    return PrintedText(page).toRawText().replace(QChar::ParagraphSeparator, u'\n');
}

} // namespace

class TestOperationPage : public QObject
{
    Q_OBJECT

private slots:
    void pageIsAProposalWithFormulas()
    {
        const QString words = wordsOf(pageOf(withOperation({.crew = "A. Pilot"})));
        QVERIFY2(words.simplified().contains(
                     u"Operation volume: proposal, to be checked with your authority"_s),
                 qPrintable(words));
        for (const QString& part :
             {u"S_CV = 3 + 3 + 1 + v · 1 s + v²/(g tan 30°) = 114.5 m"_s,
              u"H_CV = 120 + 4 + 0.707 v · 1 s + 0.3 v²/g = 154.4 m"_s,
              u"S_GRB = 1 · H_CV + 3/2 = 155.9 m"_s,
              u"S_AA = v · 180 s, %1 … %2 m = %1 m"_s.arg(fixedText(5000, 0, kEnglish),
                                                          fixedText(35'000, 0, kEnglish)),
              u"Digisky"_s, u"A. Pilot"_s})
            QVERIFY2(words.simplified().contains(part.simplified()),
                     qPrintable(part + u" in\n"_s + words));
        for (const QString& never : {u"SAIL"_s, u"approved"_s, u"risk class"_s})
            QVERIFY2(!words.contains(never, Qt::CaseInsensitive), qPrintable(never));
    }

    void nothingIsCutAtTheEndOfALine()
    {
        const QString item =
            u"Battery of the UAV checked, spare one in the warm box, "_s.repeated(3);
        const QString words = wordsOf(pageOf(
            withOperation({.crew = "A. Pilot", .checklist = item.toStdString() + "engine"})));
        QCOMPARE(words.count(u'…'), qsizetype{1}); // of the formula of the adjacent area
        QVERIFY(words.contains(u"engine"_s));
    }

    void linesOfContactsAreSeparated()
    {
        const Operation filled{.contacts = "Ship +47 1\nATS 118.1\n\nRescue 112"};
        QVERIFY(wordsOf(pageOf(withOperation(filled)))
                    .contains(u"Ship +47 1 · ATS 118.1 · Rescue 112"_s));
    }

    /** An empty entry becomes lines for handwriting. */
    void emptyFieldsAreBlankLines()
    {
        const Operation filled{
            .crew = "A", .callSign = "B", .contacts = "C", .link = "D", .checklist = "E"};
        const auto rows = [](const Operation& operation) {
            return QString::fromStdString(pageOf(withOperation(operation)).html).count(u"<tr>"_s);
        };
        // Two for each of four fields, and six items of a checklist.
        QCOMPARE(rows({}) - rows(filled), qsizetype{2 * 4 + 6});
        QCOMPARE(wordsOf(pageOf(withOperation({}))).count(u'\u2610'), qsizetype{6});
        QCOMPARE(wordsOf(pageOf(withOperation(filled))).count(u'\u2610'), qsizetype{1});
    }

    void staysOnThePage_data()
    {
        QTest::addColumn<Scenario>("scenario");
        Scenario hostile = longHostile();
        hostile.operation = Operation{.crew = std::string(3000, 'c'),
                                      .contacts = std::string(3000, ' ') + "\xFF\x01",
                                      .checklist = "\n\n<b>\r\n\xD7\xA7"};
        for (int i = 0; i < 200; ++i)
            hostile.operation->checklist += "\nitem " + std::to_string(i);
        QTest::newRow("hostile") << hostile;
        Scenario fleet = fleetScenario(20, 50);
        fleet.operation = Operation{};
        QTest::newRow("fleet") << fleet;
    }
    void staysOnThePage()
    {
        QFETCH(Scenario, scenario);
        const PrintedDocument page = operationDocument(
            planContent(scenario, fleetPlan(static_cast<int>(scenario.uavs.size()), 4)), kEnglish);
        const PrintedText text(page);
        QCOMPARE(text.pageCount(), 1);
        QVERIFY(text.size().width() <= page.room_px().width() + 5); // borders of tables
        const qsizetype items = text.toPlainText().count(u"\u2610 item"_s);
        const auto all = QString::fromStdString(scenario.operation->checklist).count(u"item"_s);
        QVERIFY(all == 0 || items > 5);
        QCOMPARE(text.toPlainText().contains(u"and %1 more"_s.arg(all - items)), items < all);
    }

    void briefHasItAsASecondPage()
    {
        QVERIFY(flightBrief(planContent(fourIcebergs()), kEnglish).more.empty());
        const PicturePage brief = flightBrief(planContent(withOperation({})), kEnglish);
        QCOMPARE(brief.more.size(), std::size_t{1});
        const QByteArray pdf = bytes(pictureFile(brief, u"pdf"_s));
        QCOMPARE(pdf.count("/Type /Page\n"), qsizetype{2});
    }
};

QTEST_MAIN(TestOperationPage)
#include "tst_operation_page.moc"
