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

constexpr QSizeF kA4(794, 1123);

Scenario withOperation(const Operation& operation)
{
    return changed([&](Scenario& s) { s.operation = operation; });
}

BriefLayout layoutOf(const Scenario& scenario)
{
    return layOutOperation(operationContent(planContent(scenario), kEnglish), kA4);
}

QString wordsOf(const BriefLayout& layout)
{
    QString words;
    for (const BriefText& text : layout.texts)
        words += text.text + u'\n';
    return words;
}

} // namespace

class TestOperationPage : public QObject
{
    Q_OBJECT

private slots:
    void pageIsAProposalWithFormulas()
    {
        const QString words = wordsOf(layoutOf(withOperation({.crew = "A. Pilot"})));
        // Lines span the page.
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
            QVERIFY2(words.contains(part), qPrintable(part + u" in\n"_s + words));
        for (const QString& never : {u"SAIL"_s, u"approved"_s, u"risk class"_s})
            QVERIFY2(!words.contains(never, Qt::CaseInsensitive), qPrintable(never));
    }

    void nothingIsCutAtTheEndOfALine()
    {
        const QString item =
            u"Battery of the UAV checked, spare one in the warm box, "_s.repeated(3);
        const BriefLayout layout = layoutOf(
            withOperation({.crew = "A. Pilot", .checklist = item.toStdString() + "engine"}));
        for (const BriefText& text : layout.texts)
            QVERIFY2(!text.text.endsWith(u'…'), qPrintable(text.text));
        QVERIFY(wordsOf(layout).contains(u"engine"_s));
    }

    void linesOfContactsAreSeparated()
    {
        const Operation filled{.contacts = "Ship +47 1\nATS 118.1\n\nRescue 112"};
        const BriefLayout layout = layoutOf(withOperation(filled));
        QVERIFY(std::ranges::any_of(layout.texts, [](const BriefText& text) {
            return text.text.contains(u"Ship +47 1 · ATS 118.1 · Rescue 112"_s);
        }));
    }

    /** An empty entry becomes a line for handwriting. */
    void emptyFieldsAreBlankLines()
    {
        const Operation filled{
            .crew = "A", .callSign = "B", .contacts = "C", .link = "D", .checklist = "E"};
        const std::size_t empty = layoutOf(withOperation({})).rules.size();
        const std::size_t full = layoutOf(withOperation(filled)).rules.size();
        // Two for each of four fields; six items of a checklist, each with a box and a line,
        // against the box of one.
        QCOMPARE(empty - full, std::size_t{2 * 4 + 6 * 5 - 4});
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
        const QRectF page(QPointF(0, 0), kA4);
        const ExportContent content =
            planContent(scenario, fleetPlan(static_cast<int>(scenario.uavs.size()), 4));
        const BriefLayout layout = layOutOperation(operationContent(content, kEnglish), kA4);
        for (const BriefText& text : layout.texts)
            QVERIFY2(page.contains(text.rect), qPrintable(text.text));
        for (const BriefRule& rule : layout.rules)
            QVERIFY(page.contains(rule.line.p1()) && page.contains(rule.line.p2()));
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
