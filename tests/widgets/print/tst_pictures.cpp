#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/presets/presets.h"
#include "tests/support/files/file_texts.h"

#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

struct Outcome
{
    int exitCode = -1;
    QString out;
    QString err;
};

/** Runs the program as a user without a display would. */
Outcome run(const QStringList& arguments)
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const QString& name :
         {u"DISPLAY"_s, u"WAYLAND_DISPLAY"_s, u"QT_QPA_PLATFORM"_s, u"LC_ALL"_s, u"LANGUAGE"_s})
        environment.remove(name);
    environment.insert(u"LANG"_s, u"C.UTF-8"_s);
    QProcess program;
    program.setProcessEnvironment(environment);
    program.start(QStringLiteral(BERG_PROGRAM), arguments);
    if (!program.waitForFinished(120000) || program.exitStatus() != QProcess::NormalExit)
        return {};
    return {.exitCode = program.exitCode(),
            .out = QString::fromUtf8(program.readAllStandardOutput()),
            .err = QString::fromUtf8(program.readAllStandardError())};
}

Scenario smallScenario()
{
    FieldSpec field;
    field.icebergs = 4;
    Scenario scenario = randomScenario(3, field);
    scenario.duration_s = 120;
    scenario.planner.policy = PolicyKind::Nearest;
    return scenario;
}

} // namespace

class TestPictures : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        m_scenario = m_folder->filePath(u"small.berg"_s);
        saveScenario(smallScenario(), m_scenario.toStdString());
        m_pictures = m_folder->filePath(u"new/pictures"_s);
    }

    void scenarioIsFlownAndDrawn()
    {
        const Outcome outcome = run({u"--pictures"_s, m_pictures, m_scenario});
        QCOMPARE(outcome.exitCode, 0);
        const QStringList names = outcome.out.split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(names, (QStringList{m_pictures + u"/map.png"_s, m_pictures + u"/zeta.png"_s,
                                     m_pictures + u"/sigma.png"_s}));
        QCOMPARE(QImage(names[0]).size(), QSize(1600, 1000));
        QCOMPARE(QImage(names[1]).size(), QSize(1600, 700));
        QCOMPARE(QImage(names[2]).size(), QSize(1600, 700));
        QCOMPARE(QDir(m_pictures).entryList(QDir::Files).size(), 3); // nothing temporary left
    }

    void bothThemesAndASize()
    {
        const Outcome outcome = run({u"--pictures"_s, m_pictures, u"--theme"_s, u"both"_s,
                                     u"--size"_s, u"640x480"_s, m_scenario});
        QCOMPARE(outcome.exitCode, 0);
        for (const QString& name : {u"map"_s, u"zeta"_s, u"sigma"_s}) {
            const QImage light(m_pictures + u'/' + name + u".png"_s);
            const QImage dark(m_pictures + u'/' + name + u"-dark.png"_s);
            QCOMPARE(light.size(), QSize(640, 480));
            QCOMPARE(dark.size(), QSize(640, 480));
            QVERIFY(light.pixelColor(1, 240).lightness() > 200);
            QVERIFY(dark.pixelColor(1, 240).lightness() < 60);
        }
    }

    void runHasThePicturesOfItsScenario()
    {
        Mission mission(smallScenario());
        mission.advance(120);
        const QString recorded = m_folder->filePath(u"small.bergrun"_s);
        saveRun(runOf(mission), recorded.toStdString());
        const QString other = m_folder->filePath(u"replayed"_s);
        QCOMPARE(run({u"--pictures"_s, m_pictures, m_scenario}).exitCode, 0);
        QCOMPARE(run({u"--pictures"_s, other, recorded}).exitCode, 0);
        for (const QString& name : {u"map.png"_s, u"zeta.png"_s, u"sigma.png"_s})
            QCOMPARE(QImage(other + u'/' + name), QImage(m_pictures + u'/' + name));
    }

    void emptySceneIsDrawn()
    {
        Scenario scenario = smallScenario();
        scenario.icebergs.clear();
        saveScenario(scenario, m_scenario.toStdString());
        QCOMPARE(run({u"--pictures"_s, m_pictures, m_scenario}).exitCode, 0);
    }

    void wrongUsage_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("no file") << QStringList{u"--pictures"_s, u"x"_s};
        QTest::newRow("two files") << QStringList{u"--pictures"_s, u"x"_s, u"a"_s, u"b"_s};
        QTest::newRow("unknown option") << QStringList{u"--nonsense"_s};
        QTest::newRow("theme") << QStringList{u"--pictures"_s, u"x"_s, u"--theme"_s, u"red"_s,
                                              u"a"_s};
        QTest::newRow("size of letters")
            << QStringList{u"--pictures"_s, u"x"_s, u"--size"_s, u"big"_s, u"a"_s};
        QTest::newRow("size too large")
            << QStringList{u"--pictures"_s, u"x"_s, u"--size"_s, u"9000x100"_s, u"a"_s};
        QTest::newRow("size too small")
            << QStringList{u"--pictures"_s, u"x"_s, u"--size"_s, u"99x100"_s, u"a"_s};
    }

    void wrongUsage()
    {
        QFETCH(QStringList, arguments);
        const Outcome outcome = run(arguments);
        QCOMPARE(outcome.exitCode, 2);
        QVERIFY(outcome.out.isEmpty());
        QVERIFY(!outcome.err.isEmpty());
        QVERIFY(!QFileInfo::exists(u"x"_s));
    }

    void badInput_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("not JSON") << QByteArray("{");
        QTest::newRow("another format")
            << QByteArray(R"({"format":"bergwatch-problem","version":1})");
        QTest::newRow("values out of range")
            << QByteArray(R"({"format":"bergwatch-scenario","version":1,)"
                          R"("uavs":[{"position_m":[0,0]}],"icebergs":[{"position_m":[1,"x"]}]})");
        QTest::newRow("no such file") << QByteArray();
    }

    void badInput()
    {
        QFETCH(QByteArray, content);
        const QString path = m_folder->filePath(u"bad.berg"_s);
        if (!content.isEmpty()) {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(content);
        }
        const Outcome outcome = run({u"--pictures"_s, m_pictures, path});
        QCOMPARE(outcome.exitCode, 3);
        QVERIFY(outcome.err.contains(u"bad.berg"_s));
        QVERIFY(!QFileInfo::exists(m_pictures)); // nothing written
    }

    void helpAndVersion()
    {
        const Outcome help = run({u"--help"_s});
        QCOMPARE(help.exitCode, 0);
        QVERIFY(help.out.contains(u"--pictures"_s));
        const Outcome version = run({u"--version"_s});
        QCOMPARE(version.exitCode, 0);
        QVERIFY(version.out.startsWith(u"bergwatch "_s));
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_scenario;
    QString m_pictures;
};

QTEST_MAIN(TestPictures)
#include "tst_pictures.moc"
