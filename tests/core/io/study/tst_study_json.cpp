#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/io/study/study_json.h"
#include "core/io/text/atomic_file.h"
#include "tests/support/expect_error.h"
#include "tests/support/flight/flown_study.h"

#include <QTemporaryDir>
#include <QTest>

using namespace berg;
using namespace berg::test;

namespace {

StudySpec smallSpec()
{
    Scenario scenario = smallField(3);
    scenario.notes = "kept \"as it is\"";
    scenario.extraJson = R"({"x_ours":[1,2]})";
    return {.name = "Small",
            .scenarios = {scenario},
            .random = 1,
            .firstSeed = 5,
            .field = {.icebergs = 3,
                      .size_m = {2000, 1500},
                      .q_m2ps = 0.05,
                      .regime = FieldRegime::UnknownVelocity},
            .taus = {0.1, 1},
            .policies = {PolicyKind::Visitation, PolicyKind::Nearest},
            .runs = 2};
}

/** A study with numbers of all digits; some missions and one whole case are not flown. */
Study partOfStudy()
{
    Study study{.spec = smallSpec()};
    study.outcomes.resize(12);
    for (std::size_t i = 0; i < 12; ++i)
        if (i != 4 && i / 3 != 2)
            study.outcomes[i] = {.metrics = {.zeta_m2s = 84000.0 / (3.0 + static_cast<double>(i)),
                                             .visits = static_cast<int>(i),
                                             .replans = 7,
                                             .flown_m = 0.1 + 0.2},
                                 .stuck = i % 2 == 0};
    return study;
}

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
    const std::size_t at = text.find(what);
    require(at != std::string::npos, "replaced: not in the text");
    return text.replace(at, what.size(), by);
}

} // namespace

class TestStudyJson : public QObject
{
    Q_OBJECT

private slots:
    void studyIsReadBackExactly_data()
    {
        QTest::addColumn<int>("kind");
        QTest::newRow("nothing flown") << 0;
        QTest::newRow("a part") << 1;
        QTest::newRow("all") << 2;
    }
    void studyIsReadBackExactly()
    {
        QFETCH(const int, kind);
        const Study study = kind == 0   ? Study{.spec = smallSpec()}
                            : kind == 1 ? partOfStudy()
                                        : flown(smallSpec());
        const std::string text = studyToJson(study);
        const Study read = studyFromJson(text, "text");
        QVERIFY(read == study); // every double to the last bit
        QCOMPARE(studyToJson(read), text);
        QCOMPARE(formatOf(text, "text"), std::string("bergwatch-study"));
    }

    void continuedStudyGivesTheSameBytes()
    {
        std::stop_source source;
        const auto stopAtFive = [&](const Study&, std::size_t done, std::size_t) {
            if (done == 5)
                source.request_stop();
        };
        Study study = flown(smallSpec(),
                            {.threads = 1, .stop = source.get_token(), .onProgress = stopAtFive});
        QCOMPARE(flownCount(study), std::size_t{5});
        study = studyFromJson(studyToJson(study), "text");
        QVERIFY(fly(study));
        QCOMPARE(studyToJson(study), studyToJson(flown(smallSpec())));
    }

    void savedStudyIsLoadedUnchanged()
    {
        const QTemporaryDir dir;
        const std::string path = dir.filePath("a.bergstudy").toStdString();
        saveStudy(partOfStudy(), path);
        QVERIFY(loadStudy(path) == partOfStudy());
        QCOMPARE(readFile(path), studyToJson(partOfStudy()));
        QCOMPARE(codeOf([&] { (void)loadStudy(dir.filePath("none").toStdString()); }),
                 std::string("FileNotFound"));
    }

    void missingMembersHaveDefaults()
    {
        const Study study = studyFromJson(
            R"({"format": "bergwatch-study", "version": 1, "policies": ["path"], "random": 3})",
            "text");
        QVERIFY(study.spec == (StudySpec{.random = 3, .policies = {PolicyKind::Path}}));
        QVERIFY(study.outcomes.empty());
    }

    void faultsAreNamed_data()
    {
        QTest::addColumn<QString>("what");
        QTest::addColumn<QString>("by");
        QTest::addColumn<QString>("message");
        const auto row = [](const char* name, const char* what, const char* by,
                            const char* message) { QTest::newRow(name) << what << by << message; };
        row("policy", R"("nearest")", R"("drunken")", "policies[1]: must be one of visitation,");
        row("policies missing", R"("policies")", R"("policy")", "policies: is missing");
        row("tau text", "[0.1, 1]", R"([0.1, "one"])", "taus[1]: must be a number, not a string");
        row("tau large", "[0.1, 1]", "[0.1, 101]", "taus[1]: must be");
        row("runs", R"("runs": 2)", R"("runs": 0)", "runs: must be");
        row("random", R"("random": 1)", R"("random": -1)", "random: must be a whole number");
        row("huge", R"("random": 1)", R"("random": 900000)",
            "would be 5400006 missions; at most 1000000 fit into one study: take several");
        row("runs beyond all", R"("runs": 2)", R"("runs": 1e9)", "runs: must be");
        row("first seed", R"("first_seed": 5)", R"("first_seed": 0.5)",
            "first_seed: must be a whole number");
        row("field", R"("icebergs": 3)", R"("icebergs": 2000)", "field.icebergs: must be");
        row("regime", R"("unknown-velocity")", R"("stormy")",
            "field.regime: must be one of published, measured, unknown-velocity, fitted-drift");
        row("scenario", R"("dt_s": 0.1)", R"("dt_s": 0)", "scenarios[0].dt_s: must be");
        row("scenario's format", R"("bergwatch-scenario")", R"("bergwatch-run")",
            R"(scenarios[0].format: must be "bergwatch-scenario", not "bergwatch-run")");
        row("cases", "\n  null,", "", "outcomes: must hold 4 entries, not 3");
        row("settings", "],[", "],null,[", "outcomes[0]: must hold 3 entries, not 4");
        row("numbers", ",0,7,", ",0,", "outcomes[0][0]: must hold 5 entries, not 4");
        row("zeta negative", "[28000,", "[-28000,", "outcomes[0][0][0]: must be");
        row("zeta text", "[28000,", R"(["28000",)",
            "outcomes[0][0][0]: must be a number, not a string");
        row("visits", ",0,7,", ",0.5,7,", "outcomes[0][0][1]: must be a whole number");
        row("stuck", ",1]", ",2]", "outcomes[0][0][4]: must be a whole number from 0 to 1");
    }
    void faultsAreNamed()
    {
        QFETCH(const QString, what);
        QFETCH(const QString, by);
        QFETCH(const QString, message);
        const std::string text =
            replaced(studyToJson(partOfStudy()), what.toStdString(), by.toStdString());
        const auto error = errorOf([&] { (void)studyFromJson(text, "a.bergstudy"); });
        QVERIFY(error);
        QCOMPARE(error->code(), ErrorCode::InvalidInput);
        const QString shown = QString::fromStdString(error->what());
        QVERIFY2(shown.startsWith("a.bergstudy: ") && shown.contains(message), qPrintable(shown));
    }

    /** A file cut off anywhere gives a clear error and never a part of a study. */
    void truncatedFileIsRejected()
    {
        const std::string text = studyToJson(partOfStudy());
        for (std::size_t size = 0; size + 2 < text.size(); size += 7)
            QCOMPARE(codeOf([&] { (void)studyFromJson(text.substr(0, size), "text"); }),
                     std::string("SyntaxError"));
    }

    void otherFilesAreRejected()
    {
        const std::string scenario = scenarioToJson(smallField(1));
        const std::string study = studyToJson(partOfStudy());
        QCOMPARE(codeOf([&] { (void)studyFromJson(scenario, "text"); }),
                 std::string("WrongFormat"));
        QCOMPARE(codeOf([&] { (void)scenarioFromJson(study, "text"); }),
                 std::string("WrongFormat"));
        QCOMPARE(codeOf([&] { (void)runFromJson(study, "text"); }), std::string("WrongFormat"));
        const std::string newer = replaced(study, R"("version": 1)", R"("version": 2)");
        QCOMPARE(codeOf([&] { (void)studyFromJson(newer, "text"); }),
                 std::string("UnsupportedVersion"));
    }

    /** The error comes before the flights, not when the file has become too large. */
    void studyTooLargeWhenFlownIsRejected()
    {
        Scenario scenario = smallField(1);
        scenario.notes = std::string(8U << 20U, 'x');
        const Study study{.spec = {.scenarios = {scenario, scenario},
                                   .random = 999'998,
                                   .policies = {PolicyKind::Path}}};
        const QTemporaryDir dir;
        const QString path = dir.filePath("large.bergstudy");
        QCOMPARE(codeOf([&] { saveStudy(study, path.toStdString()); }),
                 std::string("FileTooLarge"));
        QVERIFY(!QFile::exists(path));
    }

    /** 1000 complete scenarios and 40 tau give 40,000 outcomes. */
    void manyScenariosAreReadBack()
    {
        StudySpec spec{.policies = {PolicyKind::Visitation}};
        for (int i = 0; i < 1000; ++i)
            spec.scenarios.push_back(randomScenario(i));
        for (int i = 0; i < 40; ++i)
            spec.taus.push_back(0.1 * i);
        Study study{.spec = spec};
        for (int i = 0; i < 40'000; ++i)
            study.outcomes.push_back(
                MissionOutcome{.metrics = {.zeta_m2s = 84000.123456789 + i, .flown_m = 22000}});
        const std::string text = studyToJson(study);
        QVERIFY(text.size() < std::size_t{6} << 20U);
        QVERIFY(studyFromJson(text, "text") == study);
    }
};

QTEST_APPLESS_MAIN(TestStudyJson)
#include "tst_study_json.moc"
