#include "widgets/words/export_text.h"
#include "widgets/words/import_text.h"

#include <QSet>
#include <QtTest>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

constexpr int kNoteKinds = static_cast<int>(ExportNoteKind::OptionNotUsed) + 1;

ExportNote note(ExportNoteKind kind)
{
    return {.kind = kind, .id = {}, .tool = "The tool", .value = 21.25, .limit = 7};
}

} // namespace

/** Texts of the export dialog. */
class TestExportText : public QObject
{
    Q_OBJECT

private slots:
    void everyNoteHasASentenceOfItsOwn()
    {
        QSet<QString> sentences;
        for (int kind = 0; kind < kNoteKinds; ++kind) {
            const QString text =
                exportNoteText(note(static_cast<ExportNoteKind>(kind)), QLocale::c());
            QVERIFY2(!text.contains(u'%'), qPrintable(text));
            QVERIFY(!exportEffectText(effectOf(static_cast<ExportNoteKind>(kind))).isEmpty());
            sentences << text;
        }
        QCOMPARE(sentences.size(), kNoteKinds);
    }

    void numbersAreInTheSentence_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QStringList>("parts");
        const auto row = [](const char* name, ExportNoteKind kind, const QStringList& parts) {
            QTest::newRow(name) << static_cast<int>(kind) << parts;
        };
        row("files", ExportNoteKind::OneFileEach, {u"21"_s});
        row("acceptance", ExportNoteKind::AcceptanceCut,
            {u"The tool"_s, u"up to 7 m"_s, u"21 m becomes 7 m"_s});
        row("loiter", ExportNoteKind::LoiterInSteps, {u"The tool"_s, u"21 m becomes 7 m"_s});
        row("speed", ExportNoteKind::WholeSpeed, {u"The tool"_s, u"21,25 m/s becomes 7 m/s"_s});
        row("path", ExportNoteKind::PathAsWaypoints, {u"21"_s});
        row("idle", ExportNoteKind::NothingToFly, {u"21"_s});
        row("crossing", ExportNoteKind::LegsCross, {u"21"_s});
        row("sortie", ExportNoteKind::LaterSorties, {u"21"_s});
        row("fence", ExportNoteKind::FenceAcross180, {u"The tool"_s});
        row("option", ExportNoteKind::OptionNotUsed, {u"The tool"_s});
    }

    void numbersAreInTheSentence()
    {
        QFETCH(int, kind);
        QFETCH(QStringList, parts);
        const QString text = exportNoteText(note(static_cast<ExportNoteKind>(kind)),
                                            QLocale(QLocale::German, QLocale::Germany));
        for (const QString& part : parts)
            QVERIFY2(text.contains(part), qPrintable(text));
    }

    /** No two formats have the same description. */
    void everyFormatHasWords()
    {
        QSet<QString> shown;
        for (const ExportFormat& format : exportFormats()) {
            const ExportFormatText text = exportFormatText(format);
            QVERIFY(!text.name.isEmpty() && !text.tool.isEmpty());
            QVERIFY2(text.about.endsWith(u'.'), qPrintable(text.about));
            QCOMPARE(text.group == ExportGroup::Autopilots, format.holds.mission);
            QCOMPARE(text.group == ExportGroup::Pages, format.holds.painted);
            shown << text.name + text.about;
        }
        QCOMPARE(shown.size(), static_cast<qsizetype>(exportFormats().size()));
    }

    void refusalNamesTheReason()
    {
        const Error slow(ErrorCode::InvalidInput, "speed", {IssueId::SlowerThanWind});
        QCOMPARE(exportRefusalText(slow), u"Airspeed: must be above the speed of the wind"_s);
        const Error low(ErrorCode::InvalidInput, "altitude",
                        {IssueId::OutOfRange, {1.0, 500.0, -5.0}});
        QCOMPARE(exportRefusalText(low), u"Altitude: must be from 1 m to 500 m, not -5 m"_s);
        const Error endless(ErrorCode::InvalidInput, "speed", {IssueId::NotFinite});
        QCOMPARE(exportRefusalText(endless), u"Airspeed: must be a finite number"_s);
        const Error full(ErrorCode::FileUnwritable, "a.kml", {IssueId::CannotMake});
        QVERIFY(exportRefusalText(full).startsWith(u"a.kml: "_s));
    }

    /** Rejected options have the names of the dialog. */
    void optionsAreNamed()
    {
        const Error error(
            ErrorCode::InvalidInput, "import",
            {{Severity::Error, "until", {IssueId::BeforeOther, {FieldPath{"since"}}}},
             {Severity::Error, "area: north", {IssueId::OutOfRange, {50., 90., 40.}}}});
        QCOMPARE(importErrorReport(error), u"Not after: must not be before \"Not before\"\n"
                                           "North: must be from 50° to 90°, not 40°"_s);
    }

    void unknownFormatIsReportedOnce()
    {
        const QString report = importErrorReport(
            Error(ErrorCode::WrongFormat, "prose.txt", {IssueId::UnknownFormat, {"csv, kml"}}));
        QVERIFY(report.startsWith(u"prose.txt: Bergwatch does not recognise this file"_s));
        QVERIFY2(!report.contains(u'\n'), qPrintable(report));
        const QString empty =
            importErrorReport(Error(ErrorCode::WrongFormat, "a.csv", {IssueId::FileEmpty}));
        QCOMPARE(empty.count(u'\n'), 1); // a line that says more
    }

    void agesAreRoundedOnce()
    {
        const auto text = [](double age_s) { return ageText(age_s, QLocale::c()); };
        QCOMPARE(text(29), u"0 min"_s);
        QCOMPARE(text(3569), u"59 min"_s);
        QCOMPARE(text(3570), u"1 h 0 min"_s);
        QCOMPARE(text(86'369), u"23 h 59 min"_s);
        QCOMPARE(text(86'370), u"1 d 0 h"_s);
        QCOMPARE(text(86'400), u"1 d 0 h"_s);
        QCOMPARE(text(187'200), u"2 d 4 h"_s);
    }
};

QTEST_GUILESS_MAIN(TestExportText)
#include "tst_export_text.moc"
