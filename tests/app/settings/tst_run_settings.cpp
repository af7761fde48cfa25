#include "app/settings/run_settings.h"
#include "core/io/text/atomic_file.h"

#include <QDir>
#include <QTest>

#include <sys/stat.h>

using namespace berg;
using namespace Qt::StringLiterals;

/** Location and lifetime of the settings of a run. */
class TestRunSettings : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_dir;
    [[nodiscard]] QString path(const QString& name) const { return m_dir.filePath(name); }

    static void change(RunSettings& run)
    {
        run.settings().setValue("view/appearance", 2);
        run.settings().sync();
    }

private slots:
    /** Pictures, and settings files that are no ordinary files, use a temporary folder. */
    void settingsOfARunGoWithIt_data()
    {
        QTest::addColumn<QString>("config");
        QTest::addColumn<bool>("isPicture");
        const QString pipe = path(u"pipe"_s); // a device needs more rights to be made
        QCOMPARE(mkfifo(qPrintable(pipe), 0600), 0);
        QVERIFY(QDir(m_dir.path()).mkdir(u"folder"_s));
        QTest::newRow("picture") << QString() << true;
        QTest::newRow("picture, file to come") << path(u"none.ini"_s) << true;
        QTest::newRow("picture, pipe") << pipe << true;
        QTest::newRow("window, pipe") << pipe << false;
        QTest::newRow("window, folder") << path(u"folder"_s) << false;
        QTest::newRow("picture, device") << u"/dev/null"_s << true;
        QTest::newRow("window, device") << u"/dev/null"_s << false;
    }
    void settingsOfARunGoWithIt()
    {
        QFETCH(QString, config);
        QFETCH(bool, isPicture);
        const QStringList before = QDir(m_dir.path()).entryList();
        QString file;
        {
            RunSettings run(config, isPicture);
            file = run.settings().fileName();
            const QString folder = QFileInfo(file).path();
            QVERIFY(folder.startsWith(QDir::tempPath()) && folder != QDir::tempPath());
            QVERIFY(!folder.startsWith(m_dir.path()));
            QVERIFY(run.dataFolder().startsWith(folder));
            change(run);
            QVERIFY(QFileInfo(file).isFile());
        }
        QVERIFY(!QFileInfo::exists(QFileInfo(file).path()));
        QCOMPARE(QDir(m_dir.path()).entryList(), before);
        QVERIFY(config.isEmpty() || !QFileInfo(config).isFile());
    }

    /** A picture is as the file says, and leaves it alone. */
    void pictureReadsTheFileNamed()
    {
        const std::string text = "[view]\nappearance=1\n";
        const QString config = path(u"given.ini"_s);
        writeFileAtomically(config.toStdString(), text);
        RunSettings run(config, true);
        QCOMPARE(run.settings().value("view/appearance").toInt(), 1);
        change(run);
        QVERIFY(readFile(config.toStdString()) == text);
    }

    void windowKeepsTheFileNamed()
    {
        const QString config = path(u"own.ini"_s);
        {
            RunSettings run(config, false);
            QCOMPARE(run.dataFolder(), config + u".data"_s);
            change(run);
        }
        QCOMPARE(QSettings(config, QSettings::IniFormat).value("view/appearance").toInt(), 2);
    }
};

QTEST_GUILESS_MAIN(TestRunSettings)
#include "tst_run_settings.moc"
